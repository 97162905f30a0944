"""One broken GSD file per code: the code and the place of what is wrong."""

from pathlib import Path

import pytest

from fbgen.diagnostics import Diagnostic, DiagnosticError, Severity
from fbgen.pages import severity_of
from fbgen.wire.gsd import read_gsd
from fbgen.wire.gsd.text import MAX_BYTES

BAD = Path(__file__).parents[1] / "bad"
HEAD = "#Profibus_DP\nIdent_Number = 1\n"
FILES = [
    ("FB1301_no_gsd", 1, 1),
    ("FB1302_no_keyword", 3, 1),
    ("FB1303_no_number", 2, 16),
    ("FB1304_cut_off", 3, 1),
    ("FB1305_length_byte", 3, 10),
    ("FB1306_no_ident", 1, 1),
    ("FB1307_twice", 3, 1),
    ("FB1308_misspelt", 3, 1),
    ("FB1309_length", 4, 17),
]


def findings(data: bytes) -> tuple[Diagnostic, ...]:
    try:
        return read_gsd(data, "some.gsd").warnings
    except DiagnosticError as wrong:
        return wrong.diagnostics


@pytest.mark.parametrize(("name", "line", "column"), FILES)
def test_a_broken_file_is_reported_at_its_place(name: str, line: int, column: int) -> None:
    (found,) = findings((BAD / f"{name}.gsd").read_bytes())
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == (name[:6], line, column)
    assert found.severity is severity_of(found.code)
    assert found.help


def test_every_broken_file_is_tried() -> None:
    assert {path.stem for path in BAD.glob("*.gsd")} == {row[0] for row in FILES}


@pytest.mark.parametrize(
    ("text", "code", "message"),
    [
        ('Vendor_Name = "open\n', "FB1303", "the text has no second quote"),
        ("Vendor_Name = HMS\n", "FB1303", "Vendor_Name takes a text in quotes, not HMS"),
        ("Fail_Safe =\n", "FB1303", "Fail_Safe takes a number from 0 to 65535, not nothing"),
        ("9.6_supp = 0x10000\n", "FB1303",
         "9.6_supp takes a number from 0 to 65535, not 0x10000"),
        ("EndModule\n", "FB1304", "EndModule ends nothing"),
        ('PrmText = 1\nModule = "A" 0x10\nEndModule\n', "FB1304",
         "PrmText has no EndPrmText: Module begins before it"),
        ('Module = "A"\nEndModule\n', "FB1305",
         "a module has one configuration identifier at least"),
        ("Module = 0x10\nEndModule\n", "FB1303",
         "Module takes a name in quotes and the module's identifiers, not 0x10"),
        ('Module = "A" 0x10,x\nEndModule\n', "FB1303",
         "Module takes bytes such as 0x30,0x20, not x"),
        ("Ext_User_Prm_Data_Ref(0) = 7\n", "FB1309", "there is no ExtUserPrmData 7"),
        ("Ext_User_Prm_Data_Const(300) = 1\n", "FB1309",
         "byte 300 lies behind the 244 bytes of Set_Prm"),
        ("SlotDefinition\nSlot = 3\nEndSlotDefinition\n", "FB1303",
         "Slot takes a name, the default and the allowed references of modules, not 3"),
    ],
)  # fmt: skip
def test_a_mistake_is_told_in_the_words_of_its_line(text: str, code: str, message: str) -> None:
    (found,) = findings((HEAD + text).encode())
    assert (found.code, found.message) == (code, message)


def test_errors_of_a_file_come_together_in_the_order_of_their_places() -> None:
    text = '#Profibus_DP\nSync_Mode_supp = yes\nModule = "A" 0x40\nEndModule\nVendor_Name = 5\n'
    found = findings(text.encode())
    assert [one.code for one in found] == ["FB1306", "FB1303", "FB1305", "FB1303"]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b'<?xml version="1.0"?><ISO15745Profile/>', "it is XML"),
        (bytes(range(256)), "it is no text"),
        (b"", "the line #Profibus_DP is missing"),
    ],
)
def test_what_is_no_gsd_file_is_told_what_it_is(data: bytes, reason: str) -> None:
    (found,) = findings(data)
    assert found.code == "FB1301"
    assert reason in found.message


def test_a_file_that_is_far_too_large_is_not_read() -> None:
    (found,) = findings(b"#Profibus_DP\n" + b" " * MAX_BYTES)
    assert (found.code, found.severity) == ("FB1301", Severity.ERROR)
