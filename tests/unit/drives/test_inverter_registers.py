"""Cells of the inverter: rights, ranges, RAM and EEPROM, what acts only after a restart."""

import pytest
from drive_bench import GATEWAY_SETTINGS, SERIES, Bench

from fbgen.diagnostics import DiagnosticError
from harness.drives import InverterSettings, Panel, set_for_line
from harness.line import FRAMING_ERROR

ACC = 0x0009


@pytest.mark.fact("tos.cmd.50")
def test_p_writes_to_ram_until_the_next_restart() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 50 00 09 00 64") == "0B 50 00 09 00 64"
    assert drive.read_parameter("acceleration_time") == 10.0
    bench.ask("0B 50 00 09 00 32")
    assert drive.read_parameter("acceleration_time") == 5.0
    drive.power_off()
    drive.power_on()
    assert drive.read_parameter("acceleration_time") == 10.0
    assert drive.registers.write_cycles[ACC] == 0


@pytest.mark.fact("tos.cmd.57")
def test_w_writes_to_the_eeprom_and_each_write_counts() -> None:
    bench = Bench()
    drive = bench.add()
    for _ in range(3):
        assert bench.ask("0B 57 00 09 00 32") == "0B 57 00 09 00 32"
    assert drive.registers.write_cycles[ACC] == 3
    drive.power_off()
    drive.power_on()
    assert drive.read_parameter("0009") == 5.0


@pytest.mark.fact("tip.W.ram")
def test_w_of_a_cell_without_eeprom_goes_to_ram() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 57 FA 01 13 88") == "0B 57 FA 01 13 88"
    assert drive.read_word("FA01") == 5000
    assert drive.registers.number("frequency_setpoint") not in drive.registers.write_cycles
    drive.power_off()
    drive.power_on()
    assert drive.read_word("FA01") == 0


@pytest.mark.fact("tos.data")
def test_words_are_values_in_units_of_the_resolution() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask("0B 50 FA 01 13 88")
    assert drive.read_parameter("frequency_setpoint") == 50.0


@pytest.mark.parametrize(
    ("request_", "reply"),
    [
        ("0B 50 12 34 00 00", "0B 4E 00 02"),
        ("0B 47 12 34 00 00", "0B 4E 00 02"),
        ("0B 50 08 00 00 05", "0B 4E 00 01"),
        ("0B 50 FE 03 00 00", "0B 4E 00 00"),
        ("0B 57 FC 90 00 00", "0B 4E 00 00"),
    ],
)
@pytest.mark.fact("tip.range")
def test_what_the_inverter_does_not_take_is_refused_with_its_code(
    request_: str, reply: str
) -> None:
    bench = Bench()
    bench.add()
    assert bench.ask(request_) == reply


def test_set_point_above_the_maximum_frequency_is_refused_and_the_old_one_stays() -> None:
    # the PBDP-110 manual, section 9.1, says the same of its drives
    bench = Bench()
    drive = bench.add(parameters={"maximum_frequency": 60.0})
    bench.ask("0B 50 FA 01 17 70")
    assert bench.ask("0B 50 FA 01 17 71") == "0B 4E 00 01"
    assert drive.read_parameter("FA01") == 60.0


def test_parameter_that_needs_rest_cannot_be_written_while_running() -> None:
    bench = Bench()
    drive = bench.add()
    drive.set_panel(Panel(run=True, frequency_hz=20.0))
    bench.wait(1)
    assert bench.ask("0B 50 00 11 13 88") == "0B 4E 00 00"
    drive.set_panel(Panel())
    bench.wait(20)
    assert bench.ask("0B 50 00 11 13 88") == "0B 50 00 11 13 88"


def test_faulty_eeprom_refuses_w_and_takes_p() -> None:
    bench = Bench()
    drive = bench.add()
    drive.registers.eeprom_faulty = True
    assert bench.ask("0B 57 00 09 00 32") == "0B 4E 00 00"
    assert bench.ask("0B 50 00 09 00 32") == "0B 50 00 09 00 32"
    assert bench.ask("0B 57 FA 01 00 32") == "0B 57 FA 01 00 32"


@pytest.mark.fact("tos.prm.s9s11nc1")
def test_settings_of_the_gateway_manual_let_the_inverter_answer() -> None:
    bench = Bench()
    bench.add(settings=InverterSettings(parameters={"0800": 4, "0801": 1, "0802": 11, "0803": 1}))
    assert bench.ask("0B 47 FC 90 00 00") == "0B 47 FC 90 00 00"


def test_inverter_as_delivered_runs_at_9600_baud_and_hears_framing_errors() -> None:
    bench = Bench()
    drive = bench.add(settings=InverterSettings(parameters={"inverter_number": 11}))
    assert drive.communication.port.format.baud == 9600
    assert bench.ask("0B 47 FC 90 00 00") == ""
    drive.communication.port.transmit(b"x")
    bench.wait(1)
    assert bench.heard[0].marks == bytes([FRAMING_ERROR])


