"""Every rule of the lint: a text that breaks it, one that does not, and the generated sets."""

from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import Diagnostic
from fbgen.emit.generator import generate
from fbgen.emit.lint import lint
from fbgen.plant import read_plant
from fbgen.plant.families import PlcFamily
from fbgen.source import Source

BAD = Path(__file__).parents[1] / "bad"
ROOT = Path(__file__).parents[3]

TIA: dict[str, tuple[PlcFamily, list[tuple[int, int]]]] = {
    "FB5041_comment_in_header.scl": ("s7-1500", [(2, 1)]),
    "FB5042_header_order.scl": ("s7-1500", [(3, 1)]),
    "FB5043_name_too_long.scl": ("s7-1500", [(5, 7)]),
    "FB5044_main_of_the_user.scl": ("s7-1500", [(1, 20)]),
    "FB5045_no_marks.scl": ("s7-1500", [(8, 4), (8, 13)]),
    "FB5046_overlay.scl": ("s7-1500", [(6, 7)]),
    "FB5047_timer_without_instruction.scl": ("s7-1500", [(5, 7)]),
    "FB5048_sign_before_power.scl": ("s7-1500", [(8, 10)]),
    "FB5049_type_of_another_cpu.scl": ("s7-300", [(5, 15)]),
    "FB5053_optimized_access.scl": ("s7-400", [(2, 1)]),
}
STEP7 = {
    "FB5054_long_symbol.scl": [(4, 4)],
    "FB5055_header.scl": [(2, 1), (8, 1), (9, 1), (10, 1)],
    "FB5056_sections.scl": [(1, 16), (5, 1), (8, 1)],
    "FB5057_order.scl": [(3, 4)],
    "FB5058_calls.scl": [(17, 4), (18, 21)],
    "FB5059_number.scl": [(6, 14)],
    "FB5060_tia_only.scl": [(2, 1), (4, 11)],
}
IEC = {
    "FB5050_line_comment.st": [(5, 1)],
    "FB5051_double_underscore.st": [(3, 5)],
    "FB5052_address_in_code.st": [(5, 6)],
}


TWINCAT = {
    "FB5061_two_objects.TcPOU": [(4, 42)],
    "FB5062_located_in_block.st": [(3, 5)],
}


def found(name: str, dialect: str, plc: PlcFamily) -> list[Diagnostic]:
    """What the lint says of a broken file."""
    return lint(Source(name, (BAD / name).read_text("utf-8")), dialect, plc)


def places(diagnostics: list[Diagnostic]) -> list[tuple[str, int, int]]:
    """Code, line and column of each finding."""
    return [(d.code, d.span.line, d.span.column) for d in diagnostics if d.span is not None]


@pytest.mark.parametrize("name", TIA)
def test_a_text_that_breaks_a_rule_of_tia_portal(name: str) -> None:
    plc, wanted = TIA[name]
    diagnostics = found(name, "tia", plc)
    assert sorted(places(diagnostics)) == [(name[:6], *place) for place in wanted]
    assert all(item.help for item in diagnostics)


@pytest.mark.parametrize("name", STEP7)
def test_a_text_that_breaks_a_rule_of_step7(name: str) -> None:
    diagnostics = found(name, "step7", "s7-300")
    assert sorted(places(diagnostics)) == [(name[:6], *place) for place in STEP7[name]]
    assert all(item.help for item in diagnostics)


@pytest.mark.parametrize("name", TWINCAT)
def test_a_text_that_breaks_a_rule_of_twincat(name: str) -> None:
    diagnostics = found(name, "twincat", "twincat")
    assert places(diagnostics) == [(name[:6], *place) for place in TWINCAT[name]]
    assert all(item.help for item in diagnostics)


@pytest.mark.parametrize("name", ["Two__lines", "last_"])
@pytest.mark.parametrize("dialect", ["twincat", "plcopen"])
def test_names_of_iec_are_asked_of_its_relatives_too(name: str, dialect: str) -> None:
    text = (
        f"FUNCTION_BLOCK Pump\nVAR\n    {name} : INT;\nEND_VAR\n{name} := 1;\nEND_FUNCTION_BLOCK\n"
    )
    assert "FB5051" in {item.code for item in lint(Source("Pump.st", text), dialect, "twincat")}


