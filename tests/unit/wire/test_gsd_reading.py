"""GSD files: the language, and what a station is."""

from pathlib import Path

import pytest

from fbgen.catalog import covers_all, placed_identifiers
from fbgen.diagnostics import DiagnosticError
from fbgen.wire.gsd import GsdStation, Rate, SlotDefinition, choose, read_gsd
from fbgen.wire.profibus import Consistency, Extent

ROOT = Path(__file__).parents[3]
ESCO = ROOT / "examples" / "manual_example" / "esco1803.gsd"
MADE_UP = Path(__file__).parent / "made_up_pbdp110.gsd"
HEAD = "#Profibus_DP\nIdent_Number = 0x1234\n"


def station_of(text: str, head: str = HEAD) -> GsdStation:
    return read_gsd((head + text).encode("cp1252"), "some.gsd")


def codes(failure: pytest.ExceptionInfo[DiagnosticError]) -> list[str]:
    return [item.code for item in failure.value.diagnostics]


def test_the_file_of_the_tospbdp001_says_what_its_manual_prints() -> None:
    station = read_gsd(ESCO.read_bytes(), ESCO.name)
    assert station.ident_number == 0x1803
    assert (station.vendor, station.model, station.revision) == (
        "HMS Industrial Networks AB",
        "ANYBUS-C PDP Toshiba Inverter",
        "Version 1.1",
    )
    assert (station.hardware_release, station.software_release) == ("Version 1.4", "Version 1.1")
    assert (station.gsd_revision, station.implementation) == (2, "SPC3")
    assert station.rates == tuple(
        Rate(*pair)
        for pair in (
            ("9.6", 60), ("19.2", 60), ("45.45", 250), ("93.75", 60), ("187.5", 60),
            ("500", 100), ("1.5M", 150), ("3M", 250), ("6M", 450), ("12M", 800),
        )
    )  # fmt: skip
    assert (station.sync, station.freeze, station.auto_baud) == (True, True, True)
    assert (station.set_slave_address, station.fail_safe, station.modular) == (False, False, False)
    assert (station.min_slave_interval_us, station.max_diagnosis_bytes) == (100, 6)
    assert (station.dpv1, station.parameters, station.is_master) == (False, b"", False)
    assert station.unknown == station.warnings == ()


@pytest.mark.fact("tos.io")
def test_its_module_carries_10_bytes_out_and_8_in_where_the_text_of_the_manual_says_9_and_8() -> (
    None
):
    chosen = choose(read_gsd(ESCO.read_bytes(), ESCO.name))
    assert [module.name for module in chosen.modules] == ["Binary Mode"]
    assert chosen.code == bytes.fromhex("3030203030702070")
    assert (chosen.output_length, chosen.input_length) == (10, 8)
    assert all(
        extent.consistency is Consistency.UNIT
        for identifier in chosen.identifiers
        for extent in (identifier.outputs, identifier.inputs)
        if extent is not None
    )


def test_a_modular_station_has_modules_slots_parameters_and_texts_of_diagnosis() -> None:
    station = read_gsd(MADE_UP.read_bytes(), MADE_UP.name)
    assert station.modular
    assert (station.limits.modules, station.limits.data) == (1, 80)
    lengths = [(module.output_length, module.input_length) for module in station.modules]
    assert lengths == [(16, 24), (32, 48), (4, 8), (8, 16)]
    assert [module.reference for module in station.modules] == [1, 2, 3, 4]
    assert station.slots == (SlotDefinition(1, "Drives", 1, ((1, 4),)),)
    assert station.parameters == b"\x01"
    assert [(one.first, one.text) for one in station.diagnosis] == [
        (0, "Drive A has tripped"),
        (4, "Drive B has tripped"),
    ]
    assert station.modules[0].identifiers[0].outputs == Extent(8, 2)
    assert station.warnings == ()


