"""`fbgen sim drive`: simulated inverters on a serial port, for a master that is none of ours."""

from contextlib import ExitStack, suppress
from functools import partial
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import on_error_terminal, result, say
from fbgen.cli.ports.keyboard import keyboard
from fbgen.cli.ports.line_options import (
    BaudOption,
    ParityOption,
    PortIfAnyOption,
    ProtocolOption,
    PtyOption,
    asked_setting,
)

if TYPE_CHECKING:
    from fbgen.cli.frames.frame_lines import FrameLines
    from fbgen.cli.ports.drive_display import LineDisplay, TableDisplay
    from fbgen.cli.ports.drive_keys import DriveKeys
    from harness.drives import ReplyTime
    from harness.serial import FaultSwitches, Port, ServedDrives


def add_to(commands: typer.Typer) -> None:
    """Add the command to `fbgen sim`."""
    commands.command(
        "drive",
        epilog=examples(
            "fbgen sim drive --pty                              a VF-S11 with INV-NO 1",
            "fbgen sim drive --port /dev/ttyUSB0 --series vf-s11 --inv-no 11 --baud 19200",
            "fbgen sim drive --port COM3 --inv-no 1-5 --set max_frequency=60 --set vf3.F803=2",
            "fbgen sim drive --pty --drive vf-s11:1=pump --drive vf-s11:2=fan -v",
            "fbgen sim drive --port socket://192.168.0.9:4001 --control 127.0.0.1:7000",
        ),
    )(drive)


def drive(
    port: PortIfAnyOption = None,
    pty: PtyOption = False,
    series: Annotated[
        str | None, typer.Option("--series", metavar="S", help="Series, vf-s11 if not said.")
    ] = None,
    inv_no: Annotated[
        str | None,
        typer.Option(
            "--inv-no", metavar="N", help="INV-NO, 1 if not said; 1-5 or 1,3 for several."
        ),
    ] = None,
    drives: Annotated[
        list[str] | None,
        typer.Option(
            "--drive",
            metavar="S:N[=NAME]",
            help="Another drive: series, INV-NO and a name. May be given several times.",
        ),
    ] = None,
    protocol: ProtocolOption = None,
    baud: BaudOption = None,
    parity: ParityOption = None,
    wired: Annotated[
        str | None,
        typer.Option(
            "--wired",
            metavar="NAME",
            help="Port of a series with several: four_wire; else its first.",
        ),
    ] = None,
    settings: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="[DRIVE.]COMNO=VALUE",
            help="A parameter in its unit, of all drives or of one. May be given several times.",
        ),
    ] = None,
    reply_time: Annotated[
        str | None,
        typer.Option(
            "--reply-time", metavar="T", help="Every reply after this time; else 10 to 20 ms."
        ),
    ] = None,
    byte_times: Annotated[
        bool | None,
        typer.Option(
            "--byte-times/--no-byte-times",
            help="Add the time that bytes take on a wire. Done on a pseudo terminal if not said; "
            "a serial port takes it by itself.",
        ),
    ] = None,
    control: Annotated[
        str | None,
        typer.Option("--control", metavar="PLACE", help="Take commands at this path or HOST:PORT."),
    ] = None,
    seed: Annotated[
        int, typer.Option("--seed", metavar="N", min=0, help="Of all that is random.")
    ] = 0,
    verbose: Annotated[
        bool, typer.Option("-v", "--verbose", help="Without a terminal: print every frame.")
    ] = False,
    catalog: CatalogOption = None,
) -> None:
    """Serve simulated inverters to a master, in real time, until Ctrl-C.

    They answer when a real one would: after the bytes of the request and the reply time. On a
    terminal a table shows what they do, and keys switch faults on and off.
    """
    from fbgen.catalog import load_catalog
    from fbgen.cli.ports.drive_options import drives_to_serve, named_drives
    from fbgen.cli.sim import check_port
    from harness.serial import PseudoTerminal, serial_port, serve_drives

    check_port(port, pty, "the drives")
    chosen = named_drives(drives or (), series, inv_no, load_catalog(catalog or ()))
    wanted = drives_to_serve(chosen, settings or (), _reply_time(reply_time), wired)
    setting = asked_setting([item.series for item in wanted], protocol, baud, parity, wired)
    opened = PseudoTerminal() if port is None else serial_port(port, setting.from_drives)
    try:
        served = serve_drives(
            *(wanted, setting, opened),
            byte_times=pty if byte_times is None else byte_times,
            seed=seed,
        )
        _serve(served, opened, control, verbose, named=pty)
    finally:
        opened.close()


