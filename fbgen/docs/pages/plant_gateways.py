"""What the page of a gateway says of those in the plant: addresses slot by slot, drives."""

from collections.abc import Iterator

from fbgen.catalog import DeviceNetGateway, Gateway, ProfibusGateway
from fbgen.docs.document import Block, Facts, Row, Section, Table
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, octets
from fbgen.plant import DeviceNetDrive, PlantGateway, assemblies_of, layout_of


def in_this_plant(gateway: Gateway, subject: Subject) -> Iterator[Section]:
    """One section if the site is about a plant that has such gateways, or drives with such an
    option."""
    blocks: list[Block] = []
    if subject.plant is not None and isinstance(gateway, ProfibusGateway):
        for item in subject.plant.gateways:
            if item.type == gateway.id:
                blocks += [_facts(item), _slots(item, gateway)]
    elif subject.plant is not None and isinstance(gateway, DeviceNetGateway):
        for network in subject.plant.devicenet:
            rows = [_row(drive, gateway) for drive in network.drives if drive.type == gateway.id]
            if rows:
                head = ("Drive", "MAC ID", "Assemblies", "Outputs", "Inputs")
                blocks.append(Table(head, tuple(rows), f"Network {network.name}"))
    if blocks:
        yield Section("In this plant", tuple(blocks), "plant")


def _row(drive: DeviceNetDrive, gateway: DeviceNetGateway) -> Row:
    pair = assemblies_of(drive, gateway)
    assert pair is not None, "checked when the plant was read"
    out = _bytes("QB", drive.output_address, 0, pair.output.length)
    into = _bytes("IB", drive.input_address, 0, pair.input.length)
    return Row(((drive.name,), (str(drive.mac),), (drive.assemblies,), code(out), code(into)))


def _facts(item: PlantGateway) -> Facts:
    drives = ", ".join(f"{drive.name} ({drive.channel or drive.inv_no})" for drive in item.drives)
    return Facts(
        (
            ("Gateway", (item.name,)),
            ("PROFIBUS address", (str(item.profibus_address),)),
            ("Layout", (item.layout,)),
            ("Drives", (drives,)),
        )
    )


def _slots(item: PlantGateway, gateway: ProfibusGateway) -> Table:
    rows = []
    for one in layout_of(item, gateway).parsed_identifiers:
        out = _bytes("QB", item.output_address, one.output_offset, one.output_length)
        into = _bytes("IB", item.input_address, one.input_offset, one.input_length)
        rows.append(Row(((str(one.index + 1),), code(octets(one.code)), code(out), code(into))))
    title = f"Addresses of {item.name}"
    if item.hardware_identifier is not None:
        title += f", HW-ID {item.hardware_identifier}"
    return Table(("Slot", "Identifier", "Outputs", "Inputs"), tuple(rows), title)


def _bytes(area: str, first: int | None, offset: int, length: int) -> str:
    """`QB256 to QB257`; offsets alone where the plant file names no address."""
    if not length:
        return ""
    begin = offset if first is None else first + offset
    name = area if first is not None else "byte "
    last = begin + length - 1
    return f"{name}{begin}" if length == 1 else f"{name}{begin} to {name}{last}"
