"""In-outs are references, though the compiled engine copies them where nobody can tell.

Every test runs in both engines: what a reference is, the reference evaluator defines.
"""

import pytest

from fbgen.source import Source
from harness import load_program

ENGINES = ["compiled", "reference"]

BLOCKS = """
DATA_BLOCK "Shared" STRUCT number : INT := 5; list : ARRAY[0..3] OF INT; END_STRUCT;
BEGIN
END_DATA_BLOCK

FUNCTION "AddTwice" : INT
VAR_INPUT amount : INT; END_VAR
VAR_IN_OUT first : INT; second : INT; END_VAR
BEGIN
    #first := #first + #amount;
    #second := #second + #amount;
    #AddTwice := #first * 100 + #second;
END_FUNCTION

FUNCTION "AddToShared" : INT
VAR_IN_OUT place : INT; END_VAR
BEGIN
    #place := #place + 1;
    "Shared".number := "Shared".number * 2;
    #AddToShared := #place;
END_FUNCTION

FUNCTION "Through" : INT
VAR_IN_OUT place : INT; END_VAR
BEGIN
    #Through := "AddToShared"(place := #place) + #place;
END_FUNCTION

FUNCTION "Split" : INT
VAR_INPUT number : INT; END_VAR
VAR_OUTPUT tens : INT; ones : INT; END_VAR
BEGIN
    #tens := #number / 10;
    #ones := #number MOD 10;
    #Split := #tens + #ones;
END_FUNCTION

FUNCTION_BLOCK "Counter"
VAR_INPUT step : INT := 1; END_VAR
VAR_IN_OUT place : INT; END_VAR
VAR sum : INT; kept : INT; END_VAR
BEGIN
    #sum := #sum + 1;
    #place := #place + #step;
    #kept := #sum;
    #sum := #sum + #kept;
END_FUNCTION_BLOCK

DATA_BLOCK "CounterDb" "Counter"
BEGIN
END_DATA_BLOCK
"""


def result(body: str, engine: str, declarations: str = "") -> object:
    text = f"""{BLOCKS}
FUNCTION_BLOCK "Main"
VAR_OUTPUT result : INT; END_VAR
VAR
    a : INT := 1; b : INT := 2; list : ARRAY[0..3] OF INT; word : WORD; i : INT;
    counter : "Counter"; {declarations}
END_VAR
VAR_TEMP t : INT; END_VAR
BEGIN
    #t := 0;
    {body}
END_FUNCTION_BLOCK
"""
    program = load_program([Source("main.scl", text)], engine=engine)
    block = program.engine.instance("Main")
    block.call({})
    places = block.get("list")
    assert isinstance(places, list)
    return (
        *(block.get("result"), block.get("a"), block.get("b"), tuple(places)),
        *(program.engine.global_value("Shared.number"), block.get("counter.sum")),
    )


