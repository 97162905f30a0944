"""TOS_Line on the bench: channels of drives and of the poll, and drives that answer."""

from collections.abc import Callable
from typing import Any

from harness import LoadedProgram
from harness.engine.variables import plain
from tests.unit.blocks.programs import block
from tests.unit.blocks.telegram_bench import CYCLE_MS, FIRST, READ, WRITE

GAP_MS = 60
TIMEOUT_MS = 100
DRIVES = 5
POLL = 0


class LineBench:
    """One line with five drives, INV-NO 11 to 15. `answers` says which of them answer.

    Every telegram is noted as `INV-NO CMD ComNo DATA`; the first read is over.
    """

    def __init__(self, program: LoadedProgram, **inputs: bool | int) -> None:
        self.program = program
        self.block = block(program, "TOS_Line")
        self.answers: Callable[[int], bool] = lambda inv_no: True
        self.cycles_to_reply = 2
        self.sent: list[str] = []
        self.times: list[int] = []
        self.channels: Any = [
            {
                "invNo": 10 + number,
                "user": 0,
                "request": {"execute": False, "cmd": READ, "replyExpected": True},
                "reply": {"done": False, "error": False, "status": 0},
            }
            for number in range(DRIVES + 1)
        ]
        self.now_ms = 0
        self._status = 0x9F00
        self._reply = {"invNo": 0, "cmd": 0, "comNo": 0, "data": 0}
        self._waiting = 0
        self._trigger = 0
        self.call(count=DRIVES, firstInvNo=FIRST, gap=GAP_MS, timeout=TIMEOUT_MS, **inputs)
        self.cycles(GAP_MS // CYCLE_MS + 1)
        self.sent.clear()
        self.times.clear()

    def ask(self, number: int, cmd: int, comno: int, data: int = 0, timeout: int = 100) -> None:
        """A request on a channel; 0 is the poll's, which reads drive 11."""
        self.channels[number]["reply"].update(done=False, error=False)
        self.channels[number]["request"].update(
            execute=True,
            invNo=10 + (number or 1),
            cmd=cmd,
            comNo=comno,
            data=data,
            replyExpected=True,
            timeout=timeout,
        )

    def run(self, number: int) -> None:
        """A start command on the channel of a drive."""
        self.ask(number, WRITE, 0xFA00, 0xC400)

    def call(self, **inputs: bool | int) -> None:
        """One cycle: the time passes, the line is called, what it sends is noted and answered."""
        self.program.clock.advance(ms=CYCLE_MS)
        self.now_ms += CYCLE_MS
        frame = {"gatewayStatus": self._status, **self._reply}
        self.block(**inputs, channels=self.channels, frameIn=frame)
        self.channels = plain(self.block.channels)
        out = self.block.frameOut
        if out.trigger != self._trigger and not self.block.ioError:
            self._trigger = out.trigger
            self._waiting = self.cycles_to_reply
            self.sent.append(f"{out.invNo:02X} {out.cmd:02X} {out.comNo:04X} {out.data:04X}")
            self.times.append(self.now_ms)
            self._asked = {name: getattr(out, name) for name in self._reply}
        elif self._waiting:
            self._waiting -= 1
            if self._waiting == 0 and self.answers(self._asked["invNo"]):
                self._reply = self._asked

    def cycles(self, number: int, **inputs: bool | int) -> None:
        """Several cycles."""
        for _ in range(number):
            self.call(**inputs)

    def until(self, condition: Callable[[], bool], most: int = 2000) -> None:
        """Cycles until the condition holds."""
        for _ in range(most):
            if condition():
                return
            self.call()
        raise AssertionError(f"not within {most} cycles")

    def reply(self, number: int) -> tuple[bool, bool, int]:
        """done, error and status of a channel."""
        found = self.channels[number]["reply"]
        return found["done"], found["error"], found["status"]
