"""JUnit XML: after the schema, as an independent reader understands it, and what stands in it."""

from dataclasses import replace
from pathlib import Path
from xml.etree.ElementTree import Element, SubElement, fromstring

from junitparser import Error, Failure, JUnitXml

from fbgen.diagnostics import render
from harness.report.junit import junit_xml
from harness.results import ScenarioReport
from tests.unit.report.junit_schema import against_the_schema
from tests.unit.report.results import EXPECTED, FAILED, FOUND, PASSED, SESSION, WARNED


def test_the_file_is_as_the_schema_demands() -> None:
    assert against_the_schema(fromstring(junit_xml(SESSION))) == []
    assert against_the_schema(fromstring(junit_xml(ScenarioReport()))) == []


def test_the_check_against_the_schema_finds_what_is_wrong() -> None:
    root = Element("testsuites", time="1 s")
    SubElement(SubElement(root, "testsuite", name="a", tests="0", time="1"), "property", line="1")
    assert against_the_schema(root) == [
        "testsuites has the time 1 s",
        "testsuite lacks errors",
        "testsuite lacks failures",
        "testsuite holds property",
        "property lacks name",
        "property lacks value",
        "property has line",
    ]


def test_an_independent_reader_finds_cases_and_results(tmp_path: Path) -> None:
    path = tmp_path / "results.xml"
    path.write_text(junit_xml(SESSION), "utf-8", newline="\n")
    read = JUnitXml.fromfile(str(path))
    assert (read.tests, read.failures, read.errors, read.time) == (3, 1, 1, 2.9)
    cases = [case for suite in read for case in suite]
    assert [(case.classname, case.name) for case in cases] == [
        ("tests.stop", "A drive <stops> & waits"),
        ("tests.start", "A drive starts [step7]"),
        ("tests.broken", "broken.scenario.yaml"),
    ]
    assert [[type(item) for item in case.result] for case in cases] == [[], [Failure], [Error]]


def test_a_failure_has_the_text_of_the_terminal_with_its_places() -> None:
    failure = fromstring(junit_xml(ScenarioReport((FAILED,)))).find(".//failure")
    assert failure is not None
    assert failure.text is not None
    assert failure.attrib == {"type": "FB8001", "message": f"{FOUND} (and 1 more)"}
    for found in FAILED.failures:
        assert render(found) in failure.text
    assert "--> tests/start.scenario.yaml:2:14" in failure.text
    assert "--> TOS_Drive.scl:2:5" in failure.text
    assert f"run it again: {FAILED.replay}" in failure.text


def test_properties_say_how_it_ran_and_how_to_run_it_again() -> None:
    suite = fromstring(junit_xml(ScenarioReport((FAILED,)))).find("testsuite")
    assert suite is not None
    assert suite.get("file") == "tests/start.scenario.yaml"
    properties = {item.get("name"): item.get("value") for item in suite.iter("property")}
    assert properties == {
        "seed": "7",
        "plant": "tests/plant.yaml",
        "dialect": "step7",
        "variation": "step7",
        "virtual_time_ns": "400000000",
        "checks": "1",
        "replay": "fbgen test tests/start.scenario.yaml --seed 7 -k '\"[step7]\"'",
        "place": "tests/start.scenario.yaml:2:14",
    }


def test_a_failure_that_was_expected_is_skipped_and_says_why() -> None:
    root = fromstring(junit_xml(ScenarioReport((EXPECTED, PASSED))))
    assert against_the_schema(root) == []
    assert (root.get("failures"), [item.get("skipped") for item in root]) == ("0", ["1", "0"])
    skipped = root.find(".//skipped")
    assert skipped is not None
    assert skipped.get("message") == "the line is not repaired yet"
    assert FOUND in (skipped.text or "")


def test_warnings_are_output() -> None:
    root = fromstring(junit_xml(ScenarioReport((WARNED,))))
    assert against_the_schema(root) == []
    assert "warning[FB8021]: nothing was decided" in (root.findtext(".//system-out") or "")


def test_a_session_that_ctrl_c_ended_does_not_look_whole() -> None:
    root = fromstring(junit_xml(ScenarioReport((PASSED,), interrupted=True)))
    assert against_the_schema(root) == []
    assert (root.get("tests"), root.get("errors")) == ("2", "1")
    error = root.find(".//error")
    assert error is not None
    assert error.get("message", "").startswith("stopped by Ctrl-C")


def test_long_times_are_plain_seconds() -> None:
    long = replace(PASSED, virtual_ns=86_400 * 10**9)
    assert fromstring(junit_xml(ScenarioReport((long,)))).get("time") == "86400.000"
