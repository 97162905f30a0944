"""How long things take on a serial line of the PLC, worked out from plant and catalogue.

Characters: 8 data bits, the PLC sends one stop bit, an inverter two (VF-S11 communications manual
E6581222, page 4). The silence between telegrams is 3.5 characters for every series (E6581315, page
5; MODBUS over Serial Line V1.02, 2.5.1.1). Reserves of our own: 4 ms for the ways between CPU and
communication module, each way, and twice the time that all this adds up to. Modbus_Master cannot be
called off: an emergency stop waits until the request under way is over. With own frames of MODBUS a
read waits for twice the limit where another one from that drive had no reply.
"""

from math import ceil

from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.plant import Plant, SerialLine

_FRAME_BYTES = {"toshiba_binary": 8, "toshiba_ascii": 17, "modbus": 8}
_MODULE_MS = 4.0
_SILENT_CHARACTERS = 3.5
_GAP_BITS = 44
"""The character delay time of the communication module, in bit times: four characters."""
READS_A_DRIVE = 4
_REPLY_SHARE = 0.6
"""How much of the limit for an attempt Modbus_Master waits for a reply: templates/ports."""


@dataclass(frozen=True, slots=True)
class SerialTimes:
    """Times of one line in milliseconds.

    `timeout_ms` is the limit for one attempt, `gap_ms` how long the line is left alone after a
    telegram that nobody answers, `silence_ms` what lies between two telegrams. `telegram_ms` is the
    longest that one request keeps the line, `wait_ms` the longest that one waits for its turn,
    `emergency_stop_ms` from the edge of `emergencyStop` to the end of the broadcast. `read_ms` is
    one read of the poll, `round_ms` one round of it.
    """

    timeout_ms: float
    gap_ms: float
    silence_ms: float
    telegram_ms: float
    wait_ms: float
    emergency_stop_ms: float
    read_ms: float
    round_ms: float

    @property
    def drive_timeout_s(self) -> int:
        """F803 of the drives: longer than half as much again as a round of the poll, and a telegram
        that is repeated to the end. Nobody else speaks on the line, so a shorter one trips them."""
        return ceil((1.5 * self.round_ms + self.telegram_ms) / 1000)


def serial_times(plant: Plant, line: SerialLine, catalog: Catalog) -> SerialTimes:
    """The times of one line."""
    cycle_ms, drives = plant.cycle_time_ms, len(line.drives)
    reply_ms = max(catalog.drive(item.series).times.reply_max.ms for item in line.drives)
    request_ms, answer_ms = frame_ms(line, stop_bits=1), frame_ms(line, stop_bits=2)
    ended_ms = _GAP_BITS * 1000 / line.baud
    needed_ms = request_ms + reply_ms + answer_ms + ended_ms + 2 * _MODULE_MS
    chosen = line.parameters.timeout_ms
    timeout_ms = ceil(2 * needed_ms + 3 * cycle_ms) if chosen is None else float(chosen)
    gap_ms = ceil(reply_ms + answer_ms + ended_ms + _MODULE_MS)
    silence_ms = ceil(_SILENT_CHARACTERS * _character_bits(line, 1) * 1000 / line.baud)
    attempt_ms = timeout_ms + silence_ms + 4 * cycle_ms
    by_instruction = line.family == "modbus" and plant.modbus_by_instruction
    late_ms = 2 * timeout_ms if line.family == "modbus" and not by_instruction else 0.0
    telegram_ms = late_ms + (line.parameters.retries + 1) * attempt_ms + 2 * cycle_ms
    given_up_ms: float = gap_ms
    if by_instruction:
        over_ms = _MODULE_MS + request_ms + _REPLY_SHARE * timeout_ms + 2 * cycle_ms
        given_up_ms = max(gap_ms, over_ms)
    stop_ms = 4 * cycle_ms + given_up_ms + silence_ms + _MODULE_MS + request_ms
    read_ms = cycle_ms * ceil((needed_ms + silence_ms) / cycle_ms + 3)
    return SerialTimes(
        timeout_ms,
        gap_ms,
        silence_ms,
        telegram_ms,
        (drives + 1) * telegram_ms,
        stop_ms,
        read_ms,
        READS_A_DRIVE * drives * read_ms,
    )


def frame_ms(line: SerialLine, stop_bits: int) -> float:
    """How long the longest telegram takes on the line."""
    return _FRAME_BYTES[line.protocol] * _character_bits(line, stop_bits) * 1000 / line.baud


def _character_bits(line: SerialLine, stop_bits: int) -> int:
    return 1 + 8 + (line.parity != "none") + stop_bits
