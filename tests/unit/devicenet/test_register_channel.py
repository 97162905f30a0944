"""The parameter channel in 101 and 105: read, write, error; each write once."""

import pytest

from fbgen.wire.devicenet_ids import Group2, group_2
from tests.unit.devicenet.bench import C203, MAC, Bench, bench, words


def ask(
    made: Bench, instance: int, number: int, data: int, *, write: bool
) -> tuple[bool, int, int]:
    """Whether it failed, and number and data of the answer."""
    if instance == 101:
        answer = made.poll(words(0, 0, number & 0x7FFF | write << 15, data))
        assert answer is not None
        index = int.from_bytes(answer[4:6], "little")
        return bool(index & 0x8000), index & 0x7FFF, int.from_bytes(answer[6:8], "little")
    answer = made.poll(words(int(write), number, data) + bytes(12))
    assert answer is not None
    response = int.from_bytes(answer[0:2], "little")
    number, data = (int.from_bytes(answer[at : at + 2], "little") for at in (2, 4))
    return bool(response & 0x8000), number, data


@pytest.fixture(params=[101, 105])
def channel(request: pytest.FixtureRequest) -> tuple[Bench, int]:
    made = bench(C203[request.param])
    made.connect()
    return made, request.param


@pytest.mark.fact("dev.channel")
def test_values_are_read_and_written(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    assert ask(made, instance, 0x0018, 0, write=False) == (False, 0x0018, 0)
    assert ask(made, instance, 0x0018, 1234, write=True) == (False, 0x0018, 1234)
    assert made.drive.read_word("0018") == 1234
    assert ask(made, instance, 0x0018, 0, write=False) == (False, 0x0018, 1234)


@pytest.mark.fact("dev.channel")
@pytest.mark.parametrize(("number", "data", "code"), [(0x0002, 0, 2), (0x0011, 0xFFFF, 1)])
def test_what_cannot_be_written_is_an_error(
    channel: tuple[Bench, int], number: int, data: int, code: int
) -> None:
    made, instance = channel
    assert ask(made, instance, number, data, write=True) == (True, number, code)
    assert ask(made, instance, 0x0018, 5, write=True)[0] is False


def test_what_is_not_there_cannot_be_read(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    assert ask(made, instance, 0x0002, 0, write=False) == (True, 0x0002, 2)


def test_numbers_with_f_are_reached(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    status = made.drive.read_word("FD01")
    failed, _, data = ask(made, instance, 0xFD01, 0, write=False)
    assert (failed, data) == (False, status)


def test_a_read_is_fresh_each_time_and_a_write_is_done_once(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    ask(made, instance, 0x0018, 100, write=True)
    made.drive.set_parameter("0018", 7.0)
    assert ask(made, instance, 0x0018, 100, write=True) == (False, 0x0018, 100)
    assert made.drive.read_parameter("0018") == 7.0
    assert ask(made, instance, 0x0018, 0, write=False) == (False, 0x0018, 700)
    assert ask(made, instance, 0x0018, 100, write=True)[0] is False
    assert made.drive.read_parameter("0018") == 1.0


def test_no_number_asks_for_nothing(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    assert ask(made, instance, 0, 0, write=False) == (False, 0, 0)
    before = dict(made.drive.registers.ram)
    assert ask(made, instance, 0, 1, write=True) == (False, 0, 0)
    assert made.drive.registers.ram == before


def test_a_master_that_comes_back_writes_anew(channel: tuple[Bench, int]) -> None:
    made, instance = channel
    ask(made, instance, 0x0018, 100, write=True)
    made.run(401)
    assert made.option.node.io_timed_out
    made.drive.set_parameter("0018", 7.0)
    release = bytes.fromhex("00 4C 03 01 03")
    made.put(group_2(Group2.UNCONNECTED_REQUEST, MAC), release)
    made.run(5)
    made.connect()
    assert ask(made, instance, 0x0018, 100, write=True) == (False, 0x0018, 100)
    assert made.drive.read_parameter("0018") == 1.0
