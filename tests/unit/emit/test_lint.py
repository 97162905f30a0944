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
IEC = {
    "FB5050_line_comment.st": [(5, 1)],
    "FB5051_double_underscore.st": [(3, 5)],
    "FB5052_address_in_code.st": [(5, 6)],
}


def found(name: str, dialect: str, plc: PlcFamily) -> list[Diagnostic]:
    """What the lint says of a broken file."""
    return lint(name, (BAD / name).read_text("utf-8"), dialect, plc)


def places(diagnostics: list[Diagnostic]) -> list[tuple[str, int, int]]:
    """Code, line and column of each finding."""
    return [(d.code, d.span.line, d.span.column) for d in diagnostics if d.span is not None]


@pytest.mark.parametrize("name", TIA)
def test_a_text_that_breaks_a_rule_of_tia_portal(name: str) -> None:
    plc, wanted = TIA[name]
    diagnostics = found(name, "tia", plc)
    assert sorted(places(diagnostics)) == [(name[:6], *place) for place in wanted]
    assert all(item.help for item in diagnostics)


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
        assert lint("clean.scl", CLEAN, "tia", plc) == []


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
    diagnostics = lint("clean.scl", CHANGES[change](CLEAN), "tia", "s7-1200")
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
    codes = [item.code for item in lint("clean.scl", text, "tia", plc)]
    assert codes == ([] if allowed else ["FB5049"])


@pytest.mark.parametrize("plc", ["s7-1200", "s7-1500", "s7-300", "s7-400"])
@pytest.mark.parametrize("example", ["manual_example", "five_drives"])
def test_what_is_generated_for_each_family_is_clean(example: str, plc: str) -> None:
    text = (ROOT / "examples" / example / "plant.yaml").read_text("utf-8")
    catalog = load_catalog()
    plant = read_plant(Source("plant.yaml", text.replace("s7-1500", plc)), catalog)
    for file in generate(plant, catalog).files:
        assert lint(file.name, file.text, "tia", plant.plc) == []
