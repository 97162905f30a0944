"""Where the lines of generated files are from, kept beside them: `fbgen-origins.json`.

The map has each origin once and, for each file, the hash of its content and the origins of each
line by their numbers. So a line can be explained without the plant file and the catalogue, and a
file that was changed since is not explained wrongly.
"""

import json
from collections.abc import Iterable
from hashlib import sha256
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.emit.generated import GeneratedFile
from fbgen.lang.printer import LineOrigins
from fbgen.source import Origin

ORIGIN_MAP = "fbgen-origins.json"


@dataclass(frozen=True, slots=True)
class ExplainedLine:
    """A line of a generated file, with its origins: the line of the template, then the values.

    `own` is False for a line that says nothing by itself, such as an empty one: then the origins
    are those of the nearest line that does.
    """

    text: str
    origins: LineOrigins
    own: bool


def origin_map(files: Iterable[GeneratedFile]) -> bytes:
    """The map of these files; empty if none of their lines has an origin."""
    table = _Table()
    known = {
        file.name: {
            "hash": sha256(file.data).hexdigest(),
            "lines": [table.numbers(line) for line in file.origins],
        }
        for file in files
        if any(file.origins)
    }
    if not known:
        return b""
    content = {"origins": table.rows, "files": known}
    return (json.dumps(content, separators=(",", ":")) + "\n").encode("ascii")


def explain_line(path: Path, line: int) -> ExplainedLine:
    """Where a line of a generated file is from.

    Raises DiagnosticError FB9017 for a file that is not generated or was changed since, FB9018 for
    a line beyond its end.
    """
    data, entry, rows = _entry(path)
    texts = data.decode("utf-8").split("\n")
    lines: list[list[int]] = entry["lines"]
    if not 1 <= line <= len(lines):
        raise error(
            "FB9018",
            f"{path} has no line {line}",
            help=f"it has {len(lines)} lines",
        )
    at = _nearest(lines, line - 1)
    origins = tuple(_origin(rows, number) for number in lines[at])
    return ExplainedLine(texts[line - 1].rstrip("\r"), origins, at == line - 1)


class _Table:
    """Each origin once. Equal ones are mostly one object, which is found without comparing."""

    def __init__(self) -> None:
        self.rows: list[list[object]] = []
        self._numbers: dict[Origin, int] = {}
        self._objects: dict[int, tuple[Origin, int]] = {}

    def numbers(self, line: LineOrigins) -> list[int]:
        """Those of a line."""
        known = self._objects
        for origin in line:
            if id(origin) not in known:
                known[id(origin)] = origin, self.number(origin)
        return [known[id(origin)][1] for origin in line]

    def number(self, origin: Origin) -> int:
        """That of an origin."""
        known = self._numbers.get(origin)
        if known is None:
            inputs = [self.number(item) for item in origin.inputs]
            known = self._numbers[origin] = len(self.rows)
            self.rows.append([origin.what, origin.file, origin.line, origin.source, inputs])
        return known


def _entry(path: Path) -> tuple[bytes, dict[str, list[list[int]]], list[list[object]]]:
    """The content of a generated file, what the map says about it, and all origins."""
    try:
        data = path.read_bytes()
    except OSError as problem:
        raise _unknown(f"{path} cannot be read: {problem.strerror}") from None
    try:
        content = json.loads((path.parent / ORIGIN_MAP).read_bytes())
        entry = content["files"].get(path.name)
        if entry is None:
            raise _unknown(f"{path} is no generated file with lines of a template")
        if entry["hash"] != sha256(data).hexdigest():
            raise _unknown(f"{path} has been changed since it was generated")
        return data, entry, content["origins"]
    except OSError:
        raise _unknown(f"there is no {ORIGIN_MAP} beside {path}") from None
    except (ValueError, LookupError, TypeError, AttributeError, RecursionError):
        raise _unknown(f"{path.parent / ORIGIN_MAP} is damaged") from None


def _unknown(message: str) -> DiagnosticError:
    return error(
        "FB9017", message, help=f"fbgen generate writes the files and {ORIGIN_MAP} beside them"
    )


def _nearest(lines: list[list[int]], at: int) -> int:
    """The line itself, else the next one below that has an origin, else the next one above."""
    below = range(at, len(lines))
    above = range(at - 1, -1, -1)
    return next((number for number in (*below, *above) if lines[number]), at)


def _origin(rows: list[list[object]], number: int) -> Origin:
    what, file, line, source, inputs = rows[number]
    assert isinstance(line, int)
    assert isinstance(inputs, list)
    known = tuple(_origin(rows, item) for item in inputs)
    return Origin(str(what), str(file), line, str(source), known)
