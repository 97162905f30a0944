"""Who wrote a variable: the statement and the instance, whatever the way of writing."""

from typing import Any

import pytest

from fbgen.source import Source
from harness.engine.compiled import CompiledEngine, writers_probe
from harness.engine.compiled.data.memory import Location
from harness.engine.environment import StandaloneEnvironment
from harness.engine.loading import read_program
from harness.kernel import Kernel


class Loaded:
    """A program with its writers; `run` runs MAIN, `who` gives text and instance."""

    def __init__(self, text: str, dialect: str = "tia") -> None:
        program = read_program([Source("program.scl", text)], dialect)
        probe = writers_probe(program)
        self.engine = CompiledEngine(program, StandaloneEnvironment(Kernel()), None, probe)

    def run(self) -> "Loaded":
        self.engine.run_block("Main")
        return self

    def who(self, path: str) -> tuple[str, Any] | None:
        where = self.engine.location(path)
        assert isinstance(where, Location)
        assert where.key is not None
        writers = self.engine.writers
        assert writers is not None
        entry = writers.of(where.owner, where.key)
        if entry is None:
            return None
        number, instance = entry
        return f"{writers.statements[number].span.text.rstrip(';')};", instance

    def text(self, path: str) -> str | None:
        found = self.who(path)
        return None if found is None else found[0]

    def instance(self, path: str) -> Any:
        where = self.engine.location(path)
        assert isinstance(where, Location)
        return where.read()


def tia(main: str, data: str = "", blocks: str = "", temp: str = "") -> Loaded:
    """A data block D with these variables, and MAIN with these statements."""
    return Loaded(
        f"""
{blocks}
DATA_BLOCK "D"
STRUCT
  x : Int; y : Int; flag : Bool; word : Word;
  list : ARRAY[1..4] OF Int;
  {data}
END_STRUCT;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK "Main"
VAR_TEMP
  i : Int; {temp}
END_VAR
BEGIN
{main}
END_ORGANIZATION_BLOCK
"""
    ).run()


COUNTER = """
FUNCTION_BLOCK "Counter"
VAR_INPUT  step : Int; END_VAR
VAR_OUTPUT total : Int; END_VAR
VAR_IN_OUT seen : Int; END_VAR
VAR  kept : Int; END_VAR
BEGIN
  #kept := #kept + #step;
  #total := #kept;
  IF #step > 1 THEN
    #seen := #kept;
  END_IF;
END_FUNCTION_BLOCK
DATA_BLOCK "C1" "Counter" BEGIN END_DATA_BLOCK
DATA_BLOCK "C2" "Counter" BEGIN END_DATA_BLOCK
"""


def test_the_last_of_several_assignments_counts() -> None:
    loaded = tia('"D".x := 1; "D".y := 2; "D".x := 3;')
    assert loaded.text("D.x") == '"D".x := 3;'
    assert loaded.text("D.y") == '"D".y := 2;'
    assert loaded.text("D.flag") is None


def test_a_branch_that_is_not_taken_writes_nothing() -> None:
    loaded = tia('IF "D".flag THEN "D".x := 1; ELSE "D".y := 1; END_IF;')
    assert loaded.text("D.x") is None
    assert loaded.text("D.y") == '"D".y := 1;'


def test_two_instances_of_a_block_are_told_apart() -> None:
    loaded = tia('"C1"(step := 1, seen := "D".x); "C2"(step := 2, seen := "D".y);', blocks=COUNTER)
    for name in ("C1", "C2"):
        assert loaded.who(f"{name}.kept") == ("#kept := #kept + #step;", loaded.instance(name))
        assert loaded.who(f"{name}.total") == ("#total := #kept;", loaded.instance(name))


def test_inputs_and_outputs_are_written_by_the_arguments_of_the_call() -> None:
    loaded = tia('"C1"(step := 2, seen := "D".x, total => "D".y);', blocks=COUNTER)
    assert loaded.text("C1.step") == "2;"
    assert loaded.text("D.y") == '"D".y;'
    assert loaded.who("D.y") == ('"D".y;', None)


def test_an_in_out_is_written_by_the_statement_in_the_block() -> None:
    loaded = tia('"C1"(step := 2, seen := "D".x);', blocks=COUNTER)
    assert loaded.who("D.x") == ("#seen := #kept;", loaded.instance("C1"))


def test_fields_of_a_structure_that_is_an_in_out() -> None:
    blocks = """
TYPE "pair" STRUCT a : Int; b : Int; END_STRUCT; END_TYPE
FUNCTION "Fill" : Void
VAR_IN_OUT p : "pair"; END_VAR
BEGIN
  #p.a := 7;
END_FUNCTION
"""
    loaded = tia('"Fill"(p := "D".two);', 'two : "pair";', blocks)
    assert loaded.text("D.two.a") == "#p.a := 7;"
    assert loaded.text("D.two.b") is None


def test_a_whole_structure_and_a_whole_array() -> None:
    data = "one : STRUCT a : Int; in : ARRAY[0..1] OF Bool; END_STRUCT; two : STRUCT a : Int; "
    data += "in : ARRAY[0..1] OF Bool; END_STRUCT; other : ARRAY[1..4] OF Int;"
    loaded = tia('"D".one := "D".two; "D".list := "D".other;', data)
    assert loaded.text("D.one.a") == loaded.text("D.one.in[1]") == '"D".one := "D".two;'
    assert loaded.text("D.list[4]") == '"D".list := "D".other;'
    assert loaded.text("D.other[4]") is None


