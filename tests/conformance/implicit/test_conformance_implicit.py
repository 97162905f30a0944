"""Which type becomes which other by itself, as a table for each dialect and IEC check.

Sources: IEC 61131-3 third edition, figures 11 and 12; TIA Portal help, "Implicit conversion of
BYTE" and the pages of the other types (S7-1500; DWORD to REAL is left out because the help
contradicts itself), "Overview of data type conversion" and "Expressions"; manual "S7-SCL",
conversion functions of class A (BOOL); TwinCAT 3 help, "Type conversion operators", C0195 to
C0197. What a table leaves out has to be written.
"""

from dataclasses import replace

import pytest

from fbgen.diagnostics import Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.checker.rules import RULES, Rules
from fbgen.lang.parser import parse
from fbgen.source import Source
from harness import load_program

_CLASSIC = ("BOOL", "BYTE", "WORD", "DWORD", "CHAR", "INT", "DINT", "REAL", "TIME", "DATE", "TOD")
_ALL = (*_CLASSIC, "LWORD", "SINT", "USINT", "UINT", "UDINT", "LINT", "ULINT", "LREAL", "WCHAR")

_WIDER = {
    "SINT": "INT DINT LINT REAL LREAL",
    "INT": "DINT LINT REAL LREAL",
    "DINT": "LINT LREAL",
    "USINT": "UINT UDINT ULINT INT DINT LINT REAL LREAL",
    "UINT": "UDINT ULINT DINT LINT REAL LREAL",
    "UDINT": "ULINT LINT LREAL",
    "REAL": "LREAL",
    "BYTE": "WORD DWORD LWORD",
    "WORD": "DWORD LWORD",
    "DWORD": "LWORD",
}
_S7 = {**_WIDER, "DINT": "LINT REAL LREAL", "UDINT": "ULINT LINT REAL LREAL"}
_COUNTS = "BYTE WORD DWORD LWORD SINT USINT INT UINT DINT UDINT LINT ULINT"
_NUMBERS = "SINT USINT INT UINT DINT UDINT LINT ULINT"


def _besides(kind: str, *more: str) -> str:
    """The whole numbers and bit strings besides itself, and more."""
    return " ".join([*(one for one in _COUNTS.split() if one != kind), *more])


_UNCHECKED = {
    "BYTE": _besides("BYTE", "CHAR WCHAR"),
    "WORD": _besides("WORD", "CHAR WCHAR DATE"),
    "DWORD": _besides("DWORD", "CHAR WCHAR TIME TOD"),
    "LWORD": _besides("LWORD", "CHAR WCHAR"),
    "SINT": _besides("SINT", "CHAR WCHAR REAL LREAL"),
    "USINT": _besides("USINT", "CHAR WCHAR REAL LREAL"),
    "INT": _besides("INT", "CHAR WCHAR REAL LREAL DATE"),
    "UINT": _besides("UINT", "CHAR WCHAR REAL LREAL DATE"),
    "DINT": _besides("DINT", "CHAR WCHAR REAL LREAL TIME TOD"),
    "UDINT": _besides("UDINT", "CHAR WCHAR REAL LREAL TIME TOD"),
    "LINT": _besides("LINT", "CHAR WCHAR REAL LREAL"),
    "ULINT": _besides("ULINT", "CHAR WCHAR REAL LREAL"),
    "REAL": f"{_NUMBERS} DWORD LREAL",
    "LREAL": f"{_NUMBERS} LWORD REAL",
    "TIME": "DWORD DINT UDINT",
    "TOD": "DWORD DINT UDINT",
    "DATE": "WORD INT UINT",
    "CHAR": _COUNTS,
    "WCHAR": _COUNTS,
}
_CLASSIC_UNCHECKED = {
    "BYTE": "WORD DWORD INT DINT CHAR",
    "WORD": "DWORD INT DINT DATE",
    "DWORD": "DINT TIME TOD",
    "INT": "DINT REAL WORD DWORD",
    "DINT": "REAL DWORD",
}
_STEP7 = {**_CLASSIC_UNCHECKED, "BOOL": "BYTE WORD DWORD"}
_TWINCAT = {
    "BYTE": "USINT WORD DWORD LWORD UINT UDINT ULINT INT DINT LINT REAL LREAL",
    "USINT": "BYTE WORD DWORD LWORD UINT UDINT ULINT INT DINT LINT REAL LREAL",
    "WORD": "UINT DWORD LWORD UDINT ULINT DINT LINT REAL LREAL",
    "UINT": "WORD DWORD LWORD UDINT ULINT DINT LINT REAL LREAL",
    "DWORD": "UDINT LWORD ULINT LINT REAL LREAL",
    "UDINT": "DWORD LWORD ULINT LINT REAL LREAL",
    "LWORD": "ULINT",
    "ULINT": "LWORD",
    "SINT": "INT DINT LINT REAL LREAL",
    "INT": "DINT LINT REAL LREAL",
    "DINT": "LINT REAL LREAL",
    "REAL": "LREAL",
}
_TWINCAT_WARNED = {
    "SINT": "BYTE USINT WORD UINT DWORD UDINT LWORD ULINT",
    "INT": "WORD UINT DWORD UDINT LWORD ULINT",
    "DINT": "DWORD UDINT LWORD ULINT",
    "LINT": "LWORD ULINT",
    "BYTE": "SINT",
    "USINT": "SINT",
    "WORD": "INT",
    "UINT": "INT",
    "DWORD": "DINT",
    "UDINT": "DINT",
    "LWORD": "LINT",
    "ULINT": "LINT",
    "LREAL": "REAL",
}
_ON = replace(RULES["tia"], iec_check_open=False)
_OFF = replace(RULES["tia"], iec_check=False)
_OFF_ON_300 = replace(_OFF, narrows_unchecked=False)
_TABLES = {
    "tia with IEC check": (_ON, _ALL, _S7, {}),
    "tia without IEC check": (_OFF, _ALL, _UNCHECKED, {}),
    "tia without IEC check, S7-300": (_OFF_ON_300, _CLASSIC, _CLASSIC_UNCHECKED, {}),
    "step7": (RULES["step7"], _CLASSIC, _STEP7, {}),
    "iec": (RULES["iec"], _ALL, _WIDER, {}),
    "twincat": (RULES["twincat"], _ALL, _TWINCAT, _TWINCAT_WARNED),
}