@pytest.mark.parametrize("engine", ENGINES)
class TestReferences:
    def test_a_variable_of_its_own(self, engine: str) -> None:
        seen = result('#result := "AddTwice"(amount := 3, first := #a, second := #b);', engine)
        assert seen == (405, 4, 5, (0, 0, 0, 0), 5, 0)

    def test_the_same_variable_twice(self, engine: str) -> None:
        seen = result('#result := "AddTwice"(amount := 3, first := #a, second := #a);', engine)
        assert seen == (707, 7, 2, (0, 0, 0, 0), 5, 0)

    def test_a_temporary_twice(self, engine: str) -> None:
        body = '#t := 1; #result := "AddTwice"(amount := 3, first := #t, second := #t) + #t;'
        assert result(body, engine) == (714, 1, 2, (0, 0, 0, 0), 5, 0)

    def test_elements_that_may_be_the_same(self, engine: str) -> None:
        body = """#i := 2;
        #result := "AddTwice"(amount := 3, first := #list[#i], second := #list[2]);"""
        assert result(body, engine) == (606, 1, 2, (0, 0, 6, 0), 5, 0)

    def test_a_global_that_the_function_changes_too(self, engine: str) -> None:
        body = '#result := "AddToShared"(place := "Shared".number);'
        assert result(body, engine) == (12, 1, 2, (0, 0, 0, 0), 12, 0)

    def test_a_global_handed_on(self, engine: str) -> None:
        body = '#result := "Through"(place := "Shared".number);'
        assert result(body, engine) == (24, 1, 2, (0, 0, 0, 0), 12, 0)

    def test_an_element_of_a_global_handed_on(self, engine: str) -> None:
        body = """#i := 1;
        #result := "Through"(place := "Shared".list[#i]) + "Shared".list[1];"""
        assert result(body, engine) == (3, 1, 2, (0, 0, 0, 0), 10, 0)

    def test_the_index_is_looked_at_before_the_call(self, engine: str) -> None:
        body = """#i := 1;
        #result := "AddTwice"(amount := 2, first := #i, second := #list[#i]);"""
        assert result(body, engine) == (302, 1, 2, (0, 2, 0, 0), 5, 0)

    def test_a_slice(self, engine: str) -> None:
        body = """#word := 16#0102;
        "TakesByte"(place := #word.%B1); #result := WORD_TO_INT(#word);"""
        text = """FUNCTION "TakesByte" : VOID
        VAR_IN_OUT place : BYTE; END_VAR
        BEGIN #place := #place OR 16#30; END_FUNCTION
        """
        program = load_program(
            [
                Source(
                    "slice.scl",
                    f"""{text}
FUNCTION_BLOCK "Main"
VAR_OUTPUT result : INT; END_VAR
VAR word : WORD; END_VAR
BEGIN {body} END_FUNCTION_BLOCK
""",
                )
            ],
            engine=engine,
        )
        block = program.instance("Main")
        block()
        assert block.result == 0x3102

    def test_a_part_of_the_instance_that_is_called(self, engine: str) -> None:
        seen = result("#counter(step := 10, place := #counter.sum);", engine)
        assert seen == (0, 1, 2, (0, 0, 0, 0), 5, 10)

    def test_outputs_in_the_middle_of_an_expression(self, engine: str) -> None:
        body = '#result := 1000 + "Split"(number := 47, tens => #a, ones => #b) + #a + #b;'
        assert result(body, engine) == (1022, 4, 7, (0, 0, 0, 0), 5, 0)

    def test_outputs_in_a_condition_of_a_loop(self, engine: str) -> None:
        body = """
        #i := 34;
        WHILE "Split"(number := #i, tens => #a, ones => #list[#a MOD 4]) > 5 DO
            #i := #i - 7;
            #result := #result * 10 + #a;
        END_WHILE;"""
        assert result(body, engine) == result(body, "reference")

    def test_an_instance_in_a_data_block(self, engine: str) -> None:
        body = """
        "CounterDb"(step := 2, place := #a);
        "CounterDb"(place := "CounterDb".sum);
        #result := "CounterDb".sum + #a;"""
        assert result(body, engine) == result(body, "reference")

    def test_an_output_that_is_written_twice(self, engine: str) -> None:
        body = '#a := "Split"(number := 47, tens => #a, ones => #a); #result := #a;'
        assert result(body, engine) == (11, 11, 2, (0, 0, 0, 0), 5, 0)

    def test_own_variables_that_a_called_block_writes(self, engine: str) -> None:
        text = """
FUNCTION "Reach" : VOID
BEGIN
    "MainDb".a := "MainDb".a + 100;
END_FUNCTION
FUNCTION_BLOCK "Main"
VAR_OUTPUT result : INT; END_VAR
VAR a : INT; END_VAR
BEGIN
    #a := #a + 1; #a := #a + 1; #a := #a + 1;
    "Reach"();
    #a := #a + 1; #a := #a + 1;
    #result := #a;
END_FUNCTION_BLOCK
DATA_BLOCK "MainDb" "Main"
BEGIN
END_DATA_BLOCK
FUNCTION "Start" : VOID
BEGIN
    "MainDb"();
END_FUNCTION
"""
        program = load_program([Source("main.scl", text)], engine=engine)
        program.run("Start")
        assert program.engine.global_value("MainDb.result") == 105
