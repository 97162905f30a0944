"""What the generator gives: files with their text and where each line is from."""

from collections.abc import Mapping
from dataclasses import field
from functools import cached_property

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.emit.block_list import GeneratedBlock
from fbgen.lang import ast
from fbgen.lang.checked import Program
from fbgen.lang.printer import LineOrigins
from fbgen.source import Origin, Source


@dataclass(frozen=True)
class GeneratedFile:
    """One file: its name, its text (ASCII, LF), and the origins of each of its lines.

    `line_end` is what stands on disk for LF. `is_program` is False for what is no PLC text.
    `is_owned`: it is written once and then belongs to the user.
    """

    name: str
    text: str
    origins: tuple[LineOrigins, ...]
    line_end: str = "\n"
    is_program: bool = True
    is_owned: bool = False

    @property
    def data(self) -> bytes:
        """The bytes on disk."""
        return self.text.replace("\n", self.line_end).encode("ascii")

    @cached_property
    def source(self) -> Source:
        """The text as one that is read, the same one each time, with the origins of its lines.

        A line of a template stands in front of the value that the line is said to be from.
        """
        places: list[tuple[int, Origin | None]] = []
        offset = 0
        for line, origins in zip(self.text.splitlines(keepends=True), self.origins, strict=False):
            values = [origin for origin in origins if not origin.is_template]
            places += [(offset, origin) for origin in origins if origin.is_template]
            if values or not origins:
                places.append((offset, next(iter(values), None)))
            offset += len(line)
        return Source(self.name, self.text, tuple(places))


@dataclass(frozen=True, slots=True)
class Artefact:
    """A file beside the PLC text: lists for other tools, instructions for people."""

    name: str
    data: bytes


@dataclass(frozen=True, slots=True)
class CanonicalProgram:
    """What was generated before it got its dialect: the units in canonical SCL, and checked.

    A block whose code is that of another one with other names has none here (`fbgen.emit.twins`);
    `bodies` has that of the other one, by the name of the block.
    """

    units: tuple[ast.File, ...]
    program: Program
    bodies: Mapping[str, tuple[ast.Statement, ...]] = field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class GeneratedSet:
    """All files of a plant in the order in which they are imported.

    `inputs_hash` stands for fbgen's version, the plant file, the catalogue entries and templates;
    each file with PLC text carries it. `warnings` are findings that did not stop the work, `blocks`
    all units of the PLC program. `artefacts` are the files beside the PLC text, made from
    `canonical` by `fbgen.artefacts`.
    """

    dialect: str
    files: tuple[GeneratedFile, ...]
    inputs_hash: str
    warnings: tuple[Diagnostic, ...] = ()
    blocks: tuple[GeneratedBlock, ...] = ()
    canonical: CanonicalProgram | None = None
    artefacts: tuple[Artefact, ...] = ()

    @property
    def contents(self) -> dict[str, bytes]:
        """The bytes of all files by their names, the PLC text in front."""
        text = {file.name: file.data for file in self.files}
        return text | {file.name: file.data for file in self.artefacts}
