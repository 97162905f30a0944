"""Timers, counters and data blocks as parameters: TIMER, COUNTER, BLOCK_DB, DB_ANY.

Expected values: S7-SCL V5.3 manual, "Parameter types TIMER and COUNTER", "BLOCK"; TIA Portal help,
"DB_ANY".
"""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program
from harness.engine.variables import BlockInstance

_HERE = Path(__file__).parent
_BLOCKS = {"numbers.scl": ("tia", "Numbers"), "numbers.step7": ("step7", "FB1")}


@pytest.fixture(params=sorted(_BLOCKS))
def block(request: pytest.FixtureRequest, engine_name: str) -> BlockInstance:
    """A block that was called twice, two seconds apart."""
    dialect, name = _BLOCKS[request.param]
    path = _HERE / request.param
    numbers = {"values": 20} if dialect == "tia" else {}
    program = load_program([path], dialect=dialect, engine=engine_name, db_numbers=numbers)
    instance = program.instance(name)
    instance()
    assert not instance["q"]
    program.clock.advance(s=2)
    instance()
    return instance


def test_a_block_starts_the_timer_that_it_is_given(block: BlockInstance) -> None:
    assert block["q"]


def test_a_block_reads_the_data_block_that_it_is_given(block: BlockInstance) -> None:
    assert block["a"] == 5 + 7


def test_a_number_becomes_a_data_block(block: BlockInstance) -> None:
    assert block["c"] == 5 + 7


def test_the_number_of_a_named_data_block_is_handed_on(engine_name: str) -> None:
    path = _HERE / "numbers.scl"
    program = load_program([path], dialect="tia", engine=engine_name, db_numbers={"values": 20})
    instance = program.instance("Numbers")
    instance()
    assert instance["b"] == 50 + 70


_BY_NAME = """FUNCTION_BLOCK FB1
VAR_INPUT go : BOOL; END_VAR
VAR q : BOOL; count : WORD; END_VAR
VAR_TEMP rest : S5TIME; END_VAR
rest := S_ODT(T_NO := delay, S := go, TV := S5T#1s, Q => q);
count := S_CU(C_NO := "pieces", CU := go);
END_FUNCTION_BLOCK

FUNCTION ALSO : WORD
VAR_INPUT number : COUNTER; END_VAR
ALSO := S_CU(C_NO := number, CU := FALSE);
END_FUNCTION

FUNCTION SAME : WORD
SAME := ALSO(number := pieces);
END_FUNCTION
"""
_TABLE = """"delay                   ","T       5   ","TIMER     ",""
"pieces                  ","Z       3   ","COUNTER   ",""
"""


def test_a_timer_has_a_name_in_the_symbol_table(engine_name: str) -> None:
    program = load_program(
        [Source("fb1.scl", _BY_NAME)],
        dialect="step7",
        engine=engine_name,
        tags=[Source("symbols.sdf", _TABLE)],
    )
    block = program.instance("FB1")
    block(go=True)
    assert (block["q"], block["count"]) == (False, 1)
    program.clock.advance(s=1)
    block()
    assert block["q"]
    assert program.call("SAME") == 1


@pytest.mark.parametrize(
    ("value", "what"),
    [("T5", "a timer"), ("C3", "a counter"), ("Z3", "a counter"), ("T[1]", "a timer")],
)
def test_a_timer_or_counter_is_no_value(value: str, what: str) -> None:
    text = f"FUNCTION_BLOCK FB1\nVAR w : WORD; END_VAR\nw := {value};\nEND_FUNCTION_BLOCK\n"
    with pytest.raises(DiagnosticError) as failure:
        load_program([Source("fb1.scl", text)], dialect="step7")
    (found,) = failure.value.diagnostics
    assert found.code == "FB4047"
    assert found.message.startswith(f"{value} is {what}")
