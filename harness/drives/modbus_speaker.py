"""What an inverter makes of a MODBUS request: which access it is, what is done, what is answered.

Which functions there are, for how many words, and which exception a cause has, is the catalogue's.
Facts: VF-S11 communications manual E6581222, pp. 31-35; VF-S15 RS485 manual E6581913, pp. 25-38;
MODBUS Application Protocol Specification V1.1b3, sections 6.21 and 7.

Inferred: of several words those before one that is refused are written; a block with a word for
nothing (F870 or F871 is 0) is refused as not executable. An identification asked for by a single
object is refused with 03 unless the conformity level says that there is individual access; the
codes 2 and 3 give what there is, as the specification has it.
"""

from collections.abc import Collection, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from fbgen.catalog import ModbusAccess, ModbusService
from fbgen.catalog.communication import Cause
from fbgen.wire import modbus_rtu
from fbgen.wire.modbus import (
    BROADCAST,
    BadRequest,
    ExceptionReply,
    Function,
    IdentifyReply,
    IdentifyRequest,
    ReadReply,
    ReadRequest,
    ReadWriteReply,
    ReadWriteRequest,
    Reply,
    Request,
    WriteReply,
    WriteRequest,
    WriteSeveralReply,
    WriteSeveralRequest,
)
from harness.drives.blocks import BlockTransfer
from harness.drives.device import Device
from harness.drives.modbus_names import CAUSES, EXCEPTIONS, FUNCTIONS, USUAL

if TYPE_CHECKING:
    from harness.drives.communication import Communication

_INDIVIDUAL_ACCESS = 0x80
_ONE_OBJECT = 4


