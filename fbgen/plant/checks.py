"""What can be wrong in a plant although every single field is right."""

from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, TypeAlias, TypeVar

from fbgen.catalog import (
    Catalog,
    Drive,
    Layout,
    Located,
    ProcessDataGateway,
    ProfibusGateway,
)
from fbgen.diagnostics import Diagnostic, Note
from fbgen.nearest import nearest
from fbgen.plant import serial_checks
from fbgen.plant.connections import process_data_gateway, telegram_gateway
from fbgen.plant.cpus import CPUS, cpus_of
from fbgen.plant.devicenet_checks import ACTIVE_LENGTH, assemblies_of, option_of
from fbgen.plant.drive_checks import chosen_options, frequencies, unknown_series
from fbgen.plant.families import FAMILIES, FILE_LAYOUTS, Family
from fbgen.plant.gsd_checks import gsd_problems
from fbgen.plant.modules import layout_of
from fbgen.plant.names import name_problems
from fbgen.plant.prefix import prefix_problems
from fbgen.plant.reach import not_a_way, refusal

if TYPE_CHECKING:
    from fbgen.plant.devicenet import DeviceNetDrive, DeviceNetNetwork
    from fbgen.plant.drive import PlantDrive
    from fbgen.plant.plant import BlockNumbers, Plant, PlantGateway
    from fbgen.plant.serial_line import SerialLine

    Named: TypeAlias = PlantGateway | SerialLine | PlantDrive | DeviceNetNetwork | DeviceNetDrive
    Placed: TypeAlias = tuple[PlantGateway | DeviceNetNetwork | DeviceNetDrive, str, int]

Item = TypeVar("Item", bound=Located)


