"""RET_VAL of DPRD_DAT and DPWR_DAT on both families, and what each call moves."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.types import BOOL, BYTE, CHAR, WORD, ArrayType, StringType, StructType
from harness.plc import CpuFamily, DpInterface

ALL = [CpuFamily.S7_300, CpuFamily.S7_400, CpuFamily.S7_1200, CpuFamily.S7_1500]
NEW = [CpuFamily.S7_1200, CpuFamily.S7_1500]
WHOLE = "C0 89 87"
INPUTS = bytes.fromhex("9F 00 0B 50 FA 00 C4 00")


def code(ret_val: object) -> int:
    assert isinstance(ret_val, int)
    assert -0x8000 <= ret_val <= 0x7FFF
    return ret_val & 0xFFFF


def started(rig):
    rig.slave.set_inputs(INPUTS)
    return rig.start()


@pytest.mark.parametrize("family", ALL)
def test_one_consistent_identifier_moves_the_whole_frame(make_rig, record_of, family):
    rig = started(make_rig(WHOLE, process_image=False, family=family))
    record = record_of(8)
    assert code(rig.dprd(256, record)) == 0
    assert record.data == INPUTS
    outputs = record_of(10)
    assert code(rig.dpwr(256, outputs)) == 0
    rig.run_ms(4)
    assert rig.received[0][1] == "ee" * 10


@pytest.mark.parametrize("family", NEW)
def test_a_whole_frame_call_on_the_printed_gsd_moves_one_byte_and_says_0000(
    make_rig, record_of, family
):
    rig = started(make_rig(process_image=False, family=family))
    record = record_of(8)
    assert code(rig.dprd(256, record)) == 0
    rest = b"\0" * 7 if family is CpuFamily.S7_1500 else b"\xee" * 7
    assert record.data == b"\x9f" + rest
    assert code(rig.dpwr(256, record_of(10))) == 0
    rig.run_ms(4)
    assert rig.received[0][1] == "ee" + "00" * 9


def test_a_whole_frame_call_on_the_printed_gsd_is_80b1_on_the_classic_families(
    make_rig, record_of, classic
):
    rig = started(make_rig(process_image=False, family=classic))
    record = record_of(8)
    assert code(rig.dprd(256, record)) == 0x80B1
    assert code(rig.dpwr(256, record_of(10))) == 0x80B1
    rig.run_ms(4)
    assert record.data == b"\xee" * 8
    assert rig.received == []


@pytest.mark.parametrize("family", ALL)
def test_one_call_reaches_the_identifier_at_its_address(make_rig, record_of, family):
    rig = started(make_rig(process_image=False, family=family))
    comno = record_of(2)
    assert code(rig.dprd(260, comno)) == 0
    assert comno.data == bytes.fromhex("FA 00")
    assert code(rig.dpwr(261, comno)) == 0
    rig.run_ms(4)
    assert rig.received[0][1] == "0000000000fa00000000"


@pytest.mark.parametrize("family", NEW)
def test_hardware_identifiers_count_the_modules(make_rig, record_of, family):
    rig = started(make_rig(process_image=False, family=family, hardware_identifier=270))
    comno = record_of(2)
    assert code(rig.dprd(275, comno)) == 0
    assert comno.data == bytes.fromhex("FA 00")
    assert code(rig.dprd(256, comno)) == 0x8090


def test_a_classic_cpu_takes_addresses_even_where_a_hardware_identifier_is_known(
    make_rig, record_of, classic
):
    rig = started(make_rig(process_image=False, family=classic, hardware_identifier=270))
    assert code(rig.dprd(260, record_of(2))) == 0


@pytest.mark.parametrize("family", ALL)
@pytest.mark.parametrize("laddr", [0, 261, 1000])
def test_8090_where_no_module_begins(make_rig, record_of, family, laddr):
    rig = started(make_rig(WHOLE, process_image=False, family=family))
    assert code(rig.dprd(laddr, record_of(8))) == 0x8090
    assert code(rig.dpwr(laddr, record_of(10))) == 0x8090


@pytest.mark.parametrize("family", NEW)
def test_8093_where_the_module_has_no_inputs(make_rig, record_of, family):
    rig = started(make_rig(process_image=False, family=family, hardware_identifier=270))
    assert code(rig.dprd(272, record_of(1))) == 0x8093


@pytest.mark.parametrize("family", ALL)
def test_80b1_where_the_record_is_too_short(make_rig, record_of, family):
    rig = started(make_rig(WHOLE, process_image=False, family=family))
    assert code(rig.dprd(256, record_of(7))) == 0x80B1
    assert code(rig.dpwr(256, record_of(9))) == 0x80B1


@pytest.mark.parametrize(
    ("kind", "families"),
    [
        (ArrayType(((0, 7),), CHAR), NEW),
        (ArrayType(((0, 3),), WORD), NEW),
        (ArrayType(((0, 7),), BYTE), ALL),
        (StructType("frame", ()), ALL),
        (ArrayType(((0, 63),), BOOL), []),
        (StringType(6), []),
    ],
)
@pytest.mark.parametrize("family", ALL)
def test_8092_for_types_that_the_family_does_not_take(make_rig, record_of, family, kind, families):
    rig = started(make_rig(WHOLE, process_image=False, family=family))
    assert code(rig.dprd(256, record_of(8, kind))) == (0 if family in families else 0x8092)
    assert code(rig.dpwr(256, record_of(10, kind))) == (0 if family in families else 0x8092)


@pytest.mark.parametrize("family", ALL)
def test_80a0_and_80a1_while_the_slave_has_failed(make_rig, record_of, family):
    rig = started(make_rig(WHOLE, process_image=False, family=family))
    rig.slave.power_off()
    rig.run_ms(4)
    assert code(rig.dprd(256, record_of(8))) == 0x80A0
    assert code(rig.dpwr(256, record_of(10))) == 0x80A1


@pytest.mark.parametrize("family", ALL)
def test_80c0_before_the_first_data_were_read(make_rig, record_of, family):
    rig = make_rig(WHOLE, process_image=False, family=family)
    rig.slave.power_on(5)
    rig.cpu.start()
    rig.run_ms(3)
    assert code(rig.dprd(256, record_of(8))) == 0x80C0


def test_80b0_behind_an_external_dp_interface(make_rig, record_of, classic):
    rig = started(
        make_rig(WHOLE, process_image=False, family=classic, dp_interface=DpInterface.EXTERNAL)
    )
    rig.slave.power_off()
    rig.run_ms(4)
    assert code(rig.dprd(256, record_of(8))) == 0x80B0


@pytest.mark.parametrize("family", ALL)
def test_80c1_behind_an_external_dp_interface_until_the_write_has_gone(make_rig, record_of, family):
    rig = started(
        make_rig(WHOLE, process_image=False, family=family, dp_interface=DpInterface.EXTERNAL)
    )
    assert code(rig.dpwr(256, record_of(10))) == 0
    assert code(rig.dpwr(256, record_of(10))) == 0x80C1
    rig.run_ms(4)
    assert code(rig.dpwr(256, record_of(10))) == 0


@pytest.mark.parametrize("ret_val", [0x80B2, 0x80B3, 0x80C2, 0x80F1, 0x8081, 0x8730, 0x8540])
def test_system_errors_are_given_on_demand(make_rig, record_of, ret_val):
    rig = started(make_rig(WHOLE, process_image=False, family=CpuFamily.S7_300))
    rig.cpu.consistent_data.answer_with(ret_val, calls=2)
    record = record_of(8)
    assert code(rig.dprd(256, record)) == ret_val
    assert code(rig.dpwr(256, record_of(10))) == ret_val
    assert record.data == b"\xee" * 8
    assert code(rig.dprd(256, record)) == 0


@pytest.mark.fact("tos.s7")
def test_several_telegrams_in_one_scan_need_the_instruction(make_rig, record_of):
    def telegrams(rig) -> None:
        for trigger in (1, 2, 3):
            record = record_of(10)
            record.data[:] = bytes([trigger]) * 10
            rig.dpwr(256, record)
            rig.cpu.outputs[256:266] = record.data

    direct = make_rig(WHOLE, process_image=False, instruction_ns=2_500_000).start()
    direct.body(lambda: telegrams(direct))
    direct.run_ms(19)
    assert [data[:2] for _, data in direct.received] == ["01", "02", "03"]
    image = make_rig(WHOLE, instruction_ns=0).start()
    image.body(lambda: [image.cpu.outputs.__setitem__(256, n) for n in (1, 2, 3)])
    image.run_ms(19)
    assert [data[:2] for _, data in image.received] == ["03"]


@pytest.mark.parametrize("name", ["SFC14", "DPRD_DAT"])
def test_the_instruction_is_known_by_both_names(make_rig, record_of, name):
    rig = started(make_rig(WHOLE, process_image=False))
    record = record_of(8)
    arguments = {"LADDR": 256, "RECORD": record}
    assert rig.cpu.instruction(name, arguments, rig.program.blocks["main"].span) == 0
    assert record.data == INPUTS


def test_a_write_brings_the_process_image_up_to_date_where_it_is_mapped(make_rig, record_of):
    mapped = started(make_rig())
    mapped.dpwr(261, record_of(2))
    assert mapped.cpu.outputs[256:266].hex() == "0000000000eeee000000"
    mapped.run_ms(30)
    assert [data for _, data in mapped.received] == ["0000000000eeee000000"]
    apart = started(make_rig(process_image=False))
    apart.dpwr(261, record_of(2))
    assert not any(apart.cpu.outputs)


def test_a_read_leaves_the_input_image_alone(make_rig, record_of):
    rig = make_rig(WHOLE).start()
    rig.slave.set_inputs(INPUTS)
    rig.run_ms(3)
    rig.dprd(256, record_of(8))
    assert not any(rig.cpu.inputs)


def test_an_iec_controller_has_no_such_instruction(make_rig, record_of):
    rig = make_rig(family=CpuFamily.IEC)
    with pytest.raises(DiagnosticError) as caught:
        rig.dprd(256, record_of(1))
    found = caught.value.diagnostics[0]
    assert (found.code, found.span is not None) == ("FB7406", True)


def test_a_record_that_is_no_variable_is_refused(make_rig):
    rig = make_rig()
    with pytest.raises(DiagnosticError) as caught:
        rig.dprd(256, 3)
    assert caught.value.diagnostics[0].code == "FB7407"
