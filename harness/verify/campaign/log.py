"""The log of a campaign: its settings, then each chunk of seeds that was tried."""

from dataclasses import asdict
from pathlib import Path
from typing import Any

from fbgen import __version__
from fbgen.diagnostics import error
from harness.journal import Entry, Journal, OtherRunError
from harness.verify.campaign.contents import contents
from harness.verify.campaign.trials import CampaignSettings, Chunk, Failure

FORMAT = 2


def open_log(path: Path, settings: CampaignSettings) -> tuple[Journal, list[Chunk]]:
    """A log to write on, and the chunks that it has; none if there is no log yet.

    Raises DiagnosticError FB8072 for the log of another campaign, or for what is no log.
    """
    head = _head(settings)
    try:
        log = Journal(path, head)
    except OtherRunError as other:
        message, advice = _differs(other.head, head)
        raise error("FB8072", f"{path.as_posix()} {message}", other.span, advice) from None
    return log, [_chunk(entry) for entry in log.entries]


def add_chunk(log: Journal, chunk: Chunk) -> None:
    """Note a chunk."""
    log.add(asdict(chunk))


def _chunk(entry: Entry) -> Chunk:
    return Chunk(
        entry["first"],
        entry["behind"],
        entry["virtual_ns"],
        tuple(entry["configurations"]),
        tuple(Failure(**failure) for failure in entry["failures"]),
    )


def _head(settings: CampaignSettings) -> dict[str, Any]:
    return {
        "campaign": FORMAT,
        "fbgen": __version__,
        "files": list(settings.files),
        "kinds": list(settings.kinds),
        "contents": contents(settings.files),
    }


def _differs(entry: Entry, head: Entry) -> tuple[str, str]:
    """In what the first line of a log is not that of this campaign, and what to do then."""
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
