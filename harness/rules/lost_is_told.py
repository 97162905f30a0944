"""A drive that has tripped or whose answer is missing is not shown as running or ready.

For one scan it may be: the poll tells what it has read behind the block of the drive.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.rules.drive_variables import drive_reader
from harness.rules.rule import Rule, Watch

_VARIABLES = ("polled.lost", "polled.tripped", "state.running", "state.ready")


def _watch(plant: Installation) -> Watch:
    read = drive_reader(plant, _VARIABLES)

    since: dict[str, int] = {}

    def broken() -> Iterator[str]:
        scan = plant.cpu.scans
        for name, (lost, tripped, running, ready) in read():
            if not (lost or tripped) or not (running or ready):
                since.pop(name, None)
            elif since.setdefault(name, scan) != scan:
                shown = "running" if running else "ready"
                yield f"{name} is shown as {shown}, and it is {'lost' if lost else 'tripped'}"

    return broken


RULE = Rule(
    "lost_is_told", "A drive that is lost or tripped is not shown as running or ready", _watch
)
