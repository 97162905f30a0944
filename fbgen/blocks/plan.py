"""The list of blocks, types and data blocks that a plant needs, in the order of dependence."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from fbgen.blocks.alarms import LINE_ALARMS, drive_alarms, that_can_come
from fbgen.blocks.gateways import GatewayView, gateway_view, missing_fields, several_masters
from fbgen.blocks.literals import SclText, byte, comno, milliseconds, one_line, source_text, word
from fbgen.blocks.names import name_conflicts
from fbgen.blocks.poll_cycle import slow_polls
from fbgen.blocks.sequences import SequenceView, sequence_view
from fbgen.blocks.texts import ENGLISH, Texts
from fbgen.blocks.words import WordView, bits_origin
from fbgen.catalog import Catalog, ComNo, Drive, TelegramGateway, Trip, WriteStep, origin
from fbgen.catalog.sourced import Duration
from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.plant import Plant

_TIMER = "{InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME"
_CLASSIC_TIMER = ": TON"
"""How an instance of the on-delay timer is declared; TON is SFB 4 on S7-300/400."""


_WITH_STARTUP_BLOCKS = ("tia", "step7")
"""Dialects of PLCs that may keep data over a restart, and have OB100 to say so."""
_LONGEST_PAUSE_MS = 200.0
_LONGEST_PAUSE_CYCLES = 5
"""How long after a call the next one counts as a start of the PLC where no block says so."""
ERROR_BLOCKS = ("OB82", "OB85", "OB86", "OB122")
"""The organization blocks without which an error event takes an S7-300/400 to STOP."""
SERIAL_COMMANDS = "serial communication"
"""What the value of a command source is called in the catalogue that stands for the network."""
_LONGEST_TRIP_TEXT = 40
_COMMANDS_IN_A_ROW = 8
"""Telegrams of drives after which the status poll has its turn, while more of them wait."""
_EMERGENCY_STOP = ("network_command", "network_frequency", "emergency_stop")
"""The bits of the command word that stop a drive at once."""


@dataclass(frozen=True, slots=True)
class BlockSpec:
    """One unit to generate: its name, its template and what only this unit is told.

    `kind` is "udt", "scl" or "db", as TIA Portal calls its source files.
    """

    name: str
    kind: str
    template: str
    context: Mapping[str, object] = field(default_factory=dict)

    @property
    def subject(self) -> str:
        """The gateway or the sequence that it is made for, "" where it is made for the plant."""
        made_for = self.context.get("gateway") or self.context.get("sequence")
        if isinstance(made_for, GatewayView):
            return made_for.name
        return made_for.id if isinstance(made_for, SequenceView) else ""


@dataclass(frozen=True, slots=True)
class BlockPlan:
    """All units of a plant, and what every template is told."""

    specs: tuple[BlockSpec, ...]
    context: Mapping[str, object]
    warnings: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class PlantView:
    """The plant as templates see it."""

    name: str
    most_drives: int


def plan_blocks(plant: Plant, catalog: Catalog, texts: Texts = ENGLISH) -> BlockPlan:
    """Which blocks the plant needs; the catalogue is in the language of `texts` already.

    Raises DiagnosticError for what cannot be generated.
    """
    known = [catalog.sequence(name) for name in plant.sequences]
    found = [*name_conflicts(plant, known), *missing_fields(plant, catalog), *_other_types(plant)]
    if found:
        raise DiagnosticError(found)
    drives = _series(plant, catalog)
    sequences = tuple(_sequence(name, drives, catalog, texts) for name in plant.sequences)
    gateways = tuple(gateway_view(plant, item, catalog) for item in plant.gateways)
    context = _plant_context(plant, gateways, sequences)
    context |= _gateway_context(catalog.telegram_gateway(plant.gateways[0].type))
    context |= _drive_context(drives[0], catalog, texts)
    first = gateways[0]
    context["times"] = {"timeout": first.timeout, "gap": first.gap, "apart": first.apart}
    context["line"] = _line_context(drives[0], gateways, texts)
    specs = [*_types(gateways, sequences), *_blocks(gateways, sequences), *_data(gateways)]
    if plant.dialect in _WITH_STARTUP_BLOCKS:
        specs.append(_block("TOS_Restart"))
    if plant.has_error_blocks:
        specs.append(BlockSpec("TOS_Errors", "db", "data/TOS_Errors.db.jinja"))
        specs += [_block(name) for name in ERROR_BLOCKS]
    warnings = (*_eeprom_writes(plant, catalog), *slow_polls(plant, catalog))
    return BlockPlan(tuple(specs), context, warnings)


def _other_types(plant: Plant) -> Iterator[Diagnostic]:
    """The TOS blocks carry the words and the trigger of one type of gateway."""
    first = plant.gateways[0]
    for gateway in plant.gateways:
        if gateway.type != first.type:
            yield Diagnostic(
                "FB5009",
                f"the gateway '{gateway.name}' is a {gateway.type}, '{first.name}' a {first.type}, "
                "and the blocks of one plant are made for one type",
                gateway.span_of("type"),
                "make a plant file of its own for each type",
            )


def _types(
    gateways: tuple[GatewayView, ...], sequences: tuple[SequenceView, ...]
) -> list[BlockSpec]:
    line = ("Input", "Output", "Request", "Reply", "Channel", "Line")
    plain = (*line, "Control", "State", "Polled", "LineParam", "DriveParam")
    specs = [_type(f"typeTos{name}") for name in plain]
    specs += [_type(f"typeTos_{item.id}", "typeTosSeq", {"sequence": item}) for item in sequences]
    specs.append(_type("typeTosDrive"))
    specs += [
        _type(f"{name}_{item.name}", name, {"gateway": item})
        for item in gateways
        for name in ("typeTosGateway", "typeTosParam")
    ]
    return specs


def _blocks(
    gateways: tuple[GatewayView, ...], sequences: tuple[SequenceView, ...]
) -> list[BlockSpec]:
    names = ["TOS_HzToWord", "TOS_WordToHz", "TOS_WordToPercent"]
    names += [
        "TOS_TriggerCounter",
        "TOS_Handshake",
        "TOS_Telegram",
        "TOS_Line",
        "TOS_Drive",
    ]
    if any(item.status_poll for item in gateways):
        names += ["TOS_StatusPoll", "TOS_TripText"]
    specs = [_block(name) for name in names]
    specs += [_block(f"TOS_Seq_{item.id}", "TOS_Seq", {"sequence": item}) for item in sequences]
    if sequences:
        specs.append(_block("TOS_Sequences"))
    specs.append(_block("TOS_Alarms"))
    for name in ("TOS_ConsistentIo", "TOS_Gateway"):
        specs += [_block(f"{name}_{item.name}", name, {"gateway": item}) for item in gateways]
    return specs


def _data(gateways: tuple[GatewayView, ...]) -> list[BlockSpec]:
    specs = [BlockSpec("TOS_Plant", "db", "data/TOS_Plant.db.jinja")]
    specs += [
        BlockSpec(
            f"TOS_Gateway_{item.name}_DB",
            "db",
            "data/TOS_Gateway_DB.db.jinja",
            {"gateway": item},
        )
        for item in gateways
    ]
    specs.append(BlockSpec("TOS_Parameters", "db", "data/TOS_Parameters.db.jinja"))
    specs.append(_block("TOS_Main"))
    return specs


def _type(name: str, template: str = "", context: Mapping[str, object] | None = None) -> BlockSpec:
    return BlockSpec(name, "udt", f"types/{template or name}.udt.jinja", context or {})


def _block(name: str, template: str = "", context: Mapping[str, object] | None = None) -> BlockSpec:
    return BlockSpec(name, "scl", f"blocks/{template or name}.scl.jinja", context or {})


def _series(plant: Plant, catalog: Catalog) -> list[Drive]:
    names = dict.fromkeys(drive.series for gateway in plant.gateways for drive in gateway.drives)
    return [catalog.drive(name) for name in names]


def _sequence(name: str, drives: list[Drive], catalog: Catalog, texts: Texts) -> SequenceView:
    sequence = catalog.sequence(name)
    views = [sequence_view(sequence, drive, catalog, texts) for drive in drives]
    for drive, view in zip(drives[1:], views[1:], strict=True):
        if str(view) != str(views[0]):
            raise DiagnosticError(
                [
                    Diagnostic(
                        "FB5001",
                        f"the sequence '{name}' sends other telegrams to '{drive.id}' than to "
                        f"'{drives[0].id}', and one block cannot do both",
                        sequence.span,
                        "make a sequence of its own for each series",
                    )
                ]
            )
    return views[0]


def _eeprom_writes(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """A cell lasts about 10,000 writes (TOSPBDP001 manual v1.1, 8 D)."""
    for name in plant.sequences:
        for step in catalog.sequence(name).steps:
            if isinstance(step, WriteStep) and step.memory == "eeprom":
                yield Diagnostic(
                    "FB5005",
                    f"the sequence '{name}' writes {step.write} into the EEPROM",
                    step.span_of("memory"),
                    "a cell lasts about 10,000 writes: never run it cyclically, or use the RAM",
                    severity=Severity.WARNING,
                )


def _plant_context(
    plant: Plant, gateways: tuple[GatewayView, ...], sequences: tuple[SequenceView, ...]
) -> dict[str, object]:
    return {
        "optimized": "FALSE" if plant.family.classic else "TRUE",
        "longest_pause": longest_pause(plant),
        "on_delay": _CLASSIC_TIMER if plant.family.classic else _TIMER,
        "plant": PlantView(plant.name, max(len(item.drives) for item in gateways)),
        "gateways": gateways,
        "station_mask": "16#0000FFFF" if several_masters(plant) else "16#000000FF",
        "sequences": sequences,
        "alarms": {
            "line": that_can_come(LINE_ALARMS, plant.gateways),
            "drive": that_can_come(drive_alarms([item.id for item in sequences]), plant.gateways),
        },
    }


def longest_pause(plant: Plant) -> SclText | None:
    """From one call to the next at most while the PLC runs; None where OB100 tells of a start."""
    if plant.dialect in _WITH_STARTUP_BLOCKS:
        return None
    place = origin("cycle_time_ms", plant)
    return milliseconds(max(_LONGEST_PAUSE_MS, _LONGEST_PAUSE_CYCLES * plant.cycle_time_ms), place)


def _gateway_context(gateway: TelegramGateway) -> dict[str, object]:
    shake, trigger = gateway.handshake, gateway.trigger
    status = WordView(gateway.status_word, gateway.id)
    place = origin("trigger", trigger)
    return {
        "control": WordView(gateway.control, gateway.id),
        "status": status,
        "shake": shake,
        "undisturbed": status.masked(
            gateway.power_on_status, shake.status_changed, shake.command_done
        ),
        "gateway_type": {
            "trigger_source": source_text(trigger, trigger.source),
            "handshake_source": source_text(shake, shake.source),
            "trigger_first": SclText(str(trigger.first), place),
            "trigger_last": SclText(str(trigger.last), place),
            "processing_comment": SclText(
                f"{gateway.times.processing.ms:g} ms",
                origin(
                    "processing", gateway.times.processing, gateway.times.processing.source or ""
                ),
            ),
        },
    }


def _drive_context(drive: Drive, catalog: Catalog, texts: Texts) -> dict[str, object]:
    protocol = catalog.protocol(drive.protocol)
    numbers = protocol.inv_numbers["binary"]
    read = protocol.command("read_padded")
    lower_case = (read.tripped_reply_code or 0) ^ (read.reply_code or 0)
    trip = drive.comno(drive.link.trip)
    status = drive.comno(drive.link.status)
    return {
        "protocol": {
            "broadcast": byte(int(numbers.broadcast, 16), origin("broadcast", numbers)),
            "inv_no_max": SclText(str(numbers.maximum), origin("inverter numbers", numbers)),
            "lower_case": byte(lower_case, origin("command G", read)),
        },
        "command": {
            item.name: byte(item.code, origin(f"command {item.letter}", item, item.source or ""))
            for item in protocol.commands
        },
        "comno": {
            "trip": comno(trip),
            "status_word": comno(status),
            "setpoint": comno(drive.comno(drive.link.setpoint)),
            "command_word": comno(drive.comno(drive.link.command)),
            "output_frequency": comno(drive.comno(drive.link.output_frequency)),
            "output_current": comno(drive.comno(drive.link.output_current)),
            "trip_source": source_text(trip, trip.source),
            "command_source": _command_source(drive),
        },
        "drive_command": WordView(drive.command_word, drive.id),
        "drive_status": WordView(drive.word(drive.comno(drive.link.status).word or ""), drive.id),
        "reset_silence": _duration(drive.times.reset_silence, f"{drive.id} reset_silence"),
        "trips": [_trip(trip) for trip in drive.trips],
        "spacer": {
            "first": comno(trip),
            "second": comno(status),
            "third": comno(drive.comno(drive.link.output_frequency)),
        },
        "scaling": _scaling(drive.comno(drive.link.setpoint), drive, texts),
    }


def _duration(time: Duration, name: str) -> SclText:
    return milliseconds(time.ms, origin(name, time, time.source or ""))


def _command_source(drive: Drive) -> dict[str, SclText] | None:
    """The ComNo that says who commands, and its value for the network; None if there is none."""
    if drive.link.command_source is None:
        return None
    source = drive.comno(drive.link.command_source)
    values = [value for value, text in source.values.items() if text == SERIAL_COMMANDS]
    if not values:
        return None
    place = origin(f"ComNo {source.hex}", source, source.source or "")
    return {"number": comno(source), "network": word(int(values[0]), place)}


def _trip(trip: Trip) -> dict[str, SclText]:
    """A trip code and its text of at most 40 characters, as literals."""
    place = origin(f"trip {trip.display}", trip, trip.source or "")
    words = one_line(f"{trip.display}: {trip.meaning}")[:_LONGEST_TRIP_TEXT]
    quoted = words.replace("$", "$$").replace("'", "$'")
    return {"code": SclText(str(trip.code), place), "text": SclText(f"'{quoted}'", place)}


def _line_context(
    drive: Drive, gateways: tuple[GatewayView, ...], texts: Texts
) -> dict[str, object]:
    bits = drive.command_word
    place = bits_origin(drive.id, bits, _EMERGENCY_STOP)
    reply = drive.times.reply_max
    wait_ms = max(item.times.wait_ms for item in gateways)
    stop_ms = max(item.times.emergency_stop_ms for item in gateways)
    times = gateways[0].timeout.origin
    return {
        "commands_in_a_row": _COMMANDS_IN_A_ROW,
        "emergency_stop": word(bits.encode(_EMERGENCY_STOP), place),
        "longest_wait_comment": SclText(texts("{time} ms at most", time=f"{wait_ms:.0f}"), times),
        "longest_stop_comment": SclText(texts("{time} ms at most", time=f"{stop_ms:.0f}"), times),
        "apart_source": source_text(reply, (reply.source or "").split(";")[0]),
    }


def _scaling(setpoint: ComNo, drive: Drive, texts: Texts) -> dict[str, object]:
    current = drive.comno(drive.link.output_current)
    frequency_origin = origin(f"ComNo {setpoint.hex}", setpoint, setpoint.source or "")
    return {
        "frequency_factor": SclText(f"{round(1 / setpoint.resolution, 6)}", frequency_origin),
        "frequency_largest": SclText(f"{0xFFFF * setpoint.resolution:.2f}", frequency_origin),
        "frequency_comment": SclText(
            one_line(_one_count(setpoint, texts)),
            frequency_origin,
        ),
        "percent_factor": SclText(
            f"{round(1 / current.resolution, 6)}", origin(f"ComNo {current.hex}", current)
        ),
        "percent_comment": SclText(
            one_line(_one_count(current, texts)),
            origin(f"ComNo {current.hex}", current),
        ),
    }


def _one_count(number: ComNo, texts: Texts) -> str:
    return texts(
        "One count is {size} {unit} (ComNo {number})",
        size=number.resolution,
        unit=number.unit,
        number=number.hex,
    )
