"""What a long run has found so far, JSON Lines: a head that says which run it is, then its finds.

Each line is written at once and whole, so that a run goes on behind Ctrl-C, a kill or a power
failure; a last line that was cut off counts for nothing.
"""

import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any, TypeAlias

from fbgen.source import Source, Span

Entry: TypeAlias = Mapping[str, Any]


class OtherRunError(Exception):
    """The file is the journal of another run, with this `head`, or no journal at all.

    `span` is its first line.
    """

    def __init__(self, path: Path, data: bytes, head: Entry | None) -> None:
        super().__init__(path.as_posix())
        self.head: Entry = head or {}
        text = data.decode("utf-8", "replace")
        self.span = Span(Source(path.as_posix(), text), 0, len(text.partition("\n")[0]))


class Journal:
    """A journal that is read and then written on. `entries` are those that it had."""

    def __init__(self, path: Path, head: Entry) -> None:
        """`head` says what the finds depend on. Raises OtherRunError, OSError."""
        data = path.read_bytes() if path.exists() else b""
        lines = [_entry(line) for line in data.splitlines()]
        if data and lines[0] != head:
            raise OtherRunError(path, data, lines[0])
        self.entries = [entry for entry in lines[1:] if entry is not None]
        path.parent.mkdir(parents=True, exist_ok=True)
        if data and not data.endswith(b"\n"):
            path.write_bytes(data[: data.rfind(b"\n") + 1])
        self._file = path.open("a", encoding="utf-8", newline="\n")
        if b"\n" not in data:
            self.add(head)

    def add(self, entry: Entry) -> None:
        """Note a find."""
        self._file.write(json.dumps(entry) + "\n")
        self._file.flush()

    def close(self) -> None:
        """No more finds."""
        self._file.close()


def _entry(line: bytes) -> Entry | None:
    try:
        entry = json.loads(line)
    except ValueError:
        return None
    return entry if isinstance(entry, dict) else None