def _pairs(table: dict[str, str]) -> set[tuple[str, str]]:
    return {(source, target) for source, line in table.items() for target in line.split()}


def _judged(rules: Rules, kinds: tuple[str, ...]) -> tuple[set[tuple[str, str]], ...]:
    """The pairs that convert without and with a warning, each tried in a block of its own line."""
    pairs = [(source, target) for source in kinds for target in kinds if source != target]
    declared = " ".join(f"v_{kind} : {kind};" for kind in kinds)
    lines = "\n".join(f"v_{target} := v_{source};" for source, target in pairs)
    unit = "FUNCTION_BLOCK" if rules.dialect in ("tia", "step7") else "PROGRAM"
    begin = "BEGIN" if unit == "FUNCTION_BLOCK" else ""
    text = f"{unit} Main\nVAR {declared} END_VAR\n{begin}\n{lines}\nEND_{unit}\n"
    _, found = check_reporting([parse(Source("x", text), rules.dialect)], rules=rules)
    told = {(one.span.line, one.severity) for one in found if one.span and one.code < "FB42"}
    numbered = list(enumerate(pairs, start=4))
    refused = {pair for line, pair in numbered if (line, Severity.ERROR) in told}
    warned = {pair for line, pair in numbered if (line, Severity.WARNING) in told}
    return set(pairs) - refused - warned, warned - refused


@pytest.mark.parametrize("name", _TABLES)
def test_what_converts_by_itself(name: str) -> None:
    rules, kinds, silent, warned = _TABLES[name]
    assert _judged(rules, kinds) == (_pairs(silent), _pairs(warned))


