"""Drive to drive: a master inverter sends its set-point, slaves follow it (F806, F826)."""

import pytest
from drive_bench import CATALOG, Bench

from fbgen.wire.toshiba import seal
from harness.drives import Inverter, InverterSettings, Panel
from harness.line import Line, Topology

ZERO, KEEP, TRIP, SENDS_COMMAND, SENDS_OUTPUT = range(5)
PARAMETERS = {"point_2_frequency": 80.0, "maximum_frequency": 80.0, "acceleration_time": 8.0}


def _line(
    series: str = "vf-s11",
    slave_role: int = ZERO,
    master_role: int = SENDS_COMMAND,
    topology: Topology = Topology.TWO_WIRE,
) -> tuple[Bench, Inverter, Inverter]:
    """A master inverter and one that follows it, both running by their panels."""
    bench = Bench(series=series, topology=topology)
    master = bench.add(1, PARAMETERS | {"inter_drive_mode": master_role})
    slave = bench.add(2, PARAMETERS | {"inter_drive_mode": slave_role})
    slave.write_ram(0xFA00, 0xC400)
    return bench, master, slave


@pytest.mark.parametrize("topology", Topology)
@pytest.mark.parametrize("series", ["vf-s11", "vf-s15", "vf-as1"])
def test_a_slave_follows_the_frequency_command_of_its_master(
    series: str, topology: Topology
) -> None:
    bench, master, slave = _line(series, topology=topology)
    master.set_panel(Panel(run=True, frequency_hz=40.0))
    bench.wait(20)
    assert (master.frequency_hz, slave.frequency_hz) == (40.0, 40.0)


def test_the_telegram_is_s_to_all_in_hundredths_of_a_percent_of_fh() -> None:
    bench, master, _ = _line()
    master.set_panel(Panel(frequency_hz=40.0))
    bench.heard.clear()
    bench.wait(0.05)
    assert bench.heard[-1].data == seal(bytes.fromhex("FF 53 FA 01 13 88"))
    master.trip("OC1")
    bench.wait(0.05)
    assert bench.heard[-1].data == seal(bytes.fromhex("FF 73 FA 01 13 88"))


def test_a_four_wire_port_sends_to_fa05() -> None:
    bench = Bench(series="vf-as1")
    parameters = {
        "inverter_number": 1,
        "inter_drive_mode_4_wire": SENDS_COMMAND,
        "baud_rate_4_wire": 1,
    }
    settings = InverterSettings(parameters=parameters, port="four_wire")
    master = bench.add(settings=settings)
    heard: list[bytes] = []
    bench.line.taps.append(lambda sent: heard.append(sent.data))
    master.set_panel(Panel(frequency_hz=80.0))
    bench.wait(0.1)
    assert heard[-1] == seal(bytes.fromhex("FF 53 FA 05 27 10"))


def test_a_master_may_send_its_output_frequency() -> None:
    bench, master, slave = _line(master_role=SENDS_OUTPUT)
    master.set_panel(Panel(run=True, frequency_hz=40.0))
    bench.wait(2)
    assert slave.set_point_hz == pytest.approx(master.frequency_hz, abs=0.6)
    assert slave.set_point_hz < 30


@pytest.mark.parametrize(
    ("role", "set_point_hz", "trip"), [(ZERO, 0.0, ""), (KEEP, 40.0, ""), (TRIP, 40.0, "E")]
)
def test_what_a_slave_does_when_its_master_trips(role: int, set_point_hz: float, trip: str) -> None:
    bench, master, slave = _line(slave_role=role)
    master.set_panel(Panel(run=True, frequency_hz=40.0))
    bench.wait(20)
    master.trip("OC1")
    bench.wait(1)
    assert slave.set_point_hz == set_point_hz
    assert slave.trip_display == trip


def test_a_set_point_with_a_wrong_sum_is_neither_taken_nor_answered() -> None:
    bench = Bench()
    drive = bench.add(11)
    frame = bytearray(seal(bytes.fromhex("0B 53 FA 01 13 88")))
    frame[-1] ^= 1
    assert bench.send(bytes(frame)) == []
    assert drive.read_word("FA01") == 0


def test_slaves_notice_by_their_time_out_that_the_master_is_gone() -> None:
    bench, master, slave = _line()
    slave.set_parameter("communication_timeout", 1)
    bench.wait(5)
    assert not slave.tripped
    master.power_off()
    bench.wait(1.1)
    assert slave.trip_display == "Err5"
    slave.reset()
    master.power_on()
    bench.wait(5)
    assert not slave.tripped


def test_a_master_follows_nobody_and_stops_sending_when_it_is_one_no_more() -> None:
    bench, master, _ = _line()
    before = master.read_word("FA01")
    bench.port.transmit(seal(bytes.fromhex("01 53 FA 01 13 88")))
    bench.wait(0.1)
    assert master.read_word("FA01") == before
    master.set_parameter("inter_drive_mode", ZERO)
    bench.wait(0.1)
    bench.heard.clear()
    bench.wait(1)
    assert bench.heard == []
    master.set_parameter("inter_drive_mode", SENDS_OUTPUT)
    bench.wait(0.1)
    assert bench.heard != []


def test_a_modbus_inverter_sends_nothing_of_its_own() -> None:
    bench = Bench()
    bench.add(1, {"inter_drive_mode": SENDS_COMMAND, "protocol_selection": 1})
    bench.wait(1)
    assert bench.heard == []


def test_series_without_the_parameter_take_s_of_a_tripped_master_as_a_set_point() -> None:
    series = CATALOG.drive("vf-nc1")
    bench = Bench(series=series)
    drive = Inverter(bench.kernel, Line(bench.kernel), series)
    port = drive.communication.facts
    assert port.inter_drive is None
    drive.follow(port, 0xFA01, 5000, master_tripped=True)
    assert drive.read_parameter("FA01") == 40.0


def test_a_master_waits_while_another_sends() -> None:
    bench, _, _ = _line()
    sent: list[tuple[bool, int, int]] = []
    bench.line.taps.append(
        lambda one: sent.append((one.sender is bench.port, one.start_ns, one.end_ns))
    )
    for _ in range(40):
        bench.wait(0.0117)
        if not bench.port.pair.busy:
            bench.port.transmit(seal(bytes.fromhex("05 50 FA 01 13 88")))
    own = [(start, end) for ours, start, end in sent if ours]
    masters = [start for ours, start, _ in sent if not ours]
    assert len(own) > 5
    assert len(masters) > 3
    assert not [start for start in masters if any(begin < start < end for begin, end in own)]
