"""The blocks for serial lines of the PLC: telegrams, the line, its drives.

What orders telegrams, runs a drive and reads its state is that of lines behind gateways, from the
same templates; only who sends a telegram differs.
"""

from collections.abc import Iterator, Sequence

from fbgen.blocks.alarms import drive_alarms, that_can_come
from fbgen.blocks.drive_words import drive_context
from fbgen.blocks.family import FamilyPlan
from fbgen.blocks.line_blocks import (
    COMMANDS_IN_A_ROW,
    EMERGENCY_STOP,
    LINE_TYPES,
    eeprom_writes,
)
from fbgen.blocks.literals import SclText, byte, word
from fbgen.blocks.plant_sequences import sequence_context
from fbgen.blocks.same_text import as_text
from fbgen.blocks.sequences import SequenceView
from fbgen.blocks.serial_alarms import SERIAL_ALARMS
from fbgen.blocks.serial_lines import SerialLineView, serial_line_view
from fbgen.blocks.specs import BlockSpec, block, data_block, data_type
from fbgen.blocks.texts import Texts
from fbgen.blocks.words import bits_origin
from fbgen.catalog import Catalog, Drive, SerialPort, origin
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.plant import Plant, PlantDrive, PlantGateway, SerialLine, port_of

_FREEPORT = {
    "send": "{InstructionName := 'Send_P2P'; LibVersion := '3.0'} : Send_P2P",
    "receive": "{InstructionName := 'Receive_P2P'; LibVersion := '3.0'} : Receive_P2P",
}
_MODBUS_MASTER = {
    "load": "{InstructionName := 'Modbus_Comm_Load'; LibVersion := '3.0'} : Modbus_Comm_Load",
    "master": "{InstructionName := 'Modbus_Master'; LibVersion := '3.0'} : Modbus_Master",
}
"""How instances of the instructions are declared; which versions a project has is unverified."""
_FIRST_REGISTER = 400001
"""DATA_ADDR of register 0: S7-1200 System Manual A5E02486680, 13.5, "Modbus_Master"."""


def serial_problems(
    plant: Plant, gateways: Sequence[PlantGateway], catalog: Catalog
) -> Iterator[Diagnostic]:
    """FB5017: series that blocks of one text cannot serve together, on all lines of the plant."""
    used: list[tuple[PlantDrive, SerialPort | None]] = [
        (drive, None) for item in gateways for drive in item.drives
    ]
    used += [(drive, port_of(line, catalog.drive(drive.series))) for line, drive in _drives(plant)]
    first: tuple[object, str] | None = None
    for drive, port in used:
        known = _told(catalog.drive(drive.series), catalog, port)
        if first is None:
            first = known, drive.series
        elif known != first[0]:
            yield Diagnostic(
                "FB5017",
                f"the series '{drive.series}' has other words or numbers than '{first[1]}', and "
                "the blocks of all lines of a plant have one text",
                drive.span_of("series"),
                "make a plant file of its own for each of them",
            )
            return


def _drives(plant: Plant) -> Iterator[tuple[SerialLine, PlantDrive]]:
    for line in plant.serial:
        for drive in line.drives:
            yield line, drive


def _told(series: Drive, catalog: Catalog, port: SerialPort | None) -> object:
    return as_text(drive_context(series, catalog, port))


def serial_family(plant: Plant, catalog: Catalog, texts: Texts) -> FamilyPlan:
    """What the serial lines need; there is at least one. Raises DiagnosticError FB5001."""
    of_sequences = sequence_context(plant, catalog, texts)
    sequences = of_sequences.views
    units = tuple(serial_line_view(plant, item, catalog) for item in plant.serial)
    first = plant.serial[0]
    series = catalog.drive(first.drives[0].series)
    port = port_of(first, series)
    assert port is not None, "checked when the plant was read"
    context: dict[str, object] = {
        "most_drives": max(len(item.drives) for item in plant.serial),
        **of_sequences.context,
        "tip_alarms": {
            "line": that_can_come(SERIAL_ALARMS, plant.serial),
            "drive": that_can_come(drive_alarms([item.id for item in sequences]), plant.serial),
        },
        "modbus_numbers": _modbus(catalog),
        "freeport": _FREEPORT,
        "modbus_by_instruction": plant.modbus_by_instruction,
        "modbus_master": _MODBUS_MASTER,
    }
    context |= drive_context(series, catalog, port)
    of_lines = _of_lines(series, units, texts)
    return FamilyPlan(
        units=units,
        types=list(_types(units, sequences)),
        blocks=list(_blocks(units, sequences, of_lines)),
        data=[
            data_block(f"TIP_Serial_{item.name}_DB", "TIP_Serial_DB", {"unit": item})
            for item in units
        ],
        exchanged=list(_exchanged(units)),
        context=context | of_lines,
        warnings=(*eeprom_writes(plant, catalog), *_slow_polls(plant, units)),
    )