def test_an_address_in_code_is_refused_by_twincat() -> None:
    text = "FUNCTION_BLOCK Pump\nVAR\n    a : BYTE;\nEND_VAR\na := %IB4;\nEND_FUNCTION_BLOCK\n"
    codes = {item.code for item in lint(Source("Pump.st", text), "twincat", "twincat")}
    assert codes == {"FB5052"}


def test_a_main_of_the_user_is_left_alone_by_twincat() -> None:
    text = "PROGRAM MAIN\n;\nEND_PROGRAM\n"
    assert {item.code for item in lint(Source("MAIN.st", text), "twincat", "twincat")} == {"FB5044"}


@pytest.mark.parametrize("name", IEC)
def test_a_text_that_breaks_a_rule_of_iec_compilers(name: str) -> None:
    diagnostics = found(name, "iec", "iec")
    own = [item for item in diagnostics if item.code == name[:6]]
    assert places(own) == [(name[:6], *place) for place in IEC[name]]
    assert all(item.help for item in own)


CLEAN = """// above the block
FUNCTION_BLOCK "Clean"
TITLE = Clean
{ S7_Optimized_Access := 'FALSE' }
AUTHOR : fbgen
FAMILY : TOS
VERSION : 0.1
   VAR
      // behind the first section
      bits : Word;
      parts AT bits : Array[0..15] of Bool;
      timer {InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME;
      value : Real;
   END_VAR

BEGIN
   #value := -(#value ** 2.0);
   "Other"(x := #bits);
END_FUNCTION_BLOCK
"""


def test_a_clean_text_is_not_complained_about() -> None:
    for plc in ("s7-1200", "s7-1500", "s7-300", "s7-400"):
        assert lint(Source("clean.scl", CLEAN), "tia", plc) == []


CHANGES: dict[str, Callable[[str], str]] = {
    "FB5040 umlaut": lambda text: text.replace("// above", "// \u00fcber"),
    "FB5040 carriage return": lambda text: text.replace("\n", "\r\n", 1),
    "FB5040 tab": lambda text: text.replace("   VAR", "\tVAR", 1),
    "FB5040 no line end": lambda text: text.rstrip("\n"),
    "FB5041 in the header": lambda text: text.replace("AUTHOR", "// comment\nAUTHOR"),
    "FB5041 behind the header": lambda text: text.replace("   VAR", "// comment\n   VAR", 1),
    "FB5042 version first": lambda text: text.replace("TITLE", "VERSION : 0.1\nTITLE"),
    "FB5043 126 characters": lambda text: text.replace("value", "v" * 126),
    "FB5044 main": lambda text: text.replace("Clean", "MAIN"),
    "FB5045 global": lambda text: text.replace('"Other"(x', "Other(x").replace("#bits", "bits"),
    "FB5046 optimized": lambda text: text.replace("'FALSE'", "'TRUE'"),
    "FB5046 initial value": lambda text: text.replace("Array[0..15] of Bool", "Word := 16#0"),
    "FB5047 timer": lambda text: text.replace("InstructionName := 'TON_TIME'; ", ""),
    "FB5048 power": lambda text: text.replace("-(#value ** 2.0)", "-#value ** 2.0"),
    "FB5049 long": lambda text: text.replace("Word;", "LWord;"),
}


@pytest.mark.parametrize("change", CHANGES)
def test_one_change_of_the_clean_text_breaks_one_rule(change: str) -> None:
    diagnostics = lint(Source("clean.scl", CHANGES[change](CLEAN)), "tia", "s7-1200")
    assert {item.code for item in diagnostics} == {change[:6]}


@pytest.mark.parametrize(
    ("type_name", "plc", "allowed"),
    [
        ("SInt", "s7-300", False),
        ("UDInt", "s7-400", False),
        ("LReal", "s7-300", False),
        ("LReal", "s7-1200", True),
        ("LWord", "s7-1200", False),
        ("LTime", "s7-1200", False),
        ("S5Time", "s7-1200", False),
        ("S5Time", "s7-300", True),
        ("Date_And_Time", "s7-1200", False),
        ("LWord", "s7-1500", True),
        ("DInt", "s7-300", True),
    ],
)
def test_types_of_the_families(type_name: str, plc: PlcFamily, allowed: bool) -> None:
    text = CLEAN.replace("value : Real", f"other : {type_name};\n      value : Real")
    codes = [item.code for item in lint(Source("clean.scl", text), "tia", plc)]
    assert codes == ([] if allowed else ["FB5049"])


