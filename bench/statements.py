"""How many statements the generated blocks execute in a scan, at worst.

The plant of five drives is driven through what makes most work: every drive enabled, commanded and
polled, the emergency stop of the line, a gateway that is lost and comes back; then all of it with
every sequence of every drive under way at once. Counted are the statements that run, by the block
in which they stand, all its instances together; what a block calls counts for the called block.

`python -m bench.statements` prints the table.
"""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from fbgen.catalog import load_catalog
from fbgen.lang import checked
from fbgen.lang.checked import Program
from fbgen.plant import load_plant
from harness.engine.compiled.walk import every_node
from harness.engine.compiled.watching.probes import Moment, Probe, Probed
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS

_PLANT = Path(__file__).parents[1] / "examples" / "five_drives" / "plant.yaml"
_REACHED = "_reached"

STATEMENT_NS = 100
"""What a statement takes on the scale of this bench, at most (`python -m bench engine`)."""

STATEMENTS_OF_FIVE_PERCENT = 10_000_000 // 20 // STATEMENT_NS
"""5 % of a cycle of 10 ms on that scale."""


class StatementCount:
    """Statements executed by each block of a program, since the last `clear`."""

    def __init__(self, program: Program) -> None:
        self.blocks = [block.name for block in program.bodies]
        self._owners = {
            id(node): place
            for place, body in enumerate(program.bodies.values())
            for node in every_node(body)
            if isinstance(node, checked.Statement)
        }
        self._reached = [0] * len(self.blocks)

    @property
    def probe(self) -> Probe:
        """What an engine needs to count."""
        return Probe(self._line, {_REACHED: self._reached})

    def clear(self) -> None:
        """Begin at nought."""
        self._reached[:] = [0] * len(self._reached)

    def counts(self) -> Mapping[str, int]:
        """Statements by block."""
        return dict(zip(self.blocks, self._reached, strict=True))

    def _line(self, node: Probed, moment: Moment) -> str:
        place = self._owners.get(id(node)) if moment is Moment.BEFORE else None
        return "" if place is None else f"{_REACHED}[{place}] += 1"


def worst_scans(*, sequences: bool) -> Mapping[str, int]:
    """The most statements of one scan for each block, and for all together under `TOTAL`.

    `sequences` runs every sequence of every drive at once.
    """
    catalog = load_catalog()
    counts: list[StatementCount] = []

    def probe(program: Program) -> Probe:
        counts.append(StatementCount(program))
        return counts[0].probe

    plan = load_plant(_PLANT, catalog)
    installation = build_plant(plan, catalog, PlantSetup(probes=(probe,)))
    (count,) = counts
    worst = dict.fromkeys((*count.blocks, TOTAL), 0)

    def scanned() -> None:
        counts = count.counts()
        for name, number in (*counts.items(), (TOTAL, sum(counts.values()))):
            worst[name] = max(worst[name], number)
        count.clear()

    installation.cpu.after_scan.append(scanned)
    installation.start()
    _drive(installation, installation.plan.sequences if sequences else ())
    return worst


TOTAL = "all blocks together"


def _drive(installation: Installation, sequences: Sequence[str]) -> None:
    engine = installation.cpu.engine
    names = [drive.name for drive in installation.plan.drives]
    installation.run_for(2_000 * NS_PER_MS)
    for control in ("enable", "run", "jog"):
        for name in names:
            engine.set_global(f"TOS_Plant.gw1.{name}.control.{control}", True)
            engine.set_global(f"TOS_Plant.gw1.{name}.control.frequency", 40.0)
        installation.run_for(1_500 * NS_PER_MS)
    for sequence in sequences:
        for name in names:
            engine.set_global(f"TOS_Plant.gw1.{name}.{sequence}.execute", True)
    installation.run_for(1_000 * NS_PER_MS)
    engine.set_global("TOS_Plant.gw1.line.emergencyStop", True)
    installation.run_for(2_000 * NS_PER_MS)
    installation.gateways["gw1"].power_off()
    installation.run_for(500 * NS_PER_MS)
    installation.gateways["gw1"].power_on()
    installation.run_for(3_000 * NS_PER_MS)


def table() -> Iterator[str]:
    """The counts as lines of a table."""
    usual, most = worst_scans(sequences=False), worst_scans(sequences=True)
    yield "| block | statements | with all sequences | of 5 % of 10 ms |"
    yield "|---|---|---|---|"
    for name, number in sorted(most.items(), key=lambda item: -item[1]):
        share = number / STATEMENTS_OF_FIVE_PERCENT
        yield f"| {name} | {usual[name]} | {number} | {share:.0%} |"


if __name__ == "__main__":
    print("\n".join(table()))
