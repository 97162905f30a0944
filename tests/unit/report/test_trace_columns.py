"""Traces as columns: nothing is lost, and nothing is larger than it must be."""

import json

from harness.report.trace_columns import trace_columns
from harness.trace import Trace
from tests.unit.report.traces import MS, long_trace, short_trace


def columns(trace: Trace) -> dict[str, list[dict[str, list[object]]]]:
    """As the page gets it."""
    data: dict[str, list[dict[str, list[object]]]] = json.loads(json.dumps(trace_columns(trace)))
    return data


def test_times_are_differences_and_values_stand_beside_them() -> None:
    running = columns(short_trace())["channels"][4]
    assert running["is"][:2] == ["drive.pump.running", "the output turns the motor"]
    assert (running["t"], running["v"]) == ([0, 50 * MS, 30 * MS], [0, 1, 0])


def test_texts_and_numbers_that_json_does_not_have_are_numbers_of_texts() -> None:
    data = columns(short_trace())
    texts = data["texts"]
    mode, frequency, huge = (data["channels"][number]["s"] for number in (0, 3, 6))
    assert [texts[int(str(number))] for number in mode] == ["STOP", "RUN"]
    assert [texts[int(str(number))] for number in frequency] == ["0.0", "12.5", "NaN", "40.0"]
    assert [texts[int(str(number))] for number in huge] == [str(2**63 + 1)]


def test_writers_are_there_only_where_somebody_is_known() -> None:
    channels = columns(short_trace())["channels"]
    assert [channel.get("w") for channel in channels[:3]] == [None, [-1, 1], [-1, 1]]


def test_a_hundred_thousand_events_fit_into_two_megabytes() -> None:
    text = json.dumps(trace_columns(long_trace(100_000)), separators=(",", ":"))
    assert len(text) < 2_000_000
