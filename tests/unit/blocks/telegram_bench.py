"""TOS_Telegram on the bench: the cyclic data as bytes, and a gateway that is told what to answer.

The block is called every 10 ms, as in a cycle of that length.
"""

from harness import LoadedProgram
from tests.unit.blocks.programs import block, octets

CYCLE_MS = 10
READ, WRITE, WRITE_EEPROM, SET_POINT, SET_POINT_TRIPPED = 0x47, 0x50, 0x57, 0x53, 0x73
LOWER_CASE = 0x20
FIRST = 5
"""The drive to which the first read goes."""
GAP_MS = 60
COMMAND_BIT = 0x4000


class TelegramBench:
    """One instance of the block, its first read over. Its inputs stay until they are given anew."""

    def __init__(self, program: LoadedProgram, **inputs: bool | int) -> None:
        self.program = program
        self.block = block(program, "TOS_Telegram")
        self.status = 0x9F00
        self.reply = (0, 0, 0, 0)
        self.sent: list[str] = []
        """The nine bytes at every change of the trigger that a gateway sees."""
        self._trigger = 0
        self.call(firstInvNo=FIRST, gap=GAP_MS, **inputs)
        self.receive(FIRST, READ, 0xFC90, 0)
        self.reply = (0, 0, 0, 0)
        self.cycles(2)
        self.sent.clear()

    def call(self, **inputs: bool | int) -> None:
        """One cycle: the time passes, the block is called, a new telegram is noted."""
        self.program.clock.advance(ms=CYCLE_MS)
        inv_no, cmd, comno, data = self.reply
        frame = {
            "gatewayStatus": self.status,
            "invNo": inv_no,
            "cmd": cmd,
            "comNo": comno,
            "data": data,
        }
        self.block(**inputs, frameIn=frame)
        there = self.status != 0 and not self.block.ioError
        if there and self.block.frameOut.trigger != self._trigger:
            self._trigger = self.block.frameOut.trigger
            self.sent.append(self.frame())
            self.status = self.status & ~COMMAND_BIT | self.block.frameOut.control & COMMAND_BIT

    def send(self, inv_no: int, cmd: int, comno: int, data: int = 0, **more: bool | int) -> None:
        """A rising edge of execute with a job."""
        self.call(execute=False)
        self.call(execute=True, invNo=inv_no, cmd=cmd, comNo=comno, data=data, **more)

    def receive(self, inv_no: int, cmd: int, comno: int, data: int) -> None:
        """A reply as soon as one can come: two cycles are the gateway's and the drive's."""
        self.cycles(2)
        self.receive_at_once(inv_no, cmd, comno, data)

    def receive_at_once(self, inv_no: int, cmd: int, comno: int, data: int) -> None:
        """The cyclic inputs hold another reply from now on; one cycle."""
        self.reply = (inv_no, cmd, comno, data)
        self.call()

    def receive_octets(self, text: str) -> None:
        """The same with all eight bytes as the manual prints them."""
        data = bytes.fromhex(text)
        self.status = int.from_bytes(data[:2], "big")
        self.receive(data[2], data[3], int.from_bytes(data[4:6]), int.from_bytes(data[6:]))

    def cycles(self, number: int, **inputs: bool | int) -> None:
        """Several cycles in which nothing is received."""
        for _ in range(number):
            self.call(**inputs)

    def until_finished(self, most: int = 200) -> int:
        """Cycles until the job is over; how many they were."""
        for number in range(1, most + 1):
            self.call()
            if not self.block.busy:
                return number
        raise AssertionError(f"still busy after {most} cycles")

    def frame(self) -> str:
        """The nine bytes of frameOut in the manual's order."""
        frame = self.block.frameOut
        return octets(
            (frame.control, 2),
            (frame.trigger, 1),
            (frame.invNo, 1),
            (frame.cmd, 1),
            (frame.comNo, 2),
            (frame.data, 2),
        )
