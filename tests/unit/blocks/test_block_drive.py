"""TOS_Drive: which telegrams follow from what a drive is to do, and when it must not run.

Sources: TOSPBDP001 manual v1.1, 8 G; VF-AS1 RS485 manual E6581315, 8.1 (bits of the command word).
"""

from typing import Any

import pytest

from harness import LoadedProgram
from harness.engine.variables import plain
from tests.unit.blocks.channel_bench import COMMAND_SOURCE, CYCLE_MS, Answer, ChannelBench, echo

RUNNING = 0x0400


class DriveBench(ChannelBench):
    """TOS_Drive for INV-NO 11, polled as ready, enabled."""

    def __init__(self, program: LoadedProgram, **control: bool | float) -> None:
        super().__init__(program)
        self.block: Any = self.add("TOS_Drive", invNo=11, timeout=100, online=True)
        self.parameters = plain(self.block.params)
        self.parameters.update(maxFrequency=50.0)
        self.drive = plain(self.block.drive)
        self.drive["polled"].update(valid=True, invNo=11)
        self.control(enable=True, **control)
        self.cycles(10)

    def control(self, **values: bool | float) -> None:
        """What the drive is to do from now on."""
        self.drive["control"].update(values)

    def cycle(self) -> None:
        """One cycle with what the test wants and knows of the drive."""
        self.give(self.block, drive=self.drive, params=self.parameters)
        super().cycle()
        self.drive["state"] = plain(self.block.drive)["state"]

    @property
    def state(self) -> Any:
        """What the block says of the drive."""
        return self.drive["state"]

    def words(self) -> list[str]:
        """ComNo and data of all requests that write."""
        written = [one for one in self.requests if one.comno != COMMAND_SOURCE]
        return [f"{request.comno:04X} {request.data:04X}" for request in written]


def running(program: LoadedProgram) -> DriveBench:
    """A drive that runs forward at 40 Hz."""
    bench = DriveBench(program)
    bench.control(run=True, frequency=40.0)
    bench.cycles(10)
    bench.drive["polled"].update(statusWord=RUNNING, frequency=40.0)
    bench.cycles(3)
    bench.requests.clear()
    return bench


def test_enabled_it_takes_control_and_writes_the_set_point(program: LoadedProgram) -> None:
    bench = DriveBench(program)
    assert bench.words() == ["FA00 C000", "FA01 0000"]
    assert (bench.state["ready"], bench.state["remote"], bench.state["command"]) == (
        True,
        True,
        0xC000,
    )


def test_enabled_with_run_already_there_it_does_not_run(program: LoadedProgram) -> None:
    bench = DriveBench(program, run=True, frequency=40.0)
    assert bench.words() == ["FA00 C000", "FA01 0FA0"]
    assert (bench.state["inhibited"], bench.state["ready"]) == (True, False)
    bench.control(run=False)
    bench.cycles(2)
    bench.control(run=True)
    bench.cycles(10)
    assert bench.words()[-1] == "FA00 C400"


def test_the_set_point_goes_before_the_run_command(program: LoadedProgram) -> None:
    bench = DriveBench(program)
    bench.requests.clear()
    bench.control(run=True, frequency=40.0)
    bench.cycles(10)
    assert bench.words() == ["FA01 0FA0", "FA00 C400"]
    assert running(program).state["atSetpoint"]


def test_a_stop_goes_before_a_new_set_point_and_keeps_the_direction(program: LoadedProgram) -> None:
    bench = running(program)
    bench.control(reverse=True)
    bench.cycles(10)
    bench.control(run=False, reverse=False, frequency=10.0)
    bench.cycles(10)
    assert bench.words() == ["FA00 C600", "FA00 C200", "FA01 03E8"]


@pytest.mark.parametrize(
    ("control", "word"),
    [
        ({"emergencyStop": True}, "D000"),
        ({"coast": True}, "C800"),
        ({"dcBrake": True}, "C080"),
        ({"interlock": False}, "C000"),
        ({"jog": True}, "C500"),
        ({"preset": 15}, "C40F"),
        ({"preset": 16}, None),
        ({"preset": -1}, None),
    ],
)
def test_the_command_word_follows_what_the_drive_is_to_do(
    program: LoadedProgram, control: dict[str, bool], word: str | None
) -> None:
    bench = running(program)
    bench.control(**control)
    bench.cycles(10)
    assert bench.words() == ([f"FA00 {word}"] if word else [])


def test_manual_operation_has_its_own_values(program: LoadedProgram) -> None:
    bench = running(program)
    bench.control(manual=True)
    bench.cycles(10)
    bench.control(manualRun=True, manualReverse=True, manualFrequency=5.0)
    bench.cycles(10)
    assert bench.words() == ["FA00 C000", "FA01 0000", "FA01 01F4", "FA00 C600"]


