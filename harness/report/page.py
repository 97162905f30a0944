"""The report of a session as one HTML page that needs nothing else: no network, no other file.

The page is put together from the files in `page/`. Its policy allows the browser just this script
and this style, by their hashes, so that nothing in a trace or a title can become a program.
"""

import json
from base64 import b64encode
from collections.abc import Iterator, Sequence
from functools import cache
from hashlib import sha256
from pathlib import Path

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup

from fbgen.dataclass import dataclass
from fbgen.diagnostics import render
from harness.report.trace_columns import trace_columns
from harness.results import ScenarioReport, ScenarioResult
from harness.trace import Mark, Trace

_PAGE = Path(__file__).parent / "page"
_STYLES = ("colours.css", "layout.css", "diagram.css", "print.css")
_SCRIPTS = (
    *("elements.js", "times.js", "trace.js", "tracks.js", "view.js", "paint.js", "inspector.js"),
    *("diagram.js", "pointer.js", "commands.js", "events.js", "session.js"),
)
NS_PER_S = 1_000_000_000


@dataclass(frozen=True, slots=True)
class Table:
    """Something about the whole session that stands below the scenarios, such as coverage."""

    title: str
    headings: Sequence[str]
    rows: Sequence[Sequence[str]]


def html_report(
    report: ScenarioReport, asked: Sequence[str] = (), tables: Sequence[Table] = ()
) -> str:
    """The page; `asked` is what narrows the session, in words.

    The same results give the same page, byte for byte.
    """
    style, script = _style(), _script()
    failed = sum(not result.passed for result in report.results)
    passed = len(report.results) - failed
    return (
        _environment()
        .get_template("report.html.jinja")
        .render(
            session={
                "summary": f"{passed} passed, {failed} failed",
                "passed": passed,
                "failed": failed,
                "interrupted": report.interrupted,
                "virtual_time": _seconds(sum(result.virtual_ns for result in report.results)),
                "asked": asked,
            },
            scenarios=[_scenario(result) for result in report.results],
            tables=tables,
            style=Markup(style),
            style_hash=_hash(style),
            script=Markup(script),
            script_hash=_hash(script),
        )
    )


def _scenario(result: ScenarioResult) -> dict[str, object]:
    trace = result.observed(Trace)
    return {
        "name": result.name,
        "file": result.file,
        "passed": result.passed,
        "virtual_time": _seconds(result.virtual_ns),
        "facts": list(_facts(result, trace)),
        "replay": result.replay,
        "failures": [render(failure) for failure in result.failures],
        "warnings": [render(warning) for warning in result.warnings],
        "expected_failure": result.expected_failure if result.passed else None,
        "marks": [_mark(mark) for mark in trace.marks] if trace else [],
        "trace": _data(trace) if trace else "",
    }


def _facts(result: ScenarioResult, trace: Trace | None) -> Iterator[tuple[str, str]]:
    if result.plant:
        yield "plant", result.plant
    yield "seed", str(result.seed)
    if result.ran_dialect:
        yield "dialect", result.ran_dialect
    if trace is not None:
        yield "engine", trace.engine
    yield "checks held", str(result.checks)


def _mark(mark: Mark) -> dict[str, str]:
    return {
        "start": _seconds(mark.start_ns),
        "end": "" if mark.end_ns is None else _seconds(mark.end_ns),
        "title": mark.title,
        "target": mark.target,
        "verdict": mark.verdict or "",
    }


def _data(trace: Trace) -> Markup:
    """The columns as JSON that may stand between script tags."""
    text = json.dumps(trace_columns(trace), separators=(",", ":"), allow_nan=False)
    return Markup(text.replace("<", "\\u003c"))


def _seconds(time_ns: int) -> str:
    return f"{time_ns / NS_PER_S:.3f} s"


@cache
def _environment() -> Environment:
    return Environment(
        loader=FileSystemLoader(_PAGE),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )


@cache
def _style() -> str:
    return "".join(_text(name) for name in _STYLES)


@cache
def _script() -> str:
    parts = "".join(_text(name) for name in _SCRIPTS)
    return f'(() => {{\n"use strict";\n{parts}}})();\n'


def _text(name: str) -> str:
    return (_PAGE / name).read_text(encoding="utf-8")


def _hash(text: str) -> str:
    """As a Content-Security-Policy names an inline script or style."""
    return f"sha256-{b64encode(sha256(text.encode()).digest()).decode()}"
