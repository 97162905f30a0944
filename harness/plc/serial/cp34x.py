"""P_SND_RK and P_RCV_RK of the CP 341, P_SEND and P_RCV of the CP 340, SEND_440 and RECV_440 of the
CP 440, with the ASCII driver.

Source: TIA Portal Information System, "PtP data link CP 341", "... CP 340", "... CP 440": their
parameters and STATUS. Those of the CP 340 and CP 440 lack the parameters for RK 512, and a CP 440
sends 400 bytes at most. STATUS is 0 unless ERROR is set. What is sent and received lies in a data
block that the call names by number.
"""

from collections.abc import Mapping

from harness.engine.block_models import Outputs
from harness.plc.serial.jobs import PortInstruction, done, failed, idle
from harness.plc.serial.module import CANCELLED, OVERFLOW, TOO_MANY, SendJob, SerialModule
from harness.plc.serial.reader import Message

NO_DATA_BLOCK, TARGET_TOO_SHORT, TOO_LONG, WRONG_LENGTH = 0x0301, 0x040A, 0x0517, 0x1E41
NO_ROOM, DAMAGED = 0x080A, 0x080C
RESET, NOT_READ, NOT_WRITTEN = 0x1E0D, 0x1E0E, 0x1E0F
_LONGEST = 1024


class PSend(PortInstruction):
    """P_SND_RK and P_SEND: sends LEN bytes of a data block."""

    __slots__ = ("_job",)

    port_name = "LADDR"
    longest = _LONGEST
    _job: SendJob | None

    def forget(self) -> None:
        """No job is under way."""
        self._job = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """REQ, R, LADDR, DB_NO, DBB_NO, LEN to DONE, ERROR, STATUS."""
        rises = self.rises()
        if module is None:
            was, self._job = self._job, None
            return failed(NOT_WRITTEN) if rises or was is not None else idle(0)
        if self.flag("R"):
            was, self._job = self._job, None
            return failed(RESET) if was is not None else idle(0)
        if self._job is not None:
            if not self._job.over(self._ports.now_ns):
                return idle(0)
            status, self._job = self._job.status, None
            return failed(RESET if status == CANCELLED else status) if status else done()
        if not rises:
            return idle(0)
        memory = self._ports.data_block(self.number("DB_NO"))
        first, length = self.number("DBB_NO"), self.number("LEN")
        if length < 1:
            return failed(WRONG_LENGTH)
        if length > self.longest:
            return failed(TOO_LONG)
        if memory is None or first < 0 or first + length > len(memory):
            return failed(NO_DATA_BLOCK)
        self._job = module.send(bytes(memory[first : first + length]))
        return idle(0)


class Send440(PSend):
    """SEND_440."""

    __slots__ = ()

    longest = 400


class PReceive(PortInstruction):
    """P_RCV_RK and P_RCV: puts the oldest message into a data block."""

    __slots__ = ("_due_ns", "_message")

    port_name = "LADDR"
    _due_ns: int
    _message: Message | None

    def forget(self) -> None:
        """No message is on its way."""
        self._message = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """EN_R, R, LADDR, DB_NO, DBB_NO to NDR, ERROR, STATUS, LEN."""
        if module is None:
            return _received(NOT_READ)
        if self.flag("R") or not self.flag("EN_R"):
            was, self._message = self._message, None
            return _received(RESET if was is not None else 0)
        if self._message is None:
            self._message = module.take()
            self._due_ns = self._ports.now_ns + module.transfer_ns
            return _received(0)
        if self._ports.now_ns < self._due_ns:
            return _received(0)
        message, self._message = self._message, None
        if message.failed:
            return _received(NO_ROOM if message.status in (OVERFLOW, TOO_MANY) else DAMAGED)
        memory, first = self._ports.data_block(self.number("DB_NO")), self.number("DBB_NO")
        length = len(message.data)
        if memory is None or first < 0 or first + length > len(memory):
            return _received(TARGET_TOO_SHORT)
        memory[first : first + length] = message.data
        return Outputs(NDR=True, ERROR=False, STATUS=0, LEN=length)


def _received(status: int) -> Outputs:
    return Outputs(NDR=False, ERROR=status != 0, STATUS=status, LEN=0)
