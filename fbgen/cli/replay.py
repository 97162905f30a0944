"""`fbgen replay`: recorded traffic in words, or one side of it at a port again."""

from contextlib import suppress
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption, JsonOption
from fbgen.cli.output import result, result_json, say
from fbgen.cli.ports.line_options import PortIfAnyOption
from fbgen.cli.record import frame_row

if TYPE_CHECKING:
    from fbgen.catalog import Drive
    from harness.serial import Exchange, Port, Traffic


class Side(Enum):
    """Who is played."""

    MASTER = "master"
    DRIVES = "drives"


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen replay line.jsonl                      every frame with its time, in words",
            "fbgen replay line.jsonl --port COM3 --as master    asks again, compares the replies",
            "fbgen replay line.jsonl --port COM3 --as drives    answers a master as they did",
        )
    )(replay)


def replay(
    recorded: Annotated[
        Path, typer.Argument(metavar="FILE", help="What `fbgen record` has written.")
    ],
    port: PortIfAnyOption = None,
    side: Annotated[Side | None, typer.Option("--as", help="Who is played at the port.")] = None,
    series: Annotated[
        str | None, typer.Option("--series", metavar="S", help="Series instead of the file's.")
    ] = None,
    yes: Annotated[bool, typer.Option("--yes", help="Start motors without asking.")] = False,
    catalog: CatalogOption = None,
    as_json: JsonOption = False,
) -> None:
    """Show recorded traffic in words, or play one side of it again with its times.

    As the master it sends the requests and compares what comes back; exit status 1 if a reply
    differs. As the drives it answers each request with what was answered to the same one.
    """
    from fbgen.catalog import load_catalog
    from fbgen.diagnostics import error
    from harness.serial import read_traffic, serial_port

    if (port is None) is not (side is None):
        message = "it is not said which side is played" if side is None else "there is no port"
        raise error("FB9055", message, None, "give --port P with --as master or --as drives")
    traffic = read_traffic(recorded)
    known = load_catalog(catalog or ()).drive(series or traffic.series or "vf-s11")
    if port is None:
        _show(traffic, known, as_json)
        return
    if side is Side.MASTER and not yes:
        _refuse_starting(traffic, known)
    setting = traffic.setting
    opened = serial_port(port, setting.from_master if side is Side.MASTER else setting.from_drives)
    player = _Player(traffic, known, as_json)
    try:
        if side is Side.MASTER:
            player.ask(opened)
        else:
            player.answer(opened)
    finally:
        opened.close()


def _show(traffic: "Traffic", series: "Drive", as_json: bool) -> None:
    from fbgen.cli.frames.cell_texts import CellTexts
    from fbgen.cli.frames.frame_lines import FrameLines

    lines = FrameLines(traffic.setting.protocol, lambda address: CellTexts(series))
    if not as_json:
        for frame in traffic.frames:
            result(frame_row(frame, lines))
        return
    rows = [
        {
            "time_s": frame.start_ns / 1e9,
            "direction": frame.direction,
            "bytes": frame.data.hex(" ").upper(),
            "meaning": lines.line(frame.direction, frame.data),
        }
        for frame in traffic.frames
    ]
    result_json({"frames": rows})


def _refuse_starting(traffic: "Traffic", series: "Drive") -> None:
    """FB9053 if a request of the recording may start a motor."""
    from fbgen.cli.frames.frame_lines import frame_bytes
    from fbgen.cli.frames.motor_start import may_start
    from fbgen.diagnostics import error

    for frame in traffic.frames:
        if frame.direction == "request" and may_start(series, traffic.setting.protocol, frame.data):
            raise error(
                "FB9053",
                f"this would start a motor: {frame_bytes(frame.data)}; nothing was sent",
                None,
                "see that nobody is at the machine, then add --yes",
            )


class _Player:
    """Plays, and tells each exchange."""

    def __init__(self, traffic: "Traffic", series: "Drive", as_json: bool) -> None:
        from fbgen.cli.frames.cell_texts import CellTexts
        from fbgen.cli.frames.frame_lines import FrameLines

        self._traffic = traffic
        self._as_json = as_json
        self._done: list[Exchange] = []
        self._lines = FrameLines(traffic.setting.protocol, lambda address: CellTexts(series))

    def ask(self, port: "Port") -> None:
        """The master's side. Raises DiagnosticError FB9056 if a reply differs."""
        from fbgen.diagnostics import error
        from harness.serial import MasterReplay

        with suppress(KeyboardInterrupt):
            MasterReplay(self._traffic, port, self._told).run()
        self._end()
        if differing := sum(not item.is_same for item in self._done):
            raise error(
                "FB9056",
                f"{differing} of {len(self._done)} replies are not as they were recorded",
                None,
                "values of monitors differ from run to run; see the exchanges above",
            )

    def answer(self, port: "Port") -> None:
        """The drives' side, until Ctrl-C."""
        from harness.serial import DriveReplay

        player = DriveReplay(self._traffic, port, self._told)
        say(f"{port.name}: answers as recorded; Ctrl-C ends")
        with suppress(KeyboardInterrupt):
            while True:
                player.step()
        self._end()

    def _told(self, exchange: "Exchange") -> None:
        self._done.append(exchange)
        if self._as_json:
            return
        asked = self._lines.line("request", exchange.request)
        came = "no reply" if exchange.came is None else self._lines.line("reply", exchange.came)
        note = ""
        if not exchange.is_same:
            was = exchange.recorded
            note = "  recorded: " + ("no reply" if was is None else was.hex(" ").upper())
        result(f"{exchange.time_ns / 1e9:10.6f} s  {asked}  ->  {came}{note}")

    def _end(self) -> None:
        if self._as_json:
            result_json({"exchanges": [_exchange_json(item) for item in self._done]})
        say(f"{len(self._done)} requests")


def _exchange_json(exchange: "Exchange") -> dict[str, object]:
    recorded, came = exchange.recorded, exchange.came
    return {
        "time_s": exchange.time_ns / 1e9,
        "request": exchange.request.hex(" ").upper(),
        "recorded": None if recorded is None else recorded.hex(" ").upper(),
        "came": None if came is None else came.hex(" ").upper(),
        "same": exchange.is_same,
    }
