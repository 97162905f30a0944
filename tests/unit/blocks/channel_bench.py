"""The channel of a drive on the bench: users take it in turn, the test answers the requests.

What `TOS_Drive` and `TOS_Line` do around them is done here by hand: every user is called once a
cycle, in a fixed order, with the same `typeTosChannel`; a request gets its reply some cycles later.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from harness import LoadedProgram
from harness.engine.interface import Value
from harness.engine.variables import plain
from tests.unit.blocks.programs import block

CYCLE_MS = 10
COMMAND_SOURCE, NETWORK, TERMINALS = 0xFD45, 2, 0
"""Who commands a drive: the ComNo, and two of its values."""


@dataclass(frozen=True, slots=True)
class Request:
    """A telegram that a user of the channel asked for."""

    slot: int
    inv_no: int
    cmd: int
    comno: int
    data: int
    reply_expected: bool

    def __str__(self) -> str:
        return f"{self.inv_no:02X} {self.cmd:02X} {self.comno:04X} {self.data:04X}"


@dataclass(frozen=True, slots=True)
class Answer:
    """What the test answers: data, or an error when `status` is not 0."""

    data: int = 0
    status: int = 0
    tripped: bool = False


def echo(request: Request) -> Answer:
    """What a drive that is well does: it repeats what was written, and obeys the network."""
    return Answer(NETWORK if request.comno == COMMAND_SOURCE else request.data)


class ChannelBench:
    """Users of one channel. `answer` decides what becomes of each request."""

    def __init__(self, program: LoadedProgram, answer: Callable[[Request], Answer] = echo) -> None:
        self.program = program
        self.answer = answer
        self.requests: list[Request] = []
        self.cycles_to_reply = 2
        self.users: list[Any] = []
        self._inputs: list[dict[str, Value]] = []
        self._channel: Any = {
            "user": 0,
            "request": {"execute": False},
            "reply": {"done": False, "error": False},
        }
        self._on_its_way = False
        self._waiting = 0

    def add(self, name: str, **inputs: Value) -> Any:
        """A user, a sequence with the next slot; inputs stay until they are given anew."""
        user = block(self.program, name)
        self.users.append(user)
        slot = {"slot": len(self.users)} if name.startswith("TOS_Seq_") else {}
        self._inputs.append({**slot, **inputs})
        return user

    def give(self, user: Any, **inputs: Value) -> None:
        """Change inputs of a user from its next call on."""
        self._inputs[self.users.index(user)].update(inputs)

    def cycle(self) -> None:
        """One cycle: the reply, then every user in order, then perhaps a new request."""
        self.program.clock.advance(ms=CYCLE_MS)
        for user, inputs in zip(self.users, self._inputs, strict=True):
            user(**inputs, channel=self._channel)
            self._channel = plain(user.channel)
        reply, request = self._channel["reply"], self._channel["request"]
        if request["execute"]:
            assert not self._on_its_way
            self._on_its_way = True
            self._waiting = 0
            request["execute"] = False
            self.requests.append(self._asked())
        if self._on_its_way:
            self._waiting += 1
            if self._waiting > self.cycles_to_reply:
                self._on_its_way = False
                answer = self.answer(self.requests[-1])
                reply.update(
                    done=not answer.status,
                    error=bool(answer.status),
                    status=answer.status,
                    data=answer.data,
                    tripped=answer.tripped,
                )

    def cycles(self, number: int) -> None:
        """Several cycles."""
        for _ in range(number):
            self.cycle()

    def until(self, condition: Callable[[], bool], most: int = 1000) -> int:
        """Cycles until the condition holds; how many they were."""
        for number in range(most):
            if condition():
                return number
            self.cycle()
        raise AssertionError(f"not within {most} cycles")

    @property
    def user(self) -> int:
        """The slot that has the channel, 0 for nobody."""
        return int(self._channel["user"])

    def sent(self) -> list[str]:
        """All requests as text."""
        return [str(request) for request in self.requests]

    def _asked(self) -> Request:
        request = self._channel["request"]
        return Request(
            self.user,
            request["invNo"],
            request["cmd"],
            request["comNo"],
            request["data"],
            request["replyExpected"],
        )
