"""How long things take at worst on the line behind a gateway, worked out from plant and catalogue.

The header of TOS_Line, the generated README and the phase sweep have these figures; the sweep
measures what really comes and compares. Sources: TOSPBDP001 manual v1.1, 9, for the times of
gateway and drives; the states of TOS_Telegram and TOS_Line for what goes out.
"""

from collections.abc import Iterator
from math import ceil

from fbgen.catalog import Catalog, TelegramGateway
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.plant import Plant, PlantGateway

LONGEST_BUS_CYCLE_MS = 5.0
"""PROFIBUS cycles of more than this are not reckoned with: the watchdog is set for shorter ones."""

SPACERS = 2
"""Reads that it puts in front at most."""

HEARTBEAT_CHARACTERS = 14
"""The gateway's heartbeat on the line, which a telegram waits for: `(**P08800001)` and CR."""


@dataclass(frozen=True, slots=True)
class LineTimes:
    """Worst cases behind one gateway, in milliseconds.

    `timeout_ms` is the limit for one attempt, `gap_ms` how long the line is left alone, `apart_ms`
    how far telegrams to different drives are apart at least, `taken_ms` how long after a new
    trigger the gateway has it at the latest.
    `telegram_ms` is the longest that one request keeps the line, `wait_ms` the longest that one
    waits for its turn while every drive and the poll want the line and nobody answers; after
    start-up and a loss of the gateway `first_read_ms` come on top, for the read that goes first.
    `emergency_stop_ms` is from the rising edge of `emergencyStop` in the PLC to the end of the
    broadcast on the line: then every drive that hears it has it.
    """

    timeout_ms: float
    gap_ms: float
    apart_ms: float
    taken_ms: float
    telegram_ms: float
    wait_ms: float
    first_read_ms: float
    emergency_stop_ms: float


def line_times(plant: Plant, entry: PlantGateway, catalog: Catalog) -> LineTimes:
    """The times of one gateway of a plant."""
    gateway = catalog.telegram_gateway(entry.type)
    reply_max_ms = max(catalog.drive(item.series).times.reply_max.ms for item in entry.drives)
    chosen = entry.parameters.timeout_ms
    timeout_ms = reply_timeout_ms(plant, gateway, reply_max_ms) if chosen is None else float(chosen)
    gap_ms = silent_gap_ms(plant, gateway, reply_max_ms)
    longest_ms = max([timeout_ms, *_sequence_limits(plant, catalog)])
    telegram_ms = longest_telegram_ms(plant, longest_ms, entry.parameters.retries + 1)
    return LineTimes(
        timeout_ms,
        gap_ms,
        apart_ms(gateway, reply_max_ms),
        taken_ms(gateway),
        telegram_ms,
        (len(entry.drives) + 1) * telegram_ms,
        _attempt_ms(plant, timeout_ms),
        _emergency_stop_ms(plant, entry, gateway, gap_ms),
    )


def reply_timeout_ms(plant: Plant, gateway: TelegramGateway, reply_max_ms: float) -> float:
    """How long a reply may take, with a reserve of twice the time that the manual adds up.

    Drive, gateway in both directions and 8 bytes on the line in both directions, and two cycles of
    the PLC for reading and writing. Source: TOSPBDP001 manual v1.1, 9.
    """
    return 2 * _reply_ms(gateway, reply_max_ms) + 2 * plant.cycle_time_ms


def _reply_ms(gateway: TelegramGateway, reply_max_ms: float) -> float:
    return reply_max_ms + 2 * gateway.times.processing.ms + 2 * _frame_ms(gateway)