def test_elements_are_told_apart_by_the_index_of_the_moment() -> None:
    loaded = tia('#i := 2; "D".list[#i] := 5; #i := 3; "D".list[#i + 1] := 6; "D".list[1] := 1;')
    assert loaded.text("D.list[1]") == '"D".list[1] := 1;'
    assert loaded.text("D.list[2]") == '"D".list[#i] := 5;'
    assert loaded.text("D.list[3]") is None
    assert loaded.text("D.list[4]") == '"D".list[#i + 1] := 6;'


def test_an_index_is_not_worked_out_twice() -> None:
    blocks = """
FUNCTION "Next" : Int
VAR_IN_OUT n : Int; END_VAR
BEGIN
  #n := #n + 1;
  "Next" := #n;
END_FUNCTION
"""
    loaded = tia('"D".list["Next"(n := "D".x)] := "Next"(n := "D".x);', blocks=blocks)
    plain = read_program([Source("p.scl", "")], "tia")
    assert plain is not None
    assert loaded.engine.global_value("D.x") == 2
    assert loaded.engine.global_value("D.list") == [0, 1, 0, 0]
    assert str(loaded.text("D.list[2]")).startswith('"D".list["Next"')


def test_loops_write_their_variable_and_what_is_in_them() -> None:
    loaded = tia('FOR "D".x := 1 TO 3 DO "D".list["D".x] := "D".x; END_FOR;')
    assert loaded.text("D.x") == 'FOR "D".x := 1 TO 3 DO "D".list["D".x] := "D".x; END_FOR;'
    assert loaded.text("D.list[3]") == '"D".list["D".x] := "D".x;'
    assert loaded.text("D.list[4]") is None


def test_bits_of_a_word_are_writes_of_the_word() -> None:
    loaded = tia('"D".word.%X3 := TRUE;')
    assert loaded.text("D.word") == '"D".word.%X3 := TRUE;'


def test_what_a_timer_has_is_written_by_its_call() -> None:
    loaded = tia('"D".t(IN := TRUE, PT := T#1s);', "t : TON_TIME;")
    for name in ("IN", "PT", "Q", "ET"):
        assert loaded.text(f"D.t.{name}") == '"D".t(IN := TRUE, PT := T#1s);'


def test_edges_are_written_by_their_call() -> None:
    loaded = tia('"D".r(CLK := "D".flag, Q => "D".flag);', "r : R_TRIG;")
    assert loaded.text("D.r.Q") == '"D".r(CLK := "D".flag, Q => "D".flag);'
    assert loaded.text("D.flag") == '"D".flag;'


@pytest.mark.parametrize(
    ("statement", "written", "others"),
    [
        ('FILL_BLK(IN := 3, COUNT := 2, OUT => "D".list[2]);', "23", "14"),
        ('MOVE_BLK(IN := "D".source[1], COUNT := 3, OUT => "D".list[1]);', "123", "4"),
    ],
)
def test_moves_of_elements_write_so_many(statement: str, written: str, others: str) -> None:
    loaded = tia(statement, "source : ARRAY[1..4] OF Int;")
    assert {loaded.text(f"D.list[{index}]") for index in written} == {statement}
    assert {loaded.text(f"D.list[{index}]") for index in others} == {None}


def test_a_block_move_writes_the_whole_area() -> None:
    statement = '#i := BLKMOV(SRCBLK := "D".source, DSTBLK => "D".list);'
    loaded = tia(statement, "source : ARRAY[1..4] OF Int;")
    assert loaded.text("D.list[4]") == statement


def test_after_a_reset_nobody_has_written_anything() -> None:
    loaded = tia('"D".x := 1;')
    assert loaded.text("D.x") == '"D".x := 1;'
    loaded.engine.reset(warm=False)
    assert loaded.text("D.x") is None


def test_outputs_have_the_writer_of_the_variable_that_went_there() -> None:
    main = """
"D".word := 16#1234;
%QW10 := "D".word;
%QB12 := 16#55;
#high := WORD_TO_BYTE(SHR(IN := "D".word, N := 8));
%QB13 := #high;
"""
    loaded = tia(main, temp="high : Byte;")
    writers = loaded.engine.writers
    assert writers is not None
    texts = {
        byte: writers.statements[number].span.text for byte, (number, _) in writers.outputs.items()
    }
    assert texts == {
        10: '"D".word := 16#1234;',
        11: '"D".word := 16#1234;',
        12: "%QB12 := 16#55;",
        13: '"D".word := 16#1234;',
    }


def test_without_the_probe_nothing_is_noted() -> None:
    program = read_program([Source("p.scl", COUNTER)], "tia")
    engine = CompiledEngine(program, StandaloneEnvironment(Kernel()))
    assert engine.writers is None
    assert "_writer_of" not in engine.python_source("Counter")


def test_variables_of_a_program_in_iec() -> None:
    text = """
FUNCTION_BLOCK FB_A
VAR_INPUT on : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
  q := on;
END_FUNCTION_BLOCK
PROGRAM Main
VAR a : FB_A; b : FB_A; x : INT; END_VAR
  a(on := TRUE);
  b(on := a.q);
  x := x + 1;
END_PROGRAM
"""
    loaded = Loaded(text, "iec").run()
    assert loaded.text("Main.x") == "x := x + 1;"
    assert loaded.who("Main.b.q") == ("q := on;", loaded.instance("Main.b"))
    assert loaded.text("Main.b.on") == "a.q;"