def test_a_source_does_not_tell_the_iec_check_so_a_block_is_warned_of_once() -> None:
    text = (
        'FUNCTION_BLOCK "Many"\nVAR w : WORD; n : INT; x : LREAL; r : REAL; END_VAR\nBEGIN\n'
        "#n := #w;\n#r := #x;\n#w := #n;\nIF #n = #w THEN #n := 0; END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    _, found = check_reporting([parse(Source("x", text), "tia")])
    assert [one.code for one in found if one.code < "FB42"] == ["FB4112"]
    (warned,) = [one for one in found if one.code == "FB4112"]
    assert warned.span is not None
    assert warned.span.line == 4
    assert len(warned.notes) == 3


@pytest.mark.parametrize(
    ("target", "source", "value", "expected"),
    [
        ("BYTE", "DWORD", 0x1234_56FE, 0xFE),
        ("INT", "UINT", 65_535, -1),
        ("SINT", "INT", 300, 44),
        ("REAL", "LREAL", 0.1, 0.10000000149011612),
        ("DWORD", "REAL", 1.0, 0x3F80_0000),
        ("DINT", "TIME", 1500, 1500),
        ("CHAR", "INT", 66, "B"),
    ],
)
def test_without_the_iec_check_a_value_is_cut_or_rounded(
    engine_name: str, target: str, source: str, value: float, expected: object
) -> None:
    declared = f'FUNCTION "F" : {target}\nVAR_INPUT v : {source}; END_VAR\n'
    source_text = Source("f.scl", f"{declared}BEGIN\n#F := #v;\nEND_FUNCTION\n")
    program = load_program([source_text], engine=engine_name)
    assert program.call("F", v=value) == expected


@pytest.mark.parametrize(
    ("target", "source", "value", "expected"),
    [
        ("INT", "BYTE", 200, 200),
        ("LINT", "DWORD", 0xFFFF_FFFF, 0xFFFF_FFFF),
        ("REAL", "WORD", 40_000, 40_000.0),
        ("WORD", "USINT", 255, 255),
        ("INT", "UINT", 65_535, -1),
        ("DWORD", "INT", -1, 0xFFFF_FFFF),
        ("BYTE", "SINT", -2, 0xFE),
        ("REAL", "LREAL", 0.1, 0.10000000149011612),
    ],
)
def test_twincat_keeps_the_bits(
    engine_name: str, target: str, source: str, value: float, expected: float
) -> None:
    text = (
        f"FUNCTION F : {target}\nVAR_INPUT v : {source}; END_VAR\nF := v;\nEND_FUNCTION\n"
        f"FUNCTION G : {target}\nVAR_INPUT v : {source}; END_VAR\nVAR o : {target}; END_VAR\n"
        "o := F(v); G := o;\nEND_FUNCTION\n"
    )
    program = load_program([Source("f.st", text)], dialect="twincat", engine=engine_name)
    assert program.call("G", v=value) == expected


def test_an_output_of_twincat_goes_to_a_wider_number(engine_name: str) -> None:
    text = (
        "FUNCTION_BLOCK Raw\nVAR_OUTPUT b : BYTE; END_VAR\nb := 200;\nEND_FUNCTION_BLOCK\n"
        "FUNCTION_BLOCK User\nVAR raw : Raw; END_VAR\nVAR_OUTPUT n : INT; END_VAR\n"
        "raw(b => n);\nEND_FUNCTION_BLOCK\n"
    )
    program = load_program([Source("f.st", text)], dialect="twincat", engine=engine_name)
    user = program.instance("User")
    user()
    assert user.n == 200


@pytest.mark.parametrize(
    ("target", "source", "value", "expected"),
    [
        ("WORD", "BOOL", True, 1),
        ("INT", "WORD", 0xFFFF, -1),
        ("WORD", "INT", -1, 0xFFFF),
        ("DINT", "WORD", 0xFFFF, 65_535),
        ("CHAR", "BYTE", 65, "A"),
        ("TIME", "DWORD", 0xFFFF_FFFF, -1),
    ],
)
def test_without_the_iec_check_the_bits_stay(
    engine_name: str, target: str, source: str, value: float, expected: object
) -> None:
    text = f"FUNCTION F : {target}\nVAR_INPUT v : {source}; END_VAR\nBEGIN\nF := v;\nEND_FUNCTION\n"
    program = load_program([Source("f.scl", text)], dialect="step7", engine=engine_name)
    assert program.call("F", v=value) == expected


@pytest.mark.parametrize(
    ("expression", "expected"),
    [
        ("b + BYTE#16#1", 0),
        ("b * BYTE#16#2", 254),
        ("b / BYTE#16#2", 127),
        ("b MOD BYTE#16#10", 15),
    ],
)
def test_a_byte_calculates_as_usint_on_s7(engine_name: str, expression: str, expected: int) -> None:
    text = (
        'FUNCTION "F" : Byte\nVAR_INPUT b : Byte; END_VAR\n'
        f'BEGIN\n  "F" := {expression.replace("b ", "#b ")};\nEND_FUNCTION\n'
    )
    program = load_program([Source("f.scl", text)], engine=engine_name)
    assert program.call("F", b=255) == expected
