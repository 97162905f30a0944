"""Findings as SARIF 2.1.0, which code hosts show beside the lines of a change.

Source: OASIS Static Analysis Results Interchange Format (SARIF) Version 2.1.0. Columns count
characters (`columnKind` unicodeCodePoints); an end column is the first one behind the region.
"""

from collections.abc import Sequence
from pathlib import Path, PurePath
from urllib.parse import quote

from fbgen import __version__
from fbgen.diagnostics import Diagnostic, Note, Severity
from fbgen.pages import pages, severity_of, title_of
from fbgen.source import Span

_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_ROOT = "%SRCROOT%"
"""What relative paths are relative to: the folder in which the command runs."""


def sarif_of(findings: Sequence[Diagnostic]) -> object:
    """The log file as plain data."""
    codes = sorted({finding.code for finding in findings})
    index = {code: place for place, code in enumerate(codes)}
    return {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [
            {
                "tool": {
                    "driver": {
                        "name": "fbgen",
                        "semanticVersion": __version__,
                        "rules": [_rule(code) for code in codes],
                    }
                },
                "columnKind": "unicodeCodePoints",
                "results": [_result(finding, index[finding.code]) for finding in findings],
            }
        ],
    }


def _rule(code: str) -> dict[str, object]:
    page = pages()[code].read_text(encoding="utf-8")
    return {
        "id": code,
        "shortDescription": {"text": title_of(code)},
        "help": {"text": f"fbgen explain {code}", "markdown": page},
        "defaultConfiguration": {"level": _LEVELS[severity_of(code)]},
    }


def _result(finding: Diagnostic, rule_index: int) -> dict[str, object]:
    text = f"{finding.message}. Help: {finding.help}" if finding.help else finding.message
    result: dict[str, object] = {
        "ruleId": finding.code,
        "ruleIndex": rule_index,
        "level": _LEVELS[finding.severity],
        "message": {"text": text},
    }
    if finding.span is not None:
        result["locations"] = [_location(finding.span)]
    related = [
        _related(number, note, note.span)
        for number, note in enumerate(finding.notes)
        if note.span is not None
    ]
    if related:
        result["relatedLocations"] = related
    return result


def _related(number: int, note: Note, span: Span) -> dict[str, object]:
    return {"id": number, "message": {"text": note.message}, **_location(span)}


def _location(span: Span) -> dict[str, object]:
    return {
        "physicalLocation": {
            "artifactLocation": _artifact(span.source.name),
            "region": {
                "startLine": span.line,
                "startColumn": span.column,
                "endLine": span.end_line,
                "endColumn": span.end_column,
            },
        }
    }


def _artifact(name: str) -> dict[str, object]:
    if PurePath(name).is_absolute():
        path = Path(name)
        here = Path.cwd()
        if not path.is_relative_to(here):
            return {"uri": path.as_uri()}
        name = str(path.relative_to(here))
    return {"uri": quote(PurePath(name).as_posix()), "uriBaseId": _ROOT}
