"""`fbgen record`: what is said on a line, with times, into a file and in words."""

import sys
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import IO, TYPE_CHECKING, Annotated

import typer

from fbgen.cli.examples import examples
from fbgen.cli.layers import CatalogOption
from fbgen.cli.output import result, say
from fbgen.cli.ports.line_options import (
    BaudOption,
    ParityOption,
    PortOption,
    ProtocolOption,
    asked_setting,
)

if TYPE_CHECKING:
    from fbgen.cli.frames.frame_lines import FrameLines
    from fbgen.wire.line_frames import LineFrame


def register(program: typer.Typer) -> None:
    """Add the command to the program."""
    program.command(
        epilog=examples(
            "fbgen record --port /dev/ttyUSB0 --baud 19200 -o line.jsonl",
            "fbgen record --port COM3 --series vf-s15 --protocol modbus -o line.jsonl --for 30s",
            "fbgen record --port COM3                     shows what is said and keeps nothing",
        )
    )(record)


def record(
    port: PortOption,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE", help="Where it is kept.")
    ] = None,
    series: Annotated[
        str, typer.Option("--series", metavar="S", help="Series, for names, units and defaults.")
    ] = "vf-s11",
    protocol: ProtocolOption = None,
    baud: BaudOption = None,
    parity: ParityOption = None,
    duration: Annotated[
        str | None, typer.Option("--for", metavar="T", help="How long; else until Ctrl-C.")
    ] = None,
    force: Annotated[bool, typer.Option("--force", help="Overwrite the file.")] = False,
    catalog: CatalogOption = None,
) -> None:
    """Listen to a line between a master and inverters: each frame with its time and its meaning.

    Nothing is sent. Both directions have to be heard: on two wires they are, on four wires join
    the receivers' pairs or record each for itself.
    """
    from fbgen.catalog import load_catalog
    from fbgen.cli.frames.cell_texts import CellTexts
    from fbgen.cli.frames.frame_lines import FrameLines
    from harness.serial import Recording, protocol_of, serial_port, write_frame, write_head

    known = load_catalog(catalog or ()).drive(series)
    setting = asked_setting([known], protocol, baud, parity)
    longest_ns = _time_ns(duration)
    lines = FrameLines(setting.protocol, lambda address: CellTexts(known))
    counts = {"request": 0, "reply": 0, "unknown": 0}
    opened = serial_port(port, setting.from_master)
    file: IO[str] | None = None
    try:
        if output is not None:
            file = _opened(output, force)
            write_head(file, setting, known.id, datetime.now(UTC).isoformat(timespec="seconds"))

        def told(frame: "LineFrame") -> None:
            counts[frame.direction] += 1
            if file is not None:
                write_frame(file, frame)
            result(frame_row(frame, lines))

        recording = Recording(opened, protocol_of(setting), told)
        say(f"{port}: {setting.protocol}, {setting.from_master}; Ctrl-C ends")
        with suppress(KeyboardInterrupt):
            while longest_ns is None or recording.elapsed_ns < longest_ns:
                recording.step()
                sys.stdout.flush()
        recording.end()
    finally:
        if file is not None:
            file.close()
        opened.close()
    say(f"{counts['request']} requests, {counts['reply']} replies, {counts['unknown']} unknown")


def frame_row(frame: "LineFrame", lines: "FrameLines") -> str:
    """A frame on one line: when, which way, its bytes, what it says."""
    from fbgen.cli.frames.frame_lines import frame_bytes

    arrow = {"request": ">", "reply": "<"}.get(frame.direction, "?")
    said = lines.line(frame.direction, frame.data)
    seconds, microseconds = divmod(frame.start_ns // 1000, 1_000_000)
    return f"{seconds:3}.{microseconds:06} s {arrow} {frame_bytes(frame.data)}  {said}"


def _opened(path: Path, force: bool) -> IO[str]:
    """The file. Raises DiagnosticError FB9001 if it is there already, FB9002."""
    from fbgen.diagnostics import error

    try:
        return path.open("w" if force else "x", encoding="utf-8", newline="\n")
    except FileExistsError:
        raise error(
            "FB9001", f"{path} is already there", None, "take another name; --force overwrites it"
        ) from None
    except OSError as problem:
        raise error(
            "FB9002", f"{path} cannot be written: {problem.strerror}", None, "check the path"
        ) from None


def _time_ns(text: str | None) -> int | None:
    from fbgen.diagnostics import error
    from harness.durations import read_duration

    try:
        return None if text is None else read_duration(text)
    except ValueError as wrong:
        raise error("FB9050", f"--for: {wrong}", None, "write --for 30s") from None
