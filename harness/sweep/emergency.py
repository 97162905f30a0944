"""The emergency stop of a line in the middle of whatever goes on there.

The instant of the edge is spread over the life of a telegram: before it, while its data wait for
their trigger, on the line, while the drive answers and behind that. The line has load: every drive
and the poll want it, and in every other run the drive whose turn it is is silent, so that its
telegram would be waited for and repeated.
"""

from collections.abc import Sequence

from harness.kernel import NS_PER_MS
from harness.sweep.conditions import Conditions
from harness.sweep.requests import (
    COMMAND_WORD,
    READ,
    WRITE_RAM,
    Ask,
    Die,
    EmergencyStop,
    Pause,
    Request,
    Step,
)

_CURRENT, _RUN = 0xFE03, 0xC400
_SPREAD_MS = 130
"""Longer than a telegram with its reply takes."""

_PACE_MS = 37
"""Without a common divisor with the spread: so every instant in it has its turn."""


def stop_script(inv_nos: Sequence[int], conditions: Conditions) -> tuple[Step, ...]:
    """Requests of all drives at once, and the emergency stop so much later."""
    number = conditions.scan_offset_ns // NS_PER_MS + conditions.reply_ns // NS_PER_MS
    later_ms = number * _PACE_MS % _SPREAD_MS
    everybody = tuple(
        Request(channel, inv_no, WRITE_RAM, COMMAND_WORD, _RUN)
        for channel, inv_no in enumerate(inv_nos, 1)
    )
    return (
        Ask((Request(1, inv_nos[0], READ, _CURRENT),)),
        *([Die(inv_nos[1])] if number % 2 else []),
        Ask((*everybody, Request(0, inv_nos[0], READ, _CURRENT)), wait=False),
        Pause(later_ms * NS_PER_MS),
        EmergencyStop(),
        Pause(3 * _SPREAD_MS * NS_PER_MS),
    )
