"""From IEC 61131-3 to CODESYS and TwinCAT and back, objects included."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.conversion import convert, way
from fbgen.lang.conversion_proof import mistakes_in
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source
from harness import LoadedProgram, load_program

_OBJECTS = Path(__file__).parents[2] / "conformance" / "objects"


def _converted(text: str, source: str, target: str) -> str:
    (file,) = convert([parse(Source("x.st", text), source)], target)
    assert mistakes_in([file], target) == []
    return print_file(file).text


def _loaded(text: str, dialect: str) -> LoadedProgram:
    return load_program([Source("x.st", text)], dialect=dialect)


def test_the_way_is_direct() -> None:
    assert way("iec", "twincat") == ("iec", "twincat")
    assert way("twincat", "iec") == ("twincat", "iec")


@pytest.mark.parametrize(
    "name", ["abstract", "element_arguments", "interfaces", "objects", "shared", "starts"]
)
def test_objects_go_to_iec_and_back(name: str) -> None:
    text = (_OBJECTS / f"{name}.st").read_text(encoding="utf-8")
    there = _converted(text, "twincat", "iec")
    back = _converted(there, "iec", "twincat")
    assert "METHOD" in there or "ACTION" in there
    assert _converted(back, "twincat", "iec") == there.replace("NULL", "0")


def test_namespaces_become_parts_of_names_and_mean_the_same() -> None:
    text = (_OBJECTS / "using.st").read_text(encoding="utf-8")
    there = _converted(text, "iec", "twincat")
    assert there.startswith("(* Names in namespaces")
    for written, dialect in ((text, "iec"), (there, "twincat")):
        user = _loaded(written, dialect).instance("User")
        user()
        assert (user.first, user.second, user.third, user.runs) == (100, 102, 200, True)


_STANDARD = """\
CLASS Meter
VAR PRIVATE last : INT; END_VAR
METHOD PUBLIC Step : INT
  last := last + 1;
  Step := last;
END_METHOD
END_CLASS

PROGRAM Main
VAR_EXTERNAL total : INT; END_VAR
VAR meter : Meter; r : REF_TO INT; w : WORD := 16#10; b : BOOL; END_VAR
total := total + meter.Step();
r := REF(total);
IF r <> NULL THEN
  r^ := r^ + 10;
END_IF
b := w.%X4;
END_PROGRAM

CONFIGURATION Plant
  VAR_GLOBAL total : INT; END_VAR
  RESOURCE Cpu ON PLC
    TASK cyclic(INTERVAL := T#20ms, PRIORITY := 3);
    PROGRAM Main WITH cyclic : Main;
  END_RESOURCE
END_CONFIGURATION
"""


def test_what_only_the_standard_has_is_said_as_codesys_does() -> None:
    there = _converted(_STANDARD, "iec", "twincat")
    for gone in ("CLASS", "VAR_EXTERNAL", "PRIVATE", "REF_TO", "NULL", "%X"):
        assert gone not in there
    for text, dialect in ((_STANDARD, "iec"), (there, "twincat")):
        program = _loaded(text, dialect)
        program.start()
        program.run_for(ms=50)
        assert program.globals.total == 36
        assert program.engine.global_value("Main.b") is True


def test_variables_that_others_read_become_public() -> None:
    text = (
        "FUNCTION_BLOCK Pump\nVAR\nspeed : INT;\nEND_VAR\nVAR\ninner : INT;\nEND_VAR\n"
        "speed := inner;\nEND_FUNCTION_BLOCK\n"
        "PROGRAM Main\nVAR\npump : Pump; n : INT;\nEND_VAR\npump();\n"
        "n := pump.speed;\nEND_PROGRAM\n"
    )
    there = _converted(text, "twincat", "iec")
    assert there.count("VAR PUBLIC") == 1
    assert "VAR PUBLIC\n        speed : INT;" in there


def test_x_to_bool_keeps_its_meaning() -> None:
    text = (
        "FUNCTION_BLOCK F\nVAR_INPUT w : WORD; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n"
        "q := WORD_TO_BOOL(w);\nEND_FUNCTION_BLOCK\n"
    )
    for source, target in (("iec", "twincat"), ("twincat", "iec")):
        results = []
        for written, dialect in ((text, source), (_converted(text, source, target), target)):
            block = _loaded(written, dialect).instance("F")
            block(w=2)
            results.append(block.q)
        assert results[0] == results[1]


@pytest.mark.parametrize(
    ("statement", "word"),
    [("b := w.%B1;", "w.%B1"), ("", "an argument of a PROGRAM")],
)
def test_what_codesys_cannot_say_is_refused_by_name(statement: str, word: str) -> None:
    argument = "" if statement else "(w := 3)"
    text = (
        f"PROGRAM P\nVAR_INPUT w : WORD; END_VAR\nVAR b : BYTE; END_VAR\n{statement}\nEND_PROGRAM\n"
        "CONFIGURATION c\nRESOURCE r ON PLC\nTASK t(INTERVAL := T#1s, PRIORITY := 1);\n"
        f"PROGRAM P WITH t : P{argument};\nEND_RESOURCE\nEND_CONFIGURATION\n"
    )
    with pytest.raises(DiagnosticError) as refused:
        convert([parse(Source("x.st", text), "iec")], "twincat")
    (found,) = refused.value.diagnostics
    assert found.code == "FB3051"
    assert word in found.message


def test_what_codesys_converts_by_itself_is_written_out() -> None:
    text = (
        "TYPE Mode : (off, on); END_TYPE\nFUNCTION_BLOCK F\n"
        "VAR_INPUT w : WORD; d : DINT; m : Mode; END_VAR\n"
        "VAR_OUTPUT r : REAL; n, k : INT; b : BYTE; END_VAR\n"
        "r := d;\nn := w;\nb := (b + 1) * 2;\nk := m + n;\nEND_FUNCTION_BLOCK\n"
    )
    there = _converted(text, "twincat", "iec")
    assert "r := DINT_TO_REAL(d);" in there
    assert "n := WORD_TO_INT(w);" in there
    results = []
    for written, dialect in ((text, "twincat"), (there, "iec")):
        block = _loaded(written, dialect).instance("F")
        block(w=0xFFFE, d=7, m=1)
        block(w=0xFFFE, d=7, m=1)
        results.append((block.r, block.n, block.b, block.k))
    assert results[0] == results[1] == (7.0, -2, 6, -1)


def test_texts_stand_in_the_place_of_own_names() -> None:
    text = (_OBJECTS.parent / "codesys" / "own_names.st").read_text(encoding="utf-8")
    teller = text[text.index("FUNCTION_BLOCK Teller") : text.index("FUNCTION_BLOCK Counter")]
    there = _converted(teller, "twincat", "iec")
    assert "'Teller.Ask'" in there
    assert "__" not in there


def test_an_address_behind_the_type_is_written_in_front_of_it() -> None:
    text = "PROGRAM Main\nVAR\n  lamp : BOOL AT %QX0.0 := TRUE;\nEND_VAR\nEND_PROGRAM\n"
    assert "lamp AT %QX0.0 : BOOL := TRUE;" in print_file(parse(Source("x.st", text), "iec")).text
