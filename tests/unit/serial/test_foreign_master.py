"""pyprofibus, a DP master that others wrote, with our slave at the other end of the wire."""

import sys

import pytest

from harness.fieldbus import ControlCommand, SlaveState
from tests.unit.serial.foreign_master import WATCHDOG_MS, interplay
from tests.vectors.reading import entries

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")

EXAMPLE = [
    entry
    for entry in entries("tospbdp001_telegrams").values()
    if entry["id"].startswith("tos.g.row")
]
CURRENT = 2
"""Row of the example whose last two bytes are the motor's current, which is another motor's."""


@pytest.mark.parametrize("layout", ["gsd10", "doc9", "whole10"])
@pytest.mark.fact("dp.state")
def test_the_manuals_example_by_a_foreign_master(layout):
    configuration = bytes.fromhex("C08987") if layout == "whole10" else None
    with interplay(layout, configuration) as both:
        both.until(bool)
        assert both.slave.state is SlaveState.DATA_EXCHANGE
        for number, row in enumerate(EXAMPLE[:4]):
            both.telegram(row["send"])
            wanted = bytes.fromhex(row["receive"])
            told = 6 if number == CURRENT else 8
            both.until(lambda inputs, wanted=wanted, told=told: inputs[:told] == wanted[:told])
        drive = both.drive
        assert drive.set_point_hz == 50.0
        assert not drive.tripped
        assert both.segment.skipped == 0


def test_a_foreign_master_syncs_freezes_and_clears():
    with interplay() as both:
        both.until(bool)
        slave, master = both.slave, both.master
        master.dpm.syncMode(0)
        both.outputs = b"\x00\x01" + bytes(8)
        both.exchanges()
        assert slave.outputs == bytes(10)
        master.dpm.syncMode(0)
        both.until(lambda inputs: slave.outputs == both.outputs)
        master.dpm.syncModeCancel(0)
        both.outputs = b"\x00\x02" + bytes(8)
        both.until(lambda inputs: slave.outputs == both.outputs)

        master.dpm.freezeMode(0)
        both.until(lambda inputs: slave.freeze)
        both.telegram("E0 00 01 0B 47 FC 90 00 00")
        both.until(lambda inputs: both.gateway.telegrams == 1)
        both.skip_ms(100)
        both.exchanges()
        assert slave.inputs[2:] == bytes(6)
        master.dpm.freezeModeCancel(0)
        both.until(lambda inputs: inputs[2:4] == b"\x0b\x47")

        master.global_control(ControlCommand.CLEAR_DATA)
        both.server.step()
        assert slave.outputs == bytes(10)


def test_the_watchdog_expires_without_the_foreign_master_which_then_gets_the_slave_back():
    with interplay() as both:
        both.until(bool)
        both.skip_ms(WATCHDOG_MS // 2)
        assert both.slave.online
        both.skip_ms(WATCHDOG_MS // 2)
        assert not both.slave.online
        assert both.slave.state is SlaveState.WAIT_PRM
        both.until(lambda inputs: both.slave.online)
        both.exchanges()


def test_a_foreign_master_is_told_of_a_wrong_configuration(capsys):
    with interplay(configuration=bytes.fromhex("30 30 20 30 30 70 70")) as both:
        both.until(lambda inputs: "faulty configuration" in capsys.readouterr().out)
        assert both.slave.cfg_fault or both.slave.state is not SlaveState.DATA_EXCHANGE
        assert not both.slave.online


def test_a_foreign_master_is_told_of_a_wrong_ident_number():
    with interplay(ident=0x1804) as both:
        both.until(lambda inputs: both.slave.prm_fault)
        told = both.diagnosis()
        assert told.prmFault()
        assert told.notReady()
        assert told.prmReq()
        assert (told.identNumber, told.masterAddr) == (0x1803, 255)
        assert not both.slave.online


def test_a_foreign_master_fetches_the_diagnosis_that_the_device_reports():
    with interplay() as both:
        both.until(bool)
        both.slave.set_ext_diag(True)
        both.until(lambda inputs: not both.slave.diagnosis_waiting)
        both.exchanges()
        assert both.slave.online


def test_a_foreign_master_begins_anew_after_the_supply_was_gone():
    with interplay() as both:
        both.until(bool)
        both.gateway.power_off()
        both.until(lambda inputs: not both.master.slave.isConnected())
        both.gateway.power_on()
        both.until(lambda inputs: both.slave.online)
        both.exchanges()
