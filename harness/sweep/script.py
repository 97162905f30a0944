"""What every run of a sweep asks of its line: what is most easily taken for something else.

Equal requests one after the other, the same ComNo of two drives, the ComNos that the blocks
themselves use in between, writes of the same value, broadcasts with and without a drive that
answers them, telegrams without reply, a refusal, several users at once; and a drive that dies
between two equal requests.
"""

from collections.abc import Sequence

from harness.kernel import NS_PER_MS
from harness.sweep.answering import UNKNOWN_COM_NO
from harness.sweep.requests import (
    BROADCAST,
    COMMAND_WORD,
    FAULT_RESET,
    READ,
    SETPOINT,
    WRITE_EEPROM,
    WRITE_RAM,
    Ask,
    Die,
    Pause,
    Request,
    Revive,
    Step,
)

_TRIP, _STATUS, _CURRENT, _FREQUENCY = 0xFC90, 0xFD01, 0xFE03, 0xFD00
_FREQUENCY_SETPOINT, _ACCELERATION = 0xFA01, 0x0009
_RUN, _STOP = 0xC400, 0xC000


def refused_request(inv_nos: Sequence[int]) -> Request:
    """The one request that a living drive refuses."""
    return Request(2, inv_nos[1], READ, UNKNOWN_COM_NO)


def script(inv_nos: Sequence[int]) -> tuple[Step, ...]:
    """The requests to the first two drives of a line; the channel of a drive is its place."""
    first, second = inv_nos[:2]
    answered = 0 in inv_nos

    def one(inv_no: int, cmd: int, com_no: int, data: int = 0, *, reply: bool = True) -> Request:
        channel = inv_nos.index(inv_no) + 1 if inv_no in inv_nos else 0
        return Request(channel, inv_no, cmd, com_no, data, reply)

    def ask(*requests: Request) -> Ask:
        return Ask(requests)

    run = one(first, WRITE_RAM, COMMAND_WORD, _RUN)
    current = one(first, READ, _CURRENT)
    everywhere = one(BROADCAST, WRITE_RAM, COMMAND_WORD, _STOP, reply=answered)
    return (
        ask(run),
        ask(run),
        ask(current),
        ask(current),
        ask(one(second, READ, _CURRENT)),
        ask(current, one(second, READ, _CURRENT)),
        ask(one(first, READ, _TRIP)),
        ask(one(first, READ, _TRIP)),
        ask(one(first, READ, _STATUS)),
        ask(one(first, READ, _TRIP), one(second, READ, _TRIP)),
        ask(one(first, SETPOINT, _FREQUENCY_SETPOINT, 5000, reply=False)),
        ask(one(first, WRITE_EEPROM, _ACCELERATION, 50)),
        ask(one(first, WRITE_EEPROM, _ACCELERATION, 50)),
        ask(everywhere),
        ask(everywhere),
        ask(one(0, READ, COMMAND_WORD) if answered else current),
        Pause(70 * NS_PER_MS),
        ask(one(second, WRITE_RAM, COMMAND_WORD, _STOP | FAULT_RESET, reply=False)),
        ask(refused_request(inv_nos)),
        ask(one(second, READ, _FREQUENCY), run),
        ask(current),
        Die(first),
        ask(current),
        ask(run, one(second, READ, _CURRENT)),
        ask(one(first, WRITE_EEPROM, _ACCELERATION, 51)),
        Revive(first),
        ask(run),
        ask(current),
        Die(second),
        ask(one(second, WRITE_EEPROM, _ACCELERATION, 52)),
        ask(one(second, READ, _CURRENT)),
        ask(current),
        Revive(second),
        ask(one(second, READ, _CURRENT)),
        Die(first),
        ask(run),
        Revive(first),
        ask(one(first, READ, _TRIP)),
    )
