"""The log of a campaign, JSON Lines: its settings, then each chunk of seeds that was tried.

Each line is written at once and whole, so that a campaign goes on behind Ctrl-C, a kill or a power
failure; a last line that was cut off counts for nothing.
"""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from fbgen.diagnostics import error
from harness.verify.campaign.trials import CampaignSettings, Chunk, Failure

FORMAT = 1


def read_log(path: Path, settings: CampaignSettings) -> list[Chunk]:
    """The chunks that a log has; none if there is no log yet.

    Raises DiagnosticError FB8072 for the log of another campaign, or for what is no log.
    """
    if not path.exists():
        return []
    lines = path.read_text(encoding="utf-8").splitlines()
    entries = [entry for line in lines if (entry := _entry(line)) is not None]
    if not entries or entries[0] != _head(settings):
        raise error(
            "FB8072",
            f"{path.as_posix()} is not the log of this campaign",
            None,
            "resume with the same files and faults, or begin a new log",
        )
    return [
        Chunk(
            entry["first"],
            entry["behind"],
            entry["virtual_ns"],
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
        "files": list(settings.files),
        "kinds": list(settings.kinds),
    }


def _entry(line: str) -> dict[str, Any] | None:
    try:
        entry = json.loads(line)
    except ValueError:
        return None
    return entry if isinstance(entry, dict) else None
