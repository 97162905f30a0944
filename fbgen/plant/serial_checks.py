"""What can be wrong with a serial line although every single field is right."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog, Drive, SerialPort
from fbgen.diagnostics import Diagnostic, Note
from fbgen.plant.families import FAMILIES, Family

if TYPE_CHECKING:
    from fbgen.plant.drive import PlantDrive
    from fbgen.plant.plant import Plant
    from fbgen.plant.serial_line import SerialLine

MODULES_OF: dict[str, tuple[str, ...]] = {
    "s7-1200": ("cm_1241",),
    "s7-1500": ("cm_ptp",),
    "s7-300": ("cp_340", "cp_341"),
    "s7-400": ("cp_440",),
    "iec": ("adapter",),
    "twincat": ("adapter",),
}
"""Which modules the instructions of a PLC family reach."""


def numbers_twice(item: "SerialLine") -> Iterator[Diagnostic]:
    """FB2006: a line on which two drives have one number."""
    first: dict[int, PlantDrive] = {}
    for drive in item.drives:
        earlier = first.setdefault(drive.inv_no, drive)
        if earlier is not drive:
            yield Diagnostic(
                "FB2006",
                f"INV-NO {drive.inv_no} is given twice on this line",
                drive.span_of("inv_no"),
                "every inverter on a line needs its own number",
                (Note("first here", earlier.span_of("inv_no")),),
            )


def line(item: "SerialLine", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2007 numbers, FB2024 no number or a channel, FB2052 what a series does not know."""
    low, high = number_range(item, catalog)
    for drive in item.drives:
        if drive.channel is not None:
            yield Diagnostic(
                "FB2024",
                "a serial line has no channels",
                drive.span_of("channel"),
                "give the drive its number on the line instead: inv_no",
            )
        elif "inv_no" not in drive.model_fields_set:
            yield Diagnostic(
                "FB2024",
                f"the drive '{drive.name}' has no number on its line",
                drive.span,
                "add inv_no: as parameter F802 of the drive has it",
            )
        elif not low <= drive.inv_no <= high:
            yield Diagnostic(
                "FB2007",
                f"no inverter can have the INV-NO {drive.inv_no} on a line with {item.protocol}",
                drive.span_of("inv_no"),
                f"use {low} to {high}",
            )
        known = catalog.drives.get(drive.series)
        if known is not None:
            yield from _series(item, drive, known)


def number_range(item: "SerialLine", catalog: Catalog) -> tuple[int, int]:
    """The numbers that drives of this line may have."""
    if item.family == "modbus":
        numbers = catalog.modbus_protocol("modbus").inv_numbers
    else:
        toshiba = catalog.toshiba_protocol("toshiba").inv_numbers
        numbers = toshiba["ascii" if item.protocol == "toshiba_ascii" else "binary"]
    return numbers.minimum, numbers.maximum


def port_of(item: "SerialLine", series: Drive) -> SerialPort | None:
    """The port of a series that such a line goes to; None where it has none."""
    if series.communication is None:
        return None
    fitting = [port for port in series.communication.ports if port.wires in (None, item.wires)]
    return fitting[0] if fitting else None


def _series(item: "SerialLine", drive: "PlantDrive", series: Drive) -> Iterator[Diagnostic]:
    """FB2052: the series has no port for the line, or does not speak as the line does."""
    place = drive.span_of("series")
    if series.communication is None:
        yield Diagnostic(
            "FB2052",
            f"no document says how {series.id} communicates on a serial line",
            place,
            "use a series whose catalogue entry has communication:",
        )
        return
    port = port_of(item, series)
    if port is None:
        has = " or ".join(f"wires: {one.wires}" for one in series.communication.ports)
        yield Diagnostic(
            "FB2052",
            f"{series.id} has no port for {item.wires} wires",
            item.span_of("wires"),
            f"write {has}, as the series is wired" if has else "the catalogue knows no port of it",
        )
        return
    if item.family not in port.protocols.values():
        yield Diagnostic(
            "FB2052",
            f"{series.id} does not speak {item.family}",
            place,
            f"it speaks {', '.join(port.protocols.values())}",
        )
        return
    service = series.communication.toshiba
    form = item.protocol.removeprefix("toshiba_")
    if item.family == "toshiba" and (service is None or form not in service.forms):
        yield Diagnostic(
            "FB2052",
            f"{series.id} does not take telegrams in {form}",
            place,
            "use the other form of the protocol",
        )
    rates = sorted(series.baud_rates(port).values())
    if item.baud not in rates:
        yield Diagnostic(
            "FB2052",
            f"{series.id} cannot be set to {item.baud} bit/s",
            item.span_of("baud"),
            f"use {', '.join(map(str, rates))}",
        )
    if item.parity not in series.parities(port).values():
        yield Diagnostic(
            "FB2052",
            f"{series.id} cannot be set to parity {item.parity}",
            item.span_of("parity"),
            f"use {', '.join(series.parities(port).values())}",
        )


def module_of(item: "SerialLine", plc: str) -> str:
    """The module of a line: the one of the plant file, or the usual one of the PLC."""
    return item.module or next(iter(MODULES_OF[plc]), "")


def place_of(item: "SerialLine", plant: "Plant") -> int | None:
    """Where the instructions of the PLC find the module; None for an adapter."""
    if module_of(item, plant.plc) == "adapter":
        return None
    return item.hardware_identifier if plant.family.hardware_identifiers else item.address


def buffer_numbers(plant: "Plant") -> dict[str, int]:
    """The data blocks through which a CP gets and gives bytes, by their usual names.

    Its instructions take them by number: the last ones that blocks of the plant may have.
    """
    last = plant.block_numbers.last
    return {
        f"TIP_Buffer_{line.name}": last - index
        for index, line in enumerate(plant.serial)
        if module_of(line, plant.plc).startswith("cp_")
    }


def frames(item: "Plant") -> Iterator[Diagnostic]:
    """FB2055: a choice of MODBUS frames for no line, or one that the PLC cannot follow."""
    if item.modbus_frames is None:
        return
    if not any(line.family == "modbus" for line in item.serial):
        yield Diagnostic(
            "FB2055",
            "modbus_frames is given, and no serial line of the plant has MODBUS",
            item.span_of("modbus_frames"),
            "leave it out: frames of the Toshiba protocol are always built by the blocks",
        )
    elif item.modbus_frames == "instruction" and not item.family.modbus_master:
        having = " and ".join(one.title for one in FAMILIES.values() if one.modbus_master)
        yield Diagnostic(
            "FB2055",
            f"{item.family.title} has no Modbus_Master",
            item.span_of("modbus_frames"),
            f"leave it out, and the blocks build the frames themselves; {having} have one",
        )


def module_problems(item: "SerialLine", family: Family) -> Iterator[Diagnostic]:
    """FB2051 a module that the PLC does not have, FB2017 no place for it."""
    known = MODULES_OF[family.name]
    module = module_of(item, family.name)
    if module not in known:
        place = item.span if item.module is None else item.span_of("module")
        what = f"a {item.module}" if item.module else "a serial line"
        message = f"blocks for {family.title} cannot reach {what}"
        yield Diagnostic("FB2051", message, place, f"use {' or '.join(known)}")
        return
    if module == "adapter":
        return
    wanted = "hardware_identifier" if family.hardware_identifiers else "address"
    if getattr(item, wanted) is None:
        yield Diagnostic(
            "FB2017",
            f"a {module} on {family.title} needs {wanted}",
            item.span,
            f"add {wanted}: as the device configuration of '{item.name}' shows it",
        )
