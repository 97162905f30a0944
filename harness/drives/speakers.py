"""Which protocol a port speaks, and with which ear it listens.

A port has the protocol that its ComNo chooses, with the telegrams of the series in the catalogue.
"""

from collections.abc import Collection
from typing import TYPE_CHECKING, Protocol

from fbgen.catalog import Drive, SerialPort, ToshibaService
from fbgen.diagnostics import error
from fbgen.wire import toshiba_stream
from fbgen.wire.toshiba import BadRequest, Request
from fbgen.wire.toshiba_block import BlockRequest
from fbgen.wire.toshiba_stream import FrameStream, block_request_stream, request_stream
from harness.drives.blocks import BlockTransfer
from harness.drives.device import Owner
from harness.drives.ears import LengthEar, SilenceEar
from harness.drives.registers import Registers
from harness.drives.toshiba_speaker import ToshibaSpeaker
from harness.kernel import NS_PER_MS
from harness.line import Reception

if TYPE_CHECKING:
    from harness.drives.communication import Communication


TOSHIBA, MODBUS = "toshiba", "modbus"
"""The protocols, by their names in the catalogue."""


class Ear(Protocol):
    """What listens for telegrams and hands them to a speaker."""

    def receive(self, reception: Reception) -> None:
        """Hear what has ended on the line."""

    def reset(self) -> None:
        """Forget what was heard of a telegram."""


class _Deaf:
    """For an inverter that was told to speak what it cannot."""

    def receive(self, reception: Reception) -> None:
        """Understand nothing."""

    def reset(self) -> None:
        """There is nothing to forget."""


def protocol_of(facts: SerialPort, chosen: int) -> str | None:
    """The protocol of a port by the word of the ComNo that chooses; None for no known one."""
    if facts.protocol is None:
        return next(iter(facts.protocols.values()))
    return facts.protocols.get(chosen)


def check_protocols(series: Drive, registers: Registers) -> None:
    """FB7104 for a series without a port, and for a port told to speak what the series cannot."""
    known = series.communication
    if known is None or not known.ports:
        raise error(
            "FB7104",
            f"the series '{series.id}' cannot be simulated: it has no serial port",
            series.span if known is None else known.span,
            "add ports: to communication:, or like: with a series that has some",
        )
    services = {TOSHIBA: known.toshiba, MODBUS: known.modbus}
    for port in known.ports:
        chosen = 0 if port.protocol is None else registers.word(port.protocol)
        protocol = protocol_of(port, chosen)
        if protocol is None or services.get(protocol) is None:
            what = f"'{protocol}'" if protocol is not None else f"number {chosen}"
            raise error(
                "FB7104",
                f"an inverter of the series '{series.id}' does not speak the protocol {what} at "
                f"the port '{port.name}'",
                port.span_of("protocols"),
                f"give the parameter {port.protocol} a value that stands for a protocol of which "
                "communication: says what the series takes",
            )


def ear_for(
    port: "Communication", protocol: str | None, owner: Owner, options: Collection[str]
) -> Ear:
    """What listens at a port and speaks a protocol there, at the port's present speed."""
    known, device = owner.series.communication, owner.device
    if known is None:
        return _Deaf()
    baud = port.port.format.baud
    blocks = None if known.blocks is None else BlockTransfer(known.blocks, owner.registers)
    if protocol == TOSHIBA and known.toshiba is not None:
        service = known.toshiba
        speaker = ToshibaSpeaker(port, device, service, blocks, "broadcast_reads" in options)
        if service.silence_characters is None:
            return LengthEar(port, _by_length(service), speaker.take)
        silence = toshiba_stream.silent_intervals(baud, service.silence_characters)
        stream = toshiba_stream.silence_request_stream(silence)
        return SilenceEar(port, stream, speaker.concerns, speaker.take)
    if protocol == MODBUS and known.modbus is not None:
        from fbgen.wire import modbus_stream  # noqa: PLC0415 - few drives speak it
        from harness.drives.modbus_speaker import ModbusSpeaker  # noqa: PLC0415

        listener = ModbusSpeaker(port, device, known.modbus, blocks, options)
        frames = modbus_stream.request_stream(modbus_stream.silent_intervals(baud))
        return SilenceEar(port, frames, listener.concerns, listener.take)
    return _Deaf()


def _by_length(
    service: ToshibaService,
) -> FrameStream[Request | BadRequest] | FrameStream[Request | BadRequest | BlockRequest]:
    make = block_request_stream if "block" in service.commands else request_stream
    if service.reception_timeout_ms is None:
        return make()
    return make(service.reception_timeout_ms * NS_PER_MS)
