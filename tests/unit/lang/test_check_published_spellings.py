"""Spellings that published sources have and manuals hardly mention: checked without an error."""

import pytest
from checking import errors_of, in_block, in_program

from fbgen.lang.parser import parse_recovering
from fbgen.source import Source

_INPUTS = "FUNCTION_BLOCK Feeder\nVAR_INPUT go : BOOL; speed : REAL; END_VAR\nEND_FUNCTION_BLOCK\n"


@pytest.mark.parametrize(
    ("declarations", "statements"),
    [
        ("port : HW_INTERFACE; ob : OB_CYCLIC; db : DB_ANY;", "#port := 64; #ob := 30; #db := 5;"),
        ("id : CONN_OUC; event : EVENT_ANY; w : WORD;", "#w := #id; #event := 16#1;"),
        (
            "c : TCON_IP_v4 := (64, 2, 11, (), ([()]), (), 2345);",
            "#c.RemoteAddress.ADDR[1] := 16#0A; #c.LocalPort := 2000;",
        ),
        ("e : ErrorStruct; w : WORD;", "#w := #e.ERROR_ID; #w := #e.CODE_ADDRESS.BLOCK_TYPE;"),
        ("a : INT; b : INT;", "#a := MAX_INT(IN1 := #a, IN2 := #b); #a := ADD_INT(#a, #b);"),
        ("w : WSTRING;", "#w := CONCAT_WSTRING(IN1 := #w, IN2 := WSTRING#'x');"),
        ("s : STRING; n : INT;", "#n := LEN_STRING(#s); #s := LEFT_STRING(IN := #s, L := 3);"),
        ("c : IEC_COUNTER; d : BOOL; n : INT;", "#c.CTU(CU := #d, PV := 3, Q => #d, CV => #n);"),
        ("c : IEC_UDCOUNTER; d : BOOL;", "#c.CTD(CD := #d, LD := FALSE, PV := 70000, Q => #d);"),
    ],
)
def test_tia_knows_it(declarations: str, statements: str) -> None:
    assert errors_of(in_block(declarations, statements), "tia") == []


def test_sections_set_in_the_instance_have_overlays_in_an_optimized_block() -> None:
    text = (
        "FUNCTION_BLOCK \"F\"\n{ S7_Optimized_Access := 'TRUE' }\n"
        "VAR DB_SPECIFIC raw : WORD; bytes AT raw : ARRAY[0..1] OF BYTE; END_VAR\n"
        "BEGIN\n#bytes[0] := 1;\nEND_FUNCTION_BLOCK\n"
    )
    assert errors_of(text, "tia") == []
    assert [one.code for one in errors_of(text.replace(" DB_SPECIFIC", ""), "tia")] == ["FB4071"]


@pytest.mark.parametrize("dialect", ["iec", "twincat"])
@pytest.mark.parametrize(
    "statement",
    ["f(go := , speed := 2.0);", "f(go := TRUE, speed := 2.0,);", "f(go := , speed := , );"],
)
def test_codesys_leaves_arguments_empty(dialect: str, statement: str) -> None:
    text = f"{_INPUTS}PROGRAM main\nVAR f : Feeder; END_VAR\n{statement}\nEND_PROGRAM\n"
    assert errors_of(text, dialect) == []


@pytest.mark.parametrize("dialect", ["iec", "twincat"])
def test_a_place_that_is_linked_later_needs_no_width(dialect: str) -> None:
    text = "PROGRAM main\nVAR a AT %I* : BOOL; b AT %Q* : ARRAY[1..2] OF INT; END_VAR\n"
    assert errors_of(f"{text}b[1] := SEL(a, 0, 1);\nEND_PROGRAM\n", dialect) == []


@pytest.mark.parametrize("arguments", ["go := , speed := 2.0", "go := TRUE, speed := 2.0,"])
def test_tia_wants_every_argument_to_have_a_value(arguments: str) -> None:
    text = f'FUNCTION "f" : Void\nBEGIN\n"d"({arguments});\nEND_FUNCTION\n'
    _, findings = parse_recovering(Source("test", text), "tia")
    assert [one.code for one in findings] == ["FB3001"]


@pytest.mark.parametrize(
    ("dialect", "statement"),
    [("tia", "#s[1] := 'ab';"), ("tia", "#s[1] := 5;"), ("tia", "#s[1, 2] := 'a';")],
)
def test_one_character_takes_one_character(dialect: str, statement: str) -> None:
    assert len(errors_of(in_block("s : STRING;", statement), dialect)) == 1


def test_an_unknown_text_is_reported_once() -> None:
    (found,) = errors_of(in_block("c : CHAR;", "#missing[1] := #c;"), "tia")
    assert found.code == "FB4001"


@pytest.mark.parametrize(
    "statement",
    ["u := w;", "u := w + 1;", "w := n;", "i := b;", "w := 16#FF AND w;", "t[b] := 1;"],
)
def test_bit_strings_are_numbers_in_twincat(statement: str) -> None:
    text = (
        "PROGRAM main\nVAR CONSTANT size : BYTE := 4; END_VAR\n"
        "VAR u : UDINT; n : UINT; w : WORD; b : BYTE; i : INT; t : ARRAY[0..size] OF INT; END_VAR\n"
        f"{statement}\nEND_PROGRAM\n"
    )
    assert errors_of(text, "twincat") == []
    assert errors_of(text, "iec") != []


@pytest.mark.parametrize("statement", ["b := w;", "s := w;"])
def test_bit_strings_do_not_narrow_in_twincat(statement: str) -> None:
    text = in_program("b : BYTE; w : WORD; s : SINT; i : INT;", statement)
    assert [one.code for one in errors_of(text, "twincat")] == ["FB4011"]