@pytest.mark.fact("tos.prm.restart")
def test_baud_rate_and_parity_act_only_after_power_off_and_on() -> None:
    bench = Bench()
    drive = bench.add()
    assert bench.ask("0B 57 08 00 00 03") == "0B 57 08 00 00 03"
    assert bench.ask("0B 57 08 01 00 02") == "0B 57 08 01 00 02"
    assert bench.ask("0B 47 08 00 00 00") == "0B 47 08 00 00 03"
    assert str(drive.communication.port.format) == "19200 8E2"
    drive.power_off()
    drive.power_on()
    assert str(drive.communication.port.format) == "9600 8O2"
    bench.wait(2)
    assert bench.ask("0B 47 08 00 00 00") == ""


def test_p_to_the_baud_rate_never_acts() -> None:
    bench = Bench()
    drive = bench.add()
    bench.ask("0B 50 08 00 00 03")
    drive.power_off()
    drive.power_on()
    assert drive.communication.port.format.baud == 19200


@pytest.mark.fact("tos.inv")
def test_inverter_number_acts_at_once() -> None:
    bench = Bench()
    drive = bench.add(11)
    assert bench.ask("0B 50 08 02 00 0C") == "0B 50 08 02 00 0C"
    assert drive.inv_no == 12
    assert bench.ask("0B 47 FC 90 00 00") == ""
    assert bench.ask("0C 47 FC 90 00 00") == "0C 47 FC 90 00 00"


@pytest.mark.fact("tos.s11.option")
def test_rotary_switch_wins_over_the_parameter_unless_it_is_at_0() -> None:
    bench = Bench()
    parameters = GATEWAY_SETTINGS | {"inverter_number": 11}
    drive = bench.add(settings=InverterSettings(parameters=parameters, rotary_switch=5))
    assert bench.ask("05 47 FC 90 00 00") == "05 47 FC 90 00 00"
    assert bench.ask("0B 47 FC 90 00 00") == ""
    drive.set_parameter("inverter_number", 12)
    assert drive.inv_no == 5


def test_setting_at_the_panel_is_stored_and_counts() -> None:
    bench = Bench()
    drive = bench.add()
    drive.set_parameter("acceleration_time", 2.5)
    assert drive.registers.eeprom[ACC] == 25
    assert drive.registers.write_cycles[ACC] == 1


@pytest.mark.parametrize(
    ("key", "value", "says"),
    [
        ("baud_rate", 19200, "outside the range"),
        ("output_current", 1.0, "cannot be written"),
        ("acceleration_time", -1.0, "outside the range"),
    ],
)
def test_value_that_the_inverter_does_not_take_is_told(key: str, value: float, says: str) -> None:
    drive = Bench().add()
    with pytest.raises(DiagnosticError, match=says) as caught:
        drive.set_parameter(key, value)
    assert [finding.code for finding in caught.value.diagnostics] == ["FB7101"]


def test_all_wrong_settings_are_told_together() -> None:
    with pytest.raises(DiagnosticError) as caught:
        Bench().add(parameters={"acceleration_time": 1e6, "frequency_setpoint": 1.0, "parity": 7})
    assert [finding.code for finding in caught.value.diagnostics] == ["FB7101"] * 3


def test_series_without_the_ramp_times_cannot_be_simulated() -> None:
    bench = Bench()
    kept = tuple(comno for comno in SERIES.comnos if comno.name != "acceleration_time_2")
    short = SERIES.model_copy(update={"comnos": kept})
    with pytest.raises(DiagnosticError, match="acceleration_time_2") as caught:
        type(bench.add())(bench.kernel, bench.line, short)
    assert caught.value.diagnostics[0].code == "FB7103"


def test_series_without_a_serial_port_cannot_be_simulated() -> None:
    bench = Bench(series=SERIES.model_copy(update={"communication": None}))
    with pytest.raises(DiagnosticError, match="has no serial port") as caught:
        bench.add()
    assert [finding.code for finding in caught.value.diagnostics] == ["FB7104"]
    with pytest.raises(DiagnosticError, match="it has no serial port"):
        type(Bench().add())(bench.kernel, bench.line, bench.series)


def test_a_port_is_not_set_to_a_rate_or_by_a_name_that_it_does_not_have() -> None:
    for port, baud, says in (("serial", 38_400, "no 38400 bit/s"), ("x", 9600, "no port 'x'")):
        with pytest.raises(DiagnosticError, match=says) as caught:
            set_for_line(SERIES, port, baud, "even")
        assert [finding.code for finding in caught.value.diagnostics] == ["FB7104"]


def test_an_inverter_told_to_speak_what_its_series_cannot_is_refused() -> None:
    known = SERIES.communication
    assert known is not None
    silent = SERIES.model_copy(update={"communication": known.model_copy(update={"modbus": None})})
    with pytest.raises(DiagnosticError, match="does not speak the protocol 'modbus'") as caught:
        Bench(series=silent).add(parameters={"protocol_selection": 1})
    assert [finding.code for finding in caught.value.diagnostics] == ["FB7104"]
    drive = Bench(series=silent).add()
    assert drive.write_eeprom(0x0829, 1) is None
    drive.power_off()
    drive.power_on()
    assert drive.communication.protocol == "modbus"
