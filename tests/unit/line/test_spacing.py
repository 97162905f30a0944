"""Telegrams to different drives of a line, and whether the reply time lies between them."""

import pytest

from fbgen.wire.toshiba import seal
from harness.kernel import NS_PER_MS, Kernel
from harness.line import GATEWAY_FORMAT, Line, Reception, Role, Spacing

REPLY_NS = {1: 20 * NS_PER_MS, 2: 20 * NS_PER_MS, 3: 78 * NS_PER_MS, 0: 20 * NS_PER_MS}
READ, SETPOINT = 0x47, 0x53


class Silent:
    """A node that does nothing."""

    def receive(self, reception: Reception) -> None:
        """Hear and be silent."""


def too_close(*telegrams: tuple[float, int, int]) -> list[tuple[int, int]]:
    """The pairs that are noted, of telegrams that begin at a time in ms, to a drive, with a CMD."""
    kernel = Kernel()
    line = Line(kernel)
    port = line.attach(Silent(), Role.MASTER, GATEWAY_FORMAT)
    spacing = Spacing(line, port, REPLY_NS)
    for time_ms, inv_no, command in telegrams:
        frame = seal(bytes((inv_no, command, 0xFC, 0x90, 0, 0)))
        kernel.at(round(time_ms * NS_PER_MS), lambda frame=frame: port.transmit(frame))
    kernel.run_for(1000 * NS_PER_MS)
    return [(found.before, found.inv_no) for found in spacing.too_close]


@pytest.mark.fact("tos.t.gap")
def test_different_drives_need_the_reply_time_of_the_first_one() -> None:
    assert too_close((0, 1, READ), (19.9, 2, READ)) == [(1, 2)]
    assert too_close((0, 1, READ), (20, 2, READ)) == []
    assert too_close((0, 3, READ), (77.9, 1, READ)) == [(3, 1)]
    assert too_close((0, 1, READ), (25, 3, READ)) == []


def test_one_drive_may_be_asked_again_at_any_time() -> None:
    assert too_close((0, 3, READ), (10, 3, READ)) == []


@pytest.mark.fact("tos.t.gap")
def test_set_points_that_nobody_answers_do_not_count() -> None:
    assert too_close((0, 1, SETPOINT), (10, 2, SETPOINT), (20, 3, READ)) == []


def test_a_broadcast_does_not_wait_but_is_answered_by_drive_0() -> None:
    assert too_close((0, 1, READ), (10, 0xFF, 0x50)) == []
    assert too_close((0, 0xFF, 0x50), (10, 1, READ)) == [(0, 1)]
    assert too_close((0, 0xFF, 0x50), (25, 1, READ)) == []


def test_the_distance_and_the_instant_are_noted() -> None:
    kernel = Kernel()
    line = Line(kernel)
    port = line.attach(Silent(), Role.MASTER, GATEWAY_FORMAT)
    other = line.attach(Silent(), Role.MASTER, GATEWAY_FORMAT)
    spacing = Spacing(line, port, REPLY_NS)
    port.transmit(seal(bytes((1, READ, 0xFC, 0x90, 0, 0))))
    kernel.run_for(7 * NS_PER_MS)
    other.transmit(seal(bytes((2, READ, 0xFC, 0x90, 0, 0))))
    kernel.run_for(7 * NS_PER_MS)
    port.transmit(seal(bytes((2, READ, 0xFC, 0x90, 0, 0))))
    kernel.run_for(7 * NS_PER_MS)
    assert spacing.too_close == [(14 * NS_PER_MS, 1, 2, 14 * NS_PER_MS)]
