"""The log of a mutation run: a line for each verdict, so that a run that was ended goes on.

JSON Lines. The first line says what was run: with another text, other scenarios or another version
the verdicts do not count, and the log begins anew.
"""

import json
from pathlib import Path

from fbgen import __version__
from fbgen.diagnostics import error
from harness.verify.mutation.verdict import Verdict

_FORMAT = "fbgen mutation log 1"


class Log:
    """The verdicts of earlier runs, and a place for new ones. Without a path it forgets."""

    def __init__(self, path: Path | None, contents: str) -> None:
        """`contents` stands for everything that the verdicts depend on.

        Raises DiagnosticError FB8063 for a file that is something else.
        """
        self.known: dict[str, Verdict] = {}
        self._path = path
        if path is None:
            return
        head = {"format": _FORMAT, "version": __version__, "contents": contents}
        if path.exists() and self._read(path, head):
            return
        path.write_text(json.dumps(head) + "\n", encoding="utf-8")

    def _read(self, path: Path, head: dict[str, str]) -> bool:
        """True if the log belongs to this run; its last line may be cut off."""
        first, *lines = path.read_text(encoding="utf-8").split("\n")
        try:
            found = json.loads(first) if first else {}
        except ValueError:
            found = None
        if not isinstance(found, dict) or (found and found.get("format") != _FORMAT):
            raise error(
                "FB8063",
                f"{path.as_posix()} is no log of a mutation run",
                help="name another file with --log",
            )
        if found != head:
            return False
        whole = [line for line in lines[:-1] if line]
        for line in whole:
            verdict = Verdict.from_json(json.loads(line))
            self.known[verdict.id] = verdict
        if lines and lines[-1]:
            path.write_text("\n".join((first, *whole, "")), encoding="utf-8")
        return True

    def note(self, verdict: Verdict) -> None:
        """Write a verdict down at once."""
        if self._path is not None:
            with self._path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(verdict.as_json()) + "\n")
