"""Telegrams of a gateway as they went: cyclic data, frames on the line, times.

A telegram begins with the PROFIBUS transfer that brings the gateway another trigger byte. The frame
that the gateway sends for it is known by its bytes, the drive's by coming behind that frame; the
gateway's heartbeat and the answers to it, which are ASCII, belong to none. The reply has arrived
with the transfer that carries what the drive's frame said, once the gateway has worked on it. A
reply that equals the one before changes nothing on PROFIBUS: it has arrived when the gateway has
it.
"""

from dataclasses import field

from fbgen.catalog import Layout
from fbgen.dataclass import dataclass
from fbgen.wire.toshiba import ASCII_START
from harness.fieldbus import DpMaster, Station, Transfer
from harness.line import Line, Port, Transmission

_OUTPUT_TELEGRAM = 3
"""Offset of INV-NO in the outputs without padding, behind control word and trigger."""
_INPUT_TELEGRAM = 2
"""Offset of INV-NO in the inputs, behind the status word."""


@dataclass(frozen=True, slots=True)
class LineFrame:
    """A frame on the RS-485 line; `to_drives` tells the direction."""

    start_ns: int
    end_ns: int
    data: bytes
    to_drives: bool


@dataclass(slots=True)
class TelegramRecord:
    """One telegram. `output` and `input` are the cyclic data without padding bytes.

    `sent_ns` is when the gateway got the trigger, `received_ns` when the reply reached the master;
    both are None for what has not happened.
    """

    sent_ns: int
    output: bytes
    frames: list[LineFrame] = field(default_factory=list)
    received_ns: int | None = None
    input: bytes | None = None


class TelegramRecorder:
    """Listens to one gateway: `records` has its telegrams, the oldest first."""

    def __init__(
        self,
        master: DpMaster,
        station: Station,
        line: Line,
        port: Port,
        layout: Layout,
        *,
        processing_ns: int = 0,
    ) -> None:
        """`port` is the gateway's own on the line; `processing_ns` what it takes for each way."""
        self.records: list[TelegramRecord] = []
        self._port = port
        self._station = station
        self._layout = layout
        self._processing_ns = processing_ns
        self._trigger_offset = layout.output_field("trigger").offset
        self._trigger = 0
        self._outputs = bytes(layout.output_length)
        self._inputs = bytes(layout.input_length)
        self._asked: TelegramRecord | None = None
        self._answer: _Answer | None = None
        master.taps.append(self._transferred)
        line.taps.append(self._heard)

    def without_padding(self, output: bytes) -> bytes:
        """The output bytes that mean something, in their order."""
        return b"".join(
            output[item.offset : item.end] for item in self._layout.output if not item.pad
        )

    def _transferred(self, transfer: Transfer) -> None:
        if transfer.station is not self._station:
            return
        self._inputs, before = transfer.inputs, self._inputs
        self._outputs = transfer.outputs
        if self._answer is not None:
            self._arrived(self._answer, transfer, before)
        trigger = transfer.outputs[self._trigger_offset]
        if trigger != self._trigger:
            self._trigger = trigger
            output = self.without_padding(transfer.outputs)
            self.records.append(TelegramRecord(transfer.time_ns, output))

    def _arrived(self, answer: "_Answer", transfer: Transfer, before: bytes) -> None:
        """The first transfer behind a reply brings it, or shows that nothing has changed."""
        if transfer.time_ns < answer.ready_ns:
            return
        self._answer = None
        if transfer.inputs != before and transfer.inputs[_INPUT_TELEGRAM:] == answer.telegram:
            answer.record.received_ns = transfer.time_ns
            answer.record.input = transfer.inputs

    def _heard(self, transmission: Transmission) -> None:
        if transmission.data[:1] == bytes((ASCII_START,)):
            return
        to_drives = transmission.sender is self._port
        frame = LineFrame(transmission.start_ns, transmission.end_ns, transmission.data, to_drives)
        if to_drives:
            self._asked = self._record_of(frame)
            self._asked.frames.append(frame)
        elif self._asked is not None:
            self._asked.frames.append(frame)
            self._answered(self._asked, frame)

    def _record_of(self, frame: LineFrame) -> TelegramRecord:
        """The telegram that a frame of the gateway is sent for: the latest of those before it.

        A gateway that was off has forgotten the last trigger byte and sends once more what the PLC
        has sent before: that is a telegram of its own.
        """
        telegram = frame.data[1:-1]
        for record in reversed(self.records):
            if record.sent_ns > frame.start_ns or record.frames:
                continue
            if record.output[_OUTPUT_TELEGRAM:].startswith(telegram):
                return record
        sent_ns = max(frame.start_ns - self._processing_ns, 0)
        record = TelegramRecord(sent_ns, self.without_padding(self._outputs))
        self.records.append(record)
        return record

    def _answered(self, record: TelegramRecord, frame: LineFrame) -> None:
        ready_ns = frame.end_ns + self._processing_ns
        telegram = frame.data[1:-1]
        self._answer = _Answer(record, telegram, ready_ns)
        if self._inputs[_INPUT_TELEGRAM:] == telegram:
            record.received_ns = ready_ns
            record.input = self._inputs


@dataclass(frozen=True, slots=True)
class _Answer:
    """A drive's frame that the gateway has from `ready_ns` on."""

    record: TelegramRecord
    telegram: bytes
    ready_ns: int
