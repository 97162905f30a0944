"""A recorded plant with inverters at a communication module: all frames, and the module."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from harness.faults import FAULTS
from harness.faults.settings import fault_settings
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_S
from harness.scenario.paths import Paths
from harness.trace import Trace

EXAMPLES = Path(__file__).parents[3] / "examples"
CATALOG = load_catalog()


def recorded(example: str, series: str = "vf-s11", **changes: object) -> tuple[Installation, Trace]:
    """Three seconds, in the last of which the pump has no supply. `changes` are of the line."""
    plan = load_plant(EXAMPLES / example / "plant.yaml", CATALOG)
    line = plan.serial[0]
    drives = tuple(item.model_copy(update={"series": series}) for item in line.drives)
    line = line.model_copy(update={"drives": drives, **changes})
    plant = build_plant(plan.model_copy(update={"serial": (line,)}), CATALOG, PlantSetup())
    recorder = plant.record()
    plant.start()
    plant.cpu.engine.set_global("TOS_Plant.line1.fan.control.enable", True)
    plant.run_for(2 * NS_PER_S)
    kind = FAULTS["drive_unpowered"]
    kind.make(plant, "pump", fault_settings(kind, {}, {})).inject()
    plant.run_for(1 * NS_PER_S)
    return plant, recorder.finish()


@pytest.mark.parametrize(
    ("example", "changes"),
    [
        ("serial", {}),
        ("serial", {"protocol": "toshiba_ascii"}),
        ("serial", {"wires": 2, "series": "vf-s15"}),
        ("modbus", {}),
        ("modbus", {"wires": 2, "series": "vf-s15"}),
    ],
    ids=["binary", "ascii", "two wires", "modbus", "modbus on two wires"],
)
def test_frames_say_who_sent_them_and_what(example: str, changes: dict[str, str]) -> None:
    plant, trace = recorded(example, **changes)
    sent = plant.devices.modules["line1"]
    requests = [frame for frame in trace.frames if frame.to_drives]
    replies = [frame for frame in trace.frames if not frame.to_drives]
    assert {(frame.line, frame.sender, frame.kind) for frame in requests} == {
        ("line1", "line1", "request")
    }
    assert {frame.sender for frame in replies} == {"pump", "fan"}
    assert {frame.kind for frame in replies} == {"reply"}
    assert any("drive 2: read FD01" in frame.meaning for frame in requests)
    assert any("drive 2: FD01" in f.meaning and "standby" in f.meaning for f in replies)
    late = [frame for frame in trace.frames if frame.start_ns > 2.2 * NS_PER_S]
    assert any("drive 1: read " in frame.meaning for frame in late)
    assert "pump" not in {frame.sender for frame in late}
    assert sent.lost_messages == trace.changes_of("line.line1.lost_messages")[-1].value


def test_the_module_is_recorded_by_the_paths_of_scenarios() -> None:
    plant, trace = recorded("serial")
    plant.devices.modules["line1"].failed = True
    channels = [channel for channel in trace.channels if channel.group == "line"]
    assert [channel.path for channel in channels] == [
        "line.line1.available",
        "line.line1.lost_messages",
    ]
    paths = Paths(plant, CATALOG)
    assert paths.readable("line.line1.available", None).get() is False
    assert paths.readable("line.line1.lost_messages", None).get() == 0
    assert [change.value for change in trace.changes_of("line.line1.available")] == [True]