def drive(item: "PlantDrive", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2009 unknown series, FB2010 maximum frequency, FB2003 options."""
    entry = catalog.drives.get(item.series)
    if entry is None:
        yield unknown_series(item, item.series, catalog)
        return
    yield from frequencies(item, item.parameters, item.max_frequency_hz, entry)
    yield from chosen_options(item, item.options, entry.options, entry.id)


FIRST_SLAVE, LAST_SLAVE = 1, 125
"""PROFIBUS addresses of slaves in use: 0 is that of programming devices, 126 the one that slaves
have before they are given theirs, 127 is for all (Brinkmann FKO PROFIBUS manual V1.7, page 24)."""


def gateway(item: "PlantGateway", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2001 type, FB2002 layout, FB2003 options, FB2004 address, FB2005 access way, FB2007
    INV-NO out of range, FB2008 series that the gateway does not serve."""
    entry = catalog.profibus_gateways.get(item.type)
    if entry is None:
        message = f"there is no gateway type '{item.type}'"
        if item.type in catalog.gateways:
            message = f"a {item.type} is no slave on PROFIBUS"
            help_text = "write the drive that it is in under devicenet:"
        else:
            help_text = nearest(item.type, catalog.profibus_gateways)
        yield Diagnostic("FB2001", message, item.span_of("type"), help_text)
        return
    low, high = entry.profibus.minimum_address, entry.profibus.maximum_address
    if not low <= item.profibus_address <= high:
        yield Diagnostic(
            "FB2004",
            f"the switches of {entry.id} cannot be set to PROFIBUS address {item.profibus_address}",
            item.span_of("profibus_address"),
            f"use {max(low, FIRST_SLAVE)} to {min(high, LAST_SLAVE)}",
        )
    elif not FIRST_SLAVE <= item.profibus_address <= LAST_SLAVE:
        owner = "programming devices" if item.profibus_address == 0 else "devices without address"
        yield Diagnostic(
            "FB2004",
            f"PROFIBUS address {item.profibus_address} is kept for {owner}, not for slaves in use",
            item.span_of("profibus_address"),
            f"use {max(low, FIRST_SLAVE)} to {min(high, LAST_SLAVE)}",
        )
    yield from _layout(item, entry)
    yield from gsd_problems(item, entry)
    yield from chosen_options(item, item.options, entry.options, entry.id)
    if isinstance(entry, ProcessDataGateway):
        yield from process_data_gateway(item, entry)
    else:
        yield from telegram_gateway(item, catalog.toshiba_protocol(entry.protocol))
    for member in item.drives:
        known: Drive | None = catalog.drives.get(member.series)
        if known is not None and known.id not in entry.series:
            yield Diagnostic(
                "FB2008",
                f"{entry.id} does not serve {known.id}",
                member.span_of("series"),
                f"it serves {', '.join(entry.series)}",
            )


def _layout(item: "PlantGateway", entry: ProfibusGateway) -> Iterator[Diagnostic]:
    names = [layout.name for layout in entry.layouts]
    if item.gsd is not None and not item.layout:
        return
    if item.layout not in names:
        message = f"{entry.id} has no layout '{item.layout}'"
        help_text = nearest(item.layout, names)
        yield Diagnostic("FB2002", message, item.span_of("layout"), help_text)
        return
    layout = layout_of(item, entry)
    if item.access in layout.access_ways:
        return
    others = [other.name for other in entry.layouts if item.access in other.access_ways]
    help_text = f"use {' or '.join(layout.access_ways)}"
    if others:
        help_text += f", or the layout {' or '.join(others)}"
    yield Diagnostic(
        "FB2005",
        f"layout '{layout.name}' cannot be reached by {item.access}: {not_a_way(item.access)}",
        item.span_of("access"),
        help_text,
    )


def block_numbers(item: "BlockNumbers") -> Iterator[Diagnostic]:
    """FB2020: a range that ends before it begins."""
    if item.last < item.first:
        yield Diagnostic(
            "FB2020",
            f"the numbers of the blocks go from {item.first} to {item.last}",
            item.span_of("last"),
            "write the lowest number as first, the highest as last",
        )


def places_of_drives(item: "PlantGateway") -> Iterator[Diagnostic]:
    """FB2006: one INV-NO or one channel for two drives of one gateway."""
    yield from _twice(
        [member for member in item.drives if member.channel],
        "channel",
        lambda member: str(member.channel),
        code="FB2006",
        message="channel {} is given twice on this gateway",
        help_text="a gateway has one drive at each of its channels",
    )
    yield from _twice(
        [member for member in item.drives if "inv_no" in member.model_fields_set],
        "inv_no",
        lambda member: str(member.inv_no),
        code="FB2006",
        message="INV-NO {} is given twice on this gateway",
        help_text="every inverter on a line needs its own number",
    )


def plant(item: "Plant") -> Iterator[Diagnostic]:
    """FB2050 no drives, FB2012, FB2013 and FB2021 names, FB2014 dialect, FB2015 PROFIBUS
    addresses, FB2019 identifiers, FB2022 files."""
    if not item.units:
        yield Diagnostic(
            "FB2050",
            "the plant has nothing that drives are connected to",
            item.span,
            "add gateways: with a gateway, serial: with a line at a communication module, or "
            "devicenet: with a network at a scanner",
        )
    named: list[Named] = [*item.units, *item.drives]
    parts: tuple[Plant | Named, ...] = (item, *named)
    for part in parts:
        yield from name_problems(part.name, part.span_of("name"), item.prefix)
    yield from prefix_problems(item.prefix, item.span_of("prefix"))
    yield from _twice(
        named,
        "name",
        lambda part: part.name.lower(),
        code="FB2013",
        message="the name '{}' is given twice",
        help_text="upper and lower case are the same in a PLC: choose names that differ otherwise",
    )
    if item.dialect not in item.family.dialects:
        fitting = [family.name for family in FAMILIES.values() if item.dialect in family.dialects]
        yield Diagnostic(
            "FB2014",
            f"{item.family.title} does not read the dialect {item.dialect}",
            item.span_of("dialect"),
            f"write dialect: {' or '.join(item.family.dialects)}, or plc: {' or '.join(fitting)}",
        )
    layouts = FILE_LAYOUTS[item.dialect]
    if item.files is not None and item.files not in layouts:
        yield Diagnostic(
            "FB2022",
            f"the dialect {item.dialect} cannot be written with files: {item.files}",
            item.span_of("files"),
            f"write files: {' or '.join(layouts)}, or leave it out",
        )
    yield from _cpu(item)
    yield from _twice(
        item.gateways,
        "profibus_address",
        lambda part: f"{part.dp_master} {part.profibus_address}",
        code="FB2015",
        message="the PROFIBUS address {} is given twice",
        help_text="every slave of a DP master system (dp_master) needs its own address",
    )
    placed = item.gateways_and_lines
    with_identifier = [part for part in placed if part.hardware_identifier is not None]
    yield from _twice(
        with_identifier,
        "hardware_identifier",
        lambda part: str(part.hardware_identifier),
        code="FB2019",
        message="the hardware identifier {} is given twice",
        help_text="look it up in the device configuration of each of them",
    )
    for part in item.serial:
        yield from serial_checks.module_problems(part, item.family)
    yield from serial_checks.frames(item)


def _cpu(item: "Plant") -> Iterator[Diagnostic]:
    """FB2023: a CPU that is not known, or not of the family."""
    known = [cpu.name for cpu in cpus_of(item.plc)]
    if item.cpu is None or item.cpu in known:
        return
    other = CPUS.get(item.cpu)
    if other is not None:
        message = f"the CPU {other.name} is no {item.family.title}"
    else:
        message = f"the work memory of a CPU '{item.cpu}' is not known"
    listed = f"known are {', '.join(known)}; " if known else ""
    yield Diagnostic("FB2023", message, item.span_of("cpu"), f"{listed}leave out cpu: for another")


def sequences(item: "Plant", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2011: a sequence that is not there, stands twice, or fits no drive of the plant.

    Whether it fits is not said while a drive has a series that is not there (FB2009).
    """
    on_lines = [part for part in item.gateways if not _is_process_data(part, catalog)]
    members = [member for part in on_lines for member in part.drives]
    members += [member for part in item.serial for member in part.drives]
    series = {member.series for member in members}
    known = series <= catalog.drives.keys()
    for index, name in enumerate(item.sequences):
        span = item.item_span_of("sequences", index)
        entry = catalog.sequences.get(name)
        if entry is None:
            message = f"there is no sequence '{name}'"
            yield Diagnostic("FB2011", message, span, nearest(name, catalog.sequences))
        elif name in item.sequences[:index]:
            yield Diagnostic("FB2011", f"the sequence '{name}' stands twice", span)
        elif known and not series & set(entry.series):
            message = f"the sequence '{name}' fits no drive of this plant"
            help_text = f"it is made for {', '.join(entry.series)}"
            if not on_lines and not item.serial:
                help_text = "sequences are telegrams, and no gateway of this plant sends telegrams"
            yield Diagnostic("FB2011", message, span, help_text)


def addresses(item: "Plant", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2016 overlapping data, FB2017 missing address, FB2018 beyond the area, FB2005 access."""
    layouts = [(part, found) for part in item.gateways if (found := _found(part, catalog))]
    for part, layout in layouts:
        if part.access in layout.access_ways:
            yield from _reachable(part, layout, item.family)
    inputs: list[Placed] = []
    outputs: list[Placed] = []
    for part, layout in layouts:
        inputs.append((part, "input_address", layout.input_length))
        outputs.append((part, "output_address", layout.output_length))
    for network in item.devicenet:
        inputs.append((network, "active_address", ACTIVE_LENGTH))
        for member in network.drives:
            option = option_of(member, catalog)
            pair = None if option is None else assemblies_of(member, option)
            if pair is not None:
                inputs.append((member, "input_address", pair.input.length))
                outputs.append((member, "output_address", pair.output.length))
    yield from _overlaps(inputs, "input", item.family)
    yield from _overlaps(outputs, "output", item.family)


def _found(part: "PlantGateway", catalog: Catalog) -> Layout | None:
    entry = catalog.profibus_gateways.get(part.type)
    if entry is None:
        return None
    known = any(layout.name == part.layout for layout in entry.layouts)
    return layout_of(part, entry) if known else None


def _is_process_data(part: "PlantGateway", catalog: Catalog) -> bool:
    return isinstance(catalog.profibus_gateways.get(part.type), ProcessDataGateway)


def _reachable(part: "PlantGateway", layout: Layout, family: Family) -> Iterator[Diagnostic]:
    found = refusal(part.access, layout.parsed_identifiers, family, f"layout '{layout.name}'")
    if found is not None:
        yield Diagnostic("FB2005", found.message, part.span_of("access"), found.help)
        if part.access != "process_image":
            return
    by_identifier = part.access == "dpxx_dat" and family.hardware_identifiers
    needed = ["hardware_identifier"] if by_identifier else ["input_address", "output_address"]
    for field in needed:
        if getattr(part, field) is None:
            yield Diagnostic(
                "FB2017",
                f"{part.access} on {family.title} needs {field}",
                part.span_of("access"),
                f"add {field}: as the device configuration of gateway '{part.name}' shows it",
            )


def _overlaps(places: "list[Placed]", area: str, family: Family) -> Iterator[Diagnostic]:
    taken: list[tuple[int, int, str, Located, str]] = []
    for part, field, length in places:
        first: int | None = getattr(part, field)
        if first is None:
            continue
        last = first + length - 1
        if first < 0 or last > family.last_address:
            yield Diagnostic(
                "FB2018",
                f"{area} bytes {first} to {last} lie outside the area of {family.title}",
                part.span_of(field),
                f"the area goes from 0 to {family.last_address}",
            )
        for other_first, other_last, name, other, other_field in taken:
            if first <= other_last and other_first <= last:
                yield Diagnostic(
                    "FB2016",
                    f"{area} bytes {first} to {last} of '{part.name}' overlap "
                    f"{other_first} to {other_last} of '{name}'",
                    part.span_of(field),
                    f"the next free byte is {max(end for _, end, *_ in taken) + 1}",
                    (Note("taken here", other.span_of(other_field)),),
                )
                break
        taken.append((first, last, part.name, part, field))


def _twice(
    items: Iterable[Item],
    field: str,
    key: Callable[[Item], str],
    *,
    code: str,
    message: str,
    help_text: str,
) -> Iterator[Diagnostic]:
    first: dict[str, Item] = {}
    for item in items:
        earlier = first.setdefault(key(item), item)
        if earlier is not item:
            shown = getattr(item, field)
            notes = (Note("first here", earlier.span_of(field)),)
            text = message.format(shown)
            yield Diagnostic(code, text, item.span_of(field), help_text, notes)
