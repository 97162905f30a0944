"""TOS_Alarms: each cause raises its own bit, and nothing else does."""

from typing import Any

import pytest

from harness import LoadedProgram
from harness.engine.loading import ENGINES
from harness.engine.variables import plain
from tests.unit.blocks.programs import ALL_SEQUENCES, block, loaded

RUN = {"enable": True, "run": True}
OTHER_WAY = {"enable": True, "manual": True, "run": True}
BY_HAND = {"enable": True, "manual": True, "manualRun": True, "run": False}

DRIVE = [
    (0x0001, {"polled": {"tripped": True}}),
    (0x0002, {"polled": {"lost": True}}),
    (0x0004, {"state": {"error": True}}),
    (0x0008, {"control": {"emergencyStop": True}}),
    (0x0010, {"control": RUN, "state": {"inhibited": True}}),
    (0x0010, {"control": BY_HAND, "state": {"inhibited": True}}),
    (0x0000, {"control": {"enable": True}, "state": {"inhibited": True}}),
    (0x0000, {"control": OTHER_WAY, "state": {"inhibited": True}}),
    (0x0000, {"control": {"run": True}, "state": {"inhibited": True}}),
    (0x0020, {"control": {**RUN, "interlock": False}}),
    (0x0020, {"control": {**BY_HAND, "interlock": False}}),
    (0x0000, {"control": {"enable": True, "interlock": False}}),
    (0x0040, {"read_current": {"error": True}}),
    (0x0040, {"emergency_stop": {"error": True}}),
    (0x0043, {"polled": {"tripped": True, "lost": True}, "stop": {"error": True}}),
]  # fmt: skip

LINE = [
    (0x0001, {"online": False}),
    (0x0004, {"gatewayFault": True}),
    (0x0008, {"emergencyStop": True, "stopped": True}),
    (0x0008, {"emergencyStop": True, "stopping": True}),
    (0x0018, {"emergencyStop": True, "unreached": 1}),
    (0x0000, {"unreached": 1}),
]  # fmt: skip


def words(
    program: LoadedProgram,
    line: dict[str, Any] | None = None,
    drive: dict[str, dict[str, Any]] | None = None,
) -> tuple[int, int]:
    """The alarm words of a line that is online and a drive that is well, but for what is given."""
    alarms = block(program, "TOS_Alarms")
    given = plain(alarms.drive)
    given["control"]["interlock"] = True
    given["state"]["inhibited"] = False
    for part, values in (drive or {}).items():
        given[part].update(values)
    alarms(line={"online": True, **(line or {})}, drive=given)
    return plain(alarms.line)["alarms"], plain(alarms.drive)["alarms"]


def test_without_a_cause_there_is_no_alarm(program: LoadedProgram) -> None:
    assert words(program) == (0, 0)


@pytest.mark.parametrize(("word", "cause"), DRIVE)
def test_each_cause_of_a_drive_raises_its_bit(
    word: int, cause: dict[str, dict[str, Any]], program: LoadedProgram
) -> None:
    assert words(program, drive=cause) == (0, word)


@pytest.mark.parametrize(("word", "cause"), LINE)
def test_each_cause_of_a_line_raises_its_bit(
    word: int, cause: dict[str, Any], program: LoadedProgram
) -> None:
    assert words(program, line=cause) == (word, 0)


def test_a_failed_access_is_an_alarm_where_the_access_tells_it() -> None:
    """The others have no RET_VAL."""
    with_result = "dpxx_dat\n    hardware_identifier: 270"
    whole = ALL_SEQUENCES.replace("gsd10", "whole10").replace("per_identifier", with_result)
    for engine in ENGINES:
        assert words(loaded(whole, engine), line={"ioError": True}) == (0x0002, 0)
        assert words(loaded(ALL_SEQUENCES, engine), line={"ioError": True}) == (0, 0)


def test_an_alarm_is_gone_with_its_cause(program: LoadedProgram) -> None:
    alarms = block(program, "TOS_Alarms")
    drive = plain(alarms.drive)
    drive["polled"]["tripped"] = True
    alarms(line={"online": False}, drive=drive)
    assert plain(alarms.line)["alarms"] == 1
    drive["polled"]["tripped"] = False
    alarms(line={"online": True}, drive=drive)
    assert (plain(alarms.line)["alarms"], plain(alarms.drive)["alarms"]) == (0, 0)
