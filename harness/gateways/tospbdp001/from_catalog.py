"""From the catalogue's entry for the TOSPBDP001 to the settings of a simulated one."""

from collections.abc import Mapping

from fbgen.catalog.layouts import Layout
from fbgen.catalog.options import OptionValue
from fbgen.catalog.telegram_gateways import SubNetwork, TelegramGateway
from harness.gateways.tospbdp001.settings import (
    CyclicLayout,
    ErrorCode,
    ErrorCounter,
    OfflineInputs,
    OfflineOutputs,
    StartupLock,
    StatusToggle,
    SubnetErrorLed,
    TosSettings,
)
from harness.kernel import NS_PER_MS
from harness.line import Parity, SerialFormat

_PARITY = {"none": Parity.NONE, "even": Parity.EVEN, "odd": Parity.ODD}


def tospbdp001_settings(
    gateway: TelegramGateway, layout: Layout, options: Mapping[str, OptionValue]
) -> TosSettings:
    """The settings of one gateway; options that are not given have the catalogue's default.

    Raises DiagnosticError FB1109 for a value that an option cannot have.
    """

    def option(name: str) -> OptionValue:
        entry = gateway.option(name)
        return entry.check(options[name]) if name in options else entry.default

    times = gateway.times
    return TosSettings(
        layout=cyclic_layout(layout, gateway.trigger.field),
        ident_number=gateway.profibus.ident_number,
        serial_format=serial_format(gateway.subnetwork),
        processing_ns=times.processing.ns,
        trigger_poll_ns=times.trigger_poll.ns if option("trigger_poll") else 0,
        trigger_power_on=gateway.trigger.power_on,
        heartbeat=f"{option('heartbeat_frame')}\r".encode("ascii", "replace"),
        heartbeat_ns=times.heartbeat.ns,
        power_on_status=gateway.power_on_status,
        error_counter=ErrorCounter(option("error_counter")),
        error_code=ErrorCode(option("error_status_code")),
        status_toggle=StatusToggle(option("status_toggle")),
        offline_timeout_ns=int(option("offline_timeout_ms")) * NS_PER_MS,
        offline_inputs=OfflineInputs(option("offline_inputs")),
        offline_outputs=OfflineOutputs(option("offline_outputs")),
        startup_lock=StartupLock(option("startup_lock")),
        subnet_error_led=SubnetErrorLed(option("subnet_error_led")),
        startup_ns=int(option("startup_ms")) * NS_PER_MS,
    )


def cyclic_layout(layout: Layout, trigger: str) -> CyclicLayout:
    """Where things lie, from the catalogue's fields; `trigger` names the trigger's field.

    The telegram is everything in the outputs but the control word, the trigger and pads.
    """
    control, trigger_field = layout.output_field("control"), layout.output_field(trigger)
    pieces: list[tuple[int, int]] = []
    for field in layout.output:
        if field.pad or field is control or field is trigger_field:
            continue
        if pieces and pieces[-1][1] == field.offset:
            pieces[-1] = (pieces[-1][0], field.end)
        else:
            pieces.append((field.offset, field.end))
    return CyclicLayout(
        layout.name,
        layout.identifiers,
        layout.output_length,
        layout.input_length,
        control.offset,
        trigger_field.offset,
        tuple(pieces),
    )


def serial_format(subnetwork: SubNetwork) -> SerialFormat:
    """How the gateway sends on the line."""
    return SerialFormat(subnetwork.baud, _PARITY[subnetwork.parity], subnetwork.stop_bits)
