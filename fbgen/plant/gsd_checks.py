"""Where the GSD file that a plant file names contradicts the catalogue, or the plant file itself.

What would make the generated blocks wrong on that device is an error. What they do not depend on,
such as Sync and Freeze, is a warning: file and catalogue are of different versions of the device.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog, ProfibusGateway, PublishedProfibus
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.plant.gsd_file import configuration_of, plugged

if TYPE_CHECKING:
    from fbgen.plant.plant import Plant, PlantGateway
    from fbgen.wire.gsd import Configuration, GsdStation


def gsd_problems(item: "PlantGateway", entry: ProfibusGateway) -> Iterator[Diagnostic]:
    """FB2040 keys that do not go together, FB2041 another device, FB2042 other lengths, and what is
    wrong in the file: FB1008, FB1301 to FB1306, FB1310, FB1311."""
    if item.gsd is None:
        if item.modules:
            yield Diagnostic(
                "FB2040",
                "modules are those of a GSD file, and there is none",
                item.span_of("modules"),
                "name it with gsd:, or leave modules out",
            )
        return
    if item.identifiers is not None:
        yield Diagnostic(
            "FB2040",
            "identifiers and gsd both say what the module's identifiers are",
            item.span_of("identifiers"),
            "leave identifiers out: they stand in the GSD file",
        )
    yield from item.gsd.findings
    station = item.gsd.station
    if station is None:
        return
    if other := list(_other_device(item, entry, station)):
        yield from other
        return
    layout = next((one for one in entry.layouts if one.name == item.layout), None)
    if layout is None and item.layout:
        return
    try:
        chosen = configuration_of(item, layout)
    except DiagnosticError as wrong:
        yield from wrong.diagnostics
        return
    if layout is not None:
        yield from _other_lengths(item, entry, chosen)


def gsd_warnings(plant: "Plant", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2043: what the file and the catalogue say differently and no block depends on; and what was
    wrong in the file and did no harm."""
    for item in plant.gateways:
        if item.gsd is None or item.gsd.station is None:
            continue
        yield from item.gsd.station.warnings
        entry = catalog.profibus_gateway(item.type)
        chosen = plugged(item, entry)
        if chosen is not None:
            yield from _other_identifiers(item, entry, chosen)
        yield from _other_features(item, entry, item.gsd.station)


def _other_device(
    item: "PlantGateway", entry: ProfibusGateway, station: "GsdStation"
) -> Iterator[Diagnostic]:
    place = item.span_of("gsd")
    if station.is_master:
        yield Diagnostic(
            "FB2041", f"{station.source.name} describes a DP master, not a slave", place,
            f"name the file of the {entry.id}",
        )  # fmt: skip
        return
    known: int | None = None
    where = f"the catalogue says for {entry.id}"
    if isinstance(entry.profibus, PublishedProfibus):
        known = entry.profibus.ident_number
    elif "ident_number" in item.options:
        known = int(item.options["ident_number"])
        where = "the option ident_number says"
    if known is not None and known != station.ident_number:
        yield Diagnostic(
            "FB2041",
            f"{station.source.name} is the file of another device: its ident number is "
            f"{station.ident_number:04X}, {where} {known:04X}",
            place,
            "the blocks are made for the device of the catalogue: name its GSD file",
        )


def _other_lengths(
    item: "PlantGateway", entry: ProfibusGateway, chosen: "Configuration"
) -> Iterator[Diagnostic]:
    layout = entry.layout(item.layout)
    found = (chosen.output_length, chosen.input_length)
    wanted = (layout.output_length, layout.input_length)
    if found == wanted:
        return
    fitting = [
        one.name
        for one in entry.layouts
        if (one.output_length, one.input_length) == found and not one.invented
    ]
    place = item.span_of("layout")
    if fitting:
        help_text = f"write layout: {' or '.join(fitting)}, or leave layout out"
    else:
        listed = (f"{one.output_length} and {one.input_length}" for one in entry.layouts)
        help_text = f"the blocks know modules with {', '.join(dict.fromkeys(listed))} bytes"
    yield Diagnostic(
        "FB2042",
        f"{chosen.names} of {chosen.station.source.name} carries {found[0]} bytes out and "
        f"{found[1]} in, layout '{layout.name}' has {wanted[0]} and {wanted[1]}",
        item.span_of("gsd") if place == item.span else place,
        help_text,
    )


def _other_identifiers(
    item: "PlantGateway", entry: ProfibusGateway, chosen: "Configuration"
) -> Iterator[Diagnostic]:
    layout = entry.layout(item.layout)
    if layout.identifiers != chosen.code and "identifiers" not in layout.unverified:
        yield _differs(
            item,
            f"the identifiers of {chosen.names} are {chosen.code.hex(' ').upper()}, those of "
            f"layout '{layout.name}' {layout.identifiers.hex(' ').upper()}",
            "the blocks follow the GSD file",
        )


def _other_features(
    item: "PlantGateway", entry: ProfibusGateway, station: "GsdStation"
) -> Iterator[Diagnostic]:
    profibus = entry.profibus
    pairs: list[tuple[str, object, object]] = [
        ("Sync", station.sync, profibus.sync),
        ("Freeze", station.freeze, profibus.freeze),
        ("automatic recognition of the rate", station.auto_baud, profibus.auto_baud),
        ("Set_Slave_Add", station.set_slave_address, profibus.set_slave_address),
    ]
    if isinstance(profibus, PublishedProfibus):
        times = {rate.name: rate.max_tsdr for rate in station.rates}
        pairs += [
            ("Fail_Safe", station.fail_safe, profibus.fail_safe),
            ("Max_Diag_Data_Len", station.max_diagnosis_bytes, profibus.max_diagnosis_bytes),
            (
                "Min_Slave_Intervall in us",
                station.min_slave_interval_us,
                profibus.min_slave_interval_us,
            ),
            *(
                (f"MaxTsdr at {rate}", times.get(rate, "missing"), bits)
                for rate, bits in profibus.max_tsdr_bits.items()
            ),
        ]
    for what, found, known in pairs:
        if found != known:
            yield _differs(
                item,
                f"{what}: {_shown(found)} in {station.source.name}, {_shown(known)} in the "
                f"catalogue for {entry.id}",
                "no block depends on it; one of them is of another version of the device",
            )


def _differs(item: "PlantGateway", message: str, help_text: str) -> Diagnostic:
    place = item.span_of("gsd")
    return Diagnostic("FB2043", message, place, help_text, severity=Severity.WARNING)


def _shown(value: object) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "not said" if value is None else str(value)
