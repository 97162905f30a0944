"""What came of a scenario."""

import shlex
from collections.abc import Sequence
from dataclasses import field
from typing import TypeVar

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, render

Kind = TypeVar("Kind")


@dataclass(frozen=True, slots=True)
class ScenarioResult:
    """One run of one scenario. `virtual_ns` is how long it took in the plant's own time.

    `changes` is what the variation changes, in brackets; `dialect` and `temporaries` what was asked
    for beside it.
    `plant` is the plant file, `ran_dialect` the dialect of the text that ran: empty if none did,
    because something was wrong in the files. `warnings` say what a run that has passed does not
    show. With an `expected_failure`, the reason for it, a scenario passes by having failures.
    `catalog` has the folders over the shipped catalogue. `observations` are what the observers of
    the run have left, such as its trace.
    """

    name: str
    file: str
    seed: int
    passed: bool
    failures: tuple[Diagnostic, ...] = ()
    virtual_ns: int = 0
    checks: int = 0
    changes: str = ""
    dialect: str | None = None
    plant: str = ""
    ran_dialect: str = ""
    warnings: tuple[Diagnostic, ...] = ()
    expected_failure: str | None = None
    observations: tuple[object, ...] = ()
    temporaries: str = ""
    catalog: tuple[str, ...] = ()

    def observed(self, kind: type[Kind]) -> Kind | None:
        """The observation of this kind, `result.observed(Trace)`; None if nobody has made one."""
        return next((item for item in self.observations if isinstance(item, kind)), None)

    @property
    def replay(self) -> str:
        """The command that runs just this again, for a shell."""
        command = ["fbgen", "test", self.file, "--seed", str(self.seed)]
        if self.dialect is not None:
            command += ["--dialect", self.dialect]
        if self.temporaries:
            command += ["--temporaries", self.temporaries]
        for folder in self.catalog:
            command += ["--catalog", folder]
        if self.changes:
            command += ["-k", f'"{self.changes}"']
        return shlex.join(command)

    def as_json(self) -> dict[str, object]:
        """The result as plain data."""
        return {
            "name": self.name,
            "file": self.file,
            "seed": self.seed,
            "passed": self.passed,
            "checks": self.checks,
            "virtual_ns": self.virtual_ns,
            "replay": self.replay,
            "expected_failure": self.expected_failure,
            "warnings": [warning.as_json() for warning in self.warnings],
            "failures": [failure.as_json() for failure in self.failures],
        }

    def render(self) -> str:
        """The failures for a person, with how to run the scenario again."""
        lines = [render(failure) for failure in self.failures]
        lines.append(f"run it again: {self.replay}")
        return "\n".join(lines)


@dataclass(frozen=True, slots=True)
class ScenarioReport:
    """The runs of a session in their order; after Ctrl-C those that had ended by then."""

    results: Sequence[ScenarioResult] = field(default_factory=tuple)
    interrupted: bool = False

    @property
    def passed(self) -> bool:
        """True if every scenario has passed."""
        return all(result.passed for result in self.results)
