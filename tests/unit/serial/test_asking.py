"""A master that asks: replies, echoes, silence, and what is no reply."""

import pytest

from harness.kernel import NS_PER_MS
from harness.serial import Asking, Heard, protocol_of
from tests.unit.serial.master_port import MasterPort
from tests.unit.serial.virtual_port import SETTING, ServedLine

READ = bytes.fromhex("2F 0B 52 FD 01 8A")
STOPPED = bytes.fromhex("2F 0B 52 FD 01 60 00 EA")
FORWARD = bytes.fromhex("2F 0B 50 FA 00 C4 00 48")


def asking(port: MasterPort) -> Asking:
    return Asking(
        port, protocol_of(SETTING), SETTING.from_master, 300 * NS_PER_MS, clock_ns=port.clock
    )


def ask(port: MasterPort, *requests: bytes) -> list[Heard]:
    master = asking(port)
    return [master.ask(request) for request in requests]


@pytest.mark.parametrize("echo", [False, True])
def test_a_reply_is_told_from_an_echo_although_both_are_the_same(echo: bool) -> None:
    line = ServedLine()
    heard = ask(MasterPort(line, echo=echo), FORWARD, READ)
    assert heard[0].reply == FORWARD
    assert heard[0].took_ns > 12 * NS_PER_MS
    assert heard[1].reply is not None
    assert line.served.drives["vf11"].running


def test_an_echo_alone_is_no_reply() -> None:
    line = ServedLine()
    line.served.drives["vf11"].power_off()
    (heard,) = ask(MasterPort(line, echo=True), FORWARD)
    assert (heard.reply, heard.others, heard.rest) == (None, (), b"")
    assert heard.took_ns >= 300 * NS_PER_MS


def test_the_zero_that_looks_for_an_echo_is_sent_once_and_does_no_harm() -> None:
    port = MasterPort(ServedLine())
    assert [item.reply for item in ask(port, READ, READ)] == [STOPPED, STOPPED]
    assert port.sent == [b"\x00", READ, READ]


def test_a_reply_with_a_wrong_sum_is_no_reply() -> None:
    port = MasterPort(ServedLine(), change=lambda data: data[:-1] + b"\x00")
    (heard,) = ask(port, READ)
    assert (heard.reply, heard.rest) == (None, STOPPED[:-1] + b"\x00")


def test_a_reply_of_another_number_is_told() -> None:
    line = ServedLine(11, 12)
    line.served.drives["vf11"].communication.reply_number = 12
    (heard,) = ask(MasterPort(line), READ)
    assert heard.reply is None
    assert heard.others == (bytes.fromhex("2F 0C 52 FD 01 60 00 EB"),)


def test_a_reply_that_came_too_late_is_not_taken_for_the_next_one() -> None:
    line = ServedLine(11)
    communication = line.served.drives["vf11"].communication
    communication.late_ns, communication.late_replies.probability = 400 * NS_PER_MS, 1.0
    master = asking(MasterPort(line))
    assert master.ask(READ).reply is None
    communication.late_replies.probability = 0.0
    line.run_ms(150)
    assert master.ask(FORWARD).reply == FORWARD


def test_nobody_waits_for_what_is_not_answered() -> None:
    port = MasterPort(ServedLine())
    reset = bytes.fromhex("2F 0B 50 FA 00 20 00 A4")
    heard = asking(port).ask(reset, answered=False)
    assert heard.reply is None
    assert heard.took_ns < 20 * NS_PER_MS


def test_the_bytes_are_told_as_they_go_and_come() -> None:
    master = asking(MasterPort(ServedLine()))
    said: list[tuple[str, bytes]] = []
    master.told = lambda direction, data, took_ns: said.append((direction, data))
    master.ask(READ)
    assert said == [("sent", READ), ("heard", STOPPED)]
