"""What CODESYS and TwinCAT take without a word, the checker takes without a word, too."""

import pytest
from checking import errors_of, findings_of, hints_of, in_program

_PUMP = """
FUNCTION_BLOCK Pump
VAR_INPUT on : BOOL; END_VAR
METHOD Start : BOOL
VAR_INPUT speed : INT; ramp : INT := 2; END_VAR
VAR_OUTPUT ok : BOOL; END_VAR
ok := speed > ramp;
END_METHOD
END_FUNCTION_BLOCK
"""
_ANY = """
FUNCTION Size : DINT
VAR_INPUT item : ANY; number : ANY_NUM; END_VAR
Size := item.diSize + number.diSize;
IF item.TypeClass = __SYSTEM.TYPE_CLASS.TYPE_INT THEN Size := 0; END_IF
END_FUNCTION
"""


def test_arguments_without_names_stand_in_front_of_those_with_names() -> None:
    text = _PUMP + in_program(
        "p : Pump; b : BOOL;", "p.Start(3, ok => b);\np.Start(3, 4, ok => b);"
    )
    assert findings_of(text, "twincat") == []


def test_names_in_front_of_arguments_without_names_are_refused() -> None:
    text = _PUMP + in_program("p : Pump; b : BOOL;", "p.Start(ok => b, 3);")
    assert [one.code for one in errors_of(text, "twincat")] == ["FB4044"]


@pytest.mark.parametrize(
    ("declarations", "statements"),
    [
        ("p : POINTER TO INT; a : ARRAY[0..3] OF INT;", "p := ADR(a);\np[1] := 2;"),
        ("p : POINTER TO BYTE; n : UDINT;", "IF p > 0 THEN p := p + n; END_IF"),
        ("a, b : ARRAY[0..3] OF INT;", "MEMCPY(ADR(a), ADR(b), SIZEOF(a));"),
        ("p : PVOID; x : LREAL; n : ULINT;", "p := ADR(x);\nn := ADR(x);"),
    ],
)
def test_raw_memory_is_a_hint(declarations: str, statements: str) -> None:
    text = in_program(declarations, statements)
    assert findings_of(text, "twincat") == []
    assert {one.code for one in hints_of(text, "twincat")} == {"FB4142"}


def test_any_takes_variables_of_all_types() -> None:
    text = _ANY + in_program("x : REAL; n : DINT;", "n := Size(x, n);")
    assert errors_of(text, "twincat") == []


def test_read_only_in_outs_take_values() -> None:
    block = (
        "FUNCTION Long : INT\nVAR_IN_OUT CONSTANT s : STRING; END_VAR\n"
        "Long := LEN(s);\nEND_FUNCTION\n"
    )
    assert errors_of(block + in_program("n : INT;", "n := Long('abc');"), "twincat") == []


def test_the_default_of_an_enumeration_needs_no_type_in_front() -> None:
    text = "{attribute 'qualified_only'}\nTYPE Mode : (Off, On) := On; END_TYPE\n"
    assert errors_of(text, "twincat") == []


def test_any_integer_ends_a_loop() -> None:
    text = in_program(
        "i : INT; n : UDINT; b : BYTE;",
        "FOR i := 0 TO n DO ; END_FOR\nFOR b := 0 TO 3 DO ; END_FOR",
    )
    assert errors_of(text, "twincat") == []


@pytest.mark.parametrize(
    "declaration", ["x AT %I* : INT;", "{attribute 'OPC.UA.DA' := '1'}\nx : INT;"]
)
def test_what_others_write_is_not_missed(declaration: str) -> None:
    text = (
        f"FUNCTION_BLOCK F\nVAR_OUTPUT q : INT; END_VAR\nVAR\n{declaration}\nEND_VAR\n"
        "q := x;\nEND_FUNCTION_BLOCK\n"
    )
    assert findings_of(text, "twincat") == []


def test_an_action_does_not_repeat_what_is_said_of_its_block() -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR spare : INT; END_VAR\n"
        "ACTION Reset:\n;\nEND_ACTION\nReset();\nEND_FUNCTION_BLOCK\n"
    )
    assert [one.message for one in findings_of(text, "twincat")] == [
        "variable 'spare' of F is never used"
    ]


def test_a_point_in_front_means_the_global_variable() -> None:
    text = "VAR_GLOBAL speed : BOOL; END_VAR\n" + in_program(
        "speed : INT;", ".speed := TRUE;\nIF .speed THEN speed := 1; END_IF"
    )
    assert errors_of(text, "twincat") == []
    assert errors_of(text, "iec") == []


@pytest.mark.parametrize(
    ("declarations", "statements"),
    [
        ("t : Tc2_Standard.TON;", "t(IN := TRUE);"),
        ("s : Tc2_System.T_MaxString; n : INT;", "n := Standard.LEN(s);"),
        ("t : Standard.R_TRIG;", "t(CLK := TRUE);"),
    ],
)
def test_a_library_may_stand_in_front_of_a_name(declarations: str, statements: str) -> None:
    assert errors_of(in_program(declarations, statements), "twincat") == []


def test_a_part_of_what_a_call_gives_is_a_hint() -> None:
    chain = (
        "INTERFACE Log\nMETHOD Put : Log\nEND_METHOD\nEND_INTERFACE\n"
        "FUNCTION_BLOCK Logger IMPLEMENTS Log\nMETHOD Put : Log\nPut := THIS^;\nEND_METHOD\n"
        "END_FUNCTION_BLOCK\n"
    )
    text = chain + in_program("l : Logger;", "l.Put().Put();")
    assert errors_of(text, "twincat") == []
    assert {one.code for one in hints_of(text, "twincat")} == {"FB4142"}
