"""Between CPU and master data are consistent only as far as one identifier says."""

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.fieldbus import CycleTimes
from harness.plc import Mounting

NEW = bytes(range(1, 11))
WHOLE = "C0 89 87"


def test_a_torn_process_image_lets_the_trigger_out_before_the_data_behind_it(make_rig):
    rig = make_rig().start()
    rig.cpu.link.tear_next_write(rig.station, behind=3)
    rig.body(lambda: rig.cpu.outputs.__setitem__(slice(256, 266), NEW))
    rig.run_ms(15)
    assert [data for _, data in rig.received] == ["01020300000000000000", NEW.hex()]


def test_without_demand_or_seed_nothing_is_torn(make_rig):
    rig = make_rig().start()
    rig.body(lambda: rig.cpu.outputs.__setitem__(slice(256, 266), NEW))
    rig.run_ms(15)
    assert [data for _, data in rig.received] == [NEW.hex()]


def test_by_seed_a_transfer_is_torn_at_every_boundary_and_nowhere_else(make_rig):
    rig = make_rig(tear_probability=1.0, seed=5)
    rig.body(lambda: rig.cpu.outputs.__setitem__(slice(256, 266), bytes([rig.cpu.scans]) * 10))
    rig.start()
    rig.run_ms(2_000)
    seen = [bytes.fromhex(data) for _, data in rig.received if data != "online"]
    cuts = {data.index(data[-1]) for data in seen if data[0] != data[-1]}
    assert cuts == {1, 2, 3, 4, 5, 7, 8}  # never inside the words at 5 and 8


def test_a_consistent_identifier_is_never_torn(make_rig, record_of):
    rig = make_rig(WHOLE, tear_probability=1.0).start()
    rig.body(lambda: rig.dpwr(256, record_of(10)))
    rig.run_ms(15)
    assert [data for _, data in rig.received] == ["ee" * 10]
    with pytest.raises(DiagnosticError) as caught:
        rig.cpu.link.tear_next_write(rig.station, behind=1)
    assert caught.value.diagnostics[0].code == "FB7403"


def test_torn_inputs_have_an_old_front_and_a_new_rear(make_rig):
    rig = make_rig(times=CycleTimes(phase_ns=500_000)).start()
    seen: list[str] = []
    rig.body(lambda: seen.append(rig.cpu.inputs[256:264].hex()))
    rig.cpu.link.tear_next_read(rig.station, behind=5)
    rig.run_ms(9.5)
    rig.slave.set_inputs(NEW[:8])
    rig.run_ms(20)
    assert seen[-2:] == ["0000000005060708", NEW[:8].hex()]


def test_a_read_is_torn_only_when_the_cycle_brings_something_new(make_rig):
    rig = make_rig(process_image=False).start()
    rig.cpu.link.tear_next_read(rig.station, behind=1)
    assert rig.cpu.link.read(rig.station, 0, 8) == bytes(8)
    rig.slave.set_inputs(NEW[:8])
    assert rig.cpu.link.read(rig.station, 0, 8) == b"\0" + NEW[1:8]
    assert rig.cpu.link.read(rig.station, 0, 8) == NEW[:8]
    assert rig.cpu.link.torn == 1


def test_a_demand_waits_for_a_transfer_that_reaches_over_its_place(make_rig):
    rig = make_rig(process_image=False).start()
    rig.cpu.link.tear_next_write(rig.station, behind=3)
    rig.cpu.link.write(rig.station, 0, b"\x01\x02")
    assert rig.cpu.link.torn == 0
    rig.cpu.link.write(rig.station, 2, b"\x03\x04")
    assert rig.cpu.link.torn == 1


@pytest.mark.parametrize("behind", [0, 8, 9])
def test_a_place_that_is_none_is_refused(make_rig, behind):
    rig = make_rig()
    with pytest.raises(DiagnosticError) as caught:
        rig.cpu.link.tear_next_write(rig.station, behind)
    assert caught.value.diagnostics[0].code == "FB7403"


def test_inputs_cannot_be_torn_behind_a_module_that_has_none(make_rig):
    rig = make_rig()
    with pytest.raises(DiagnosticError) as caught:
        rig.cpu.link.tear_next_read(rig.station, behind=3)
    assert caught.value.diagnostics[0].code == "FB7403"


def test_cycles_fall_between_two_direct_accesses_of_one_scan(make_rig):
    rig = make_rig(process_image=False, peripheral_ns=1_500_000).start()

    def body() -> None:
        rig.cpu.write_peripheral(264, 2, 0xC400)
        rig.cpu.write_peripheral(258, 1, 1)

    rig.body(body)
    rig.run_ms(15)
    assert [data for _, data in rig.received] == ["0000000000000000c400", "0000010000000000c400"]


def test_peripheral_words_are_big_endian(make_rig):
    rig = make_rig(process_image=False).start()
    rig.cpu.write_peripheral(261, 2, 0xFA01)
    rig.slave.set_inputs(bytes.fromhex("9F000B50FA01C400"))
    rig.run_ms(4)
    assert rig.station.outputs[5:7].hex() == "fa01"
    assert rig.cpu.read_peripheral(260, 2) == 0xFA01
    assert rig.cpu.read_peripheral(256, 4) == 0x9F000B50
    assert rig.cpu.read_peripheral(258, 1) == 0x0B


def test_two_stations_cannot_share_an_address(make_rig):
    rig = make_rig()
    with pytest.raises(DiagnosticError) as caught:
        rig.cpu.mount(Mounting(rig.station, process_image=False))
    assert caught.value.diagnostics[0].code == "FB7402"


def test_addresses_behind_the_process_image_are_refused(make_rig):
    with pytest.raises(DiagnosticError) as caught:
        make_rig(memory_bytes=260)
    assert caught.value.diagnostics[0].code == "FB7402"


@pytest.mark.parametrize("byte", [263, 700])
def test_an_access_that_reaches_over_the_end_of_a_module_reads_0_and_writes_nothing(make_rig, byte):
    rig = make_rig(process_image=False).start()
    rig.slave.set_inputs(NEW[:8])
    rig.run_ms(4)
    assert rig.cpu.read_peripheral(byte, 2) == 0
    rig.cpu.write_peripheral(byte + 2, 2, 0xFFFF)
    assert rig.cpu.access_errors == 2
    assert rig.station.outputs == bytes(10)