def short_timeouts(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5016: timeout_ms of a line, less than a reply may take."""
    for entry in plant.gateways:
        gateway, chosen = catalog.profibus_gateway(entry.type), entry.parameters.timeout_ms
        if chosen is None or not isinstance(gateway, TelegramGateway):
            continue
        reply_max_ms = max(catalog.drive(item.series).times.reply_max.ms for item in entry.drives)
        needed_ms = _reply_ms(gateway, reply_max_ms) + 2 * plant.cycle_time_ms
        if chosen < needed_ms:
            usual_ms = reply_timeout_ms(plant, gateway, reply_max_ms)
            yield Diagnostic(
                "FB5016",
                f"timeout_ms is {chosen:g}, and a reply to '{entry.name}' may take "
                f"{ceil(needed_ms)} ms",
                entry.parameters.span_of("timeout_ms"),
                f"leave it out, then it is {ceil(usual_ms)} ms; drives that answer later than "
                "this limit count as lost",
                severity=Severity.WARNING,
            )


def silent_gap_ms(plant: Plant, gateway: TelegramGateway, reply_max_ms: float) -> float:
    """How long the line is left alone after a telegram that nobody answers.

    The gateway has surely looked at the trigger, processed and sent the telegram, also where the
    trigger leaves the PLC a cycle after its data; then comes the drive's reply time, which the
    manual asks for between telegrams to different drives. Source: TOSPBDP001 manual v1.1, 9.
    """
    times = gateway.times
    sent_ms = times.trigger_poll.ms + times.processing.ms + _frame_ms(gateway)
    return 2 * plant.cycle_time_ms + sent_ms + reply_max_ms


def apart_ms(gateway: TelegramGateway, reply_max_ms: float) -> float:
    """How long after a telegram the PLC may send one to another drive of the same line.

    On the line they must be the reply time apart, that of the slowest series. A bus cycle and the
    grid on which the gateway may look at the trigger shift each of them. Source: TOSPBDP001 manual
    v1.1, 9; the bus cycle of 5 ms is a reserve.
    """
    return reply_max_ms + taken_ms(gateway)


def taken_ms(gateway: TelegramGateway) -> float:
    """How long after a cycle that puts out a new trigger the gateway has seen it at the latest.

    A bus cycle brings it there, then the gateway looks at it. Until then the data of the frame
    belong to this trigger. Source: TOSPBDP001 manual v1.1, 9; the bus cycle is a reserve.
    """
    return gateway.times.trigger_poll.ms + LONGEST_BUS_CYCLE_MS


def longest_telegram_ms(plant: Plant, limit_ms: float, attempts: int) -> float:
    """How long one request keeps the line at most, with so many attempts and this limit for each.

    Each spacer may be answered at the last moment, and the attempts are shared by all of them.
    """
    return (attempts + SPACERS) * _attempt_ms(plant, limit_ms) + 4 * plant.cycle_time_ms


def _attempt_ms(plant: Plant, limit_ms: float) -> float:
    """How long an attempt takes that ends with its limit: three cycles more, to send, for the grain
    of the timer, and to see it."""
    return limit_ms + 3 * plant.cycle_time_ms


def _sequence_limits(plant: Plant, catalog: Catalog) -> list[float]:
    limits: list[float] = []
    for name in plant.sequences:
        sequence = catalog.sequence(name)
        own = (getattr(step, "timeout_ms", None) for step in sequence.steps)
        limits += [sequence.reply_timeout_ms, *(limit for limit in own if limit is not None)]
    return limits


def _emergency_stop_ms(
    plant: Plant, entry: PlantGateway, gateway: TelegramGateway, gap_ms: float
) -> float:
    """From the edge to the end of the broadcast.

    The block sees it in its next cycle, leaves the line alone for the gap (three cycles more, as
    above), and sends; by the process image the outputs leave at the end of a cycle and the trigger
    one later. Then PROFIBUS, the look at the trigger, the processing, a heartbeat that is going
    out, and the frame itself.
    """
    cycles = 1 + 3 + (2 if entry.access == "process_image" else 0)
    times, bits = gateway.times, gateway.subnetwork.character_bits
    heartbeat_ms = HEARTBEAT_CHARACTERS * bits / gateway.subnetwork.baud * 1000
    return (
        cycles * plant.cycle_time_ms
        + gap_ms
        + LONGEST_BUS_CYCLE_MS
        + times.trigger_poll.ms
        + times.processing.ms
        + heartbeat_ms
        + _frame_ms(gateway)
    )


def _frame_ms(gateway: TelegramGateway) -> float:
    """How long 8 bytes take on the line towards the drives."""
    return 8 * gateway.subnetwork.character_bits / gateway.subnetwork.baud * 1000