CLASSIC = """// above the block
TYPE "Pair"
   STRUCT
      a : INT;
   END_STRUCT;
END_TYPE
FUNCTION_BLOCK "Clean"
TITLE = 'Clean'
AUTHOR : fbgen
FAMILY : TOS
VERSION : '0.1'
   CONST
      MASK := W#16#00FF;
   END_CONST
   VAR_INPUT
      run : BOOL;
   END_VAR
   VAR_OUTPUT
      done : BOOL;
   END_VAR
   VAR
      pair : "Pair";
      word : WORD;
      timer : SFB4;
   END_VAR

BEGIN
   timer(IN := run, PT := T#1S);
   done := timer.Q;
   word := word AND MASK;
   pair.a := 16;
END_FUNCTION_BLOCK
DATA_BLOCK "Clean_DB"
"Clean"
BEGIN
END_DATA_BLOCK
FUNCTION "Cycle" : VOID
BEGIN
   "Clean"."Clean_DB"(run := TRUE);
END_FUNCTION
"""


def test_a_clean_classic_text_is_not_complained_about() -> None:
    for plc in ("s7-300", "s7-400"):
        assert lint(Source("clean.scl", CLASSIC), "step7", plc) == []


CLASSIC_CHANGES: dict[str, Callable[[str], str]] = {
    "FB5040 umlaut": lambda text: text.replace("// above", "// \u00fcber"),
    "FB5044 main": lambda text: text.replace('FUNCTION "Cycle"', 'FUNCTION "Main"'),
    "FB5054 25 characters": lambda text: text.replace('"Pair"', f'"{"p" * 25}"'),
    "FB5055 title": lambda text: text.replace("TITLE = 'Clean'", "TITLE = Clean"),
    "FB5055 author": lambda text: text.replace("AUTHOR : fbgen", "AUTHOR : fbgenfbgen"),
    "FB5056 begin": lambda text: text.replace("\nBEGIN\n   timer", "\n   timer"),
    "FB5057 caller first": lambda text: "".join(
        (text[text.index('FUNCTION "Cycle"') :], text[: text.index('FUNCTION "Cycle"')])
    ),
    "FB5058 alone": lambda text: text.replace('"Clean"."Clean_DB"', '"Clean_DB"'),
    "FB5058 output": lambda text: text.replace("PT := T#1S", "PT := T#1S, Q => done"),
    "FB5059 number": lambda text: text.replace("AND MASK", "AND 16#00FF"),
    "FB5060 edge": lambda text: text.replace("SFB4", "R_TRIG").replace(", PT := T#1S", ""),
}


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("   done := timer.Q;", "   REGION x\n   done := timer.Q;\n   END_REGION"),
        ("pair.a := 16", "pair.a += 16"),
        ("done := timer.Q", "done := word.%X3"),
        ("word AND MASK", "%IW4:P"),
        ("word : WORD", "word : LWORD"),
        ("   CONST\n", "   VAR CONSTANT\n"),
    ],
)
def test_what_classic_scl_has_not_is_refused(old: str, new: str) -> None:
    assert old in CLASSIC
    diagnostics = lint(Source("clean.scl", CLASSIC.replace(old, new, 1)), "step7", "s7-300")
    assert "FB3009" in {item.code for item in diagnostics}


@pytest.mark.parametrize("change", CLASSIC_CHANGES)
def test_one_change_of_the_clean_classic_text_breaks_one_rule(change: str) -> None:
    diagnostics = lint(Source("clean.scl", CLASSIC_CHANGES[change](CLASSIC)), "step7", "s7-300")
    assert {item.code for item in diagnostics} == {change[:6]}


@pytest.mark.parametrize("plc", ["s7-1200", "s7-1500", "s7-300", "s7-400"])
@pytest.mark.parametrize("example", ["manual_example", "five_drives", "devicenet"])
def test_what_is_generated_for_each_family_is_clean(example: str, plc: str) -> None:
    text = (ROOT / "examples" / example / "plant.yaml").read_text("utf-8")
    catalog = load_catalog()
    plant = read_plant(Source("plant.yaml", text.replace("s7-1500", plc)), catalog)
    for file in generate(plant, catalog).files:
        assert lint(file.source, "tia", plant.plc) == []