@pytest.mark.parametrize(
    "text",
    [
        'Module = "One" 0x30,0x20\nEndModule\n',
        'MODULE="One"0x30,0x20\nendmodule\n',
        'Module = "One" \\\n 0x30, \\ ; out and in\n 0x20 ; out\nEndModule ; of One\n',
        'Module = "O\\\nne" 48,32\nEndModule',
        '; Module = "Two" 0x10\\\nModule\t=\t"One"\t0X30 0x20,\r\nEndModule\r\n',
    ],
)
def test_spaces_case_comments_and_continued_lines_change_nothing(text: str) -> None:
    (module,) = station_of(text).modules
    assert (module.name, module.code) == ("One", b"\x30\x20")


def test_lines_may_end_in_three_ways_and_places_stay_right() -> None:
    for end in ("\n", "\r\n", "\r"):
        text = f'#Profibus_DP{end}{end}Ident_Number = 1{end}  Module "One" 256{end}EndModule'
        with pytest.raises(DiagnosticError) as failure:
            read_gsd(text.encode(), "some.gsd")
        (found,) = failure.value.diagnostics
        assert found.span is not None
        assert (found.code, found.span.line, found.span.column) == ("FB1303", 4, 16)


def test_texts_of_the_windows_code_page_and_of_utf_8_are_read() -> None:
    line = 'Vendor_Name = "Größe ½ €"\n'
    for data in (line.encode("cp1252"), line.encode(), b"\xef\xbb\xbf" + line.encode()):
        head = HEAD.encode() if not data.startswith(b"\xef") else b""
        text = head + data if head else data[:3] + HEAD.encode() + data[3:]
        assert read_gsd(text, "some.gsg").vendor == "Größe ½ €"
    assert read_gsd(("\ufeff" + HEAD + line).encode("utf-16-le"), "some.gsd").vendor == "Größe ½ €"
    assert read_gsd(HEAD.encode() + b'Vendor_Name = "\x81"', "some.gsd").vendor == "\x81"


def test_what_stands_outside_of_the_profibus_part_is_for_others() -> None:
    text = 'Ident_Number = 1\n"\n#Profibus_DP\nIdent_Number = 2\n#Other\nIdent_Number = 3\n'
    station = read_gsd(text.encode(), "some.gsd")
    assert (station.ident_number, station.warnings) == (2, ())


def test_an_unknown_keyword_is_kept_with_whatever_stands_behind_it() -> None:
    station = station_of('Makers_Own(3) = "text", 5-7 @ ! 0x\nSlave_Family = 3@Digital@24V\n')
    (kept,) = station.unknown
    assert (kept.keyword, kept.index) == ("Makers_Own", (3,))
    assert station.warnings == ()


def test_user_parameters_are_preset_bits_words_and_negative_numbers() -> None:
    station = station_of(
        """
ExtUserPrmData = 1 "a bit"
Bit(3) 1 0-1
EndExtUserPrmData
ExtUserPrmData = 2 "some bits"
BitArea(4-6) 5 0-7
EndExtUserPrmData
ExtUserPrmData = 3 "a word"
Unsigned16 0x1388 0-65535
EndExtUserPrmData
ExtUserPrmData = 4 "a number below 0"
Signed8 -2 -10-10
EndExtUserPrmData
Ext_User_Prm_Data_Const(0) = 0x80,0x01,0x00,\\
                             0x00
Ext_User_Prm_Data_Ref(1) = 1
Ext_User_Prm_Data_Ref(1) = 2
Ext_User_Prm_Data_Ref(2) = 3
Ext_User_Prm_Data_Ref(4) = 4
Module = "One" 0x30
Ext_Module_Prm_Data_Len = 2
Ext_User_Prm_Data_Const(0) = 0x07
EndModule
"""
    )
    assert station.parameters == bytes.fromhex("80 59 13 88 FE")
    assert choose(station).user_parameters == bytes.fromhex("80 59 13 88 FE 07 00")


def test_older_files_have_their_user_parameters_as_bytes() -> None:
    station = station_of("User_Prm_Data_Len = 2\nUser_Prm_Data = 1,0xFF\n")
    assert (station.parameters, station.warnings) == (b"\x01\xff", ())


