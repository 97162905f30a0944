"""What `fbgen check --format json` prints, as models: `schemas/check-report.schema.json`."""

from collections.abc import Sequence
from typing import Literal

from pydantic import BaseModel, ConfigDict, Field

from fbgen.cli.sources.plc_files import ProgramFiles
from fbgen.diagnostics import Diagnostic, Severity


class _Part(BaseModel):
    model_config = ConfigDict(extra="forbid", frozen=True)


class CheckedProgram(_Part):
    """The files of one dialect, which are checked as one program."""

    dialect: str = Field(description="Dialect of the files: tia, step7, iec or twincat.")
    files: list[str] = Field(description="Paths as they were given or found.")


class Place(_Part):
    """A piece of a file. Lines and columns count from 1; the end is the first place behind it."""

    file: str | None = Field(None, description="Path of the file; missing if it is about none.")
    line: int | None = Field(None, ge=1)
    column: int | None = Field(None, ge=1, description="Counts characters, not bytes.")
    end_line: int | None = Field(None, ge=1)
    end_column: int | None = Field(None, ge=1)


class ReportedNote(Place):
    """A second place that belongs to a finding."""

    message: str


class Finding(Place):
    """One finding, with its place if it has one."""

    code: str = Field(pattern="^FB[1-9][0-9]{3}$", description="`fbgen explain CODE` says more.")
    severity: Literal["error", "warning", "info"]
    message: str = Field(description="What is there.")
    help: str | None = Field(None, description="How to mend it.")
    notes: list[ReportedNote] | None = None


class CheckReport(_Part):
    """The result of one run of `fbgen check`."""

    version: Literal[1] = Field(1, description="Version of this format.")
    programs: list[CheckedProgram]
    errors: int = Field(ge=0)
    warnings: int = Field(ge=0)
    diagnostics: list[Finding]


def report_of(programs: Sequence[ProgramFiles], findings: Sequence[Diagnostic]) -> object:
    """The report as plain data."""
    severities = [finding.severity for finding in findings]
    return {
        "version": 1,
        "programs": [
            {"dialect": program.dialect, "files": [str(path) for path in program.paths]}
            for program in programs
        ],
        "errors": severities.count(Severity.ERROR),
        "warnings": severities.count(Severity.WARNING),
        "diagnostics": [finding.as_json() for finding in findings],
    }
