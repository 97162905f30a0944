"""All series of the catalogue, each as an inverter of its own on a line at its own port."""

import pytest
from drive_bench import CATALOG, Bench

from fbgen.catalog import Drive
from fbgen.wire import modbus
from harness.drives import Inverter, InverterSettings, set_for_line
from harness.line import Parity, SerialFormat

SERIES = [pytest.param(drive, id=drive.id) for drive in CATALOG.drives.values()]
every_series = pytest.mark.parametrize("series", SERIES)


def _bench(series: Drive, **parameters: float) -> tuple[Bench, Inverter]:
    bench = Bench(series=series)
    return bench, bench.add(1, parameters)


def _number(drive: Inverter, name: str) -> str:
    comno = drive.series.comno(name).hex
    return f"{comno[:2]} {comno[2:]}"


def test_there_are_the_ten_series_that_the_catalogue_has() -> None:
    assert {drive.id for drive in CATALOG.drives.values()} == {
        *("vf-s11", "vf-as1", "vf-s15", "vf-mb1", "vf-nc1", "vf-s9", "vf-a7", "vf-p7", "g7"),
        "vf-s7",
    }


@every_series
def test_it_runs_and_stops_by_the_command_word_of_its_port(series: Drive) -> None:
    bench, drive = _bench(series, acceleration_time=1.0, deceleration_time=1.0)
    port = drive.communication.facts
    command, set_point = _number(drive, port.command), _number(drive, port.setpoint)
    bench.ask(f"01 50 {set_point} 0F A0")
    assert bench.ask(f"01 50 {command} C6 00") == f"01 50 {command} C6 00"
    bench.wait(3)
    assert (drive.shaft_hz, drive.running) == (-40.0, True)
    status = series.word("status").decode(drive.read_word(series.link.status))
    names = {item.field.name for item in status if item.value}
    assert {"running", "reverse"} <= names
    assert bench.ask("01 47 FD 00 00 00") == "01 47 FD 00 0F A0"
    bench.ask(f"01 50 {command} C0 00")
    bench.wait(3)
    assert not drive.running


@every_series
@pytest.mark.fact("tip.trip")
def test_a_trip_freezes_its_monitors_and_is_remembered(series: Drive) -> None:
    bench, drive = _bench(series, acceleration_time=0.0)
    drive.write_ram(series.comno(drive.communication.facts.setpoint).number, 4000)
    drive.write_ram(series.comno(drive.communication.facts.command).number, 0xC400)
    held = {
        comno.number: drive.read_word(comno.number)
        for comno in series.comnos
        if comno.frozen_copy_of is not None
    }
    drive.trip("OC1")
    assert drive.read_word("FD00") == 0
    assert {number: drive.read_word(number) for number in held} == held
    assert drive.read_word("FE00") == 4000
    assert bench.ask("01 47 FC 90 00 00") == f"01 67 FC 90 00 {drive.trip_code:02X}"
    assert bench.send(b"(01RFC90)\r") == [b"(01rFC90%04X)\r" % drive.trip_code]
    drive.reset()
    drive.trip("OC2")
    drive.reset()
    codes = [drive.trips.code_of(display) for display in ("OC2", "OC1")]
    assert [drive.read_word(f"past_trip_{place}") for place in (1, 2)] == codes


@every_series
@pytest.mark.fact("tip.boot")
def test_it_is_silent_for_its_own_time_after_power_on(series: Drive) -> None:
    bench, drive = _bench(series)
    drive.power_off()
    drive.power_on()
    bench.wait(series.times.boot.ns / 1e9 - 0.05)
    assert bench.ask("01 47 FC 90 00 00") == ""
    bench.wait(0.05)
    assert bench.ask("01 47 FC 90 00 00") == "01 47 FC 90 00 00"


@every_series
@pytest.mark.fact("tip.baud")
@pytest.mark.fact("tip.baud.code")
@pytest.mark.fact("tip.parity.code")
@pytest.mark.fact("tip.change")
def test_each_rate_and_parity_of_its_port_acts_after_power_off(series: Drive) -> None:
    port = CATALOG.drive(series.id).communication.ports[0]  # type: ignore[union-attr]
    bench, drive = _bench(series)
    for code, rate in series.baud_rates(port).items():
        for parity_code, parity in series.parities(port).items():
            before = str(drive.communication.port.format)
            drive.set_parameter(port.baud_rate, series.comno(port.baud_rate).to_value(code))
            drive.set_parameter(port.parity, parity_code)
            assert str(drive.communication.port.format) == before
            drive.power_off()
            drive.power_on()
            bench.wait(3)
            own = SerialFormat(rate, Parity[parity.upper()], 2)
            assert drive.communication.port.format == own
            bench.port.format = SerialFormat(rate, own.parity, 1)
            bench.send(b"(01RFC90)\r")
            bench.wait(0.3)
            assert [heard.data for heard in bench.heard] == [b"(01RFC900000)\r"]


@every_series
def test_its_time_out_trips_unless_it_is_off(series: Drive) -> None:
    bench, drive = _bench(series)
    timeout = series.comno(drive.communication.facts.timeout)
    bench.ask("01 47 FC 90 00 00")
    bench.wait(200)
    assert not drive.tripped
    drive.set_parameter(timeout.number, 1)
    bench.ask("01 47 FC 90 00 00")
    bench.wait(1)
    assert drive.trip_display == "Err5"


@every_series
def test_every_comno_can_be_read_over_the_line(series: Drive) -> None:
    bench, drive = _bench(series)
    for comno in series.comnos:
        wanted = f"01 47 {_number(drive, comno.name)} {drive.read_word(comno.number):04X}"
        assert bench.ask(f"01 47 {_number(drive, comno.name)} 00 00").replace(" ", "") == (
            wanted.replace(" ", "")
        )


@every_series
def test_modbus_is_spoken_by_those_that_have_it(series: Drive) -> None:
    known = series.communication
    assert known is not None
    port = known.ports[0]
    if port.protocol is None:
        assert list(port.protocols.values()) == ["toshiba"]
        return
    bench, drive = _bench(series, **{port.protocol: 1})
    assert drive.communication.protocol == "modbus"
    assert bench.ask_modbus("01 03 FC 90 00 01") == "01 03 02 00 00"
    assert bench.send(modbus.seal(bytes.fromhex("01 08 00 00 00 00")))[0][1:3] == b"\x88\x01"


def test_the_four_wire_port_of_vf_a7_and_vf_p7_is_set_by_f820() -> None:
    for name in ("vf-a7", "vf-p7"):
        series = CATALOG.drive(name)
        _, drive = _bench(series, baud_rate=0, baud_rate_4_wire=3)
        assert drive.communication.port.format.baud == 9600


@every_series
def test_each_port_can_be_set_for_a_line_by_its_rate_and_parity(series: Drive) -> None:
    assert series.communication is not None
    for port in series.communication.ports:
        parameters = set_for_line(series, port.name, 19_200, "even")
        settings = InverterSettings(parameters=parameters, port=port.name)
        drive = Bench(series=series).add(settings=settings)
        assert str(drive.communication.port.format) == "19200 8E2"
