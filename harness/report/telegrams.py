"""Telegrams of a gateway as they went: cyclic data, frames on the line, times.

A telegram begins with the PROFIBUS transfer that brings the gateway another trigger byte. What is
heard on its line until the next one belongs to it, except the gateway's heartbeat and the answers
to it, which are ASCII. The reply has arrived with the transfer that carries what the drive's frame
said.
"""

from dataclasses import dataclass, field

from fbgen.catalog import Layout
from fbgen.wire.toshiba import ASCII_START
from harness.fieldbus import DpMaster, Station, Transfer
from harness.line import Line, Port, Transmission

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
        self, master: DpMaster, station: Station, line: Line, port: Port, layout: Layout
    ) -> None:
        """`port` is the gateway's own on the line."""
        self.records: list[TelegramRecord] = []
        self._port = port
        self._station = station
        self._layout = layout
        self._trigger_offset = layout.output_field("trigger").offset
        self._trigger = 0
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
        trigger = transfer.outputs[self._trigger_offset]
        if self.records:
            self._reply(self.records[-1], transfer)
        if trigger != self._trigger:
            self._trigger = trigger
            output = self.without_padding(transfer.outputs)
            self.records.append(TelegramRecord(transfer.time_ns, output))

    def _reply(self, record: TelegramRecord, transfer: Transfer) -> None:
        if record.received_ns is not None:
            return
        for frame in record.frames:
            if not frame.to_drives and frame.data[1:-1] == transfer.inputs[_INPUT_TELEGRAM:]:
                record.received_ns = transfer.time_ns
                record.input = transfer.inputs

    def _heard(self, transmission: Transmission) -> None:
        if not self.records or transmission.data[:1] == bytes((ASCII_START,)):
            return
        to_drives = transmission.sender is self._port
        self.records[-1].frames.append(
            LineFrame(transmission.start_ns, transmission.end_ns, transmission.data, to_drives)
        )


def one_line(record: TelegramRecord) -> str:
    """A telegram for a message: time, bytes out, bytes in."""
    received = record.input.hex(" ").upper() if record.input is not None else "no reply"
    return f"{record.sent_ns / 1_000_000:.3f} ms  {record.output.hex(' ').upper()}  ->  {received}"
