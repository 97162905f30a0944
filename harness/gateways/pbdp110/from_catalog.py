"""From the catalogue's entry for the PBDP-110 to the settings of a simulated one."""

from collections.abc import Iterable, Mapping

from fbgen.catalog.drives import Drive
from fbgen.catalog.layouts import Layout
from fbgen.catalog.options import OptionValue
from fbgen.catalog.process_data_gateways import ParameterChannel, ProcessDataGateway
from fbgen.wire.toshiba import ErrorCode
from harness.gateways.pbdp110.settings import (
    AccessCodes,
    AccessPlace,
    BusLost,
    ChannelPlace,
    ChannelSettings,
    DriveFacts,
    Module,
    PbdpSettings,
)
from harness.kernel import NS_PER_MS
from harness.line import Parity, SerialFormat

_PARITY = {"none": Parity.NONE, "even": Parity.EVEN, "odd": Parity.ODD}
_SENT_STOP_BITS = 1
_NO_NUMBER = 0xFFFF
"""What the option `write_only_number` says for none."""


def pbdp110_settings(
    gateway: ProcessDataGateway,
    layout: Layout,
    options: Mapping[str, OptionValue],
    facts: Mapping[str, DriveFacts],
) -> PbdpSettings:
    """The settings of one interface; options that are not given have the catalogue's default.

    `layout` is the module of the plant, perhaps with identifiers of the plant's own; a master may
    choose the other modules as well. `facts` go by the channel. Raises DiagnosticError FB1109 for
    a value that an option cannot have.
    """

    def option(name: str) -> OptionValue:
        entry = gateway.option(name)
        return entry.check(options[name]) if name in options else entry.default

    others = [item for item in gateway.layouts if item.name != layout.name]
    write_only = frozenset((int(option("write_only_number")),)) - {_NO_NUMBER}
    access, times = gateway.parameter_channel, gateway.times
    return PbdpSettings(
        modules=tuple(_module(gateway, item) for item in (layout, *others)),
        channels=tuple(
            ChannelSettings(
                item.name,
                item.powers_gateway,
                1 << item.diagnosis_bit,
                _with_write_only(facts.get(item.name, DriveFacts()), write_only),
            )
            for item in gateway.channels
        ),
        command=_cell(gateway, "command"),
        frequency=_cell(gateway, "frequency"),
        inputs=tuple(item.comno for item in gateway.inputs),
        online_mask=gateway.word("status").field("online").mask,
        reset_mask=gateway.word("command").field("fault_reset").mask,
        access=_codes(gateway, access),
        formats=tuple(_formats(gateway)),
        ident_number=int(option("ident_number")),
        processing_ns=times.processing.ns,
        reply_timeout_ns=times.reply_timeout.ns,
        startup_ns=int(option("startup_ms")) * NS_PER_MS,
        bus_lost=BusLost(option("bus_lost")),
        local={item.number: int(option(item.name)) for item in access.local},
        highest_address=gateway.profibus.maximum_address,
    )


def drive_facts(series: Drive) -> DriveFacts:
    """What the interface knows of the parameters of a series."""
    return DriveFacts(
        frozenset(item.number for item in series.comnos if item.access == "r"),
        frozenset(item.number for item in series.comnos if item.access == "w"),
    )


def _with_write_only(facts: DriveFacts, numbers: frozenset[int]) -> DriveFacts:
    return DriveFacts(facts.read_only, facts.write_only | numbers)


def _cell(gateway: ProcessDataGateway, name: str) -> int:
    return next(item.comno for item in gateway.outputs if item.field == name)


def _module(gateway: ProcessDataGateway, layout: Layout) -> Module:
    outputs = {field.name: field.offset for field in layout.output}
    inputs = {field.name: field.offset for field in layout.input}
    access = gateway.parameter_channel
    places = []
    for channel in gateway.channels_of(layout):
        start = f"{channel.name}_"
        place = None
        if start + access.action in outputs:
            place = AccessPlace(
                outputs[start + access.action],
                outputs[start + access.number],
                outputs[start + access.data],
                inputs[start + access.response_word],
                inputs[start + access.number],
                inputs[start + access.data],
            )
        places.append(
            ChannelPlace(
                outputs[start + "command"],
                outputs[start + "frequency"],
                tuple(inputs[start + item.field] for item in gateway.inputs),
                place,
            )
        )
    return Module(
        layout.name, layout.identifiers, layout.output_length, layout.input_length, tuple(places)
    )


def _codes(gateway: ProcessDataGateway, access: ParameterChannel) -> AccessCodes:
    request, response = access.request_code, access.response_code
    other = access.error("other").code
    return AccessCodes(
        request_shift=gateway.word(access.action).field(access.request).low,
        response_shift=gateway.word(access.response_word).field(access.response).low,
        idle=request("idle"),
        read=request("read"),
        write_eeprom=request("write_eeprom"),
        write_ram=request("write_ram"),
        response_idle=response("idle"),
        response_read=response("read"),
        response_written=response("written"),
        response_error=response("error"),
        read_only=access.error("read_only").code,
        write_only=access.error("write_only").code,
        other=other,
        refusals={
            ErrorCode.CANNOT_EXECUTE: access.error("cannot_execute").code,
            ErrorCode.DATA: access.error("data_error").code,
            ErrorCode.COM_NO: access.error("invalid_number").code,
        },
    )


def _formats(gateway: ProcessDataGateway) -> Iterable[SerialFormat]:
    scan = gateway.autoscan
    for baud in scan.baud_rates:
        for parity in scan.parities:
            yield SerialFormat(baud, _PARITY[parity], _SENT_STOP_BITS)
