"""Each fault does to a plant what its name says, at its place only, and ends when it is cleared."""

from collections.abc import Mapping
from typing import Any

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant
from harness.drives import ReplyTime
from harness.faults import FAULTS, Target
from harness.faults.settings import fault_settings
from harness.fieldbus import MasterMode
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import CpuMode
from tests.unit.faults.fault_plant import all_is_well, fault, five_drives, snapshot, started


@pytest.fixture(scope="module")
def plan() -> Plant:
    return five_drives()


@pytest.fixture
def plant(plan: Plant) -> Installation:
    return started(plan)


STOPPED = {"cpu": CpuMode.STOP, "bus": MasterMode.CLEAR}
UNPOWERED = {"cpu": CpuMode.STOP, "bus": MasterMode.STOP}
MS = NS_PER_MS
CHANGES: dict[str, Mapping[str, Any]] = {
    "cpu_jitter": {"scans": (MS, 5 * MS)},
    "cpu_overrun": {"scans": (50 * MS, 0)},
    "cpu_retentive_lost": UNPOWERED,
    "cpu_stopped": STOPPED,
    "cpu_unpowered": UNPOWERED,
    "drive_alarm": {"drive3": {"alarm": 8}},
    "drive_answers_for_another": {"drive3": {"numbers": (3, 0)}},
    "drive_answers_late": {"drive3": {"reply": (ReplyTime(), 0.2, 100 * MS)}},
    "drive_disconnected": {"drive3": {"open": (True, True)}},
    "drive_eeprom_worn": {"drive3": {"worn": True}},
    "drive_emergency_stop": {"drive3": {"emergency": True}},
    "drive_local": {"drive3": {"local": True}},
    "drive_number_doubled": {"drive3": {"numbers": (0, None)}},
    "drive_parameters_locked": {"drive3": {"locked": True}},
    "drive_slow": {"drive3": {"reply": (ReplyTime(30 * MS, 30 * MS), 0.0, 0)}},
    "drive_unpowered": {"drive3": {"powered": False}},
    "gateway_buffer_overwritten": {"overwrites": 0.1},
    "gateway_diagnosis": {"diagnosis": True},
    "gateway_slow": {"processing": 20 * MS},
    "gateway_trigger_stuck": {"stuck": True},
    "gateway_unpowered": {"gateway": False},
    "line_broken": {"to_drives": {"broken": True}, "from_drives": {"broken": True}},
    "line_broken_one_way": {"from_drives": {"broken": True}},
    "line_bytes_delayed": {
        "to_drives": {"delays": 0.1, "delay": 10 * MS},
        "from_drives": {"delays": 0.1, "delay": 10 * MS},
    },
    "line_bytes_doubled": {"to_drives": {"doubled": 0.01}, "from_drives": {"doubled": 0.01}},
    "line_bytes_lost": {"to_drives": {"lost": 0.01}, "from_drives": {"lost": 0.01}},
    "line_noise": {"to_drives": {"noise": 0.01}, "from_drives": {"noise": 0.01}},
    "master_stopped": {"bus": MasterMode.STOP},
    "profibus_clear": {"bus": MasterMode.CLEAR},
    "profibus_freeze_held": {"sync": (False, True)},
    "profibus_interrupted": {"connected": False},
    "profibus_jitter": {"jitter": MS},
    "profibus_plug_pulled": {"plugged": False},
    "profibus_sync_held": {"sync": (True, False)},
    "transfers_refused": {"refused": (0x80B0, 0x80B0)},
    "transfers_torn": {"torn": 1.0},
}
"""What each fault changes, as it is without settings; what comes of the others is seen."""

OF_OTHER_PLANTS = {name for name in FAULTS if name.startswith(("devicenet_", "module_"))}
"""Those that this plant cannot have: test_devicenet_faults.py, test_fault_module.py."""

SEEN_ELSEWHERE = {
    "drive_tripped",
    "gateway_reports",
    "line_babbling",
    "profibus_watchdog_expired",
    "profibus_wrong_configuration",
}


