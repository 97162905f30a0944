"""Modbus_Comm_Load and Modbus_Master, MB_COMM_LOAD and MB_MASTER: MODBUS-RTU out of the CPU.

Sources: TIA Portal Information System, "MODBUS (RTU)"; S7-1200 System Manual A5E02486680, 13.5.
Our own: MB_DB of the master holds the port that the load has tied to it; a reply that is not right
ends the job, only silence is tried again; frames end behind 3.5 characters (1.75 ms above 19 200
Bd), measured to the end of the next character. Not here: coils and inputs (8189).
"""

from collections.abc import Mapping

from fbgen.dataclass import dataclass
from fbgen.wire.modbus import (
    BROADCAST,
    EXCEPTION_BIT,
    HIGHEST_ADDRESS,
    MOST_READ,
    MOST_WRITTEN,
    ExceptionCode,
    Function,
    crc,
    seal,
)
from harness.engine.block_models import Outputs
from harness.kernel import NS_PER_MS
from harness.line import Parity, SerialFormat
from harness.plc.serial.conditions import ReceiveConditions
from harness.plc.serial.jobs import (
    FIRST_CALL,
    IDLE,
    MODULE_MISSING,
    NEXT_CALL,
    PortInstruction,
    TimedInstruction,
)
from harness.plc.serial.module import ModbusSettings, SendJob, SerialModule
from harness.plc.serial.reader import FRAMING, PARITY

NOT_LOADED, BAD_BAUD, BAD_PARITY, BAD_FLOW_CONTROL, BAD_TIME_OUT = range(0x8180, 0x8185)
BAD_ADDRESS = 0x8186
BAD_MODE, BAD_DATA_ADDRESS, BAD_LENGTH, BAD_POINTER = range(0x8188, 0x818C)
NO_REPLY, PORT_BUSY = 0x80C8, 0x8200
WRONG_CHECK_SUM, WRONG_FUNCTION, WRONG_SLAVE, OTHER_REPLY = 0x8380, 0x8386, 0x8387, 0x8388
_DAMAGED = {PARITY: 0x80E1, FRAMING: 0x80E2}
_OVERFLOW = 0x80E0
_REFUSED: dict[int, int] = {
    **{ExceptionCode.FUNCTION: 0x8381, ExceptionCode.VALUE: 0x8382, ExceptionCode.ADDRESS: 0x8383},
}
_REFUSED_OTHERWISE = 0x8384
_BAUD_RATES = (
    *(300, 600, 1200, 2400, 3600, 4800, 6000, 9600, 19_200, 38_400, 57_600, 76_800, 115_200),
)
_PARITIES = (Parity.NONE, Parity.ODD, Parity.EVEN)
_READ_INPUT = 0x04
_FASTEST_BY_CHARACTERS = 19_200


class ModbusCommLoad(TimedInstruction):
    """Ties the port to a master, and sets it."""

    __slots__ = ()

    areas = ("MB_DB",)

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """As the other instructions that set, and the port in MB_DB once that has worked."""
        given = super().run(module, areas)
        if given.values["DONE"]:
            return Outputs({"MB_DB": self.number("PORT").to_bytes(2, "big")}, **given.values)
        return given

    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """8181 to 8184 for what cannot be."""
        baud, parity = self.number("BAUD", 9600), self.number("PARITY")
        reply_ms = self.number("RESP_TO", 1000)
        checks = (
            (BAD_BAUD, baud in _BAUD_RATES),
            (BAD_PARITY, parity < len(_PARITIES)),
            (BAD_FLOW_CONTROL, self.number("FLOW_CTRL") == 0),
            (BAD_TIME_OUT, reply_ms >= 5),
            (NOT_LOADED, len(areas["MB_DB"]) == 2),
        )
        for status, right in checks:
            if not right:
                return status
        stop_bits = self.number("STOP_BITS", 1)
        character_bits = 9 + stop_bits + (parity != 0)
        silence_bits = 7 * character_bits // 2
        if baud > _FASTEST_BY_CHARACTERS:
            silence_bits = 175 * baud // 100_000
        module.configure(
            SerialFormat(baud, _PARITIES[parity], stop_bits),
            ReceiveConditions(gap_bits=silence_bits + character_bits),
        )
        module.modbus = ModbusSettings(reply_ms, self.number("RETRIES", 2))
        return 0


@dataclass(frozen=True, slots=True)
class _Request:
    frame: bytes
    reads: int = 0

    @property
    def is_broadcast(self) -> bool:
        return self.frame[0] == BROADCAST


class _RefusedError(Exception):
    """The inputs cannot be; `args` has the status."""


