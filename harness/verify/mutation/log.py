"""The log of a mutation run: what each case said of each mutant, so that nothing is run twice.

JSON Lines. Each line belongs to a block and a case, both named by what they contain: a run that was
ended goes on, and after a change of some scenarios, or of another block, only what the change can
have touched is run again. With another version of fbgen the log begins anew.
"""

import json
from dataclasses import field
from pathlib import Path
from typing import Any, TypeAlias

from fbgen import __version__
from fbgen.dataclass import dataclass
from fbgen.diagnostics import error

Noticed: TypeAlias = tuple[str, int]
"""The first check that failed, as code and message, and when in the plant's time."""
_FORMAT = "fbgen mutation log 2"


@dataclass(slots=True)
class Known:
    """What is known of the mutants of a block in a case, by their numbers.

    `reached` and `changed` are among the `asked`. `noticed` has the message and the time of the
    check that failed, None where none did.
    """

    asked: set[int] = field(default_factory=set)
    reached: set[int] = field(default_factory=set)
    changed: set[int] = field(default_factory=set)
    noticed: dict[int, Noticed | None] = field(default_factory=dict)


class Log:
    """What earlier runs have found, and a place for more. Without a path it forgets."""

    def __init__(self, path: Path | None) -> None:
        """Raises DiagnosticError FB8063 for a file that is something else."""
        self._cases: dict[tuple[str, str], Known] = {}
        self._said: dict[tuple[str, int, str], str] = {}
        self._path = path
        if path is None:
            return
        head = {"format": _FORMAT, "version": __version__}
        if path.exists() and self._read(path, head):
            return
        path.write_text(json.dumps(head) + "\n", encoding="utf-8")

    def _read(self, path: Path, head: dict[str, str]) -> bool:
        """True if the log is one of this version; its last line may be cut off."""
        first, *lines = path.read_text(encoding="utf-8").split("\n")
        try:
            found = json.loads(first) if first else {}
        except ValueError:
            found = None
        if not isinstance(found, dict) or (found and "mutation log" not in found.get("format", "")):
            raise error(
                "FB8063",
                f"{path.as_posix()} is no log of a mutation run",
                help="name another file with --log",
            )
        if found != head:
            return False
        whole = [line for line in lines[:-1] if line]
        for line in whole:
            self._take(json.loads(line))
        if lines and lines[-1]:
            path.write_text("\n".join((first, *whole, "")), encoding="utf-8")
        return True

    def _take(self, line: dict[str, Any]) -> None:
        if "mutant" in line:
            self._said[line["block"], line["mutant"], line["of"]] = line["said"]
            return
        known = self.known(line["block"], line["case"])
        if "run" in line:
            noticed = line.get("noticed")
            known.noticed[line["run"]] = None if noticed is None else (noticed, line["at_ns"])
            return
        known.asked.update(line["asked"])
        known.reached.update(line["reached"])
        known.changed.update(line["changed"])

    def known(self, block: str, case: str) -> Known:
        """What is known of the mutants of a block in a case."""
        return self._cases.setdefault((block, case), Known())

    def note_look(
        self, block: str, case: str, asked: set[int], reached: set[int], changed: set[int]
    ) -> None:
        """Write down at once which mutants a case could notice."""
        known = self.known(block, case)
        known.asked |= asked
        known.reached |= reached
        known.changed |= changed
        lists = {"asked": sorted(asked), "reached": sorted(reached), "changed": sorted(changed)}
        self._write({"block": block, "case": case, **lists})

    def note_run(self, block: str, case: str, number: int, noticed: Noticed | None) -> None:
        """Write down at once what came of a mutant in a case."""
        self.known(block, case).noticed[number] = noticed
        line: dict[str, object] = {"block": block, "case": case, "run": number}
        if noticed is not None:
            line |= {"noticed": noticed[0], "at_ns": noticed[1]}
        self._write(line)

    def said(self, block: str, number: int, of: str) -> str | None:
        """What has been said of a mutant; `of` names what it depends on."""
        return self._said.get((block, number, of))

    def note_said(self, block: str, number: int, of: str, said: str) -> None:
        """Write it down at once."""
        self._said[block, number, of] = said
        self._write({"block": block, "mutant": number, "of": of, "said": said})

    def _write(self, line: dict[str, object]) -> None:
        if self._path is not None:
            with self._path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(line) + "\n")
