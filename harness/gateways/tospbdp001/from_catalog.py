"""From the catalogue's entry for the TOSPBDP001 to the settings of a simulated one."""

from collections.abc import Mapping
from enum import Enum
from typing import TypeVar

from fbgen.catalog.gateways import Gateway, SubNetwork
from fbgen.catalog.layouts import Layout
from fbgen.catalog.options import OptionValue
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

Choice = TypeVar("Choice", bound=Enum)

_PARITY = {"none": Parity.NONE, "even": Parity.EVEN, "odd": Parity.ODD}


def tospbdp001_settings(
    gateway: Gateway, layout: Layout, options: Mapping[str, OptionValue]
) -> TosSettings:
    """The settings of one gateway; options that are not given have the catalogue's default.

    Raises DiagnosticError FB1109 for a value that an option cannot have.
    """

    known = {item.id: item for item in gateway.options}

    def option(name: str) -> OptionValue:
        entry = gateway.option(name)
        return entry.check(options[name]) if name in options else entry.default

    def choice(name: str, default: Choice) -> Choice:
        """One of an enumeration's members, `default` where the catalogue leaves the choice out."""
        if name not in known:
            return default
        chosen = option(name)
        members = type(default)
        return next(
            (item for item in members if chosen in (item.value, item.name.lower())), default
        )

    times = gateway.times
    startup_ms = int(option("startup_ms")) if "startup_ms" in known else 0
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
        offline_inputs=choice("offline_inputs", OfflineInputs.FREEZE),
        offline_outputs=choice("offline_outputs", OfflineOutputs.NO_SCANNING),
        startup_lock=choice("startup_lock", StartupLock.NONE),
        subnet_error_led=choice("subnet_error_led", SubnetErrorLed.DEVICE_STATUS),
        startup_ns=startup_ms * NS_PER_MS,
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