class ModbusMaster(PortInstruction):
    """One request and its reply."""

    __slots__ = ("_job", "_request", "_sent")

    areas = ("DATA_PTR",)
    port_name = "MB_DB"
    _request: _Request | None
    _job: SendJob
    _sent: int

    def forget(self) -> None:
        """No request is under way."""
        self._request = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """REQ, MB_ADDR, MODE, DATA_ADDR, DATA_LEN, DATA_PTR to DONE, BUSY, ERROR, STATUS."""
        rises = self.rises()
        if module is None or module.modbus is None:
            was, self._request = self._request, None
            if not rises and was is None:
                return _outputs(IDLE)
            is_tied = self.number("MB_DB") != 0 and module is None
            return _outputs(MODULE_MISSING if is_tied else NOT_LOADED)
        if self._request is not None:
            return self._go_on(module, module.modbus, self._request)
        if not rises:
            return _outputs(IDLE)
        if module.modbus.master not in (None, self):
            return _outputs(PORT_BUSY)
        try:
            self._request = self._requested(areas["DATA_PTR"])
        except _RefusedError as refused:
            return _outputs(refused.args[0])
        module.modbus.master = self
        self._sent = 0
        self._send(module, self._request)
        return _outputs(FIRST_CALL, busy=True)

    def _requested(self, data: bytes) -> _Request:
        address, mode = self.number("MB_ADDR"), self.number("MODE")
        if address > HIGHEST_ADDRESS:
            raise _RefusedError(BAD_ADDRESS)
        if mode > 2 or (mode == 0 and address == BROADCAST):
            raise _RefusedError(BAD_MODE)
        function, start = _place(self.number("DATA_ADDR"))
        if mode != 0 and function != Function.READ:
            raise _RefusedError(BAD_DATA_ADDRESS)
        count = self.number("DATA_LEN")
        if not 1 <= count <= (MOST_READ if mode == 0 else MOST_WRITTEN):
            raise _RefusedError(BAD_LENGTH)
        if 2 * count > len(data):
            raise _RefusedError(BAD_POINTER)
        where, many = start.to_bytes(2, "big"), count.to_bytes(2, "big")
        if mode == 0:
            return _Request(seal(bytes((address, function)) + where + many), count)
        words = data[: 2 * count]
        if mode == 1 and count == 1:
            return _Request(seal(bytes((address, Function.WRITE)) + where + words))
        head = bytes((address, Function.WRITE_SEVERAL)) + where + many
        return _Request(seal(head + bytes((len(words),)) + words))

    def _send(self, module: SerialModule, request: _Request) -> None:
        module.clear()
        self._job = module.send(request.frame)
        self._sent += 1

    def _go_on(self, module: SerialModule, settings: ModbusSettings, request: _Request) -> Outputs:
        if not self._job.over(self._ports.now_ns):
            return _outputs(NEXT_CALL, busy=True)
        if self._job.status:
            return self._end(settings, self._job.status)
        if request.is_broadcast:
            return self._end(settings, 0)
        message = module.take()
        if message is not None:
            if message.failed:
                return self._end(settings, _DAMAGED.get(message.status, _OVERFLOW))
            status = _judge(request, message.data)
            words = message.data[3:-2] if request.reads and not status else b""
            return self._end(settings, status, words)
        assert self._job.end_ns is not None
        if self._ports.now_ns < self._job.end_ns + settings.reply_ms * NS_PER_MS:
            return _outputs(NEXT_CALL, busy=True)
        if self._sent > settings.retries:
            return self._end(settings, NO_REPLY)
        self._send(module, request)
        return _outputs(NEXT_CALL, busy=True)

    def _end(self, settings: ModbusSettings, status: int, words: bytes = b"") -> Outputs:
        self._request = settings.master = None
        return _outputs(status, words=words)


def _place(data_address: int) -> tuple[int, int]:
    """The function that reads there, and the address in the frame."""
    for function, digit in ((Function.READ, 4), (_READ_INPUT, 3)):
        for unit, most in ((10_000, 9_999), (100_000, 65_536)):
            start = data_address - digit * unit - 1
            if 0 <= start < most:
                return function, start
    raise _RefusedError(BAD_DATA_ADDRESS)


def _judge(request: _Request, reply: bytes) -> int:
    """The status of a reply, 0 for one that is right."""
    asked = request.frame
    if len(reply) < 5 or crc(reply):
        return WRONG_CHECK_SUM
    if reply[0] != asked[0]:
        return WRONG_SLAVE
    if reply[1] == asked[1] | EXCEPTION_BIT:
        return _REFUSED.get(reply[2], _REFUSED_OTHERWISE)
    if reply[1] != asked[1]:
        return WRONG_FUNCTION
    if request.reads:
        right = reply[2] == 2 * request.reads and len(reply) == 5 + reply[2]
        return 0 if right else WRONG_CHECK_SUM
    return 0 if reply[2:6] == asked[2:6] and len(reply) == 8 else OTHER_REPLY


def _outputs(status: int, *, busy: bool = False, words: bytes = b"") -> Outputs:
    failed = not busy and status not in (0, IDLE)
    areas = {"DATA_PTR": words} if words else {}
    return Outputs(areas, DONE=status == 0, BUSY=busy, ERROR=failed, STATUS=status)
