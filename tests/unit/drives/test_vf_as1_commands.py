"""The VF-AS1: two ports with a command word each, every bit of its table, what wins over what."""

from collections.abc import Callable

import pytest
from drive_bench import CATALOG, Bench

from fbgen.diagnostics import DiagnosticError
from harness.drives import Inverter, Panel
from tests.vectors.reading import entries

AS1 = CATALOG.drive("vf-as1")
TABLE = entries("vf_as1_command_word")
RAMPS = {"acceleration_time": 8.0, "deceleration_time": 8.0, "maximum_frequency": 80.0}
PORTS = {"two_wire": ("FA 00", "FA 01", "FA 20"), "four_wire": ("FA 04", "FA 05", "FA 22")}


class Plant:
    """One inverter with both ports on lines of their own."""

    def __init__(self, **parameters: float) -> None:
        self.two_wire = Bench(series=AS1)
        self.drive: Inverter = self.two_wire.add(1, RAMPS | parameters)
        self.four_wire = Bench(series=AS1, kernel=self.two_wire.kernel)
        self.drive.connect("four_wire", self.four_wire.line)

    def bench(self, port: str) -> Bench:
        """The line at a port."""
        return self.two_wire if port == "two_wire" else self.four_wire

    def command(self, port: str, *bits: str) -> None:
        """Write the named bits into the command word of a port, through it."""
        self.bench(port).ask(f"01 50 {PORTS[port][0]} {AS1.command_word.encode(list(bits)):04X}")

    def set_point(self, port: str, hz: float) -> None:
        """Write the set-point of a port, through it."""
        self.bench(port).ask(f"01 50 {PORTS[port][1]} {round(hz * 100):04X}")

    def second(self, port: str, word: int) -> None:
        """Write the second command word of a port, through it."""
        self.bench(port).ask(f"01 50 {PORTS[port][2]} {word:04X}")

    def network(self) -> tuple[bool, bool]:
        """Whether run and stop, and the set-point, come from a port."""
        return self.drive.network_command, self.drive.network_frequency

    def status(self) -> set[str]:
        """Names of the bits that FD01 shows."""
        decoded = AS1.word("status").decode(self.drive.read_word("FD01"))
        return {item.field.name for item in decoded if item.value}


NETWORK = ("network_command", "network_frequency")
at_each_port = pytest.mark.parametrize("port", list(PORTS))


def _reaches(hz: float, seconds: float = 12) -> Callable[[Plant], bool]:
    def check(plant: Plant) -> bool:
        plant.two_wire.wait(seconds)
        return plant.drive.frequency_hz == pytest.approx(hz)

    return check


@at_each_port
@pytest.mark.parametrize(
    ("bits", "holds"),
    [
        (("run",), _reaches(50.0)),
        (("run", "reverse"), lambda plant: _reaches(50.0)(plant) and plant.drive.shaft_hz == -50.0),
        (("run", "jog"), lambda plant: _reaches(5.0)(plant) and "jog" in plant.status()),
        (("run", "preset_speed_1"), _reaches(11.0)),
        (("run", "preset_speed_2"), _reaches(12.0)),
        (("run", "preset_speed_3"), _reaches(14.0)),
        (("run", "preset_speed_4"), _reaches(18.0)),
        (
            ("run", "preset_speed_1", "preset_speed_2", "preset_speed_3", "preset_speed_4"),
            _reaches(25.0),
        ),
        (
            ("run", "pattern_2"),
            lambda plant: _reaches(50.0, 1)(plant) and "pattern_2" in plant.status(),
        ),
        (
            ("run", "dc_braking"),
            lambda plant: _reaches(0.0)(plant) and "dc_braking" in plant.status(),
        ),
        (
            ("run", "coast_stop"),
            lambda plant: _reaches(0.0)(plant) and "coast_stopped" in plant.status(),
        ),
        (("run", "motor_2"), lambda plant: _reaches(50.0)(plant) and "motor_2" in plant.status()),
        (
            ("run", "pi_control_off"),
            lambda plant: _reaches(50.0)(plant) and "pi_control_off" in plant.status(),
        ),
        (
            ("run", "emergency_stop"),
            lambda plant: _reaches(0.0)(plant) and plant.drive.trip_display == "E",
        ),
    ],
    ids=lambda item: "+".join(item) if isinstance(item, tuple) else "",
)
@pytest.mark.fact("as1.cw.nos")
def test_each_bit_of_the_table_does_what_it_says(
    port: str, bits: tuple[str, ...], holds: Callable[[Plant], bool]
) -> None:
    presets = {f"preset_speed_{number}": 10.0 + number for number in range(1, 16)}
    plant = Plant(acceleration_time_2=0.5, jog_frequency=5.0, **presets)
    plant.set_point(port, 50.0)
    plant.command(port, *NETWORK, *bits)
    assert holds(plant)


