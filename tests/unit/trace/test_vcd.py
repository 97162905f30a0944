"""VCD files, read back by a reader that shares no code with the writer."""

from typing import Any

import pytest
from vcdvcd import VCDVCD

from fbgen.diagnostics import DiagnosticError
from harness.trace import Change, Channel, Frame, Mark, Trace
from harness.trace.vcd import vcd_text
from tests.unit.trace.recorded import START, traced


def signals(text: str) -> Any:
    return VCDVCD(vcd_string=text)


def changes(read: Any, path: str) -> list[tuple[int, str]]:
    found: list[tuple[int, str]] = read[path].tv
    return found


def bits(value: str) -> int:
    return int(value, 2)


def test_every_channel_is_a_signal_with_all_its_changes() -> None:
    trace = traced()
    read = signals(vcd_text(trace))
    for channel in trace.channels:
        if channel.kind == "text":
            continue
        expected = {change.time_ns: change.value for change in trace.changes_of(channel.path)}
        found = dict(changes(read, channel.path))
        assert list(found) == list(expected), channel.path
        for text, value in zip(found.values(), expected.values(), strict=True):
            if isinstance(value, float):
                assert float(text) == value
            elif isinstance(value, bytes):
                assert bits(text) == int.from_bytes(value, "big")
            else:
                assert isinstance(value, int)
                assert bits(text) == value


def test_one_step_is_a_nanosecond_and_the_end_is_the_end() -> None:
    trace = traced()
    read = signals(vcd_text(trace))
    assert (read.timescale["magnitude"], read.timescale["unit"]) == (1, "ns")
    assert read.endtime == trace.end_ns


def test_a_word_is_as_wide_as_it_is() -> None:
    text = vcd_text(traced())
    assert "$var wire 16" in text
    assert signals(text)[f"plc.{START}.status"].size == "16"
    assert signals(text)["plc.TOS_Plant.inputsHash"].size == "32"


def test_a_line_shows_who_sends_and_what() -> None:
    trace = traced()
    text = vcd_text(trace)
    sent = changes(signals(text), "line.gw1.to_drives")
    requests = [frame for frame in trace.frames if frame.to_drives]
    assert [time for time, value in sent if value == "1"] == [one.start_ns for one in requests]
    assert "sdrive\\x2011:\\x20read\\x20FC90" in text


def small(*changes: Change, channels: tuple[Channel, ...], marks: tuple[Mark, ...] = ()) -> Trace:
    frames = (Frame(3, 5, "gw 1", None, False, "unknown", b"\x01\xff"),)
    return Trace(
        *("Umlaut \u00e4", "", 0, "compiled", "tia", False, 2, 9),
        channels=channels,
        changes=changes,
        frames=frames,
        marks=marks,
    )


def test_faults_and_steps_are_signals() -> None:
    marks = (
        Mark(2, "step", "wait", 4),
        Mark(4, "fault", "line_noise", 6, "gw1"),
        Mark(7, "fault", "line_noise", None, "gw1"),
        Mark(5, "fault", "cpu_stopped", 8),
    )
    text = vcd_text(small(channels=(), marks=marks))
    read = signals(text)
    noise = changes(read, "scenario.fault.line_noise_gw1")
    assert noise[1:] == [(4, "1"), (6, "0"), (7, "1")]
    assert changes(read, "scenario.fault.cpu_stopped")[-1] == (8, "0")
    assert "swait" in text


def test_names_that_no_viewer_can_read_are_mended() -> None:
    channels = (
        Channel('plc."my block".a b', "", "text", "plc"),
        Channel("plc.my_block.a_b", "", "integer", "plc"),
    )
    text = vcd_text(small(Change(2, 0, ""), Change(2, 1, -5), channels=channels))
    read = signals(text)
    assert {"plc.my_block.a_b", "plc.my_block.a_b_", "line.gw_1.frame"} < set(read.signals)
    assert changes(read, "plc.my_block.a_b_") == [(2, f"{(1 << 64) - 5:b}")]
    assert "s- " in text
    assert text.isascii()


def test_without_the_package_there_is_a_hint(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("harness.trace.vcd.find_spec", lambda name: None)
    with pytest.raises(DiagnosticError, match="FB8041") as missing:
        vcd_text(small(channels=()))
    assert missing.value.diagnostics[0].help == "pip install 'fbgen[reports]'"