def _reply_time(text: str | None) -> "ReplyTime | None":
    from fbgen.diagnostics import error
    from harness.drives import ReplyTime
    from harness.durations import read_duration

    if text is None:
        return None
    try:
        time_ns = read_duration(text)
    except ValueError as wrong:
        raise error("FB9035", f"--reply-time: {wrong}", None, "write --reply-time 12ms") from None
    return ReplyTime(time_ns, time_ns)


def _serve(
    served: "ServedDrives", port: "Port", control: str | None, verbose: bool, *, named: bool
) -> None:
    from harness.serial import Commands, ControlSocket, DriveServer, FaultSwitches

    faults = FaultSwitches(served)
    commands = Commands(served, faults)
    with ExitStack() as stack:
        socket = None
        if control is not None:
            socket = ControlSocket(control, commands.answer)
            stack.callback(socket.close)
        say(_beginning(served, port, None if socket is None else socket.address))
        display, keys = _shown(served, faults, verbose)
        board = stack.enter_context(keyboard())
        stack.callback(display.end)

        def goes_on(idle_s: float) -> bool:
            if socket is not None:
                socket.look()
            keys.press(board.keys())
            display.look(idle_s)
            return not (commands.wants_end or keys.wants_end)

        server = DriveServer(served, port)
        with suppress(KeyboardInterrupt):
            if named:
                result(port.name)
            server.serve(goes_on)
    log = served.log
    late_ms = server.longest_delay_ns / 1e6
    say(
        f"{log.requests} requests, {log.replies} replies, {log.unknown} unknown frames; "
        f"nothing was more than {late_ms:.1f} ms late"
    )


def _shown(
    served: "ServedDrives", faults: "FaultSwitches", verbose: bool
) -> "tuple[LineDisplay | TableDisplay, DriveKeys]":
    from fbgen.cli.ports.drive_display import LineDisplay, TableDisplay
    from fbgen.cli.ports.drive_keys import DriveKeys
    from harness.serial import drive_states

    keys = DriveKeys(served, faults)
    states = partial(drive_states, served)
    lines = _lines(served)
    if on_error_terminal():
        return TableDisplay(served, states, lines, faults, keys), keys
    return LineDisplay(served, states, lines, frames=verbose), keys


def _beginning(served: "ServedDrives", port: "Port", control: str | None) -> str:
    names = ", ".join(
        f"{name} ({drive.series.id}, INV-NO {drive.inv_no})"
        for name, drive in served.drives.items()
    )
    told = f"; commands at {control}" if control is not None else ""
    setting = served.setting
    return f"{port.name}: {names}; {setting.protocol}, {setting.from_drives}{told}; Ctrl-C ends"


def _lines(served: "ServedDrives") -> "FrameLines":
    from fbgen.cli.frames.cell_texts import CellTexts
    from fbgen.cli.frames.frame_lines import FrameLines

    by_number = {drive.inv_no: drive.series for drive in served.drives.values()}
    first = next(iter(by_number.values()))

    def cells(address: object) -> CellTexts:
        number = address if isinstance(address, int) else -1
        return CellTexts(by_number.get(number, first))

    return FrameLines(served.setting.protocol, cells)