@at_each_port
@pytest.mark.parametrize(("bit", "hz"), [("preset_speed_2", 12.0), ("jog", 5.0)])
def test_preset_speeds_and_jog_need_no_frequency_priority(port: str, bit: str, hz: float) -> None:
    plant = Plant(jog_frequency=5.0, preset_speed_2=12.0)
    plant.drive.set_panel(Panel(frequency_hz=40.0))
    plant.command(port, "network_command", "run", bit)
    assert _reaches(hz)(plant)
    plant.command(port, "network_command", "run")
    assert _reaches(40.0)(plant)


def test_the_tests_above_name_every_bit_of_the_table() -> None:
    tried = {"network_command", "network_frequency", "fault_reset"}
    for mark in test_each_bit_of_the_table_does_what_it_says.pytestmark:  # type: ignore[attr-defined]
        if mark.args[0] == ("bits", "holds"):
            tried |= {bit for bits, _ in mark.args[1] for bit in bits}
    assert tried == {field.name for field in AS1.command_word.bits}
    assert len(tried) == len(TABLE["as1.command_word"]["bits"])


@pytest.mark.parametrize("example", ["forward", "reverse", "reverse_with_frequency"])
def test_examples_of_the_manual_run_as_they_say(example: str) -> None:
    plant = Plant()
    plant.drive.set_panel(Panel(frequency_hz=20.0))
    plant.set_point("two_wire", 50.0)
    frame = str(TABLE[f"as1.example.{example}"]["ascii"]).encode("ascii")
    assert plant.two_wire.send(frame) == [frame]
    plant.two_wire.wait(12)
    hz = 50.0 if example == "reverse_with_frequency" else 20.0
    assert plant.drive.shaft_hz == (hz if example == "forward" else -hz)


@at_each_port
@pytest.mark.fact("as1.cw.estop")
@pytest.mark.fact("tip.reset")
def test_emergency_stop_needs_no_priority_and_a_reset_has_no_answer(port: str) -> None:
    plant = Plant()
    plant.command(port, "emergency_stop")
    assert plant.drive.trip_display == "E"
    assert plant.bench(port).ask(f"01 50 {PORTS[port][0]} 20 00") == ""
    assert not plant.drive.tripped
    plant.two_wire.wait(3)
    assert plant.drive.read_word(PORTS[port][0].replace(" ", "")) == 0


@at_each_port
@pytest.mark.fact("as1.cw.latch")
def test_priorities_stay_until_off_reset_or_power_off(port: str) -> None:
    def taken() -> Plant:
        plant = Plant()
        plant.command(port, *NETWORK)
        plant.two_wire.wait(1000)
        assert plant.network() == (True, True)
        return plant

    plant = taken()
    plant.command(port)
    assert plant.network() == (False, False)
    plant = taken()
    plant.bench(port).ask(f"01 50 {PORTS[port][0]} 20 00")
    assert plant.network() == (False, False)
    plant = taken()
    plant.drive.power_off()
    plant.drive.power_on()
    assert plant.network() == (False, False)


@pytest.mark.fact("as1.cw.latch")
def test_the_factory_setting_ends_priorities_and_gives_every_parameter_its_default() -> None:
    plant = Plant(acceleration_time_2=1.0)
    plant.command("two_wire", *NETWORK)
    assert plant.two_wire.ask("01 50 00 07 00 02") == "01 50 00 07 00 02"
    assert plant.network() == (True, True)
    assert plant.two_wire.ask("01 50 00 07 00 03") == ""
    assert plant.network() == (False, False)
    assert plant.drive.inv_no == 0
    for comno in AS1.comnos:
        if comno.storage == "eeprom":
            assert plant.drive.read_word(comno.number) == comno.default_word, comno.name
    plant.two_wire.wait(3)
    assert plant.two_wire.ask("00 47 00 07 00 00") == "00 47 00 07 00 00"


def test_the_port_that_stands_first_has_priority_and_the_other_gets_it_after_it() -> None:
    plant = Plant()
    plant.set_point("two_wire", 30.0)
    plant.set_point("four_wire", 60.0)
    plant.command("four_wire", *NETWORK, "run")
    assert _reaches(60.0)(plant)
    plant.command("two_wire", *NETWORK, "run")
    assert _reaches(30.0)(plant)
    plant.command("two_wire", "network_frequency")
    assert _reaches(30.0)(plant), "run from FA04, frequency from FA01"
    plant.command("two_wire")
    assert _reaches(60.0)(plant)


@at_each_port
@pytest.mark.parametrize(
    ("function", "forward_hz"), [(48, 0.0), (56, -50.0), (58, 33.0)], ids=["local", "run", "speed"]
)
@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.fact("as1.cw.prio")
def test_terminal_functions_win_over_the_command_words(
    port: str, function: int, forward_hz: float, inverted: bool
) -> None:
    plant = Plant(input_function_s1=function + inverted, preset_speed_15=33.0)
    plant.drive.switch_terminal("s1", inverted)
    plant.set_point(port, 50.0)
    plant.command(port, *NETWORK, "run", "reverse")
    assert _reaches(50.0)(plant)
    plant.drive.switch_terminal("s1", not inverted)
    assert plant.network() == (False, False)
    plant.command(port, *NETWORK)
    plant.two_wire.wait(20)
    assert plant.drive.shaft_hz == forward_hz
    plant.drive.switch_terminal("s1", inverted)
    assert _reaches(0.0)(plant)


