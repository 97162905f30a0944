"""Findings for code hosts without SARIF: GitHub's log lines, GitLab's code quality report.

Sources: GitHub Docs, "Workflow commands" (error, warning, notice; % and line ends are escaped, in
properties also : and ,); GitLab Docs, "Code Quality report format".
"""

from collections import Counter
from collections.abc import Iterator, Sequence
from hashlib import sha256

from fbgen.diagnostics import Diagnostic, Severity

_COMMANDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "notice"}
_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def github_lines(findings: Sequence[Diagnostic]) -> Iterator[str]:
    """One workflow command for each finding."""
    for finding in findings:
        properties = {"title": finding.code}
        if (span := finding.span) is not None:
            properties |= {
                "file": span.source.name,
                "line": str(span.line),
                "endLine": str(span.end_line),
                "col": str(span.column),
                "endColumn": str(span.end_column),
            }
        listed = ",".join(
            f"{name}={_escaped(value).replace(':', '%3A').replace(',', '%2C')}"
            for name, value in properties.items()
        )
        text = f"{finding.message}\n{finding.help}" if finding.help else finding.message
        yield f"::{_COMMANDS[finding.severity]} {listed}::{_escaped(text)}"


def _escaped(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def gitlab_report(findings: Sequence[Diagnostic]) -> list[dict[str, object]]:
    """The report as plain data; findings without a place are at the first line of no file."""
    report: list[dict[str, object]] = []
    seen: Counter[tuple[str, ...]] = Counter()
    for finding in findings:
        span = finding.span
        path = span.source.name if span is not None else "."
        line = span.line if span is not None else 1
        content = span.source.line_text(line).strip() if span is not None else ""
        key = (finding.code, path, content, finding.message)
        seen[key] += 1
        report.append(
            {
                "description": f"{finding.message} ({finding.code})",
                "check_name": finding.code,
                "fingerprint": sha256("\0".join((*key, str(seen[key]))).encode()).hexdigest(),
                "severity": _SEVERITIES[finding.severity],
                "location": {"path": path, "lines": {"begin": line}},
            }
        )
    return report