def test_nothing_is_sent_while_nothing_changes_or_while_it_is_not_enabled(
    program: LoadedProgram,
) -> None:
    bench = running(program)
    bench.cycles(50)
    assert bench.words() == []
    bench.control(run=False)
    bench.cycles(10)
    bench.requests.clear()
    bench.control(enable=False, frequency=0.0)
    bench.cycles(50)
    assert bench.words() == []
    assert bench.block.active, "it is looked at until it stands"
    bench.drive["polled"].update(statusWord=0, frequency=0.0)
    bench.cycles(2)
    assert not bench.block.active
    assert bench.words() == []


def test_a_drive_that_runs_is_stopped_when_enable_is_taken_back(program: LoadedProgram) -> None:
    bench = running(program)
    bench.answer = lambda request: Answer(status=0x8401 if len(bench.requests) < 3 else 0)
    bench.control(enable=False, frequency=10.0, reset=True)
    bench.cycles(500)
    assert bench.words() == ["FA00 C000"] * 3
    bench.drive["polled"].update(statusWord=0, frequency=0.0)
    bench.cycles(2)
    assert not bench.block.active
    assert bench.words() == ["FA00 C000"] * 3


def test_a_run_command_on_its_way_is_followed_by_a_stop_when_enable_is_taken_back(
    program: LoadedProgram,
) -> None:
    bench = DriveBench(program)
    bench.requests.clear()
    bench.control(run=True)
    bench.cycles(1)
    bench.control(enable=False)
    bench.cycles(50)
    assert bench.words()[-2:] == ["FA00 C400", "FA00 C000"]


@pytest.mark.parametrize("cause", ["tripped", "online", "enable"])
def test_after_it_was_kept_from_running_it_needs_a_new_run(
    program: LoadedProgram, cause: str
) -> None:
    bench = running(program)

    def keep(on: bool) -> None:
        if cause == "tripped":
            bench.drive["polled"]["tripped"] = on
        elif cause == "online":
            bench.give(bench.block, online=not on)
        else:
            bench.control(enable=not on)

    keep(True)
    bench.cycles(5)
    keep(False)
    bench.cycles(20)
    assert bench.state["inhibited"]
    assert all(not request.data & RUNNING for request in bench.requests if request.comno == 0xFA00)
    bench.control(run=False)
    bench.cycles(2)
    bench.control(run=True)
    bench.cycles(20)
    assert bench.words()[-1] == "FA00 C400"


def test_a_run_command_without_acknowledgement_is_followed_by_a_stop(
    program: LoadedProgram,
) -> None:
    bench = DriveBench(program)
    bench.requests.clear()
    bench.control(run=True)
    bench.answer = lambda request: Answer(status=0x8401 if request.data == 0xC400 else 0)
    bench.cycles(10)
    assert (bench.state["error"], bench.state["inhibited"]) == (False, True)
    assert bench.words() == ["FA00 C400", "FA00 C000"]


def test_a_stop_is_repeated_until_it_is_acknowledged(program: LoadedProgram) -> None:
    bench = running(program)
    bench.answer = lambda request: Answer(status=0x8401)
    bench.control(run=False)
    bench.cycles(1000 // CYCLE_MS)
    sent = len(bench.requests)
    assert (sent, bench.state["error"], bench.state["status"]) == (1, True, 0x8401)
    bench.cycles(2000 // CYCLE_MS)
    assert bench.words() == ["FA00 C000"] * 3
    bench.answer = echo
    bench.cycles(2000 // CYCLE_MS)
    assert bench.words() == ["FA00 C000"] * 4
    assert not bench.state["error"]


def test_a_reset_has_no_reply_and_control_is_taken_again_after_the_restart(
    program: LoadedProgram,
) -> None:
    bench = running(program)
    bench.drive["polled"].update(tripped=True, tripCode=3, statusWord=0)
    bench.cycles(10)
    assert not bench.state["running"]
    bench.requests.clear()
    bench.control(reset=True)
    bench.cycles(10)
    assert bench.words() == ["FA00 E000"]
    assert not bench.requests[0].reply_expected
    assert bench.state["resetting"]
    bench.drive["polled"].update(tripped=False, tripCode=0)
    bench.cycles(1800 // CYCLE_MS)
    assert len(bench.requests) == 1
    bench.cycles(400 // CYCLE_MS)
    assert bench.words() == ["FA00 E000", "FA00 C000", "FA01 0FA0"]
    assert not bench.state["resetting"]


def test_a_reset_without_a_trip_does_nothing(program: LoadedProgram) -> None:
    bench = running(program)
    bench.control(reset=True)
    bench.cycles(10)
    assert bench.words() == []
