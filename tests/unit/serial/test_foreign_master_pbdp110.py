"""pyprofibus runs a PBDP-110: a module of its choice, the diagnosis of a drive that has tripped."""

import sys
from contextlib import closing

import pytest

from fbgen.catalog import load_catalog
from harness.drives import Inverter, InverterSettings
from harness.fieldbus import ControlCommand
from harness.gateways.pbdp110 import Pbdp110, drive_facts, pbdp110_settings
from harness.kernel import Kernel
from harness.line import Line
from tests.unit.serial.foreign_master import SLAVE, Interplay

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")
PARAMETERS = {"baud_rate": 4, "parity": 1, "maximum_frequency": 80.0}
FORWARD_30_HZ = bytes.fromhex("C4 00 0B B8")


def test_a_foreign_master_runs_a_drive_at_the_pbdp110_and_fetches_its_diagnosis():
    catalog, kernel = load_catalog(), Kernel()
    interface, series = catalog.process_data_gateway("pbdp110"), catalog.drive("vf-s11")
    lines = {name: Line(kernel) for name in "ab"}
    known = dict.fromkeys("ab", drive_facts(series))
    settings = pbdp110_settings(interface, interface.layout("module2"), {}, known)
    device = Pbdp110(kernel, settings, lines, SLAVE, "gw1")
    drive = Inverter(kernel, lines["a"], series, InverterSettings("a", PARAMETERS))
    compact = interface.layout("module3")
    sizes = (compact.output_length, compact.input_length)
    ident = device.slave.type.ident_number
    device.supply("a", True)
    device.power_on()
    with closing(Interplay(kernel, device.slave, compact.identifiers, sizes, ident)) as both:
        both.until(bool)
        assert len(both.inputs) == 8
        both.outputs = FORWARD_30_HZ
        both.skip_ms(200)
        for _ in range(20):
            both.exchanges(1)
            both.skip_ms(100)
        both.until(lambda inputs: inputs[0] & 0x84 == 0x84)
        assert drive.running

        drive.trip("OC1")
        both.skip_ms(250)
        both.until(lambda inputs: both.slave.ext_diag)
        assert both.slave.diagnosis_waiting
        both.until(lambda inputs: not both.slave.diagnosis_waiting)
        assert both.diagnosis().hasExtDiag()
        assert both.slave.slave_diag()[6:] == b"\x02\x01"

        both.master.global_control(ControlCommand.CLEAR_DATA)
        both.server.step()
        assert both.slave.outputs == bytes(4)
