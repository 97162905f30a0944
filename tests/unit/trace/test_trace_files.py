"""Trace files: written, read back, and refused where they are wrong."""

import json
from collections.abc import Callable
from math import inf, isnan, nan
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness.trace import (
    Change,
    Channel,
    Frame,
    Mark,
    Place,
    Telegram,
    Trace,
    TraceWord,
    WordField,
    read_traces,
    trace_text,
)
from harness.trace.model import ChannelKind, TraceValue
from tests.unit.trace.recorded import traced

BAD = Path(__file__).parents[1] / "bad"
HEAD = trace_text([Trace("t", "", 0, "compiled", "tia", False, 0, 0)])
CHANNEL = '{"type":"channel","id":0,"path":"p","title":"","kind":"bool","group":"plc"}\n'


def everything() -> Trace:
    """A trace with each thing that there can be."""
    word = TraceWord(
        "a.b", "B", (WordField("mode", "M", 1, 2, {2: "two"}), WordField("on", "", 0, 0))
    )
    kinds: tuple[tuple[ChannelKind, TraceValue, TraceValue], ...] = (
        ("bool", False, True),
        ("word", 0, 0xFFFF),
        ("integer", -1, 1 << 40),
        ("real", 0.1, inf),
        ("text", "", 'Umlaut "\u00e4"'),
        ("bytes", b"", b"\x00\xff"),
    )
    return Trace(
        *("Everything", "every.scenario.yaml", 7, "compiled", "iec", True, 5, 900),
        words=(word,),
        places=(Place("p.scl", 3, 7, "#a := b;", "FB_A", "DB_A.inst"), Place("s.yaml", 1, 1, "")),
        channels=tuple(
            Channel(f"plc.{kind}", kind, kind, "plc", "DB", "Hz", 16, "a.b") for kind, _, _ in kinds
        ),
        changes=(
            *(Change(5, number, first) for number, (_, first, _) in enumerate(kinds)),
            *(Change(50, number, second, 0) for number, (_, _, second) in enumerate(kinds)),
        ),
        frames=(
            Frame(10, 20, "gw1", "gw1", True, "request", b"/\x0b", None, meaning="read"),
            Frame(12, 22, "gw1", None, False, "unknown", b"/", b"", damaged=True, collided=True),
        ),
        telegrams=(
            Telegram(9, "gw1", b"\x01", 30, b"\x02", "read", 0),
            Telegram(40, "gw1", b"\x03"),
        ),
        marks=(
            Mark(5, "step", "set a", 5, "", 1, "passed"),
            Mark(6, "fault", "noise", None, "gw1", 1),
            Mark(6, "check", "a is 1", 40, "plc.a", None, "failed"),
        ),
    )


def read(text: str) -> list[Trace]:
    return list(read_traces(Source("run.jsonl", text)))


def test_what_was_written_is_read_back() -> None:
    trace = everything()
    assert read(trace_text([trace])) == [trace]


def test_a_file_holds_several_runs() -> None:
    first, second = everything(), traced()
    assert read(trace_text([first, second])) == [first, second]


def test_not_a_number_is_written_and_read() -> None:
    channel = Channel("plc.x", "x", "real", "plc")
    trace = Trace(
        "t", "", 0, "c", "tia", False, 0, 0, channels=(channel,), changes=(Change(0, 0, nan),)
    )
    text = trace_text([trace])
    assert '"v":"NaN"' in text
    value = read(text)[0].changes[0].value
    assert isinstance(value, float)
    assert isnan(value)


def test_each_line_is_plain_json_in_the_order_of_its_time() -> None:
    lines = [json.loads(line) for line in trace_text([traced()]).splitlines()]
    assert [line["type"] for line in lines[:2]] == ["trace", "word"]
    times = [line["t"] for line in lines if "t" in line]
    assert times == sorted(times)
    assert trace_text([traced()]).isascii()


def test_the_example_is_as_it_was(golden: Callable[[str, str], None]) -> None:
    """But for the hash of what it was generated from, which other golden files hold."""
    trace = traced()
    (_, at_start), (_, given) = [
        (change.time_ns, change.value) for change in trace.changes_of("plc.TOS_Plant.inputsHash")
    ]
    assert at_start == 0
    text = trace_text([trace])
    assert text.count(f'"v":{given}}}') == 1
    golden("start_forward.trace.jsonl", text.replace(f'"v":{given}}}', '"v":1}'))


def test_the_page_shows_a_trace_that_can_be_read() -> None:
    page = (BAD.parents[2] / "docs" / "reference" / "trace.md").read_text(encoding="utf-8")
    example = page.split("```json\n")[1].split("```")[0]
    [trace] = read(example)
    assert [change.value for change in trace.changes_of("drive.PUMP.running")] == [False, True]


def test_an_unknown_channel_is_refused_at_its_line() -> None:
    path = BAD / "FB8040_unknown_channel.jsonl"
    with pytest.raises(DiagnosticError) as wrong:
        read(path.read_text(encoding="utf-8"))
    [found] = wrong.value.diagnostics
    assert found.code == "FB8040"
    assert found.span is not None
    assert (found.span.line, found.span.column) == (3, 1)
    assert "there is no channel 7" in found.message


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (CHANNEL, "stands before the first trace line"),
        (HEAD + "{", "invalid JSON"),
        (HEAD + '{"type":"chance"}\n', "tag"),
        (HEAD + '{"type":"channel","id":0}\n', "path: field required"),
        (HEAD + CHANNEL.replace('"id":0', '"id":1'), "channel 1 stands where channel 0 belongs"),
        (HEAD + CHANNEL + '{"type":"change","t":0,"c":0,"v":1}\n', "kind bool and never 1"),
        (HEAD + CHANNEL + '{"type":"change","t":0,"c":0,"v":true,"w":0}\n', "no place 0"),
        (HEAD + CHANNEL + '{"type":"change","t":-1,"c":0,"v":true}\n', "t: input should be"),
        (HEAD.replace('"version":1', '"version":2'), "version: input should be 1"),
        (HEAD + '{"type":"telegram","t":0,"gateway":"g","output":"0"}\n', "output: string should"),
    ],
)
def test_a_wrong_line_is_refused_with_what_is_wrong(text: str, message: str) -> None:
    with pytest.raises(DiagnosticError, match="FB8040") as wrong:
        read(text)
    assert message in wrong.value.diagnostics[0].message
