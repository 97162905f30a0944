"""Both engines run the same random accesses to memory: overlays, addresses, PEEK, POKE and moves.

Whatever name, view, address or instruction writes a byte, everything that shows it shows the same.
"""

from hypothesis import given, settings
from hypothesis import strategies as st

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.source import Source
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import engine_named, read_program
from harness.engine.variables import BlockInstance, plain

PLACES = {
    "BOOL": ("#flag", "#bits[#i]", "#mixed.on", '"DB5".on', "%DB5.DBX0.3", "%M1.2"),
    "BYTE": ("#bytes[#i]", "#mixed.small", "%DB5.DBB1", "#mixedBytes[3]", '"DB5".row[2]', "%MB2"),
    "WORD": ("#mixedWord", "%DB5.DBW2", "%MW(#i)", '"DB5".DW(#i)', "#tempWord"),
    "INT": ("#mixed.wide", '"DB5".speed', "#tempInt", "#words[1]", "#plain"),
    "DWORD": ("#double", "%DB5.DBD4", "#doubleAgain"),
    "REAL": ("#real", '"DB5".load', "#mixed.part"),
}
"""Places of each type; many of them share their bytes with places of others."""

SOURCES = {
    "BOOL": (
        "TRUE",
        "FALSE",
        "PEEK_BOOL(area := 16#84, dbNumber := 5, byteOffset := #i, bitOffset := 3)",
    ),
    "BYTE": ("BYTE#16#A5", "PEEK(area := 16#84, dbNumber := 5, byteOffset := #i)"),
    "WORD": ("WORD#16#1234", "PEEK_WORD(area := 16#83, dbNumber := 0, byteOffset := #i)"),
    "INT": ("-2", "#i * 1000", '"Taken"(value := #mixed.wide, other := "DB5".speed)'),
    "DWORD": ("DWORD#16#3F8000FF", "DWORD#0"),
    "REAL": ("-1.5", "0.1"),
}

CALLS = (
    "POKE(area := 16#84, dbNumber := 5, byteOffset := #i, value := WORD#16#BEEF);",
    "POKE(area := 16#83, dbNumber := 0, byteOffset := #i + 1, value := BYTE#16#77);",
    "POKE_BOOL(area := 16#84, dbNumber := 5, byteOffset := 0, bitOffset := #i, value := TRUE);",
    "POKE_BLK(area_src := 16#84, dbNumber_src := 5, byteOffset_src := 0, area_dest := 16#84,"
    " dbNumber_dest := 5, byteOffset_dest := #i, count := 6);",
    "MOVE_BLK(IN := #bytes[0], COUNT := #i, OUT => #bytes[1]);",
    "FILL_BLK(IN := BYTE#16#11, COUNT := 2, OUT => #mixedBytes[#i]);",
    '#plain := BLKMOV(SRCBLK := #mixed, DSTBLK => "DB5".row);',
    "#plain := BLKMOV(SRCBLK := P#DB5.DBX2.0 BYTE 6, DSTBLK => #bytes);",
    "#plain := FILL(BVAL := #mixedWord, BLK => #mixed);",
    '"Raise"(value := #mixed.wide);',
    '"Raise"(value := "DB5".speed);',
    '"Raise"(value := #words[1]);',
    '"Raise"(value := #tempInt);',
    "#i := (#i + 1) MOD 5;",
)

DECLARATIONS = """
DATA_BLOCK "DB5"
{ S7_Optimized_Access := 'FALSE' }
STRUCT
  on : BOOL; off : BOOL; small : BYTE := 16#7F;
  speed : INT := -3; load : REAL := 2.0;
  row : ARRAY[0..7] OF BYTE := [1, 2, 3, 4, 5, 6, 7, 8];
END_STRUCT;
BEGIN
END_DATA_BLOCK

FUNCTION "Taken" : INT
VAR_INPUT value : INT; END_VAR
VAR_IN_OUT other : INT; END_VAR
BEGIN
  #other := #other + 1;
  %DB5.DBB3 := 16#55;
  "Taken" := #value + #other;
END_FUNCTION

FUNCTION "Raise" : Void
VAR_IN_OUT value : INT; END_VAR
BEGIN
  #value := #value + 7;
  "DB5".row[0] := %DB5.DBB2;
  #value := #value + "DB5".speed;
END_FUNCTION

FUNCTION_BLOCK "Outer"
{ S7_Optimized_Access := 'FALSE' }
VAR_INPUT double : DWORD; bytes AT double : ARRAY[0..3] OF BYTE; real AT double : REAL; END_VAR
VAR_OUTPUT flag : BOOL; END_VAR
VAR
  doubleAgain AT double : DWORD;
  mixed : STRUCT on : BOOL; small : BYTE; wide : INT := 5; part : REAL; END_STRUCT;
  mixedBytes AT mixed : ARRAY[0..7] OF BYTE;
  mixedWord AT mixed : WORD;
  words AT mixed : ARRAY[0..3] OF INT;
  pattern : WORD;
  bits AT pattern : ARRAY[0..15] OF BOOL;
  i : INT;
  plain : INT;
END_VAR
VAR_TEMP tempWord : WORD; tempInt AT tempWord : INT; END_VAR
BEGIN
"""


@st.composite
def statements(draw: st.DrawFn) -> str:
    """A few assignments, conditions and calls."""
    lines = []
    for _ in range(draw(st.integers(2, 12))):
        kind = draw(st.sampled_from(sorted(PLACES)))
        target, other = (draw(st.sampled_from(PLACES[kind])) for _ in range(2))
        source = draw(st.sampled_from((*SOURCES[kind], *PLACES[kind])))
        match draw(st.integers(0, 3)):
            case 0:
                lines.append(draw(st.sampled_from(CALLS)))
            case 1 if kind != "BOOL":
                lines.append(f"IF {target} > {other} THEN {other} := {source}; END_IF;")
            case _:
                lines.append(f"{target} := {source};")
    return "".join(f"  {line}\n" for line in lines)


def history(engine_name: str, program: Program, inputs: list[int]) -> list[str]:
    """What can be seen after each call; a fault ends it."""
    environment = StandaloneEnvironment()
    engine = engine_named(engine_name)(program, environment, Limits())
    block = BlockInstance(engine.instance("Outer"), program)
    seen = []
    for number in inputs:
        try:
            block(double=number)
        except DiagnosticError as fault:
            return [*seen, str(fault)]
        shown = (plain(block), engine.global_value("DB5"), environment.markers[:12])
        seen.append(repr(shown))
    return seen


@settings(max_examples=60)
@given(statements(), st.lists(st.integers(0, (1 << 32) - 1), min_size=1, max_size=3))
def test_both_engines_see_the_same_memory(body: str, inputs: list[int]) -> None:
    text = f"{DECLARATIONS}{body}END_FUNCTION_BLOCK\n"
    program = read_program([Source("memory.scl", text)])
    assert history("compiled", program, inputs) == history("reference", program, inputs), body
