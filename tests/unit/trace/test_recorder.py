"""What a recorded plant has left: channels, frames, telegrams, and that nobody was disturbed."""

from itertools import pairwise

import pytest

from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import Restart
from harness.trace import Recorder, Trace, trace_text
from harness.trace.model import TraceValue
from tests.unit.trace.recorded import START, one_drive, started, traced


@pytest.fixture(scope="module")
def trace() -> Trace:
    """The drive is started, recorded once."""
    return traced()


def values(trace: Trace, path: str) -> list[TraceValue]:
    return [change.value for change in trace.changes_of(path)]


def test_the_modes_are_recorded_from_power_on(trace: Trace) -> None:
    assert values(trace, "cpu.mode") == ["STOP", "STARTUP", "RUN"]
    assert values(trace, "bus.mode") == ["STOP", "CLEAR", "OPERATE"]
    assert values(trace, "gateway.gw1.powered") == [False, True]
    assert values(trace, "gateway.gw1.led.fieldbus_online") == ["off", "green"]


def test_each_scan_is_there(trace: Trace) -> None:
    scans = trace.changes_of("cpu.scans")
    assert values(trace, "cpu.scans") == list(range(len(scans)))
    assert {round((b.time_ns - a.time_ns) / NS_PER_MS) for a, b in pairwise(scans[1:])} == {10}


def test_variables_of_the_plant_change_with_the_scan_that_wrote_them(trace: Trace) -> None:
    assert values(trace, f"plc.{START}.execute") == [False, True]
    assert values(trace, f"plc.{START}.busy") == [False, True, False]
    assert values(trace, f"plc.{START}.done") == [False, True]
    assert values(trace, f"plc.{START}.stepNumber")[:3] == [0, 1, 2]
    assert trace.changes_of(f"plc.{START}.execute")[1].time_ns == 100 * NS_PER_MS


def test_fields_of_the_cyclic_data_are_taken_apart(trace: Trace) -> None:
    outputs = trace.changes_of("gateway.gw1.outputs")
    by_time = {change.time_ns: change.value for change in trace.changes_of("gateway.gw1.trigger")}
    for change in outputs:
        assert isinstance(change.value, bytes)
        if change.time_ns in by_time:
            assert change.value[2] == by_time[change.time_ns]
    status = trace.word("tospbdp001.status")
    last = trace.changes_of("gateway.gw1.status")[-1].value
    assert isinstance(last, int)
    assert "status_code" in status.describe(last)
    assert values(trace, "gateway.gw1.status_code")[-1] == last >> 8 & 0x1F


def test_the_drive_is_told_and_follows(trace: Trace) -> None:
    assert values(trace, "drive.pump.running") == [False, True]
    assert values(trace, "drive.pump.set_point") == [0.0, 40.0]
    told = values(trace, "drive.pump.word.FA00")[-1]
    assert isinstance(told, int)
    fields = trace.word("vf-s11.command").decode(told)
    names = [field.name for field, value in fields if value]
    assert names == ["network_command", "network_frequency", "run"]


def test_frames_have_sender_kind_and_meaning(trace: Trace) -> None:
    requests = [frame for frame in trace.frames if frame.kind == "request"]
    replies = [frame for frame in trace.frames if frame.kind == "reply"]
    assert {frame.sender for frame in requests} == {"gw1"}
    assert {frame.sender for frame in replies} == {"pump"}
    assert all(frame.to_drives for frame in requests)
    assert any("write FA00 Command word = C400 (network_command" in f.meaning for f in requests)
    assert any("FA01 Frequency set-point is 0FA0 (40.00 Hz)" in f.meaning for f in replies)
    assert not any(frame.collided or frame.damaged or frame.heard for frame in trace.frames)


def test_telegrams_are_there_with_their_replies(trace: Trace) -> None:
    sent = [telegram for telegram in trace.telegrams if "write FA00" in telegram.meaning]
    assert sent
    assert all(one.received_ns is not None and one.received_ns > one.sent_ns for one in sent)


def test_a_heartbeat_is_told_from_a_telegram() -> None:
    def waits(plant: Installation, recorder: Recorder) -> None:
        plant.start()
        plant.run_for(2 * NS_PER_S)

    kinds = [frame.kind for frame in traced(waits).frames]
    assert "heartbeat" in kinds
    assert "unknown" not in kinds


def ramps(plant: Installation, recorder: Recorder) -> None:
    plant.drives["pump"].set_parameter("acceleration_time", 1.0)
    started(plant, recorder)
    plant.run_for(2 * NS_PER_S)


def test_a_ramp_is_a_straight_line_between_the_changes() -> None:
    changes = [
        change for change in traced(ramps).changes_of("drive.pump.frequency") if change.value
    ]
    drive_hz_per_s = 50.0
    for a, b in pairwise(changes):
        assert isinstance(a.value, float)
        assert isinstance(b.value, float)
        rise = drive_hz_per_s * (b.time_ns - a.time_ns) / NS_PER_S
        assert b.value - a.value == pytest.approx(rise, abs=0.0015)
    assert changes[-1].value == 40.0
    assert 75 <= len(changes) <= 85