class ModbusSpeaker:
    """Obeys and answers MODBUS requests at one port."""

    __slots__ = ("_accesses", "_blocks", "_device", "_port", "_service")

    def __init__(
        self,
        port: "Communication",
        device: Device,
        service: ModbusService,
        blocks: BlockTransfer | None,
        options: Collection[str],
    ) -> None:
        """`options`: those of the drive that are set."""
        self._port = port
        self._device = device
        self._service = service
        self._blocks = blocks
        self._accesses: dict[int, list[ModbusAccess]] = {}
        for use in sorted(service.accesses, key=lambda use: not use.starts):
            if use.option is None or use.option in options:
                self._accesses.setdefault(FUNCTIONS[use.function], []).append(use)

    def concerns(self, begin: bytes) -> bool:
        """Whether a frame that begins so can be for this inverter."""
        return begin[0] in (self._port.inv_no, BROADCAST)

    def take(self, message: Request | BadRequest, heard_ns: int) -> None:
        """Obey and answer a request that was over at `heard_ns`."""
        address, port = message.address, self._port
        if address not in (port.inv_no, BROADCAST):
            return
        writes = isinstance(message, WriteRequest | WriteSeveralRequest)
        if address == BROADCAST and not writes:
            return
        if not isinstance(message, BadRequest):
            port.carried_out(isinstance(message, ReadRequest | IdentifyRequest))
        reply = self._serve(message)
        if address == BROADCAST or port.mute:
            return
        if port.reply_number is not None:
            reply = replace(reply, address=port.reply_number)
        port.answer(modbus_rtu.encode_reply(reply), heard_ns)

    def _serve(self, message: Request | BadRequest) -> Reply:
        match message:
            case BadRequest():
                return self._bad(message)
            case ReadRequest():
                return self._read(message)
            case WriteRequest():
                return self._write(message)
            case WriteSeveralRequest():
                return self._write_several(message)
            case ReadWriteRequest():
                return self._read_write(message)
            case IdentifyRequest():
                return self._identify(message)

    def _bad(self, message: BadRequest) -> Reply:
        address, function, code = message.address, message.function, message.error
        if function not in self._accesses:
            return self._refused(address, function, "unknown_function")
        return ExceptionReply(address, function, code)

    def _read(self, request: ReadRequest) -> Reply:
        address, start, count = request.address, request.start, request.count
        use = self._access(address, Function.READ, (start,), count, 0)
        if isinstance(use, ExceptionReply):
            return use
        numbers: Sequence[int | None] = range(start, start + count)
        if use.way == "indirect":
            numbers = self._chosen_to_read(count)
        words = self._words(numbers)
        if words is None:
            return self._refused(address, Function.READ, "unknown_comno")
        return ReadReply(address, words)

    def _write(self, request: WriteRequest) -> Reply:
        address, start = request.address, request.start
        use = self._access(address, Function.WRITE, (start,), 0, 1)
        if isinstance(use, ExceptionReply):
            return use
        cause = self._put(use, (start,), (request.word,))
        if cause is not None:
            return self._refused(address, Function.WRITE, cause)
        return WriteReply(address, start, request.word)

    def _write_several(self, request: WriteSeveralRequest) -> Reply:
        address, start, words = request.address, request.start, request.words
        use = self._access(address, Function.WRITE_SEVERAL, (start,), 0, len(words))
        if isinstance(use, ExceptionReply):
            return use
        cause = self._put(use, range(start, start + len(words)), words)
        if cause is not None:
            return self._refused(address, Function.WRITE_SEVERAL, cause)
        return WriteSeveralReply(address, start, len(words))

    def _read_write(self, request: ReadWriteRequest) -> Reply:
        address, words, count = request.address, request.words, request.read_count
        starts = (request.write_start, request.read_start)
        use = self._access(address, Function.READ_WRITE, starts, count, len(words))
        if isinstance(use, ExceptionReply):
            return use
        begin = request.write_start
        cause = self._put(use, range(begin, begin + len(words)), words)
        if cause is not None:
            return self._refused(address, Function.READ_WRITE, cause)
        numbers: Sequence[int | None] = range(request.read_start, request.read_start + count)
        if use.way == "indirect":
            numbers = self._chosen_to_read(count)
        read = self._words(numbers)
        if read is None:
            return self._refused(address, Function.READ_WRITE, "unknown_comno")
        return ReadWriteReply(address, read)

    def _identify(self, request: IdentifyRequest) -> Reply:
        address, texts = request.address, self._service.identification
        if Function.IDENTIFY not in self._accesses or texts is None:
            return self._refused(address, Function.IDENTIFY, "unknown_function")
        objects = [
            (number, text.encode("ascii"))
            for number, text in enumerate((texts.vendor, texts.product, texts.revision))
        ]
        asked = request.object_id
        if request.code == _ONE_OBJECT:
            if not texts.conformity & _INDIVIDUAL_ACCESS:
                return self._refused(address, Function.IDENTIFY, "wrong_data")
            if asked >= len(objects):
                return self._refused(address, Function.IDENTIFY, "unknown_comno")
            objects = objects[asked : asked + 1]
        elif asked < len(objects):
            objects = objects[asked:]
        return IdentifyReply(address, request.code, texts.conformity, tuple(objects))

    def _access(
        self, address: int, function: Function, starts: tuple[int, ...], read: int, written: int
    ) -> ModbusAccess | ExceptionReply:
        """The use of a function that takes so many words at these places, or why there is none."""
        uses = self._accesses.get(function)
        if uses is None:
            return self._refused(address, function, "unknown_function")
        for use in uses:
            if (
                use.least_read <= read <= use.most_read
                and use.least_written <= written <= use.most_written
                and (not use.starts or use.starts == starts)
            ):
                return use
        return self._refused(address, function, "wrong_quantity")

    def _chosen_to_read(self, count: int) -> list[int | None]:
        assert self._blocks is not None, "checked when the series was read"
        return self._blocks.read(count)

    def _words(self, numbers: Sequence[int | None]) -> tuple[int, ...] | None:
        """The words of ComNos; None if a single one, or one that may not be missing, is none."""
        missing = self._service.missing_reads_as if len(numbers) > 1 else None
        words = []
        for number in numbers:
            word = None if number is None else self._device.read(number)
            if word is None:
                word = missing
            if word is None:
                return None
            words.append(word)
        return tuple(words)

    def _put(
        self, use: ModbusAccess, places: Sequence[int], words: tuple[int, ...]
    ) -> Cause | None:
        numbers: Sequence[int | None] = places
        if use.way == "indirect":
            assert self._blocks is not None, "checked when the series was read"
            numbers = self._blocks.written(len(words))
        if None in numbers:
            return "not_executable"
        device = self._device
        write = device.write_eeprom if use.keeps == "eeprom" else device.write_ram
        for number, word in zip(numbers, words, strict=True):
            assert number is not None
            refused = write(number, word)
            if refused is not None:
                return CAUSES[refused]
        return None

    def _refused(self, address: int, function: int, cause: Cause) -> ExceptionReply:
        name = self._service.exceptions.get(cause)
        code = USUAL[cause] if name is None else EXCEPTIONS[name]
        return ExceptionReply(address, function, code)
