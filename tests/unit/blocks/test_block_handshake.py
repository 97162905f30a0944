"""TOS_Handshake. Source: TOSPBDP001 manual v1.1, 8 A."""

import pytest

from harness import LoadedProgram
from tests.unit.blocks.programs import block

STATUS_CHANGED = 0x8000
COMMAND = 0x4000
DATA_VALID = 0x2000


@pytest.mark.fact("tos.sw.ok")
@pytest.mark.parametrize("status", [0x1F00, 0x5F00, 0x9F00, 0xDF00])
def test_the_four_states_of_undisturbed_operation_are_no_fault(
    program: LoadedProgram, status: int
) -> None:
    handshake = block(program, "TOS_Handshake")
    handshake(gatewayStatus=status)
    assert not handshake.fault
    assert (handshake.statusCode, handshake.errorCount) == (0x1F, 0)


@pytest.mark.parametrize(
    ("status", "code", "count"),
    [
        (0x0001, 0x00, 1),
        (0x80FF, 0x00, 0xFF),
        (0x0100, 0x01, 0),
        (0x4207, 0x02, 7),
        (0x1F01, 0x1F, 1),
        (0x3F00, 0x1F, 0),
        (0x0000, 0x00, 0),
    ],
)
def test_everything_else_is_a_fault_with_code_and_counter(
    program: LoadedProgram, status: int, code: int, count: int
) -> None:
    handshake = block(program, "TOS_Handshake")
    handshake(gatewayStatus=status)
    assert handshake.fault
    assert (handshake.statusCode, handshake.errorCount) == (code, count)


@pytest.mark.fact("tos.sw.b14")
def test_bit_14_toggles_once_per_new_command(program: LoadedProgram) -> None:
    handshake = block(program, "TOS_Handshake")
    seen = []
    for new in (False, True, True, False, True, False, False, True):
        handshake(newCommand=new, gatewayStatus=0x1F00)
        seen.append(bool(handshake.control & COMMAND))
    assert seen == [False, True, True, True, False, False, False, True]


def test_a_command_is_acknowledged_when_the_gateway_shows_the_same_bit_14(
    program: LoadedProgram,
) -> None:
    handshake = block(program, "TOS_Handshake")
    handshake(newCommand=True, gatewayStatus=0x1F00)
    assert not handshake.acknowledged
    handshake(newCommand=False, gatewayStatus=0x5F00)
    assert handshake.acknowledged
    handshake(newCommand=True, gatewayStatus=0x5F00)
    assert not handshake.acknowledged
    handshake(newCommand=False, gatewayStatus=0x1F00)
    assert handshake.acknowledged


@pytest.mark.fact("tos.sw.b15")
def test_bit_15_of_the_status_is_copied_and_its_change_reported_for_one_call(
    program: LoadedProgram,
) -> None:
    handshake = block(program, "TOS_Handshake")
    seen = []
    for status in (0x1F00, 0x9F00, 0x9F00, 0x1F00, 0x1F00):
        handshake(gatewayStatus=status)
        seen.append((bool(handshake.control & STATUS_CHANGED), handshake.newStatus))
    assert seen == [(False, False), (True, True), (True, False), (False, True), (False, False)]


def test_the_control_word_is_that_of_the_manuals_example(program: LoadedProgram) -> None:
    handshake = block(program, "TOS_Handshake")
    words = []
    status = 0x9F00
    for _ in range(4):
        handshake(newCommand=True, gatewayStatus=status)
        words.append(f"{handshake.control:04X}")
        status = 0x9F00 | (int(handshake.control) & COMMAND)
        handshake(newCommand=False, gatewayStatus=status)
    assert words == ["E000", "A000", "E000", "A000"]


@pytest.mark.fact("tos.cw.optional")
def test_switched_off_it_leaves_the_control_word_at_0000_and_still_reads_the_status(
    program: LoadedProgram,
) -> None:
    handshake = block(program, "TOS_Handshake")
    for new, status in ((True, 0x9F00), (False, 0x8003), (True, 0x1F00)):
        handshake(enable=False, newCommand=new, gatewayStatus=status)
        assert handshake.control == 0
        assert handshake.fault == (status == 0x8003)
    assert handshake.newStatus


def test_switched_on_bit_13_is_set_as_in_the_manuals_example(program: LoadedProgram) -> None:
    handshake = block(program, "TOS_Handshake")
    handshake(gatewayStatus=0x1F00)
    assert handshake.control == DATA_VALID
