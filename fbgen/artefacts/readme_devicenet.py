"""What README.md says about DeviceNet: networks, where the bytes of each drive lie, what is set."""

from collections.abc import Iterator

from fbgen.artefacts.view import PlantLists
from fbgen.blocks.dev_assemblies import has_command_word, has_links, pair_of
from fbgen.plant import ACTIVE_LENGTH, DeviceNetDrive, DeviceNetNetwork

_CONNECTIONS = {
    "polled": ("polled", "gepollt"),
    "change_of_state": ("polled, change of state", "gepollt, bei Änderung"),
    "cyclic": ("polled, cyclic", "gepollt, zyklisch"),
}


def network_rows(lists: PlantLists) -> Iterator[dict[str, object]]:
    """The networks, each with its drives, for the hardware configuration."""
    for network in lists.plant.devicenet:
        yield {
            "name": network.name,
            "rate": network.rate,
            "mac": network.mac,
            "table": _table(network),
            "drives": [_drive(lists, drive) for drive in network.drives],
        }


def without_links(lists: PlantLists) -> list[str]:
    """The drives whose assemblies cannot take the command away from their terminals."""
    catalog = lists.catalog
    return [
        drive.name
        for drive in lists.plant.devicenet_drives
        if not has_links(pair_of(drive, catalog.devicenet_gateway(drive.type)))
    ]


def without_command_word(lists: PlantLists) -> list[str]:
    """The drives whose assemblies know no emergency stop, no coast, no jog and no preset speed."""
    catalog = lists.catalog
    return [
        drive.name
        for drive in lists.plant.devicenet_drives
        if not has_command_word(pair_of(drive, catalog.devicenet_gateway(drive.type)))
    ]


def _table(network: DeviceNetNetwork) -> str:
    first = network.active_address
    assert first is not None, "checked before"
    return f"IB{first} - IB{first + ACTIVE_LENGTH - 1}"


def _drive(lists: PlantLists, drive: DeviceNetDrive) -> dict[str, object]:
    pair = pair_of(drive, lists.catalog.devicenet_gateway(drive.type))
    first_in, first_out = drive.input_address, drive.output_address
    return {
        "name": drive.name,
        "mac": drive.mac,
        "assemblies": drive.assemblies,
        "connection": lists.in_words(*_CONNECTIONS[drive.connection]),
        "rate": drive.packet_rate_ms,
        "inputs": f"IB{first_in} - IB{first_in + pair.input.length - 1}",
        "outputs": f"QB{first_out} - QB{first_out + pair.output.length - 1}",
    }
