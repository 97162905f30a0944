"""Send_P2P, Receive_P2P and Receive_Reset.

Source: TIA Portal Information System, "Freeport communication": "Send_P2P: Sending data",
"Receive_P2P: Receiving data", "Using the BUFFER and LENGTH parameters", "Error messages". A job
takes several calls: STATUS is 7001 in the first, 7002 in the next ones; DONE, NDR, ERROR and what
STATUS says then are there for one call. Not told: a message that is longer than BUFFER is gone.
"""

from collections.abc import Mapping

from harness.engine.block_models import Outputs
from harness.plc.serial.conditions import LONGEST_MESSAGE
from harness.plc.serial.jobs import (
    FIRST_CALL,
    IDLE,
    MODULE_MISSING,
    NEXT_CALL,
    PortInstruction,
    TimedInstruction,
    done,
    failed,
    idle,
)
from harness.plc.serial.module import SendJob, SerialModule
from harness.plc.serial.reader import Message

BAD_LENGTH, BUFFER_TOO_SHORT = 0x8085, 0x8088
ALREADY_SENDING, TOO_LONG = 0x81D0, 0x81D3


class SendP2p(PortInstruction):
    """Sends BUFFER, or its first LENGTH bytes."""

    __slots__ = ("_job",)

    areas = ("BUFFER",)
    _job: SendJob | None

    def forget(self) -> None:
        """No job is under way."""
        self._job = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """REQ, PORT, BUFFER, LENGTH to DONE, ERROR, STATUS."""
        rises = self.rises()
        if module is None:
            was, self._job = self._job, None
            return failed(MODULE_MISSING) if rises or was is not None else idle()
        if self._job is not None:
            if not self._job.over(self._ports.now_ns):
                return idle(NEXT_CALL)
            status, self._job = self._job.status, None
            return failed(status) if status else done()
        if not rises:
            return idle()
        buffer, length = areas["BUFFER"], self.number("LENGTH")
        if length > len(buffer):
            return failed(BUFFER_TOO_SHORT)
        if length < 0:
            return failed(BAD_LENGTH)
        if module.sending:
            return failed(ALREADY_SENDING)
        data = buffer[: length or len(buffer)]
        if len(data) > min(module.buffer_bytes, LONGEST_MESSAGE):
            return failed(TOO_LONG)
        self._job = module.send(data)
        return idle(FIRST_CALL)


class ReceiveP2p(PortInstruction):
    """Fetches the oldest message of the module into BUFFER."""

    __slots__ = ("_due_ns", "_message")

    areas = ("BUFFER",)
    _due_ns: int
    _message: Message | None

    def forget(self) -> None:
        """No message is on its way."""
        self._message = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """PORT, BUFFER to NDR, ERROR, STATUS, LENGTH."""
        if module is None:
            return _received(ERROR=True, STATUS=MODULE_MISSING)
        if self._message is None:
            self._message = module.take()
            self._due_ns = self._ports.now_ns + module.transfer_ns
            return _received(STATUS=IDLE if self._message is None else FIRST_CALL)
        if self._ports.now_ns < self._due_ns:
            return _received(STATUS=NEXT_CALL)
        message, self._message = self._message, None
        if message.failed:
            return _received(ERROR=True, STATUS=message.status)
        if len(message.data) > len(areas["BUFFER"]):
            return _received(ERROR=True, STATUS=BUFFER_TOO_SHORT)
        length = len(message.data)
        return Outputs(
            {"BUFFER": message.data}, NDR=True, ERROR=False, STATUS=message.status, LENGTH=length
        )


def _received(*, ERROR: bool = False, STATUS: int) -> Outputs:  # noqa: N803  # PLC names
    return Outputs(NDR=False, ERROR=ERROR, STATUS=STATUS, LENGTH=0)


class ReceiveReset(TimedInstruction):
    """Deletes what the module has received."""

    __slots__ = ()

    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """Nothing yet."""
        return 0

    def end(self, module: SerialModule) -> None:
        """All of it is gone."""
        module.clear()
