"""What a block does with structured parameters stays the same where they go through copies."""

from fbgen.lang.conversion import convert
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import Source
from harness import load_program

_SCL = """TYPE "Tank" STRUCT level : Int; name : String[10]; END_STRUCT; END_TYPE
FUNCTION "Fill" : Int
VAR_INPUT amount : Int; END_VAR
VAR_IN_OUT tank : "Tank"; END_VAR
BEGIN
  #tank.level := #tank.level + #amount;
  #tank.name := CONCAT(IN1 := #tank.name, IN2 := '+');
  #Fill := #tank.level;
END_FUNCTION
FUNCTION_BLOCK "Pump"
VAR_INPUT amount : Int; END_VAR
VAR_IN_OUT tank : "Tank"; other : "Tank"; END_VAR
VAR strokes : Int; END_VAR
BEGIN
  #strokes := #strokes + "Fill"(amount := #amount, tank := #tank);
  #other.level := #other.level - #amount;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "Hall"
VAR_INPUT amount : Int; END_VAR
VAR_OUTPUT first : Int; second : Int; strokes : Int; name : String[10]; END_VAR
VAR tanks : Array[1..2] of "Tank"; inst : "Row"; END_VAR
BEGIN
  #inst(amount := #amount, tanks := #tanks);
  #first := #tanks[1].level;
  #second := #tanks[2].level;
  #strokes := #inst.strokes;
  #name := #tanks[1].name;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "Row"
VAR_INPUT amount : Int; END_VAR
VAR_OUTPUT strokes : Int; END_VAR
VAR_IN_OUT tanks : Array[1..2] of "Tank"; END_VAR
VAR pump : "Pump"; END_VAR
BEGIN
  #pump(amount := #amount, tank := #tanks[1], other := #tanks[2]);
  #strokes := #pump.strokes;
END_FUNCTION_BLOCK
"""


def test_a_copy_does_what_the_parameter_did(engine_name: str) -> None:
    [file] = convert([parse(Source("hall.scl", _SCL), "tia")], "step7")
    classic = print_file(file).text
    assert "tank := copyTank, other := copyOther" in classic
    for text, dialect in ((_SCL, "tia"), (classic, "step7")):
        hall = load_program([Source("hall.scl", text)], dialect=dialect, engine=engine_name)
        block = hall.instance("Hall")
        for amount in (5, 7):
            block(amount=amount)
        assert (block.first, block.second, block.strokes, block.name) == (12, -12, 17, "++")
