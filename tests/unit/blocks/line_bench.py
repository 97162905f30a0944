"""The line behind a gateway on the bench: users take it in turn, requests are answered by the test.

What `TOS_Gateway` does around its users is done here by hand: every user is called once a cycle,
in a fixed order, with the same `typeTosLine`; a request gets its reply some cycles later.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from harness import LoadedProgram
from harness.engine.interface import Value
from harness.engine.variables import plain
from tests.unit.blocks.programs import block

CYCLE_MS = 10


@dataclass(frozen=True, slots=True)
class Request:
    """A telegram that a user of the line asked for."""

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
    """What a drive that is well does: it repeats what was written."""
    return Answer(request.data)


class LineBench:
    """Users of one line. `answer` decides what becomes of each request."""

    def __init__(self, program: LoadedProgram, answer: Callable[[Request], Answer] = echo) -> None:
        self.program = program
        self.answer = answer
        self.requests: list[Request] = []
        self.cycles_to_reply = 2
        self.users: list[Any] = []
        self._inputs: list[dict[str, Value]] = []
        self._line: Any = {
            "owner": 0,
            "request": {"execute": False},
            "reply": {"done": False, "error": False},
        }
        self._waiting = 0

    def add(self, name: str, **inputs: Value) -> Any:
        """A user of the line with the next slot; inputs stay until they are given anew."""
        user = block(self.program, name)
        self.users.append(user)
        self._inputs.append({"slot": len(self.users), **inputs})
        return user

    def give(self, user: Any, **inputs: Value) -> None:
        """Change inputs of a user from its next call on."""
        self._inputs[self.users.index(user)].update(inputs)

    def cycle(self) -> None:
        """One cycle: the reply, then every user in order, then perhaps a new request."""
        self.program.clock.advance(ms=CYCLE_MS)
        for user, inputs in zip(self.users, self._inputs, strict=True):
            user(**inputs, line=self._line)
            self._line = plain(user.line)
        reply, request = self._line["reply"], self._line["request"]
        if reply["done"] or reply["error"]:
            reply["done"] = reply["error"] = False
            self._waiting = 0
        elif request["execute"]:
            self._waiting += 1
            if self._waiting == 1:
                self.requests.append(self._asked())
            if self._waiting > self.cycles_to_reply:
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
    def owner(self) -> int:
        """The slot that has the line, 0 for nobody."""
        return int(self._line["owner"])

    def sent(self) -> list[str]:
        """All requests as text."""
        return [str(request) for request in self.requests]

    def _asked(self) -> Request:
        request = self._line["request"]
        return Request(
            self.owner,
            request["invNo"],
            request["cmd"],
            request["comNo"],
            request["data"],
            request["replyExpected"],
        )
