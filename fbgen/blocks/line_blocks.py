"""The blocks for gateways with a serial line (TOSPBDP001): telegrams, the line, its drives."""

from collections.abc import Iterator, Sequence

from fbgen.blocks.alarms import LINE_ALARMS, drive_alarms, that_can_come
from fbgen.blocks.drive_words import drive_context
from fbgen.blocks.family import FamilyPlan
from fbgen.blocks.gateways import other_types
from fbgen.blocks.line_gateways import LineGatewayView, line_gateway_view, missing_fields
from fbgen.blocks.line_times import short_timeouts
from fbgen.blocks.literals import SclText, source_text, word
from fbgen.blocks.plant_sequences import sequence_context
from fbgen.blocks.poll_cycle import slow_polls
from fbgen.blocks.sequences import SequenceView
from fbgen.blocks.specs import BlockSpec, block, data_block, data_type
from fbgen.blocks.texts import Texts
from fbgen.blocks.words import WordView, bits_origin
from fbgen.catalog import Catalog, Drive, TelegramGateway, WriteStep, origin
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.plant import Plant, PlantGateway

COMMANDS_IN_A_ROW = 8
"""Telegrams of drives after which the status poll has its turn, while more of them wait."""
EMERGENCY_STOP = ("network_command", "network_frequency", "emergency_stop")
"""The bits of the command word that stop a drive at once."""


LINE_TYPES = tuple(
    f"typeTos{name}"
    for name in (
        *("Request", "Reply", "Channel"),
        *("Control", "State", "Polled", "LineParam", "DriveParam"),
    )
)
"""The types of every line, in the order of dependence."""


def line_problems(chosen: Sequence[PlantGateway], catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5008 layouts that the blocks do not know, FB5009 gateways of several types."""
    yield from missing_fields(chosen, catalog)
    yield from other_types(chosen)


def line_family(
    plant: Plant, chosen: Sequence[PlantGateway], catalog: Catalog, texts: Texts
) -> FamilyPlan:
    """What the gateways with a line need; there is at least one.

    Raises DiagnosticError FB5001.
    """
    drives = _series(chosen, catalog)
    of_sequences = sequence_context(plant, catalog, texts)
    sequences = of_sequences.views
    gateways = tuple(line_gateway_view(plant, item, catalog) for item in chosen)
    first = gateways[0]
    context: dict[str, object] = {
        "most_drives": max(len(item.drives) for item in gateways),
        **of_sequences.context,
        "alarms": {
            "line": that_can_come(LINE_ALARMS, chosen),
            "drive": that_can_come(drive_alarms([item.id for item in sequences]), chosen),
        },
        "times": {
            "timeout": first.timeout,
            "gap": first.gap,
            "apart": first.apart,
            "taken": first.taken,
        },
        "line": _line_context(drives[0], gateways, texts),
    }
    context |= _gateway_context(catalog.telegram_gateway(chosen[0].type))
    context |= drive_context(drives[0], catalog)
    return FamilyPlan(
        units=gateways,
        types=_types(gateways, sequences),
        blocks=_blocks(gateways, sequences),
        data=[
            data_block(f"TOS_Gateway_{item.name}_DB", "TOS_Gateway_DB", {"gateway": item})
            for item in gateways
        ],
        context=context,
        warnings=(
            *eeprom_writes(plant, catalog),
            *slow_polls(plant, catalog),
            *short_timeouts(plant, catalog),
        ),
    )


def _types(
    gateways: tuple[LineGatewayView, ...], sequences: tuple[SequenceView, ...]
) -> list[BlockSpec]:
    specs = [data_type(name) for name in ("typeTosInput", "typeTosOutput", *LINE_TYPES)]
    specs.insert(5, data_type("typeTosLine"))
    specs += [
        data_type(f"typeTos_{item.id}", "typeTosSeq", {"sequence": item}) for item in sequences
    ]
    specs.append(data_type("typeTosDrive"))
    specs += [
        data_type(f"{name}_{item.name}", name, {"gateway": item})
        for item in gateways
        for name in ("typeTosGateway", "typeTosParam")
    ]
    return specs


def _blocks(
    gateways: tuple[LineGatewayView, ...], sequences: tuple[SequenceView, ...]
) -> list[BlockSpec]:
    names = ["TOS_TriggerCounter", "TOS_Handshake", "TOS_Telegram", "TOS_Line", "TOS_Drive"]
    if any(item.status_poll for item in gateways):
        names += ["TOS_StatusPoll", "TOS_TripText"]
    specs = [block(name) for name in names]
    specs += [block(f"TOS_Seq_{item.id}", "TOS_Seq", {"sequence": item}) for item in sequences]
    if sequences:
        specs.append(block("TOS_Sequences"))
    specs.append(block("TOS_Alarms"))
    for name in ("TOS_ConsistentIo", "TOS_Gateway"):
        specs += [block(f"{name}_{item.name}", name, {"gateway": item}) for item in gateways]
    return specs


def _series(chosen: Sequence[PlantGateway], catalog: Catalog) -> list[Drive]:
    names = dict.fromkeys(drive.series for gateway in chosen for drive in gateway.drives)
    return [catalog.drive(name) for name in names]


def eeprom_writes(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5005: a cell lasts about 10,000 writes (TOSPBDP001 manual v1.1, 8 D)."""
    on_lines = {drive.series for drive in plant.numbered_drives}
    for name in plant.sequences:
        for step in catalog.sequence(name).steps:
            if isinstance(step, WriteStep) and step.memory == "eeprom":
                message = f"the sequence '{name}' writes {step.write} into the EEPROM"
                way_out = (
                    "a cell lasts about 10,000 writes: never run it cyclically, or use the RAM"
                )
                cells = [catalog.drive(one).comno(step.write).storage for one in sorted(on_lines)]
                if "eeprom" not in cells:
                    message = f"{message}, and that ComNo has no cell there"
                    way_out = "it is lost when the drive is switched off: leave out memory: eeprom"
                yield Diagnostic(
                    "FB5005",
                    message,
                    step.span_of("memory"),
                    way_out,
                    severity=Severity.WARNING,
                )


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


def _line_context(
    drive: Drive, gateways: tuple[LineGatewayView, ...], texts: Texts
) -> dict[str, object]:
    bits = drive.command_word
    place = bits_origin(drive.id, bits, EMERGENCY_STOP)
    reply = drive.times.reply_max
    wait_ms = max(item.times.wait_ms for item in gateways)
    stop_ms = max(item.times.emergency_stop_ms for item in gateways)
    times = gateways[0].timeout.origin
    return {
        "commands_in_a_row": COMMANDS_IN_A_ROW,
        "emergency_stop": word(bits.encode(EMERGENCY_STOP), place),
        "longest_wait_comment": SclText(texts("{time} ms at most", time=f"{wait_ms:.0f}"), times),
        "longest_stop_comment": SclText(texts("{time} ms at most", time=f"{stop_ms:.0f}"), times),
        "apart_source": source_text(reply, (reply.source or "").split(";")[0]),
    }
