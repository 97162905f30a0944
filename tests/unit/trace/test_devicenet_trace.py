"""A recorded DeviceNet plant: all CAN frames in words, the scanner's table, the option's state."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.source import Source
from fbgen.wire.devicenet import Frame as CanFrame
from fbgen.wire.devicenet import Service
from fbgen.wire.devicenet_messages import Request
from harness.engine.compiled import writers_probe
from harness.faults import FAULTS
from harness.faults.settings import fault_settings
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.scenario.paths import Paths
from harness.trace import Trace, read_traces, trace_text
from harness.trace.model import Frame, TraceValue
from harness.trace.vcd import vcd_text

EXAMPLE = Path(__file__).parents[3] / "examples" / "devicenet"
CATALOG = load_catalog()


def built(assemblies: str = "") -> Installation:
    """The example, off; with other assemblies for its first drive if some are named."""
    plan = load_plant(EXAMPLE / "plant.yaml", CATALOG)
    if assemblies:
        network = plan.devicenet[0]
        first = network.drives[0].model_copy(
            update={"assemblies": assemblies, "input_address": 400, "output_address": 400}
        )
        network = network.model_copy(update={"drives": (first, *network.drives[1:])})
        plan = plan.model_copy(update={"devicenet": (network,)})
    setup = PlantSetup(sources=[EXAMPLE / "conveyors.scl"], probes=[writers_probe])
    return build_plant(plan, CATALOG, setup)


def happens(plant: Installation, name: str, on: str) -> None:
    kind = FAULTS[name]
    kind.make(plant, on, fault_settings(kind, {}, {})).inject()


def ask(plant: Installation, mac: int, *requests: Request) -> None:
    for request in requests:
        plant.networks["net1"].scanner.request(mac, request, lambda _: None)
    plant.run_for(200 * NS_PER_MS)


@pytest.fixture(scope="module")
def run() -> tuple[Installation, Trace]:
    """Started, run for a second at 20 Hz, asked, then the cable of the scanner is cut."""
    plant = built()
    recorder = plant.record()
    plant.start()
    plant.run_for(3 * NS_PER_S)
    plant.cpu.engine.set_global("Conveyors.hz", 20.0)
    plant.cpu.engine.set_global("Conveyors.run", True)
    plant.run_for(1 * NS_PER_S)
    ask(
        plant,
        5,
        Request(Service.GET_ATTRIBUTE_SINGLE, 0x64, 0x4003, b"\x03"),
        Request(Service.SET_ATTRIBUTE_SINGLE, 0x64, 0x4003, bytes.fromhex("03 02 00")),
        Request(Service.GET_ATTRIBUTE_SINGLE, 0x29, 1, b"\x06"),
        Request(Service.GET_ATTRIBUTE_SINGLE, 0x29, 1, b"\x63"),
        Request(Service.RESET, 0x2A, 1),
        Request(Service.GET_ATTRIBUTE_SINGLE, 1, 1, b"\x07"),
    )
    happens(plant, "devicenet_interrupted", "net1")
    plant.run_for(2 * NS_PER_S)
    return plant, recorder.finish()


def of_kind(trace: Trace, kind: str) -> list[Frame]:
    return [frame for frame in trace.frames if frame.kind == kind]


def values(trace: Trace, path: str) -> list[TraceValue]:
    return [change.value for change in trace.changes_of(path)]


def test_io_data_are_told_field_by_field(run: tuple[Installation, Trace]) -> None:
    outputs, inputs = of_kind(run[1], "output"), of_kind(run[1], "input")
    assert {(frame.sender, frame.to_drives) for frame in outputs} == {("net1", True)}
    assert {frame.sender for frame in inputs} == {"infeed", "outfeed", "sorter"}
    said = {frame.meaning for frame in run[1].frames}
    assert (
        "infeed: command = C400 (network_command, network_frequency, run), frequency = 20.00 Hz"
        in said
    )
    assert (
        "outfeed: control = 0061 (net_reference, net_control, run_forward), speed = 600 min-1"
        in said
    )
    assert any(text.startswith("outfeed, by itself: status = 0474 (Enabled, ") for text in said)
    assert "outfeed: its data have come" in said
    polled = next(frame for frame in outputs if "C400" in frame.meaning)
    assert (polled.identifier, polled.data.hex()) == (0x42D, "00c4d007")
    assert polled.end_ns - polled.start_ns == (47 + 32) * 2000


def test_explicit_messages_are_told_by_name(run: tuple[Installation, Trace]) -> None:
    said = [
        frame.meaning for kind in ("request", "reply", "refusal") for frame in of_kind(run[1], kind)
    ]
    for text in (
        "infeed: allocate explicit, polled for the master 0",
        "outfeed: done, allocate explicit, polled, change of state for the master 0",
        "infeed: write connection 2 expected_packet_rate = 100",
        "infeed: read 0003 Command mode selection",
        "infeed refuses to write 0003 Command mode selection = 0002 (2): device state conflict",
        "infeed: read control_supervisor state",
        "infeed: control_supervisor state is 4 (Enabled)",
        "infeed refuses to read control_supervisor attribute 99: attribute not supported",
        "infeed refuses to reset ac_dc_drive: service not supported",
    ):
        assert text in said, said


def test_a_long_response_comes_in_fragments_and_the_last_says_all(
    run: tuple[Installation, Trace],
) -> None:
    fragments = of_kind(run[1], "fragment")
    assert fragments
    assert fragments[0].meaning == "infeed: fragment 0"
    name = b"DEV003Z".hex(" ").upper()
    (whole,) = [f for f in of_kind(run[1], "reply") if "identity product_name" in f.meaning]
    assert whole.meaning.endswith(f"07 {name}")
    assert any("fragment 0 has come" in frame.meaning for frame in of_kind(run[1], "acknowledge"))


def test_macs_are_checked(run: tuple[Installation, Trace]) -> None:
    checks = of_kind(run[1], "check")
    assert [frame.sender for frame in checks] == ["net1", "infeed", "outfeed", "sorter"] * 2
    assert checks[1].meaning.startswith("MAC ID 5: does somebody have it? (vendor 0179")


def test_the_loss_is_seen_at_both_ends(run: tuple[Installation, Trace]) -> None:
    trace = run[1]
    assert values(trace, "devicenet.net1.mode") == ["OFF", "IDLE", "RUN"]
    assert values(trace, "devicenet.infeed.network") == ["self_test", "checking", "online"]
    table = values(trace, "devicenet.infeed.scanner")
    assert table[:5] == ["waiting", "connecting", "lost", "connecting", "running"]
    assert table[5] == "lost"
    assert values(trace, "devicenet.infeed.exchanging") == [False, True, False]
    assert values(trace, "devicenet.infeed.connection.polled") == [
        *("non_existent", "configuring", "established", "timed_out")
    ]
    assert values(trace, "devicenet.outfeed.led.network_status")[-1] == "red_flashing"
    assert values(trace, "devicenet.outfeed.state")[:4] == [
        "startup",
        "ready",
        "enabled",
        "stopping",
    ]
    lost, timed_out = (
        trace.changes_of(f"devicenet.infeed.{item}")[-1].time_ns
        for item in ("exchanging", "connection.polled")
    )
    assert timed_out - lost == pytest.approx(400 * NS_PER_MS - 30 * NS_PER_MS, abs=15 * NS_PER_MS)


def test_fields_name_the_statement_that_wrote_them(run: tuple[Installation, Trace]) -> None:
    trace = run[1]
    told = trace.changes_of("devicenet.infeed.output.command")
    assert [change.value for change in told] == [0, 0xC000, 0xC400]
    place = trace.writer_of(told[-1])
    assert place is not None
    assert place.text.startswith("%QW310 := ")
    assert "run" in trace.word("dev003z.command").describe(0xC400)


def test_every_channel_has_the_value_that_a_scenario_reads(run: tuple[Installation, Trace]) -> None:
    plant, trace = run
    paths = Paths(plant, CATALOG)
    channels = [channel for channel in trace.channels if channel.group == "devicenet"]
    assert len(channels) > 30
    for channel in channels:
        read = paths.readable(channel.path, None).get()
        assert read == trace.changes_of(channel.path)[-1].value, channel.path


def test_files_carry_it_whole(run: tuple[Installation, Trace]) -> None:
    text = trace_text([run[1]])
    assert '"identifier":1069,"data":"00 C4 D0 07"' in text
    [again] = read_traces(Source("run.jsonl", text))
    assert again == run[1]
    assert r"sinfeed:\x20command\x20=\x20C400" in vcd_text(run[1])


def test_data_of_more_than_eight_bytes_are_put_together() -> None:
    plant = built("105/155")
    recorder = plant.record()
    plant.start()
    plant.run_for(3 * NS_PER_S)
    trace = recorder.finish()
    told = [frame for frame in trace.frames if frame.sender == "infeed" and frame.kind == "input"]
    assert told
    assert told[0].meaning.startswith("infeed: function = 0000 (no bit set), index = 0000, data = ")
    assert "monitor_6 = 0000" in told[0].meaning
    before = [frame for frame in trace.frames if frame.kind == "fragment"]
    assert {frame.meaning for frame in before} == {"infeed: fragment 0", "infeed: fragment 1"}


def strange(mac: int) -> Iterator[tuple[CanFrame, str, str]]:
    yield CanFrame(0x3FF, b""), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 7, b"\x00"), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 4, b""), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 4, b"\x80"), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 4, b"\x00\x8e"), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 3, b"\x00\x0e"), "unknown", ""
    yield CanFrame(0x400 + 8 * mac + 5, b"\x01"), "output", "which are 1 bytes instead of 4"
    yield CanFrame(0x400 + 8 * mac + 5, b""), "output", "no data"
    yield CanFrame(0x400 + 8 * mac + 3, b"\x00\x8e\x07"), "reply", "infeed: 07"
    yield (
        CanFrame(0x400 + 8 * mac + 3, b"\x00\x94\x0c\x05"),
        "refusal",
        "object state conflict, code",
    )


def test_frames_of_nobody_and_frames_of_no_sense_are_noted() -> None:
    plant = built()
    recorder = plant.record()
    stranger = plant.networks["net1"].bus.attach(lambda _: None)
    expected = list(strange(5))
    for frame, _, _ in expected:
        stranger.send(frame)
        plant.kernel.run_for(NS_PER_MS)
    found = [frame for frame in recorder.finish().frames if frame.sender is None]
    assert [(frame.identifier, frame.kind) for frame in found] == [
        (frame.identifier, kind) for frame, kind, _ in expected
    ]
    for seen, (_, _, text) in zip(found, expected, strict=True):
        assert text in seen.meaning if text else seen.meaning == ""
