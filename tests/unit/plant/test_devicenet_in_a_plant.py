"""DeviceNet in a plant file: what is checked, what is built, what a program of one's own sees."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant, read_plant
from fbgen.source import Source
from harness.faults import FAULTS
from harness.faults.settings import fault_settings
from harness.gateways.dev003z import State
from harness.installation import Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.scenario.devicenet_paths import DEVICENET_ITEMS
from harness.scenario.paths import Paths

EXAMPLE = Path(__file__).parents[3] / "examples" / "devicenet"
CATALOG = load_catalog()
PLANT = EXAMPLE / "plant.yaml"
TEXT = PLANT.read_text("utf-8")


def built(name: str = "plant.yaml") -> Installation:
    """Switched on, three seconds later: the scanner has found its nodes."""
    plan = load_plant(EXAMPLE / name, CATALOG)
    made = build_plant(plan, CATALOG, PlantSetup(sources=[EXAMPLE / "conveyors.scl"]))
    made.start()
    made.run_for(3 * NS_PER_S)
    return made


@pytest.fixture
def plant() -> Installation:
    return built()


def running(plant: Installation) -> Installation:
    """The same, with both drives at 20 Hz."""
    plant.cpu.engine.set_global("Conveyors.hz", 20.0)
    plant.cpu.engine.set_global("Conveyors.run", True)
    plant.run_for(6 * NS_PER_S)
    assert plant.drives["infeed"].frequency_hz == 20.0
    assert plant.drives["outfeed"].frequency_hz == pytest.approx(20.0, abs=0.05)
    return plant


def inject(plant: Installation, name: str, on: str, **settings: str) -> object:
    kind = FAULTS[name]
    made = kind.make(plant, on, fault_settings(kind, settings, {}))
    made.inject()
    return made


def there(plant: Installation) -> list[object]:
    names = ("infeed_there", "outfeed_there")
    return [plant.cpu.engine.global_value(f"Conveyors.{name}") for name in names]


@pytest.mark.parametrize(
    ("old", "new", "code", "words"),
    [
        ("type: dev003z", "type: dev03z", "FB2001", "there is no DeviceNet option 'dev03z'"),
        ("series: vf-mb1", "series: vf-s11", "FB2008", "does not fit into vf-s11"),
        ("series: vf-mb1", "series: vf-mb9", "FB2009", "no drive series 'vf-mb9'"),
        ("max_frequency_hz: 60.0", "max_frequency_hz: 6000.0", "FB2010", "6000 Hz"),
        ("name: outfeed", "name: infeed", "FB2013", "'infeed' is given twice"),
        ("name: outfeed", "name: IF", "FB2012", "IF"),
        ("output_address: 320", "output_address: 312", "FB2016", "312 to 315 of 'outfeed'"),
        ("input_address: 320", "input_address: 304", "FB2016", "304 to 307 of 'outfeed'"),
        ("input_address: 320", "input_address: 32766", "FB2018", "32766 to 32769"),
        ("active_address: 300", "active_address: 306", "FB2016", "310 to 313 of 'infeed'"),
        ("mac: 6", "mac: 5", "FB2053", "MAC ID 5 is given twice"),
        ("mac: 6", "mac: 0", "FB2053", "MAC ID 0 is given twice"),
        ("mac: 6", "mac: 64", "FB2053", "cannot have the MAC ID 64"),
        ("rate: 500", "rate: 1000", "FB2053", "cannot be set to 1000 kbit/s"),
        ("assemblies: 21/71", "assemblies: 21/70", "FB2053", "no assemblies '21/70'"),
        ("timeout_action: 2", "timeout_action: 6", "FB2003", "6 is no value of c101"),
        ("timeout_action: 2", "timeout_acton: 2", "FB2003", "'timeout_acton'"),
        ("timeout_action: 2", "assembly_instances: 2", "FB2003", "'assembly_instances'"),
        ("settings: {", "options: {poles: 4}\n        settings: {", "FB2003", "'poles'"),
    ],
)
def test_what_does_not_fit_is_reported(old: str, new: str, code: str, words: str) -> None:
    assert old in TEXT
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", TEXT.replace(old, new)), CATALOG)
    found = failure.value.diagnostics
    assert {item.code for item in found} == {code}
    assert words in found[0].message
    assert found[0].span is not None


@pytest.mark.parametrize(
    ("old", "new", "message", "help_text"),
    [
        ("assemblies: 100/150", "assemblies: 100", "no assemblies '100'", "input: 100/150"),
        ("assemblies: 100/150", "assemblies: 100/71", "'100/71'", "input: 21/71 or 100/150"),
        ("{timeout_action: 2}", "{c101: 2}", "no parameter 'c101'", "c101 is 'timeout_action'"),
        ("packet_rate_ms: 250", "packet_rate_ms: 2", "lost 8 ms after a poll", "use 3 ms at least"),
        ("rate: 500", "rate: 125\n    scan_ms: 1", "take 4.3 ms at 125", "scan_ms: be 5 at least"),
        ("mac: 6", "options: {motor_poles: 5}\n        mac: 6", "'5' is no value", "steps of 2"),
    ],
)
def test_the_help_says_what_to_write(old: str, new: str, message: str, help_text: str) -> None:
    assert old in TEXT
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", TEXT.replace(old, new)), CATALOG)
    (found,) = failure.value.diagnostics
    assert message in found.message
    assert help_text in (found.help or "")


def test_the_mac_id_that_the_scanner_has_unsaid_is_told() -> None:
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", TEXT.replace("mac: 5", "mac: 0")), CATALOG)
    (found,) = failure.value.diagnostics
    assert [note.message for note in found.notes] == ["the scanner has 0 if nothing is said"]


def test_options_below_gateways_are_told_where_they_belong() -> None:
    text = (Path(__file__).parents[2] / "scenarios" / "one_drive.yaml").read_text("utf-8")
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("p.yaml", text.replace("type: tospbdp001", "type: dev003z")), CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == "FB2001"
    assert "devicenet:" in (found.help or "")


def test_options_are_set_as_the_plant_file_says(plant: Installation) -> None:
    option = plant.options["outfeed"]
    assert option.assemblies.chosen.output.instance == 21
    assert option.own["timeout_action"] == 2
    assert plant.drives["infeed"].read_word("0011") == 6000
    assert plant.neighbours("infeed") == ()


@pytest.mark.parametrize("item", [*DEVICENET_ITEMS, "led.module_status", "input.status"])
def test_scenarios_can_ask_a_drive_on_devicenet(plant: Installation, item: str) -> None:
    reading = Paths(plant, CATALOG).readable(f"devicenet.infeed.{item}", None)
    assert reading.kind.show(reading.get())


@pytest.mark.parametrize("path", ["devicenet.inlet.online", "devicenet.infeed.led.ms", "devicenet"])
def test_paths_that_lead_nowhere_are_refused(plant: Installation, path: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        Paths(plant, CATALOG).readable(path, None)
    assert failure.value.diagnostics[0].code == "FB8003"


def test_a_cpu_in_stop_leaves_drives_running_and_nothing_stale_goes_out(
    plant: Installation,
) -> None:
    running(plant)
    made = FAULTS["cpu_stopped"].make(plant, "", fault_settings(FAULTS["cpu_stopped"], {}, {}))
    made.inject()
    plant.run_for(1 * NS_PER_S)
    assert plant.drives["infeed"].running
    assert plant.options["infeed"].assemblies.outputs(
        plant.options["infeed"].assemblies.chosen
    ) == bytes.fromhex("00 C4 D0 07")
    commanded = []
    scanner = plant.networks["net1"].scanner
    plant.networks["net1"].bus.taps.append(lambda *_: commanded.append(scanner.slaves[5].outputs))
    made.clear()
    plant.run_for(1 * NS_PER_S)
    assert commanded
    assert all(not data[1] & 0x04 for data in commanded), "no run that nobody asked for"
    assert not plant.drives["infeed"].told_to_run


def test_a_cpu_without_supply_silences_its_scanner(plant: Installation) -> None:
    running(plant)
    made = FAULTS["cpu_unpowered"].make(plant, "", fault_settings(FAULTS["cpu_unpowered"], {}, {}))
    made.inject()
    plant.run_for(20 * NS_PER_MS)
    frames: list[int] = []
    plant.networks["net1"].bus.taps.append(lambda _, frame, __: frames.append(frame.identifier))
    plant.run_for(3 * NS_PER_S)
    assert not [one for one in frames if one & 0x400 and one & 7 != 7], "the master is silent"
    assert not plant.drives["outfeed"].told_to_run, "c101"
    assert plant.options["outfeed"].lights[1].state == "timed_out"
    made.clear()
    plant.run_for(4 * NS_PER_S)
    assert there(plant) == [True, True]


@pytest.mark.parametrize(
    ("name", "on", "left", "back"),
    [
        ("devicenet_interrupted", "net1", [False, False], [True, True]),
        ("drive_disconnected", "outfeed", [True, False], [True, True]),
        ("drive_unpowered", "infeed", [False, True], [True, True]),
        ("devicenet_bus_off", "infeed", [False, True], [True, True]),
        ("devicenet_mac_doubled", "infeed", [False, True], [True, True]),
        ("devicenet_wrong_assembly", "infeed", [False, True], [True, True]),
        ("devicenet_wrong_assembly", "outfeed", [True, False], [True, True]),
        ("devicenet_scanner_idle", "net1", [True, True], [True, True]),
    ],
)
def test_a_fault_of_the_network_is_seen_and_over(
    plant: Installation, name: str, on: str, left: list[bool], back: list[bool]
) -> None:
    assert there(plant) == [True, True]
    kind = FAULTS[name]
    made = kind.make(plant, on, fault_settings(kind, {}, {}))
    made.inject()
    plant.run_for(1 * NS_PER_S)
    assert there(plant) == left
    made.clear()
    plant.run_for(5 * NS_PER_S)
    assert there(plant) == back


def test_bus_off_is_over_when_the_supply_was_away(plant: Installation) -> None:
    inject(plant, "devicenet_bus_off", "infeed")
    plant.run_for(1 * NS_PER_S)
    assert plant.options["infeed"].lights[1].state == "link_failure"
    plant.drives["infeed"].power_off()
    plant.run_for(1 * NS_PER_S)
    plant.drives["infeed"].power_on()
    plant.run_for(5 * NS_PER_S)
    assert there(plant) == [True, True]
    assert plant.options["infeed"].state is State.READY


@pytest.mark.parametrize(
    ("name", "settings"),
    [
        ("drive_slow", {}),
        ("drive_answers_late", {}),
        ("drive_disconnected", {"direction": "to_drive"}),
    ],
)
def test_faults_of_telegrams_are_refused(
    plant: Installation, name: str, settings: dict[str, str]
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        inject(plant, name, "infeed", **settings)
    assert failure.value.diagnostics[0].code == "FB7522"


def test_direct_access_reaches_the_same_bytes(plant: Installation) -> None:
    cpu = plant.cpu
    assert cpu.read_peripheral(300, 1) == 0b1110_0000
    assert cpu.read_peripheral(310, 2) == int.from_bytes(cpu.inputs[310:312], "big")
    cpu.write_peripheral(312, 2, 0xA00F)
    assert plant.networks["net1"].scanner.slaves[5].outputs[2:] == b"\xa0\x0f"
    assert cpu.access_errors == 0