def changed(before: Mapping[str, Any], changes: Mapping[str, Any]) -> dict[str, Any]:
    """A snapshot with changes, which name only what is other inside of a drive or a pair."""
    return dict(before) | {
        key: before[key] | value if isinstance(value, dict) else value
        for key, value in changes.items()
    }


@pytest.mark.parametrize("name", CHANGES)
def test_a_fault_changes_its_own_place_and_nothing_else(plant: Installation, name: str) -> None:
    before = snapshot(plant)
    made = fault(plant, name)
    assert snapshot(plant) == before, "making it does nothing"
    made.inject()
    assert snapshot(plant) == changed(before, CHANGES[name])
    assert changed(before, CHANGES[name]) != before


@pytest.mark.parametrize("name", sorted(set(FAULTS) - OF_OTHER_PLANTS))
def test_a_cleared_fault_leaves_a_plant_that_works_again(plant: Installation, name: str) -> None:
    before = snapshot(plant)
    made = fault(plant, name)
    made.inject()
    plant.run_for(3 * NS_PER_S)
    made.clear()
    plant.run_for(6 * NS_PER_S)
    assert snapshot(plant) == before
    assert all_is_well(plant)


def test_every_fault_is_tried_and_named_as_in_scenarios() -> None:
    assert {*CHANGES, *SEEN_ELSEWHERE, *OF_OTHER_PLANTS} == set(FAULTS)
    for name, kind in FAULTS.items():
        assert kind.name == name
        assert kind.title


def test_places_are_those_of_the_plant(plant: Installation) -> None:
    assert set(Target.GATEWAY.places(plant)) == {"gw1"}
    assert set(Target.DRIVE.places(plant)) == {f"drive{number}" for number in range(5)}
    assert not Target.WHOLE.places(plant)


@pytest.mark.parametrize(
    ("name", "settings", "message", "advice"),
    [
        ("line_noise", {"bit_error_rate": 0.0}, "is never 0.0", "more than 0"),
        ("line_noise", {"bit_error_rate": "much"}, "is never 'much'", "a number"),
        ("line_noise", {"probability": 0.5}, "has no setting 'probability'", "bit_error_rate"),
        ("line_noise", {"direction": "up"}, "is never 'up'", "'both', 'to_drives'"),
        ("line_babbling", {"longest": 0.5}, "is never 0.5", "a whole number"),
        ("drive_tripped", {"display": ""}, "is never ''", "a text"),
        ("gateway_slow", {"processing_time": 20}, "is never 20", "such as 500 ms"),
        ("gateway_slow", {"processing_time": "0 s"}, "is never '0 s'", "that is not 0"),
        ("transfers_refused", {"ret_val": "16#7000"}, "is never '16#7000'", "16#80B0"),
        ("gateway_reports", {"code": "no_error"}, "is never 'no_error'", "'frame_error'"),
        ("cpu_unpowered", {"display": "OC1"}, "has no setting 'display'", "it has none"),
    ],
)
def test_wrong_settings_are_refused(
    name: str, settings: dict[str, float | str], message: str, advice: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault_settings(FAULTS[name], settings, {})
    (found,) = failure.value.diagnostics
    assert found.code == "FB8004"
    assert message in found.message
    assert advice in found.help


def test_all_wrong_settings_are_told_together() -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault_settings(FAULTS["line_noise"], {"bit_error_rate": 5, "x": 1}, {})
    assert len(failure.value.diagnostics) == 2


@pytest.mark.parametrize(
    ("name", "settings", "code"),
    [
        ("drive_tripped", {"display": "OC77"}, "FB7102"),
        ("drive_tripped", {"display": "nErr"}, "FB7102"),
        ("drive_number_doubled", {"other": "drive3"}, "FB7520"),
        ("drive_answers_for_another", {"other": "drive9"}, "FB7520"),
        ("profibus_jitter", {"up_to": "2 ms"}, "FB7201"),
    ],
)
def test_what_the_plant_does_not_allow_is_refused_when_the_fault_is_made(
    plant: Installation, name: str, settings: dict[str, float | str], code: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        fault(plant, name, settings)
    assert [item.code for item in failure.value.diagnostics] == [code]
