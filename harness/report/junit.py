"""The results of a session as JUnit XML, for CI servers.

There is no one standard. The file keeps to the schema of Jenkins' xUnit plugin (junit-10.xsd),
where only suites may have properties and a file: so each run of a scenario is a `testsuite` with
one `testcase`. GitLab tells testcases apart by `classname` and `name` (GitLab Docs, "Unit test
reports"). `time` is the plant's own time, so the same runs give the same file, byte for byte.
"""

import re
from collections.abc import Iterator
from pathlib import PurePosixPath
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from fbgen.diagnostics import render
from harness.results import ScenarioReport, ScenarioResult

NS_PER_S = 1_000_000_000
_SESSION = "fbgen test"
_SUFFIX = ".scenario.yaml"
_NO_XML = re.compile("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
"""Characters that XML 1.0 does not have, not even escaped."""


def junit_xml(report: ScenarioReport) -> str:
    """The file. A session that Ctrl-C ended has one more testcase, with an error that says so."""
    root = Element("testsuites", name=_SESSION)
    for number, result in enumerate(report.results):
        root.append(_suite(number, result))
    if report.interrupted:
        root.append(_interrupted(len(report.results)))
    total_ns = sum(result.virtual_ns for result in report.results)
    counts = _counts(root)
    del counts["skipped"]
    root.attrib |= counts | {"time": _seconds(total_ns)}
    indent(root)
    return tostring(root, encoding="unicode", xml_declaration=False).join(
        ('<?xml version="1.0" encoding="UTF-8"?>\n', "\n")
    )


def _suite(number: int, result: ScenarioResult) -> Element:
    time = _seconds(result.virtual_ns)
    suite = Element("testsuite", name=_clean(result.name), id=str(number))
    suite.attrib |= {"package": _package(result.file), "file": _clean(result.file), "time": time}
    properties = SubElement(suite, "properties")
    for name, value in _properties(result):
        SubElement(properties, "property", name=name, value=_clean(value))
    case = SubElement(suite, "testcase", name=_clean(result.name), time=time)
    case.set("classname", _package(result.file))
    if not result.passed:
        _add_failures(case, result)
    elif result.expected_failure is not None:
        expected = SubElement(case, "skipped", type="expected failure")
        expected.set("message", _clean(result.expected_failure))
        expected.text = _clean(f"\n{result.render()}\n")
    if result.warnings:
        told = "\n".join(render(warning) for warning in result.warnings)
        SubElement(case, "system-out").text = _clean(f"\n{told}\n")
    suite.attrib |= _counts(suite)
    return suite


def _properties(result: ScenarioResult) -> Iterator[tuple[str, str]]:
    yield "seed", str(result.seed)
    if result.plant:
        yield "plant", result.plant
    if result.ran_dialect:
        yield "dialect", result.ran_dialect
    if result.changes:
        yield "variation", result.changes.strip("[]")
    yield "virtual_time_ns", str(result.virtual_ns)
    yield "checks", str(result.checks)
    yield "replay", result.replay
    places = (failure.span for failure in result.failures if failure.span is not None)
    if (place := next(places, None)) is not None:
        yield "place", str(place)


def _add_failures(case: Element, result: ScenarioResult) -> None:
    """One element with everything: readers take the first. An error is what could not even run."""
    failure = SubElement(case, "failure" if result.ran_dialect else "error")
    codes = list(dict.fromkeys(found.code for found in result.failures))
    failure.set("type", codes[0])
    more = len(result.failures) - 1
    message = result.failures[0].message + (f" (and {more} more)" if more else "")
    failure.set("message", _clean(message))
    failure.text = _clean(f"\n{result.render()}\n")


def _interrupted(number: int) -> Element:
    suite = Element("testsuite", name=_SESSION, id=str(number), package=_SESSION, time="0.000")
    SubElement(suite, "properties")
    case = SubElement(suite, "testcase", name="runs to its end", classname=_SESSION, time="0.000")
    what = "stopped by Ctrl-C: scenarios behind these were not run"
    SubElement(case, "error", type="interrupted", message=what)
    suite.attrib |= _counts(suite)
    return suite


def _counts(element: Element) -> dict[str, str]:
    return {
        "tests": str(len(list(element.iter("testcase")))),
        "failures": str(len(list(element.iter("failure")))),
        "errors": str(len(list(element.iter("error")))),
        "skipped": str(len(list(element.iter("skipped")))),
    }


def _package(file: str) -> str:
    """The file as readers show classes: folders and name with dots."""
    parts = [part for part in PurePosixPath(file).parts if part not in {"/", ".", ".."}]
    return _clean(".".join(parts).removesuffix(_SUFFIX)) or _SESSION


def _seconds(time_ns: int) -> str:
    return f"{time_ns / NS_PER_S:.3f}"


def _clean(text: str) -> str:
    return _NO_XML.sub("\N{REPLACEMENT CHARACTER}", text)
