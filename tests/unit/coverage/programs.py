"""A block that has some of everything, and runs of it."""

from collections.abc import Mapping, Sequence

from fbgen.source import Source
from harness import load_program
from harness.engine.interface import Value
from harness.verify.coverage import Coverage
from harness.verify.coverage.counts import BlockCounts
from harness.verify.coverage.items import items_of

BELT = """\
FUNCTION_BLOCK "Belt"
VAR_INPUT start : BOOL; stop : BOOL; ready : BOOL; speed : INT; END_VAR
VAR_OUTPUT run : BOOL; level : INT; count : INT; END_VAR
VAR i : INT; END_VAR
BEGIN
  IF #start AND #ready AND NOT #stop THEN
    #run := TRUE;
  ELSIF #stop THEN
    #run := FALSE;
  END_IF;
  CASE #speed OF
    0: #level := 0;
    1..10: #level := 1;
  ELSE
    #level := 2;
  END_CASE;
  FOR #i := 1 TO #level DO
    #count := #count + 1;
    IF #count > 100 THEN EXIT; END_IF;
  END_FOR;
  REPEAT
    #i := #i + 1;
  UNTIL #i > 3 END_REPEAT;
END_FUNCTION_BLOCK
"""
IDLE: dict[str, Value] = {"start": False, "stop": False, "ready": False, "speed": 0}


def run_of(
    text: str,
    calls: Sequence[Mapping[str, Value]],
    coverage: Coverage | None = None,
    dialect: str = "tia",
) -> Coverage:
    """The coverage of calls of the block `Belt`, each with all inputs."""
    coverage = coverage or Coverage()
    program = load_program([Source("belt.scl", text)], dialect, probes=[coverage])
    block = program.instance("Belt")
    for inputs in calls:
        block(**inputs)
    return coverage


def belt(*calls: Mapping[str, Value], coverage: Coverage | None = None) -> Coverage:
    """The coverage of calls of `BELT`; inputs that are not given are FALSE or 0."""
    return run_of(BELT, [{**IDLE, **inputs} for inputs in calls], coverage)


def decided(
    condition: str, calls: Sequence[Mapping[str, Value]], dialect: str = "tia"
) -> BlockCounts:
    """The counts of a block with inputs a, b, c, d and x that assigns one decision."""
    begin, name, target = ("BEGIN", '"Belt"', "#q") if dialect == "tia" else ("", "Belt", "q")
    text = (
        f"FUNCTION_BLOCK {name}\nVAR_INPUT a, b, c, d : BOOL; x : INT; END_VAR\n"
        f"VAR q : BOOL; END_VAR\n{begin}\n  {target} := {condition};\nEND_FUNCTION_BLOCK\n"
    )
    (block,) = run_of(text, calls, dialect=dialect).blocks()
    return block


def missing(block: BlockCounts) -> list[tuple[str, int, str]]:
    """Kind, line and words of what is missing."""
    found = [item for item in items_of(block) if item.missing and not item.excluded]
    found.sort(key=lambda item: item.place)
    return [(item.kind, item.place.line, item.missing) for item in found]
