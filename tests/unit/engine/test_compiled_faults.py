"""What stops a compiled block is shown at its very place in the PLC text, in both engines alike."""

import pytest

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.source import Source
from harness import load_program
from harness.engine.interface import Limits

ENGINES = ["compiled", "reference"]
LIMITS = Limits(loop_passes=100, call_depth=4)


def fault(body: str, engine: str, more: str = "") -> Diagnostic:
    text = f"""FUNCTION "Ratio" : INT
VAR_INPUT a : INT; b : INT; END_VAR
VAR_OUTPUT rest : INT; END_VAR
BEGIN
    #rest := 0;
    #Ratio := #a / #b;
END_FUNCTION
{more}
FUNCTION_BLOCK "Faulty"
VAR
    list : ARRAY[0..9] OF INT; table : ARRAY[1..3, -2..2] OF INT; a : INT; i : INT; flag : BOOL;
    floating : REAL; text : STRING; zero : INT; others : ARRAY[0..9] OF INT; word : WORD;
END_VAR
BEGIN
{body}
END_FUNCTION_BLOCK
"""
    program = load_program([Source("faulty.scl", text)], engine=engine, limits=LIMITS)
    block = program.instance("Faulty")
    with pytest.raises(DiagnosticError) as failure:
        block()
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.span is not None
    return diagnostic


def place(body: str, engine: str) -> tuple[str, str]:
    found = fault(body, engine)
    assert found.span is not None
    return found.code, found.span.text


@pytest.mark.parametrize("engine", ENGINES)
@pytest.mark.parametrize(
    ("body", "code", "text"),
    [
        ("#a := 7 / #zero;", "FB6003", "7 / #zero"),
        ("#a := (8 / 2) + (7 / #zero);", "FB6003", "7 / #zero"),
        ("#a := 1 / (#zero + 1) + 1 MOD #zero;", "FB6003", "1 MOD #zero"),
        ("#flag := #a = 0 AND 1 / #zero = 1;", "FB6003", "1 / #zero"),
        ("IF #a = 1 THEN ; ELSIF 1 / #zero = 1 THEN ; END_IF;", "FB6003", "1 / #zero"),
        ("WHILE 1 / #zero = 1 DO ; END_WHILE;", "FB6003", "1 / #zero"),
        ("REPEAT #a := 1; UNTIL 1 / #zero = 1 END_REPEAT;", "FB6003", "1 / #zero"),
        ("FOR #i := 1 TO 1 / #zero DO ; END_FOR;", "FB6003", "1 / #zero"),
        ("#a := 10; #a := #list[#a];", "FB6002", "#list[#a]"),
        ("#a := 10; #list[#a] := 1;", "FB6002", "#list[#a]"),
        ("#a := -1; #a := #list[#a];", "FB6002", "#list[#a]"),
        ("#a := -1; #list[#a + 0] := 1;", "FB6002", "#list[#a + 0]"),
        ("#a := 10; #a := #list[3] + #others[#a] + #list[#a];", "FB6002", "#others[#a]"),
        ("#a := 3; #list[#list[#a] - 1] := 1;", "FB6002", "#list[#list[#a] - 1]"),
        ("#a := 3; #table[#a, #a] := 1;", "FB6002", "#table[#a, #a]"),
        ("#a := 0; #a := #table[#a, 0];", "FB6002", "#table[#a, 0]"),
        ("#a := 10; #list[#a].%X3 := TRUE;", "FB6002", "#list[#a]"),
        ("#floating := 1.0E9; #a := REAL_TO_INT(#floating);", "FB6006", "REAL_TO_INT(#floating)"),
        ("#text := 'x'; #a := STRING_TO_INT(#text);", "FB6007", "STRING_TO_INT(#text)"),
        ("FOR #i := 1 TO 5 BY #zero DO ; END_FOR;", "FB6008", ""),
        ("#a := MUX(K := #zero + 2, IN0 := 1, IN1 := 2);", "FB6009", "MUX(K := #zero + 2, IN0"),
        ("WHILE #zero = 0 DO #a := 1; END_WHILE;", "FB6004", "WHILE #zero = 0 DO"),
        ("FOR #i := 1 TO 200 DO #a := #i; END_FOR;", "FB6004", "FOR #i := 1 TO 200"),
        ("FOR #i := 1 TO 20 DO FOR #a := 1 TO 20 DO ; END_FOR; END_FOR;", "FB6004", "FOR #a"),
    ],
)
def test_the_place_of_a_fault(body: str, code: str, text: str, engine: str) -> None:
    found_code, found_text = place(body, engine)
    assert found_code == code
    assert found_text.startswith(text)


@pytest.mark.parametrize("engine", ENGINES)
def test_a_fault_inside_of_a_called_function(engine: str) -> None:
    assert place('#a := "Ratio"(a := 1, b := #zero);', engine) == ("FB6003", "#a / #b")


@pytest.mark.parametrize("engine", ENGINES)
def test_the_index_that_was_wrong_is_named(engine: str) -> None:
    for body, index, bounds in (
        ("#a := 17; #list[#a] := 0;", "the index is 17", "0..9"),
        ("#a := -5; #list[#a] := 0;", "the index is -5", "0..9"),
        ("#a := 12; #i := #list[#a * 2 - 10];", "the index is 14", "0..9"),
        ("#a := 3; #table[#a, #a] := 0;", "index 2 is 3", "-2..2"),
    ):
        message = fault(body, engine).message
        assert index in message
        assert bounds in message


@pytest.mark.parametrize("engine", ENGINES)
def test_blocks_nested_deeper_than_the_cpu_allows(engine: str) -> None:
    functions = "\n".join(
        f'FUNCTION "Level{n}" : INT\nBEGIN #Level{n} := '
        + (f'"Level{n + 1}"();' if n < 5 else "1;")
        + "\nEND_FUNCTION"
        for n in range(1, 6)
    )
    found = fault('#a := "Level1"();', engine, functions)
    assert found.code == "FB6005"
    assert found.span is not None
    assert found.span.text == '"Level4"()'
    assert "'Level4'" in found.message


@pytest.mark.parametrize("engine", ENGINES)
def test_the_limits_are_enough_for_what_they_allow(engine: str) -> None:
    text = """FUNCTION_BLOCK "Fine"
VAR n : INT; i : INT; END_VAR
BEGIN
    FOR #i := 1 TO 40 DO #n := #n + 1; END_FOR;
    WHILE #n < 80 DO #n := #n + 1; END_WHILE;
    REPEAT #n := #n + 1; UNTIL #n >= 100 END_REPEAT;
END_FUNCTION_BLOCK
"""
    program = load_program([Source("fine.scl", text)], engine=engine, limits=LIMITS)
    block = program.instance("Fine")
    for _ in range(3):
        block.n = 0
        block()
        assert block.n == 100
    block.n = -1
    with pytest.raises(DiagnosticError, match="FB6004"):
        block()
