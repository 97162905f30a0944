"""A drive that has tripped or whose answer is missing is not shown as running or ready.

For one scan it may be: the poll tells what it has read behind the block of the drive. Behind a
gateway for process data a drive that is not online is one whose answer is missing, on DeviceNet one
with which the scanner exchanges no data.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.rules.drive_variables import Unit, drive_reader
from harness.rules.rule import Rule, Watch

_SHOWN = ("state.running", "state.ready")
_ON_A_LINE = ("polled.lost", "polled.tripped", *_SHOWN)
_ON_A_NETWORK = ("state.tripped", *_SHOWN)
_AT_AN_INTERFACE = ("state.online", "polled.tripped", *_SHOWN)


def _watch(plant: Installation) -> Watch:
    lines: tuple[Unit, ...] = (*plant.telegram_entries, *plant.plan.serial)
    on_lines = drive_reader(plant, lines, _ON_A_LINE)
    at_interfaces = drive_reader(plant, plant.interface_entries, _AT_AN_INTERFACE)
    on_networks = drive_reader(plant, plant.plan.devicenet, _ON_A_NETWORK)
    scanned = {
        item.name: network.scanner.slaves[item.mac]
        for network in plant.networks.values()
        for item in network.entry.drives
    }
    since: dict[str, int] = {}

    def drives() -> Iterator[tuple[str, bool, bool, bool, bool]]:
        for name, (lost, tripped, running, ready) in on_lines():
            yield name, bool(lost), bool(tripped), bool(running), bool(ready)
        for name, (online, tripped, running, ready) in at_interfaces():
            yield name, not online, bool(tripped), bool(running), bool(ready)
        for name, (tripped, running, ready) in on_networks():
            lost = not scanned[name].exchanging
            yield name, lost, bool(tripped), bool(running), bool(ready)

    def broken() -> Iterator[str]:
        scan = plant.cpu.scans
        for name, lost, tripped, running, ready in drives():
            if not (lost or tripped) or not (running or ready):
                since.pop(name, None)
            elif since.setdefault(name, scan) != scan:
                shown = "running" if running else "ready"
                yield f"{name} is shown as {shown}, and it is {'lost' if lost else 'tripped'}"

    return broken


RULE = Rule(
    "lost_is_told", "A drive that is lost or tripped is not shown as running or ready", _watch
)