def _types(
    units: tuple[SerialLineView, ...], sequences: tuple[SequenceView, ...]
) -> Iterator[BlockSpec]:
    own_frames = any(unit.port_kind != "modbus_master" for unit in units)
    yield data_type("typeTipPort", "", {"own_frames": own_frames})
    for name in ("typeTipLine", *LINE_TYPES):
        yield data_type(name)
    if any(unit.port_kind == "adapter" for unit in units):
        yield data_type("typeTipAdapter")
    for item in sequences:
        yield data_type(f"typeTos_{item.id}", "typeTosSeq", {"sequence": item})
    yield data_type("typeTosDrive")
    for unit in units:
        for name in ("typeTipSerial", "typeTipParam"):
            yield data_type(f"{name}_{unit.name}", name, {"unit": unit})


def _blocks(
    units: tuple[SerialLineView, ...],
    sequences: tuple[SequenceView, ...],
    of_lines: dict[str, object],
) -> Iterator[BlockSpec]:
    for line_block, telegram in (("TIP_Line", "TIP_Telegram"), ("MB_Line", "MB_Telegram")):
        if any(item.line_block == line_block for item in units):
            yield block(telegram, "", of_lines)
            yield block(line_block, "", of_lines)
    yield block("TIP_Drive", "", {"line_block": units[0].line_block})
    polls = dict.fromkeys(item.poll_block for item in units if item.status_poll)
    for name in polls:
        yield block(name)
    if polls:
        yield block("TOS_TripText")
    for item in sequences:
        yield block(f"TOS_Seq_{item.id}", "TOS_Seq", {"sequence": item})
    if sequences:
        yield block("TOS_Sequences")
    yield block("TIP_Alarms")
    for name in ("TIP_Port", "TIP_Serial"):
        for unit in units:
            yield block(f"{name}_{unit.name}", name, {"unit": unit})


def _exchanged(units: tuple[SerialLineView, ...]) -> Iterator[BlockSpec]:
    """Data blocks through which bytes go to modules that take no variables."""
    for item in units:
        if item.port_kind in ("cp34x", "modbus_master"):
            yield data_block(f"TIP_Buffer_{item.name}", "TIP_Buffer", {"unit": item})
    adapted = [item for item in units if item.port_kind == "adapter"]
    if adapted:
        yield data_block("TIP_Adapters", "", {"adapted": adapted})


def _of_lines(series: Drive, units: tuple[SerialLineView, ...], texts: Texts) -> dict[str, object]:
    """What TIP_Line and TIP_Telegram are told, beside what every line knows."""
    bits = series.command_word
    place = bits_origin(series.id, bits, EMERGENCY_STOP)
    wait_ms = max(item.times.wait_ms for item in units)
    stop_ms = max(item.times.emergency_stop_ms for item in units)
    first = units[0]
    times = first.timeout.origin
    return {
        "times": {"timeout": first.timeout, "gap": first.gap, "silence": first.silence},
        "line": {
            "commands_in_a_row": COMMANDS_IN_A_ROW,
            "emergency_stop": word(bits.encode(EMERGENCY_STOP), place),
            "longest_wait_comment": SclText(
                texts("{time} ms at most", time=f"{wait_ms:.0f}"), times
            ),
            "longest_stop_comment": SclText(
                texts("{time} ms at most", time=f"{stop_ms:.0f}"), times
            ),
        },
    }


def _modbus(catalog: Catalog) -> dict[str, SclText]:
    protocol = catalog.modbus_protocol("modbus")
    numbers, crc = protocol.inv_numbers, protocol.crc
    functions = {item.name: item for item in protocol.functions}
    read, write = functions["read"], functions["write"]
    return {
        "minimum": SclText(str(numbers.minimum), origin("inverter numbers", numbers)),
        "maximum": SclText(str(numbers.maximum), origin("inverter numbers", numbers)),
        "polynomial": word(crc.polynomial, origin("CRC", crc, crc.source or "")),
        "read": byte(read.code, origin("function 03", read, read.source or "")),
        "write": byte(write.code, origin("function 06", write, write.source or "")),
        "first_register": SclText(str(_FIRST_REGISTER), origin("register numbers", protocol)),
        "exception": byte(protocol.exception_bit, origin("exception bit", protocol)),
    }


def _slow_polls(plant: Plant, units: tuple[SerialLineView, ...]) -> Iterator[Diagnostic]:
    """FB5014: a round takes longer than the plant allows."""
    for line, view in zip(plant.serial, units, strict=True):
        if line.status_poll and view.times.round_ms > plant.poll_limit_ms:
            yield Diagnostic(
                "FB5014",
                f"reading the state of the {len(line.drives)} drives of '{line.name}' takes about "
                f"{view.times.round_ms:.0f} ms, more than poll_limit_ms ({plant.poll_limit_ms:g})",
                line.span_of("name"),
                f"a read takes {view.times.read_ms:.0f} ms, four of them a drive: put fewer drives "
                "on one line, or allow more by poll_limit_ms",
                severity=Severity.WARNING,
            )
