"""A VF-S11 as the LinuxCNC driver vfs11_vfd uses it: MODBUS, 19200 8E1, one word a request.

What that driver does, and nothing of its text: it reads FD01 and FD00 in each round, FC90 if the
trip bit is set and FC91 if the alarm bit is, then FE16, FE27, FE03 and FE05; it writes FA01 and
FA00, 0 to FA00 when the spindle is disabled, and reset and emergency stop once.
"""

from dataclasses import dataclass, field

from drive_bench import Bench

from harness.drives import Inverter

MACHINE = {"protocol_selection": 1.0, "maximum_frequency": 60.0}
MACHINE |= {"acceleration_time": 1.0, "deceleration_time": 1.0}
TRIPPED, ALARM, RUNNING, REVERSE = 1 << 1, 1 << 2, 1 << 10, 1 << 9
RUN, BACKWARD, BOTH_PRIORITIES = 0x0400, 0x0200, 0xC000
RESET, EMERGENCY = 0x2000, 0x1000


@dataclass
class Client:
    """The driver's rounds over one inverter; every request is for one word."""

    bench: Bench
    asked: list[str] = field(default_factory=list)

    def read(self, comno: str) -> int:
        self.asked.append(comno)
        reply = self.bench.ask_modbus(f"01 03 {comno[:2]} {comno[2:]} 00 01")
        assert reply.startswith("01 03 02")
        return int(reply[9:].replace(" ", ""), 16)

    def write(self, comno: str, word: int) -> bool:
        """Whether the write was confirmed."""
        request = f"01 06 {comno[:2]} {comno[2:]} {word >> 8:02X} {word & 0xFF:02X}"
        return self.bench.ask_modbus(request) == request

    def round(self) -> dict[str, int]:
        found = {"FD01": self.read("FD01"), "FD00": self.read("FD00")}
        if found["FD01"] & TRIPPED:
            found["FC90"] = self.read("FC90")
        if found["FD01"] & ALARM:
            found["FC91"] = self.read("FC91")
        for comno in ("FE16", "FE27", "FE03", "FE05"):
            found[comno] = self.read(comno)
        return found

    def spindle(self, hz: float) -> None:
        """Turn at this frequency, negative backwards; 0 disables."""
        if not hz:
            assert self.write("FA00", 0)
            return
        assert self.write("FA01", round(abs(hz) * 100))
        assert self.write("FA00", BOTH_PRIORITIES | RUN | (BACKWARD if hz < 0 else 0))


def _spindle() -> tuple[Client, Inverter]:
    bench = Bench(series="vf-s11")
    return Client(bench), bench.add(1, MACHINE)


def test_a_spindle_turns_both_ways_and_stops() -> None:
    client, drive = _spindle()
    client.spindle(40.0)
    client.bench.wait(2)
    seen = client.round()
    assert seen["FD01"] & (RUNNING | REVERSE) == RUNNING
    assert (seen["FD00"], seen["FE16"]) == (4000, 4000)
    assert seen["FE03"] == drive.read_word("FE03") > 0
    assert seen["FE27"] == round(seen["FE03"] / 100)
    assert seen["FE05"] == 8000
    client.spindle(-40.0)
    client.bench.wait(3)
    assert client.round()["FD01"] & (RUNNING | REVERSE) == RUNNING | REVERSE
    client.spindle(0)
    assert not drive.network_command
    client.bench.wait(30)
    assert not client.round()["FD01"] & RUNNING


def test_trip_and_alarm_are_read_when_their_bits_are_set_and_a_reset_is_sent_once() -> None:
    client, drive = _spindle()
    client.round()
    assert "FC90" not in client.asked
    drive.trip("OC1")
    drive.monitors.alarm = 0x0008
    seen = client.round()
    assert (seen["FC90"], seen["FC91"]) == (drive.trip_code, 0x0008)
    assert not client.write("FA00", RESET), "a reset has no answer"
    client.bench.wait(2)
    assert "FC90" not in client.round()


def test_an_emergency_stop_is_answered_and_trips() -> None:
    client, drive = _spindle()
    client.spindle(40.0)
    assert client.write("FA00", EMERGENCY)
    assert (drive.trip_display, client.round()["FD01"] & TRIPPED) == ("E", TRIPPED)
