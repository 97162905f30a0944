"""The failures of a session as findings at places, for code hosts that mark lines."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.source import Source, Span
from harness.results import ScenarioReport, ScenarioResult


def findings_of(report: ScenarioReport) -> Iterator[Diagnostic]:
    """Each failure at its line of the scenario, then what its notes say at lines of PLC text.

    A failure without a place stands at the first line of its scenario file. Failures that were
    expected are none; warnings are told too.
    """
    for result in report.results:
        failures = () if result.passed else result.failures
        for failure in (*failures, *result.warnings):
            yield _failure(result, failure)
            for note in failure.notes:
                if note.span is not None:
                    message = f"{result.name}: {note.message}"
                    yield Diagnostic(failure.code, message, note.span, severity=Severity.INFO)


def _failure(result: ScenarioResult, failure: Diagnostic) -> Diagnostic:
    told = [note.message for note in failure.notes]
    told += [failure.help] if failure.help else []
    told.append(f"run it again: {result.replay}")
    place = failure.span or Span(Source(result.file, ""), 0, 0)
    return Diagnostic(
        failure.code,
        f"{result.name}: {failure.message}",
        place,
        "\n".join(told),
        severity=failure.severity,
    )
