"""`fbgen test --port` with a plant that has serial lines: real inverters at a communication module.

As in `test_real_drives`, the inverters are simulated on a clock of their own.
"""

from collections.abc import Callable
from functools import partial
from pathlib import Path

import pytest

from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Parity, SerialFormat
from harness.scenario import real_drives
from harness.serial import LineSetting
from tests.unit.cli.running import Fbgen, Run
from tests.unit.serial.master_port import MasterPort
from tests.unit.serial.virtual_port import ServedLine

ROOT = Path(__file__).parents[3]
PLANT = """\
version: 1
name: hall
dialect: tia
plc: s7-1500
serial:
  - name: line1
    hardware_identifier: 270
    protocol: {protocol}
    baud: {baud}
    parity: {parity}
    drives:
      - {{name: pump, inv_no: 11, series: vf-s11, max_frequency_hz: 50.0}}
      - {{name: fan, inv_no: 12, series: vf-s11, max_frequency_hz: 50.0}}
"""
RUN = """\
version: 1
title: With a real pump
plant: plant.yaml
steps:
  - expect:
      plc.TOS_Plant.line1.pump.polled.valid: true
      plc.TOS_Plant.line1.fan.polled.valid: true
    within: 3 s
  - set:
      plc.TOS_Plant.line1.pump.control.enable: true
      plc.TOS_Plant.line1.pump.control.interlock: true
      plc.TOS_Plant.line1.pump.control.frequency: 20.0
  - expect: {plc.TOS_Plant.line1.pump.state.ready: true}
    within: 3 s
  - set: {plc.TOS_Plant.line1.pump.control.run: true}
  - expect: {plc.TOS_Plant.line1.pump.state.running: true}
    within: 3 s
  - expect: {plc.TOS_Plant.line1.line.errorCount: 0}
"""
NINE = SerialFormat(9_600, Parity.ODD, 1)

Test = Callable[..., tuple[Run, MasterPort]]


class Torn(MasterPort):
    """An adapter that gives what came in pieces of three bytes, with 12 ms between them."""

    def __init__(self, line: ServedLine) -> None:
        super().__init__(line)
        self._pieces = b""
        self._not_before_ns = 0

    def read(self, wait_s: float = 0.01) -> bytes:
        if self._pieces:
            wait_s = min(wait_s, max(self._not_before_ns - self.clock(), 0) / NS_PER_S)
        self._pieces += super().read(wait_s)
        if self.clock() < self._not_before_ns or not self._pieces:
            return b""
        found, self._pieces = self._pieces[:3], self._pieces[3:]
        self._not_before_ns = self.clock() + 12 * NS_PER_MS
        return found


@pytest.fixture
def run(fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Test:
    """Run a scenario with a port at which inverter 11 is."""

    def run(
        protocol: str,
        port_of: Callable[[ServedLine], MasterPort] = MasterPort,
        text: str = RUN,
        real: str = "pump",
    ) -> tuple[Run, MasterPort]:
        plant = PLANT.format(protocol=protocol, baud=NINE.baud, parity="odd")
        (tmp_path / "plant.yaml").write_text(plant, "utf-8")
        (tmp_path / "a.scenario.yaml").write_text(text, "utf-8")
        family = "modbus" if protocol == "modbus" else "toshiba"
        port = port_of(ServedLine(11, setting=LineSetting(family, NINE.baud, NINE.parity)))
        for name in ("RealDrives", "stop_drives"):
            patched = partial(getattr(real_drives, name), clock_ns=port.clock)
            monkeypatch.setattr(real_drives, name, patched)
        monkeypatch.setattr("harness.serial.serial_port", lambda name, characters: port)
        options = ("--port", "COM3", "--real", real, "--yes")
        return fbgen("test", str(tmp_path / "a.scenario.yaml"), *options), port

    return run


@pytest.mark.parametrize(
    ("protocol", "start", "stop"),
    [
        ("toshiba_binary", "2F 0B 50 FA 00 C4 00 48", "2F 0B 50 FA 00 80 00 04"),
        ("toshiba_ascii", b"(11PFA00C400&BE)\r".hex(), b"(11PFA008000&AF)\r".hex()),
        ("modbus", "0B 06 FA 00 C4 00 EB 78", "0B 06 FA 00 80 00 D8 78"),
    ],
)
def test_the_module_runs_an_inverter_at_a_port_and_stops_it_behind_the_run(
    run: Test, protocol: str, start: str, stop: str
) -> None:
    done, port = run(protocol)
    assert done.status == 0, done.err
    assert port.characters == NINE
    assert bytes.fromhex(start) in port.sent
    assert port.sent[-1] == bytes.fromhex(stop)


def test_a_reply_that_an_adapter_gives_in_pieces_is_one_message(run: Test) -> None:
    done, _ = run("modbus", Torn)
    assert done.status == 0, done.err


def test_drives_on_devicenet_are_refused(run: Test) -> None:
    folder = ROOT / "examples" / "devicenet"
    text = (folder / "start_stop.scenario.yaml").read_text("utf-8")
    text = text.replace("plant: plant.yaml", f"plant: {(folder / 'plant.yaml').as_posix()}")
    text = text.replace("conveyors.scl", (folder / "conveyors.scl").as_posix())
    done, port = run("modbus", text=text, real="infeed")
    assert done.status == 1
    assert "'infeed' is on DeviceNet" in done.err
    assert port.sent == []
