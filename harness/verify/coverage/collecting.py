"""Coverage while it is collected, and what several runs and processes have collected together."""

from collections.abc import Iterable, Iterator
from itertools import count

from fbgen.lang.checked import Program
from harness.engine.compiled import Probe
from harness.verify.coverage.catalogue import CatalogueCoverage
from harness.verify.coverage.counts import BlockCounts, BlockKey, FileCounts
from harness.verify.coverage.model import FileKey
from harness.verify.coverage.places import blocks_by_file
from harness.verify.coverage.probe import counting

_numbers = count()


class Coverage:
    """What the runs of any number of programs have reached, file by file.

    It looks on at a program from when that is loaded:

        coverage = Coverage()
        program = load_program(["conveyor.scl"], probes=[coverage])

    All programs that it looks on at count together; files of the same name and text are one.
    `catalogue` is what they have exercised of the catalogue (`harness.verify.coverage.watch`).
    """

    def __init__(self) -> None:
        self.files: dict[FileKey, FileCounts] = {}
        self.catalogue = CatalogueCoverage()
        self._generated: set[FileKey] = set()

    def __call__(self, program: Program) -> Probe:
        """What an engine needs to count; `probes` take the object itself."""
        counted = []
        for source, blocks in blocks_by_file(program).items():
            key = FileKey(source.name, program.dialect, source.text)
            if key not in self.files:
                self.files[key] = FileCounts(key, [block.places for block in blocks])
            if source.origins:
                self._generated.add(key)
            counted.append((self.files[key], blocks))
        return counting(counted, f"_coverage_{next(_numbers)}")

    def name_plant(self, name: str) -> None:
        """Say that all text which was generated up to now belongs to a plant."""
        for key in self._generated:
            self.files[key].plants.add(name)

    def merge(self, others: "Iterable[Coverage]") -> None:
        """Take over what others have collected, in other processes or on other days."""
        for other in others:
            for key, counts in other.files.items():
                if key not in self.files:
                    self.files[key] = FileCounts(key, counts.blocks)
                self.files[key].add(counts)
            self.catalogue.merge([other.catalogue.items])

    def blocks(self) -> Iterator[BlockCounts]:
        """The blocks by name. Those with the same text count together, whatever their files."""
        found: dict[BlockKey, BlockCounts] = {}
        for file in sorted(self.files):
            for block in self.files[file].of_blocks():
                key = block.key
                found[key] = found[key].plus(block) if key in found else block
        yield from (found[key] for key in sorted(found))
