"""How long the status poll takes for one round over the drives of a gateway.

From the times of the catalogue, with the longest reply time of the drives, and while no command
comes in between. A read takes from leaving the PLC to its reply: the gateway in both directions, 8
characters on the line each way, the drive's reply time, and about a cycle of the PROFIBUS each way.
The PLC sees the reply when its next cycle begins; the blocks need two cycles more until the next
read has gone out: TOS_Line hands the reply on, the poll takes it and asks for the next value. A
trigger that follows its data through the process image costs one cycle more. A round is four reads
for each drive: trip code, status word, frequency, current.

The simulated plant stays within 20 % of it: heartbeats of the gateway and the phase between PLC and
PROFIBUS make single reads a cycle longer.

Sources: TOSPBDP001 manual v1.1, 9 (times); the blocks (cycles).
"""

from collections.abc import Iterator
from math import ceil

from fbgen.catalog import Catalog, TelegramGateway
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.plant import Plant, PlantGateway

READS_A_DRIVE = 4
_CYCLES_BETWEEN = 2
_TELEGRAM_BYTES = 8
_BUS_MS = 1.5
"""A PROFIBUS cycle of a small plant at 1.5 Mbit/s and the end of the PLC's cycle, each way."""
_DRIVE_BITS = 12
"""Bits of a character that an inverter sends: start, 8 data, parity, 2 stop bits (manual, 9)."""


@dataclass(frozen=True, slots=True)
class PollCycle:
    """What polling a gateway's drives takes while no command comes in between, in ms.

    `line_ms` is one read outside of the PLC, `read_ms` from one read to the next, `round_ms` until
    every value of every drive was read once.
    """

    gateway: str
    drives: int
    line_ms: float
    read_ms: float

    @property
    def reads(self) -> int:
        """Reads of one round."""
        return READS_A_DRIVE * self.drives

    @property
    def round_ms(self) -> float:
        """One round over all drives."""
        return self.reads * self.read_ms


def poll_cycle(plant: Plant, gateway: PlantGateway, catalog: Catalog) -> PollCycle:
    """The poll of one gateway."""
    entry = catalog.telegram_gateway(gateway.type)
    net, times = entry.subnetwork, entry.times
    sent_ms = _TELEGRAM_BYTES * net.character_bits / net.baud * 1000
    received_ms = _TELEGRAM_BYTES * _DRIVE_BITS / net.baud * 1000
    reply_ms = max(catalog.drive(drive.series).times.reply_max.ms for drive in gateway.drives)
    trigger_ms = times.trigger_poll.ms if gateway.options.get("trigger_poll") else 0
    line_ms = 2 * _BUS_MS + trigger_ms + 2 * times.processing.ms + sent_ms + received_ms + reply_ms
    cycles = ceil(line_ms / plant.cycle_time_ms) + _CYCLES_BETWEEN
    if gateway.access == "process_image":
        cycles += 1
    return PollCycle(gateway.name, len(gateway.drives), line_ms, cycles * plant.cycle_time_ms)


def slow_polls(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5014: a round takes longer than the plant allows."""
    for gateway in plant.gateways:
        known = catalog.profibus_gateway(gateway.type)
        if not gateway.status_poll or not isinstance(known, TelegramGateway):
            continue
        found = poll_cycle(plant, gateway, catalog)
        if found.round_ms > plant.poll_limit_ms:
            fitting = int(plant.poll_limit_ms // (found.read_ms * READS_A_DRIVE))
            yield Diagnostic(
                "FB5014",
                f"reading the state of the {found.drives} drives of '{gateway.name}' takes about "
                f"{found.round_ms:.0f} ms, more than poll_limit_ms ({plant.poll_limit_ms:g})",
                gateway.span_of("name"),
                f"{found.reads} reads of {found.read_ms:.0f} ms each: {_advice(fitting)}, "
                "or allow more by poll_limit_ms",
                severity=Severity.WARNING,
            )


def _advice(fitting: int) -> str:
    """What helps when so many drives fit."""
    if fitting == 0:
        return "call TOS_Main more often (cycle_time_ms)"
    drives = "one drive" if fitting == 1 else f"{fitting} drives"
    return f"put at most {drives} behind one gateway"
