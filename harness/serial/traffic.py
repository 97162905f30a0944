"""Files of line traffic: JSON Lines, a head and then one line for each frame.

docs/reference/traffic.md describes the format.
"""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import IO, Any, get_args

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.source import Source, Span
from fbgen.wire.line_frames import Direction, LineFrame
from fbgen.wire.line_protocols import LINE_PROTOCOLS
from harness.line import Parity
from harness.serial.drives import LineSetting

FORMAT = "fbgen line traffic"
VERSION = 1
_NS_PER_US = 1000
_DIRECTIONS = get_args(Direction)
_UNREADABLE = (KeyError, ValueError, TypeError, OverflowError)


@dataclass(frozen=True, slots=True)
class Traffic:
    """What was said on a line: how it was set, with which series, and the frames with their times.

    Times count from the begin of the recording.
    """

    setting: LineSetting
    series: str
    frames: tuple[LineFrame, ...]


def write_head(file: IO[str], setting: LineSetting, series: str, started: str) -> None:
    """The first line. `started` is the time of day, for people."""
    head = {
        "format": FORMAT,
        "version": VERSION,
        "protocol": setting.protocol,
        "baud": setting.baud,
        "parity": setting.parity.name.lower(),
        "series": series,
        "started": started,
    }
    file.write(json.dumps(head) + "\n")


def write_frame(file: IO[str], frame: LineFrame) -> None:
    """One frame, at once."""
    line = {
        "t_us": frame.start_ns // _NS_PER_US,
        "end_us": frame.end_ns // _NS_PER_US,
        "direction": frame.direction,
        "bytes": frame.data.hex(" ").upper(),
    }
    file.write(json.dumps(line) + "\n")
    file.flush()


def read_traffic(path: Path) -> Traffic:
    """The content of a file.

    Raises DiagnosticError as `traffic_of`, and FB9002 for a file that cannot be read.
    """
    try:
        text = path.read_text("utf-8")
    except (OSError, UnicodeDecodeError) as problem:
        reason = getattr(problem, "strerror", None) or "it is no text in UTF-8"
        raise error(
            "FB9002", f"{path.as_posix()} cannot be read: {reason}", None, "check the path"
        ) from None
    return traffic_of(Source(path.as_posix(), text))


def traffic_of(source: Source) -> Traffic:
    """What a text says. Raises DiagnosticError FB9054 at the first line that is wrong."""
    return _Reader(source).traffic()


class _Reader:
    def __init__(self, source: Source) -> None:
        self._source = source

    def traffic(self) -> Traffic:
        lines = self._lines()
        first = next(lines, None)
        if first is None or not self._is_head(first[1]):
            at, length = (0, 1) if first is None else (first[0], 1)
            raise self._wrong(at, length, "this is no head of line traffic")
        at, head = first
        try:
            parity = Parity[str(head["parity"]).upper()]
            setting = LineSetting(str(head["protocol"]), int(head["baud"]), parity)
        except _UNREADABLE:
            raise self._wrong(at, 1, "the head does not say speed, parity and protocol") from None
        if setting.protocol not in LINE_PROTOCOLS or setting.baud <= 0:
            raise self._wrong(at, 1, "the head has a protocol or speed that there is not")
        frames = tuple(self._frame(at, line) for at, line in lines)
        return Traffic(setting, str(head.get("series", "")), frames)

    def _is_head(self, head: dict[str, Any]) -> bool:
        return head.get("format") == FORMAT and head.get("version") == VERSION

    def _lines(self) -> Iterator[tuple[int, dict[str, Any]]]:
        at = 0
        for line in self._source.text.splitlines(keepends=True):
            if line.strip():
                try:
                    data = json.loads(line)
                except (ValueError, RecursionError):
                    data = None
                if not isinstance(data, dict):
                    raise self._wrong(at, len(line.rstrip()), "this is no JSON object")
                yield at, data
            at += len(line)

    def _frame(self, at: int, line: dict[str, Any]) -> LineFrame:
        try:
            start_ns, end_ns = (int(line[key]) * _NS_PER_US for key in ("t_us", "end_us"))
            data = bytes.fromhex(line["bytes"])
            direction = line["direction"]
        except _UNREADABLE:
            raise self._wrong(at, 1, "this line says no frame") from None
        if direction not in _DIRECTIONS or not data or not 0 <= start_ns <= end_ns:
            raise self._wrong(at, 1, "this line says no frame")
        return LineFrame(direction, data, start_ns, end_ns)

    def _wrong(self, at: int, length: int, message: str) -> Exception:
        return error(
            "FB9054",
            message,
            Span(self._source, at, at + max(length, 1)),
            "fbgen record writes such files; docs/reference/traffic.md describes them",
        )
