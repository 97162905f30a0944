"""The log of a campaign, JSON Lines: its settings, then each chunk of seeds that was tried.

Each line is written at once and whole, so that a campaign goes on behind Ctrl-C, a kill or a power
failure; a last line that was cut off counts for nothing.
"""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from fbgen import __version__
from fbgen.diagnostics import error
from fbgen.source import Source, Span
from harness.verify.campaign.contents import contents
from harness.verify.campaign.trials import CampaignSettings, Chunk, Failure

FORMAT = 2


def read_log(path: Path, settings: CampaignSettings) -> list[Chunk]:
    """The chunks that a log has; none if there is no log yet.

    Raises DiagnosticError FB8072 for the log of another campaign, or for what is no log.
    """
    if not path.exists():
        return []
    text = path.read_text(encoding="utf-8", errors="replace")
    entries = [entry for line in text.splitlines() if (entry := _entry(line)) is not None]
    if (found := _differs(entries[0] if entries else {}, _head(settings))) is not None:
        message, advice = found
        source = Source(path.as_posix(), text)
        first = Span(source, 0, len(text.partition("\n")[0]))
        raise error("FB8072", f"{path.as_posix()} {message}", first, advice)
    return [
        Chunk(
            entry["first"],
            entry["behind"],
            entry["virtual_ns"],
            tuple(entry["configurations"]),
            tuple(Failure(**failure) for failure in entry["failures"]),
        )
        for entry in entries[1:]
    ]


class Log:
    """A log that is written on."""

    def __init__(self, path: Path, settings: CampaignSettings) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        text = path.read_text(encoding="utf-8") if path.exists() else ""
        if text and not text.endswith("\n"):
            whole = text[: text.rfind("\n") + 1]
            path.write_text(whole, encoding="utf-8")
            text = whole
        self._file = path.open("a", encoding="utf-8", newline="\n")
        if not text:
            self._write(_head(settings))

    def add(self, chunk: Chunk) -> None:
        """Note a chunk."""
        self._write(asdict(chunk))

    def close(self) -> None:
        """No more chunks."""
        self._file.close()

    def _write(self, entry: dict[str, Any]) -> None:
        self._file.write(json.dumps(entry) + "\n")
        self._file.flush()


def _head(settings: CampaignSettings) -> dict[str, Any]:
    return {
        "campaign": FORMAT,
        "fbgen": __version__,
        "files": list(settings.files),
        "kinds": list(settings.kinds),
        "contents": contents(settings.files),
    }


def _differs(entry: dict[str, Any], head: dict[str, Any]) -> tuple[str, str] | None:
    """In what the first line of a log is not that of this campaign, and what to do then."""
    if entry == head:
        return None
    if any(entry.get(key) != head[key] for key in ("campaign", "files", "kinds")):
        message = "is not the log of this campaign"
        return message, "resume with the same files and faults, or begin a new log"
    if entry.get("fbgen") != head["fbgen"]:
        message = f"was written by fbgen {entry.get('fbgen')}, this is {head['fbgen']}"
    else:
        changed = [
            file
            for file, now in head["contents"].items()
            if entry.get("contents", {}).get(file) != now
        ]
        names = ", ".join(changed) or "a file that is not there any more"
        message = f"is of another state of the plant: {names} has changed since"
    return message, "its seeds would do something else now: begin a new log, without --resume"


def _entry(line: str) -> dict[str, Any] | None:
    try:
        entry = json.loads(line)
    except ValueError:
        return None
    return entry if isinstance(entry, dict) else None
