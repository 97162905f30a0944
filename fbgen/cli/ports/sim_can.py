"""`fbgen sim gateway --can`: a simulated DeviceNet option on a CAN interface."""

from pathlib import Path
from typing import TYPE_CHECKING

from fbgen.cli.output import say
from fbgen.cli.ports.state_line import StateLine
from fbgen.dataclass import dataclass

if TYPE_CHECKING:
    from fbgen.catalog import Catalog, DeviceNetGateway
    from harness.serial import CanInterface, OptionServer

_USUAL = "dev003z"
_USUAL_RATE = 500_000
_USUAL_MAC = 63


@dataclass(frozen=True, slots=True)
class OptionWanted:
    """What the command line says of the option; None takes what is usual."""

    kind: str | None
    layout: str | None
    mac: int | None
    bit_rate: int | None
    series: str | None
    log: Path | None


def serve_option(interface: str, known: "Catalog", wanted: OptionWanted) -> None:
    """Serve until Ctrl-C.

    Raises DiagnosticError FB9030, FB9031, FB9033, FB9034, FB7106, FB1105 for what cannot be.
    """
    from contextlib import nullcontext
    from time import time

    from harness.gateways.dev003z import Dev003zSettings
    from harness.serial import CanLog, OptionServer

    gateway = _gateway(wanted.kind or _USUAL, known)
    rate = _USUAL_RATE if wanted.bit_rate is None else wanted.bit_rate
    settings = Dev003zSettings(
        series=wanted.series or gateway.series[-1],
        mac=_USUAL_MAC if wanted.mac is None else wanted.mac,
        baud=_rate(gateway, rate),
        parameters={} if wanted.layout is None else _assemblies(gateway, wanted.layout),
    )
    opened = _open(interface, rate)
    try:
        with nullcontext() if wanted.log is None else CanLog(wanted.log, time()) as log:
            _serve(OptionServer(known, gateway.id, settings, opened, log=log), opened.name, rate)
    finally:
        opened.close()


def _serve(server: "OptionServer", name: str, rate: int) -> None:
    display = StateLine(server)
    node = server.option.node.settings
    say(f"{name}: {server.option.gateway.id} with MAC ID {node.mac}, {rate} bit/s; Ctrl-C ends")
    try:
        server.serve(display.look)
    except KeyboardInterrupt:
        pass
    finally:
        display.end()
    say(f"{server.received} frames heard, {server.sent} sent")


def _open(interface: str, rate: int) -> "CanInterface":
    from harness.serial import can_interface

    return can_interface(interface, rate)


def _gateway(kind: str, known: "Catalog") -> "DeviceNetGateway":
    from fbgen.catalog import DeviceNetGateway
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest

    served = [item.id for item in known.gateways.values() if isinstance(item, DeviceNetGateway)]
    if kind not in served:
        message = f"there is no DeviceNet adapter '{kind}' to serve"
        raise error("FB9034", message, None, nearest(kind, served))
    return known.devicenet_gateway(kind)


def _rate(gateway: "DeviceNetGateway", rate: int) -> int:
    from fbgen.diagnostics import error

    for value, kilobits in gateway.devicenet.baud_rates.items():
        if kilobits * 1000 == rate:
            return value
    rates = ", ".join(f"{item * 1000}" for item in gateway.devicenet.baud_rates.values())
    raise error("FB9030", f"{rate} bit/s is no rate of DeviceNet", None, f"use {rates}")


def _assemblies(gateway: "DeviceNetGateway", named: str) -> dict[str, int]:
    """As a plant file names them, or by their name in the catalogue."""
    from fbgen.diagnostics import error

    by_instances = {
        f"{pair.output.instance}/{pair.input.instance}": pair for pair in gateway.assemblies
    }
    if "/" in named and named not in by_instances:
        raise error(
            "FB1105",
            f"'{gateway.id}' has no assemblies '{named}'",
            None,
            f"known: {', '.join(by_instances)}",
        )
    pair = by_instances.get(named) or gateway.pair(named)
    return {gateway.assembly_parameter: pair.setting}