def test_the_ramp_goes_on_while_the_cpu_is_in_stop() -> None:
    def stopped(plant: Installation, recorder: Recorder) -> None:
        plant.drives["pump"].set_parameter("acceleration_time", 1.0)
        started(plant, recorder)
        plant.cpu.stop()
        plant.run_for(2 * NS_PER_S)

    trace = traced(stopped)
    assert values(trace, "cpu.mode")[-1] == "STOP"
    assert values(trace, "bus.mode")[-1] == "CLEAR"
    assert values(trace, "drive.pump.frequency")[-1] == 40.0


def test_noise_and_collisions_are_seen() -> None:
    def disturbed(plant: Installation, recorder: Recorder) -> None:
        line = plant.lines["gw1"]
        line.slave_pair.interference.bit_errors.probability = 0.05
        plant.start()
        plant.run_for(100 * NS_PER_MS)
        drive = plant.drives["pump"].communication.port
        line.slave_pair.inject(b"\x55" * 20, drive.format)
        drive.transmit(b"\x00" * 8)
        plant.run_for(500 * NS_PER_MS)

    frames = traced(disturbed).frames
    assert any(frame.damaged for frame in frames)
    assert any(frame.heard is not None for frame in frames)
    assert [frame.sender for frame in frames if frame.collided] == ["pump", None]
    outside = next(frame for frame in frames if frame.sender is None)
    assert (outside.kind, outside.to_drives, outside.meaning) == ("unknown", False, "")


def test_a_loss_of_supply_is_seen_at_once() -> None:
    begin_ns: list[int] = []

    def lost(plant: Installation, recorder: Recorder) -> None:
        started(plant, recorder)
        begin_ns.append(plant.kernel.now_ns)
        plant.gateways["gw1"].power_off()
        plant.run_for(1)
        plant.drives["pump"].power_off()
        plant.run_for(1)
        plant.cpu.start(Restart.COLD)
        plant.run_for(1)

    trace = traced(lost)
    assert trace.changes_of("gateway.gw1.powered")[-1].time_ns == begin_ns[0]
    assert values(trace, "gateway.gw1.led.fieldbus_online")[-1] == "off"
    assert trace.changes_of("drive.pump.powered")[-1].time_ns == begin_ns[0] + 1
    assert values(trace, "drive.pump.frequency")[-1] == 0.0
    assert trace.changes_of("cpu.mode")[-1].time_ns == begin_ns[0] + 2
    assert values(trace, "cpu.scans")[-2:] == [0, 1]


def test_more_variables_are_recorded_where_they_are_asked_for() -> None:
    plant = one_drive()
    paths = ["TOS_Parameters", "TOS_Plant.gw1.pump.polled.tripCodeAge"]
    trace = plant.record(paths).finish()
    assert values(trace, "plc.TOS_Parameters.gw1.line.retries") == [2]
    age = trace.channels[trace.channel("plc.TOS_Plant.gw1.pump.polled.tripCodeAge")]
    assert (age.kind, age.unit) == ("integer", "ms")
    assert not any(channel.path.endswith("currentAge") for channel in trace.channels)


def test_recording_changes_nothing_of_the_run() -> None:
    def state(record: bool) -> tuple[object, ...]:
        plant = one_drive(seed=3)
        telegrams = plant.record_telegrams()["gw1"].records
        recorder = plant.record() if record else None
        plant.drives["pump"].set_parameter("acceleration_time", 1.0)
        plant.start()
        plant.run_for(100 * NS_PER_MS)
        plant.cpu.engine.set_global(f"{START}.execute", True)
        plant.run_for(NS_PER_S)
        assert recorder is None or recorder.finish().changes
        return plant.cpu.engine.snapshot(), plant.kernel.random.getstate(), telegrams

    assert state(record=True) == state(record=False)


def test_both_engines_leave_the_same_trace() -> None:
    compiled = trace_text([traced(ramps)]).splitlines()
    reference = trace_text([traced(ramps, engine="reference")]).splitlines()
    assert compiled[0].replace("compiled", "reference") == reference[0]
    assert compiled[1:] == reference[1:]


def test_marks_have_their_times() -> None:
    def marked(plant: Installation, recorder: Recorder) -> None:
        plant.start()
        step = recorder.marks.begin("step", "wait: 5 ms", None)
        recorder.marks.begin("fault", "line_noise", None, "gw1")
        plant.run_for(5 * NS_PER_MS)
        recorder.marks.end(step, "passed")

    step, fault = traced(marked).marks
    assert (step.start_ns, step.end_ns, step.verdict) == (0, 5 * NS_PER_MS, "passed")
    assert (fault.title, fault.target, fault.end_ns) == ("line_noise", "gw1", None)