def test_a_function_without_a_terminal_acts_always() -> None:
    plant = Plant(input_function_always=48)
    plant.command("two_wire", *NETWORK, "run")
    assert not plant.drive.network_command


def test_terminals_that_are_not_there_are_told() -> None:
    with pytest.raises(DiagnosticError, match="no input terminal 's5'") as caught:
        Plant().drive.switch_terminal("s5", True)
    assert caught.value.diagnostics[0].code == "FB7105"


@at_each_port
@pytest.mark.parametrize("pattern", range(4))
def test_bits_8_and_9_of_the_second_word_choose_among_four_ramps(port: str, pattern: int) -> None:
    times = {"acceleration_time_2": 4.0, "acceleration_time_3": 2.0, "acceleration_time_4": 1.0}
    plant = Plant(**times)
    plant.set_point(port, 80.0)
    plant.second(port, pattern << 8)
    plant.command(port, *NETWORK, "run")
    begin_hz = plant.drive.frequency_hz
    plant.two_wire.wait(0.1)
    assert plant.drive.frequency_hz - begin_hz == pytest.approx(8.0 / (8.0, 4.0, 2.0, 1.0)[pattern])


def test_either_word_is_enough_for_the_second_ramp() -> None:
    plant = Plant(acceleration_time_2=1.0)
    plant.set_point("two_wire", 80.0)
    plant.command("two_wire", *NETWORK, "run", "pattern_2")
    assert "pattern_2" in plant.status()
    plant.second("two_wire", 1 << 8)
    plant.command("two_wire", *NETWORK, "run")
    assert "pattern_2" in plant.status()
    plant.second("two_wire", 0)
    assert "pattern_2" not in plant.status()


def test_the_second_word_counts_with_its_own_first_word_only() -> None:
    plant = Plant()
    plant.second("four_wire", 1 << 8)
    plant.command("two_wire", *NETWORK, "run")
    assert "pattern_2" not in plant.status()


def test_forced_stop_with_the_greatest_deceleration_is_quicker_than_any_ramp() -> None:
    plant = Plant(deceleration_time=100.0, acceleration_time=1.0)
    plant.set_point("two_wire", 50.0)
    plant.command("two_wire", *NETWORK, "run")
    assert _reaches(50.0)(plant)
    plant.second("two_wire", 1 << 7)
    assert _reaches(0.0, 0.1)(plant)
    plant.second("two_wire", 0)
    assert _reaches(50.0)(plant), "it goes on when the bit is gone, as run is still there"


@pytest.mark.parametrize(
    ("action", "at_two", "at_four"),
    [
        (0, "", ""),
        (1, "t", ""),
        (2, "Err5", ""),
        (3, "", "t"),
        (6, "", "Err5"),
        (8, "Err5", "Err5"),
    ],
)
@at_each_port
def test_time_out_of_each_port_does_what_f804_says(
    port: str, action: int, at_two: str, at_four: str
) -> None:
    plant = Plant(communication_timeout=1, timeout_action=action)
    expected = at_two if port == "two_wire" else at_four
    plant.bench(port).ask("01 47 FC 90 00 00")
    plant.two_wire.wait(0.9)
    assert (plant.drive.tripped, plant.drive.read_word("FC91")) == (False, 0)
    plant.two_wire.wait(1)
    assert plant.drive.trip_display == ("Err5" if expected == "Err5" else "")
    alarms = AS1.word("alarm").decode(plant.drive.read_word("FC91"))
    assert [item.field.name for item in alarms if item.value] == (
        ["communication_timeout"] if expected == "t" else []
    )
    assert ("alarm" in plant.status()) is (expected == "t")
    if expected == "t":
        plant.bench(port).ask("01 47 FC 90 00 00")
        assert plant.drive.read_word("FC91") == 0


def test_ports_are_set_apart() -> None:
    plant = Plant(protocol_selection=1, send_waiting_time_4_wire=0.5)
    assert plant.two_wire.ask("01 47 FC 90 00 00") == "01 47 FC 90 00 00"
    assert plant.four_wire.ask_modbus("01 03 FC 90 00 01") == ""
    plant.two_wire.wait(0.5)
    assert plant.four_wire.heard[0].data.hex() == "010302" + "0000" + "b844"
    assert [port.protocol for port in plant.drive.ports.values()] == ["toshiba", "modbus"]


def test_a_port_cannot_be_connected_twice_nor_one_that_is_not_there() -> None:
    plant = Plant()
    for name in ("four_wire", "three_wire"):
        with pytest.raises(DiagnosticError, match=f"no free port '{name}'") as caught:
            plant.drive.connect(name, plant.four_wire.line)
        assert caught.value.diagnostics[0].code == "FB7104"