def test_areas_of_diagnosis_and_blocks_that_are_not_needed_are_read_over() -> None:
    station = station_of(
        """
Unit_Diag_Area = 8-15
Value(1) = "Cable"
Value(2) = "Fuse"
Unit_Diag_Area_End
UnitDiagType = 2
X_Unit_Diag_Area = 24-27
X_Value(1) = "Other"
X_Unit_Diag_Area_End
EndUnitDiagType
Physical_Interface = 0
Module = "One" 0x30
Info_Text = "the only one"
Data_Area_Beg
Length = 1
Data_Area_End
EndModule
"""
    )
    assert [(one.first, one.last, one.value, one.text) for one in station.diagnosis] == [
        (8, 15, 1, "Cable"),
        (8, 15, 2, "Fuse"),
    ]
    assert [(module.name, module.info) for module in station.modules] == [("One", "the only one")]
    assert station.warnings == ()


TWO = station_of(
    'Modular_Station = 1\nMax_Module = 2\nMax_Output_Len = 3\nModule = "In" 0x11\n1\nEndModule\n'
    'Module = "Out" 0x21\n2\nEndModule\n'
    'SlotDefinition\nSlot(1) = "First" 1 1,3\nSlot(2) = "Second" 1 1-2\nEndSlotDefinition\n'
)


def test_modules_are_plugged_in_the_order_of_their_names() -> None:
    chosen = choose(TWO, ("in", "Out"))
    assert chosen.code == b"\x11\x21"
    assert chosen.names == "'In', 'Out'"
    assert choose(TWO, lengths=(2, 0)).code == b"\x21"


@pytest.mark.parametrize(
    ("names", "expected", "message"),
    [
        ((), "FB1311", "some.gsd has 2 modules, and nothing says which of them are plugged"),
        (("Ins",), "FB1310", "some.gsd has no module 'Ins'"),
        (("In", "In", "In"), "FB1311", "some.gsd takes at most 2 modules, not 3"),
        (("Out",), "FB1311", "'Out' cannot be plugged in slot 1, 'First'"),
        (("In", "Out", "Out"), "FB1311", "the modules carry 4 bytes out, some.gsd allows 3"),
    ],
)
def test_modules_that_cannot_be_plugged_are_told(
    names: tuple[str, ...], expected: str, message: str
) -> None:
    with pytest.raises(DiagnosticError) as failure:
        choose(TWO, names)
    assert (expected, message) in [(one.code, one.message) for one in failure.value.diagnostics]


PRESET = station_of(
    "Modular_Station = 1\nMax_Module = 3\nFixPresetModules = 1\n"
    'Module = "Empty" 0x00\n2\nPreset=1\nEndModule\n'
    'Module = "Head" 0xC2,0x83,0x8B,0x0A,0x05\n5\nPreset=1\nEndModule\n'
    'Module = "In  " 0x11\n6\nEndModule\n'
)


def test_preset_modules_are_plugged_and_stay_where_they_cannot_be_pulled() -> None:
    assert choose(PRESET).code == bytes.fromhex("00 C2 83 8B 0A 05")
    assert choose(PRESET, ("In",)).code == bytes.fromhex("00 C2 83 8B 0A 05 11")
    assert covers_all(placed_identifiers(choose(PRESET).code))
    with pytest.raises(DiagnosticError) as failure:
        choose(PRESET, ("In", "In"))
    assert codes(failure) == ["FB1311"]


def test_one_name_for_two_modules_with_other_identifiers_says_nothing() -> None:
    station = station_of('Module = "A" 0x10\nEndModule\nModule = "A" 0x20\nEndModule\n')
    with pytest.raises(DiagnosticError) as failure:
        choose(station, ("A",))
    assert codes(failure) == ["FB1311"]


def test_a_station_without_modules_can_be_shown_but_not_plugged() -> None:
    with pytest.raises(DiagnosticError) as failure:
        choose(station_of("Station_Type = 1\n"))
    assert codes(failure) == ["FB1311"]
