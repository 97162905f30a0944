"""When bytes of a port are on the line, and when those of the line get to the port."""

import pytest

from harness.kernel import NS_PER_MS
from harness.line import GATEWAY_FORMAT, Parity
from harness.serial import LineSetting
from tests.unit.serial.virtual_port import REPLY_NS, SETTING, ServedLine

READ = "2F 0B 52 FD 01 8A"
STOPPED = "2F 0B 52 FD 01 60 00 EA"
FORWARD = "2F 0B 50 FA 00 C4 00 48"
REQUEST_NS = GATEWAY_FORMAT.duration_ns(6)
REPLY_BYTES_NS = SETTING.from_drives.duration_ns(8)


def reply_after_ns(line: ServedLine, *parts: tuple[int, str]) -> list[int]:
    """How long after the first part of a request each piece of its reply was written."""
    line.run_ms(20)
    start_ns = line.port.now_ns
    line.port.script += [(start_ns + at_ns, bytes.fromhex(text)) for at_ns, text in parts]
    line.run_ms(80)
    return [at_ns - start_ns for at_ns, _ in line.port.written]


def test_where_bytes_take_no_time_a_reply_comes_when_its_last_byte_would() -> None:
    (after_ns,) = reply_after_ns(ServedLine(), (0, READ))
    assert after_ns == pytest.approx(REQUEST_NS + REPLY_NS + REPLY_BYTES_NS, abs=2)


def test_at_a_serial_port_a_reply_is_handed_over_when_its_first_byte_is_due() -> None:
    (after_ns,) = reply_after_ns(ServedLine(byte_times=False), (0, READ))
    assert after_ns == pytest.approx(REPLY_NS, abs=2)


@pytest.mark.parametrize("byte_times", [True, False])
def test_a_request_may_come_in_pieces(byte_times: bool) -> None:
    line = ServedLine(byte_times=byte_times)
    pieces = (0, READ[:5]), (3 * NS_PER_MS, READ[6:])
    (after_ns,) = reply_after_ns(line, *pieces)
    extra_ns = GATEWAY_FORMAT.duration_ns(4) + REPLY_BYTES_NS if byte_times else 0
    assert after_ns == pytest.approx(3 * NS_PER_MS + extra_ns + REPLY_NS, abs=2)


@pytest.mark.parametrize("byte_times", [True, False])
def test_a_master_that_asks_again_at_once_is_heard(byte_times: bool) -> None:
    line = ServedLine(byte_times=byte_times)
    for _ in range(5):
        line.port.written.clear()
        line.port.script.append((line.port.now_ns, bytes.fromhex(READ)))
        for _ in range(20):
            if not line.port.written:
                line.server.step()
        assert line.port.written[0][1].hex(" ").upper() == STOPPED


@pytest.mark.parametrize("byte_times", [True, False])
def test_characters_of_another_speed_are_not_understood(byte_times: bool) -> None:
    line = ServedLine(byte_times=byte_times)
    line.served.bridge.node.format = LineSetting("toshiba", 9_600, Parity.EVEN).from_master
    assert line.ask(READ) == [""]


@pytest.mark.parametrize("byte_times", [True, False])
def test_what_is_lost_on_the_line_does_not_get_to_the_port(byte_times: bool) -> None:
    line = ServedLine(byte_times=byte_times)
    pair = line.served.line.slave_pair
    pair.interference.byte_losses.probability = 1.0
    assert line.ask(READ) == [""]
    pair.interference.byte_losses.probability = 0.0
    pair.broken = True
    assert line.ask(READ) == [""]
    pair.broken = False
    assert line.ask(READ) == [STOPPED]


def test_what_was_due_while_the_machine_slept_happens_in_its_order() -> None:
    line = ServedLine()
    line.served.drives["vf11"].set_parameter("communication_timeout", 1)
    assert line.ask(FORWARD) == [FORWARD]
    line.port.now_ns += 3_000 * NS_PER_MS
    line.server.step()
    assert line.served.drives["vf11"].trip_display == "Err5"
    assert line.server.longest_delay_ns >= 1_900 * NS_PER_MS
