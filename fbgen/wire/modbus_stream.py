"""The silences of MODBUS-RTU, and what slaves and masters listen with.

MODBUS over Serial Line V1.02, section 2.5.1.1: 3.5 characters of silence end a frame, more than 1.5
inside it spoil it; above 19,200 bit/s 1.75 ms and 750 us are recommended, whatever the speed. The
VF-S11 manual E6581222, p. 31, has the same two, and says of the 1.5 characters that a frame "may"
be given up. A byte with a parity, framing or overrun error spoils a frame (same page).
"""

from fbgen.wire import modbus_rtu
from fbgen.wire.modbus import LONGEST_FRAME, BadRequest, Reply, Request
from fbgen.wire.silence import SilenceStream, SilentIntervals, characters_ns

FASTEST_BY_CHARACTERS = 19_200
_FRAME_CHARACTERS, _INSIDE_CHARACTERS = 3.5, 1.5
_FIXED = SilentIntervals(frame_ns=1_750_000, inside_ns=750_000)


def silent_intervals(baud: int) -> SilentIntervals:
    """The silences at a speed, with characters of eleven bits."""
    if baud > FASTEST_BY_CHARACTERS:
        return _FIXED
    return SilentIntervals(
        characters_ns(_FRAME_CHARACTERS, baud), characters_ns(_INSIDE_CHARACTERS, baud)
    )


def request_stream(intervals: SilentIntervals) -> SilenceStream[Request | BadRequest]:
    """What a slave listens with."""
    return SilenceStream[Request | BadRequest](modbus_rtu.parse_request, intervals, LONGEST_FRAME)


def reply_stream(intervals: SilentIntervals) -> SilenceStream[Reply]:
    """What a master listens with. `modbus_rtu.reply_length` says sooner when a reply is whole."""
    return SilenceStream[Reply](modbus_rtu.parse_reply, intervals, LONGEST_FRAME)
