"""`fbgen sim`: simulated devices on a real port, for a PLC or a master that is none of ours."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import result, say
from fbgen.cli.ports import sim_drive
from fbgen.cli.ports.line_options import PortIfAnyOption, PtyOption
from fbgen.cli.ports.sim_can import OptionWanted, serve_option
from fbgen.cli.ports.state_line import StateLine

if TYPE_CHECKING:
    from fbgen.catalog import Catalog
    from fbgen.plant import Plant
    from harness.serial import Port, ServedGateways

_USUAL_BAUD = 19_200
_EXAMPLES = {"pbdp110": "pbdp110", "tospbdp001": "manual_example"}
"""The shipped example plant with a gateway of each type that can be served."""

commands = typer.Typer(help="Serve simulated devices on a real port.", no_args_is_help=True)


def register(program: typer.Typer) -> None:
    """Add the commands to the program."""
    program.add_typer(
        commands,
        name="sim",
        epilog=examples("fbgen sim drive --pty", "fbgen sim gateway --port /dev/ttyUSB0"),
    )


@commands.callback()
def _sim() -> None:
    """Serve simulated devices on a real port, in real time."""


@commands.command(
    "gateway",
    epilog=examples(
        "fbgen sim gateway --port /dev/ttyUSB0              the manual's example: drive 11",
        "fbgen sim gateway --port COM3 --baud 93750 plant.yaml",
        "fbgen sim gateway --port socket://192.168.0.9:4001 --address 7 --layout doc9",
        "fbgen sim gateway --pty                            prints the pseudo terminal's name",
        "fbgen sim gateway --pty --type pbdp110             two drives at a PBDP-110",
        "fbgen sim gateway --type dev003z --can socketcan:can0 --address 5",
    ),
)
def gateway(
    plant: Annotated[
        Path | None,
        typer.Argument(
            metavar="PLANT", help="Plant file with gateways and drives; else the example plant."
        ),
    ] = None,
    port: PortIfAnyOption = None,
    pty: PtyOption = False,
    baud: Annotated[
        int | None,
        typer.Option("--baud", metavar="N", help="Speed in bit/s: 19200 at ports, 500000 on CAN."),
    ] = None,
    kind: Annotated[
        str | None,
        typer.Option(
            "--type",
            metavar="T",
            help="Example plant: with a tospbdp001, or a pbdp110. On CAN: dev003z.",
        ),
    ] = None,
    layout: Annotated[
        str | None,
        typer.Option(
            "--layout",
            metavar="L",
            help="gsd10, module1 ...: instead of the plant's. On CAN: 21/71 ...",
        ),
    ] = None,
    address: Annotated[
        int | None,
        typer.Option(
            "--address", metavar="N", help="PROFIBUS address instead of the plant's; MAC ID."
        ),
    ] = None,
    can: Annotated[
        str | None,
        typer.Option("--can", metavar="I", help="socketcan:can0, slcan:PORT ...: of python-can."),
    ] = None,
    series: Annotated[
        str | None,
        typer.Option("--series", metavar="S", help="On CAN: vf-s15, or vf-mb1."),
    ] = None,
    log: Annotated[
        Path | None,
        typer.Option("--log", metavar="F", help="On CAN: log of all frames, .asc, .blf or .log."),
    ] = None,
    catalog: CatalogOption = None,
) -> None:
    """Serve gateways with their inverters, until Ctrl-C: PROFIBUS DP slaves, or one on DeviceNet.

    A real master sees the slaves that the simulated PLC sees. Answers come at once, not after the
    delays that PROFIBUS asks for; a pseudo terminal keeps neither speed nor parity.
    """
    from fbgen.catalog import load_catalog
    from harness.serial import gateways_to_serve

    known = load_catalog(catalog or ())
    if can is not None:
        _only_can(port, pty, plant)
        wanted = OptionWanted(kind, layout, address, baud, series, log)
        serve_option(can, known, wanted)
        return
    _only_ports(series, log)
    _served_at_ports(kind, known)
    check_port(port, pty, "the gateway")
    plan = _plant(plant, kind, layout, address, known)
    served = gateways_to_serve(plan, known)
    opened = _open(port, _USUAL_BAUD if baud is None else baud)
    try:
        if pty:
            result(opened.name)
        _serve(served, opened)
    finally:
        opened.close()


def _only_can(port: str | None, pty: bool, plant: Path | None) -> None:
    from fbgen.diagnostics import error

    if port is not None or pty or plant is not None:
        other = "--port" if port is not None else "--pty" if pty else "a plant file"
        message = f"--can and {other} at once"
        raise error("FB9030", message, None, "--can takes --type, --address, --layout and --series")


def _only_ports(series: str | None, log: Path | None) -> None:
    from fbgen.diagnostics import error

    if series is not None or log is not None:
        name = "--series" if series is not None else "--log"
        raise error(
            "FB9030", f"{name} is for a CAN interface", None, "give --can INTERFACE:CHANNEL"
        )


def _served_at_ports(kind: str | None, known: "Catalog") -> None:
    """FB9034 for a gateway that is not on PROFIBUS."""
    from fbgen.diagnostics import error
    from fbgen.nearest import nearest

    if kind is not None and kind not in _EXAMPLES:
        on_can = kind in known.gateways and kind not in known.profibus_gateways
        help_ = "give --can INTERFACE:CHANNEL" if on_can else nearest(kind, _EXAMPLES)
        raise error("FB9034", f"there is no gateway '{kind}' to serve here", None, help_)


def check_port(port: str | None, pty: bool, what: str) -> None:
    """FB9030 unless it is said in one way where the devices shall be."""
    from fbgen.diagnostics import error

    if (port is None) is not pty:
        message = "--port and --pty at once" if pty else f"it is not said where {what} shall be"
        raise error("FB9030", message, None, "give --port NAME, or --pty on Linux")


def _plant(
    path: Path | None, kind: str | None, layout: str | None, address: int | None, known: "Catalog"
) -> "Plant":
    from fbgen.diagnostics import Diagnostic, DiagnosticError, error
    from fbgen.plant import load_plant
    from fbgen.resources import shipped

    if path is not None and kind is not None:
        raise error(
            "FB9030", "--type is for the example plant", None, f"{path.as_posix()} has the types"
        )
    example = _EXAMPLES[kind or "tospbdp001"]
    plan = load_plant(path or shipped("examples") / example / "plant.yaml", known)
    if not plan.gateways:
        what = "all its drives are on serial lines: fbgen sim drive serves drives"
        if plan.devicenet:
            what = "drives on DeviceNet are served by --can INTERFACE:CHANNEL, without a plant file"
        raise error("FB9034", f"the plant '{plan.name}' has no gateway to serve", None, what)
    if layout is None and address is None:
        return plan
    if len(plan.gateways) != 1:
        raise error(
            "FB9030",
            f"--layout and --address are for one gateway, and there are {len(plan.gateways)}",
            None,
            "set them in the plant file",
        )
    entry = plan.gateways[0]
    ways = {item.name: item.access_ways[0] for item in known.profibus_gateway(entry.type).layouts}
    chosen = entry.layout if layout is None else layout
    other = entry.model_copy(
        update={
            "layout": chosen,
            # How the PLC of the plant would reach the data does not matter here.
            "access": ways.get(chosen, entry.access),
            "profibus_address": entry.profibus_address if address is None else address,
        }
    )
    if found := list(other.problems_against(known)):
        # They are about the options: nothing in the plant file is to be mended.
        raise DiagnosticError(
            [
                Diagnostic(
                    item.code,
                    f"{'--address' if item.code == 'FB2004' else '--layout'}: {item.message}",
                    None,
                    item.help,
                )
                for item in found
            ]
        )
    return plan.model_copy(update={"gateways": (other,)})


def _open(port: str | None, baud: int) -> "Port":
    from harness.serial import PseudoTerminal, profibus_port

    return PseudoTerminal() if port is None else profibus_port(port, baud)


def _serve(served: "ServedGateways", port: "Port") -> None:
    from harness.serial import Server

    display = StateLine(served)
    addresses = ", ".join(
        f"{entry.name} at address {entry.profibus_address}, {entry.layout}"
        for entry in served.plan.gateways
    )
    say(f"{port.name}: {addresses}; Ctrl-C ends")
    try:
        Server(served.kernel, served.segment, port).serve(display.look)
    except KeyboardInterrupt:
        pass
    finally:
        display.end()
    segment = served.segment
    say(f"{segment.requests} telegrams, {segment.answers} answers, {segment.skipped} bytes skipped")


sim_drive.add_to(commands)
