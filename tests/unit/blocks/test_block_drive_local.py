"""TOS_Drive and a drive that somebody switches to its panel or its terminals.

Source: VF-AS1 RS485 manual E6581315, 8.1: input functions take the command away from the network,
and the priority of the network lasts until power off or reset. FD45 is unverified.
"""

from harness import LoadedProgram
from tests.unit.blocks.channel_bench import (
    COMMAND_SOURCE,
    CYCLE_MS,
    TERMINALS,
    Answer,
    Request,
    echo,
)
from tests.unit.blocks.test_block_drive import DriveBench, running

LOOK = 2000 // CYCLE_MS + 10


def at_its_terminals(request: Request) -> Answer:
    return Answer(TERMINALS) if request.comno == COMMAND_SOURCE else echo(request)


def test_an_enabled_drive_is_asked_every_two_seconds_who_commands_it(
    program: LoadedProgram,
) -> None:
    bench = DriveBench(program)
    bench.cycles(3 * LOOK)
    looks = [one for one in bench.requests if one.comno == COMMAND_SOURCE]
    assert [(one.cmd, one.reply_expected) for one in looks] == [(0x47, True)] * 3
    assert (bench.state["local"], bench.state["remote"], bench.state["ready"]) == (
        False,
        True,
        True,
    )


def test_a_drive_that_is_not_enabled_is_not_asked(program: LoadedProgram) -> None:
    bench = DriveBench(program)
    bench.control(enable=False)
    bench.cycles(20)
    bench.requests.clear()
    bench.cycles(2 * LOOK)
    assert not bench.requests


def test_switched_to_local_it_is_not_told_to_run(program: LoadedProgram) -> None:
    bench = running(program)
    bench.answer = at_its_terminals
    bench.cycles(LOOK)
    assert (bench.state["local"], bench.state["remote"], bench.state["ready"]) == (
        True,
        False,
        False,
    )
    assert bench.words()[-1] == "FA00 C000"


def test_switched_back_it_runs_only_when_run_was_taken_back(program: LoadedProgram) -> None:
    bench = running(program)
    bench.answer = at_its_terminals
    bench.cycles(LOOK)
    bench.control(run=False)
    bench.cycles(5)
    bench.control(run=True)
    bench.cycles(5)
    bench.answer = echo
    bench.cycles(LOOK)
    assert not bench.state["local"]
    assert bench.words()[-1] == "FA00 C000"
    bench.control(run=False)
    bench.cycles(5)
    bench.control(run=True)
    bench.cycles(10)
    assert bench.words()[-1] == "FA00 C400"


def test_the_network_takes_the_command_again(program: LoadedProgram) -> None:
    bench = DriveBench(program)
    bench.answer = at_its_terminals
    bench.cycles(LOOK)
    bench.requests.clear()
    bench.cycles(LOOK)
    assert bench.words() == ["FA00 C000"]


def test_where_it_does_not_inhibit_it_is_only_shown(program: LoadedProgram) -> None:
    bench = running(program)
    bench.parameters.update(localInhibits=False)
    bench.answer = at_its_terminals
    bench.cycles(LOOK)
    assert (bench.state["local"], bench.state["remote"]) == (True, False)
    assert bench.words() == []


def test_no_answer_changes_nothing(program: LoadedProgram) -> None:
    bench = running(program)
    bench.answer = lambda request: (
        Answer(status=0x8401) if request.comno == COMMAND_SOURCE else echo(request)
    )
    bench.cycles(LOOK)
    assert (bench.state["local"], bench.state["remote"], bench.state["error"]) == (
        False,
        True,
        False,
    )
    assert bench.words() == []
