"""Calls: which argument goes where, and what comes back."""

import pytest
from checking import errors_of, in_block, in_program, program_of

from fbgen.lang.checked import (
    Assignment,
    Block,
    Constant,
    Convert,
    Evaluate,
    FunctionCall,
    InstanceCall,
    StandardBlock,
    Statement,
    SystemCall,
    VariableRef,
)
from fbgen.lang.types import INT, WORD

SCALE = """
FUNCTION Scale : REAL
VAR_INPUT raw : INT; factor : REAL := 0.5; END_VAR
VAR_OUTPUT clipped : BOOL; END_VAR
VAR_IN_OUT calls : DINT; END_VAR
calls := calls + 1;
clipped := raw > 100;
Scale := raw * factor;
END_FUNCTION
"""
COUNTER = """
FUNCTION_BLOCK Counter
VAR_INPUT step : INT := 1; END_VAR
VAR_OUTPUT count : INT; END_VAR
VAR_IN_OUT total : DINT; END_VAR
count := count + step;
total := total + count;
END_FUNCTION_BLOCK
"""


def first_statement(text: str, block: str = "main", dialect: str = "iec") -> Statement:
    program = program_of(text, dialect)
    return program.bodies[program.blocks[block]][0]


def test_function_call_by_name_has_every_input_in_order() -> None:
    statement = first_statement(
        SCALE
        + in_program(
            "r : REAL; n : DINT; c : BOOL;",
            "r := Scale(factor := 2.0, raw := 7, calls := n, clipped => c);",
        )
    )
    assert isinstance(statement, Assignment)
    call = statement.value
    assert isinstance(call, FunctionCall)
    assert [variable.name for variable, _ in call.inputs] == ["raw", "factor"]
    assert [variable.name for variable, _ in call.in_outs] == ["calls"]
    assert [variable.name for variable, _ in call.outputs] == ["clipped"]


def test_function_call_in_iec_fills_in_initial_values() -> None:
    statement = first_statement(
        SCALE + in_program("r : REAL; n : DINT;", "r := Scale(raw := 7, calls := n);")
    )
    assert isinstance(statement, Assignment)
    assert isinstance(statement.value, FunctionCall)
    value = statement.value.inputs[1][1]
    assert isinstance(value, Constant)
    assert value.value == 0.5


def test_function_call_by_position_follows_the_declaration() -> None:
    statement = first_statement(
        SCALE + in_program("r : REAL; n : DINT; c : BOOL;", "r := Scale(7, 2.0, c, n);")
    )
    assert isinstance(statement, Assignment)
    call = statement.value
    assert isinstance(call, FunctionCall)
    assert len(call.inputs) == 2
    assert call.outputs[0][0].name == "clipped"


def test_function_may_be_called_for_its_effects() -> None:
    statement = first_statement(SCALE + in_program("n : DINT;", "Scale(raw := 7, calls := n);"))
    assert isinstance(statement, Evaluate)


def test_instance_call_leaves_out_what_keeps_its_value() -> None:
    statement = first_statement(
        COUNTER + in_program("c : Counter; t : DINT; n : DINT;", "c(total := t, count => n);")
    )
    assert isinstance(statement, InstanceCall)
    assert isinstance(statement.block, Block)
    assert statement.inputs == ()
    assert statement.outputs[0][1].type.name == "DINT"


def test_arguments_convert_like_assignments() -> None:
    statement = first_statement(
        COUNTER + in_program("c : Counter; t : DINT; s : SINT;", "c(step := s, total := t);")
    )
    assert isinstance(statement, InstanceCall)
    value = statement.inputs[0][1]
    assert isinstance(value, Convert)
    assert value.type == INT


@pytest.mark.parametrize(
    ("call", "code"),
    [
        ("c(step := 1);", "FB4040"),
        ("c(total => t);", "FB4041"),
        ("c(step => t, total := t);", "FB4041"),
        ("c(total := t, count := n);", "FB4041"),
        ("c(total := n);", "FB4010"),
        ("c(total := t, count => flag);", "FB4010"),
        ("c(step := 40000, total := t);", "FB4014"),
        ("c(step := 1.5, total := t);", "FB4010"),
        ("c(total := t + 1);", "FB4022"),
        ("c(total := t, totl := t);", "FB4006"),
        ("Counter(total := t);", "FB4045"),
        ("n := c(total := t);", "FB4045"),
        ("unknown(total := t);", "FB4004"),
        ("main();", "FB4051"),
    ],
)
def test_wrong_calls(call: str, code: str) -> None:
    found = errors_of(COUNTER + in_program("c : Counter; t : DINT; n : INT; flag : BOOL;", call))
    assert [one.code for one in found] == [code]


def test_unknown_parameter_suggests_the_nearest() -> None:
    (found,) = errors_of(COUNTER + in_program("c : Counter; t : DINT;", "c(totl := t);"))
    assert found.help == "did you mean 'total'?"


def test_standard_block_is_known_by_all_its_names() -> None:
    for name in ("TON", "TON_TIME", "SFB4"):
        statement = first_statement(
            in_block(f"t : {name};", "#t(IN := TRUE, PT := T#1s);"), "test", "tia"
        )
        assert isinstance(statement, InstanceCall)
        assert isinstance(statement.block, StandardBlock)
        assert statement.block.name == "TON"
        assert statement.instance.type.name == "TON"


def test_iec_timer_takes_its_kind_from_the_call() -> None:
    statement = first_statement(
        in_block("t : IEC_TIMER;", "#t.TOF(IN := TRUE, PT := T#1s);"), "test", "tia"
    )
    assert isinstance(statement, InstanceCall)
    assert (statement.block.name, statement.instance.type.name) == ("TOF", "IEC_TIMER")


def test_block_of_the_user_hides_the_standard_one() -> None:
    text = """
FUNCTION_BLOCK TON
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT gone : BOOL; END_VAR
gone := go;
END_FUNCTION_BLOCK
"""
    statement = first_statement(text + in_program("t : TON;", "t(go := TRUE);"))
    assert isinstance(statement, InstanceCall)
    assert isinstance(statement.block, Block)


def test_array_of_instances_is_called_by_index() -> None:
    statement = first_statement(
        in_program("t : ARRAY[1..3] OF TON; i : INT;", "t[i](IN := TRUE, PT := T#1s);")
    )
    assert isinstance(statement, InstanceCall)


def test_instruction_reads_into_an_area() -> None:
    statement = first_statement(
        in_block(
            "ret : INT; rec : ARRAY[0..7] OF BYTE;",
            "#ret := DPRD_DAT(LADDR := W#16#100, RECORD => #rec);",
        ),
        "test",
        "tia",
    )
    assert isinstance(statement, Assignment)
    call = statement.value
    assert isinstance(call, SystemCall)
    assert call.name == "DPRD_DAT"
    laddr, record = call.arguments
    assert (laddr[0], laddr[1].type) == ("LADDR", WORD)
    assert (record[0], isinstance(record[1], VariableRef)) == ("RECORD", True)


def test_classic_name_and_ret_val_of_an_instruction() -> None:
    statement = first_statement(
        in_block(
            "ret : INT; rec : ARRAY[0..7] OF BYTE; adr : HW_IO;",
            "SFC15(LADDR := #adr, RECORD := #rec, RET_VAL => #ret);",
        ),
        "test",
        "tia",
    )
    assert isinstance(statement, Assignment)
    assert isinstance(statement.value, SystemCall)
    assert statement.value.name == "DPWR_DAT"
    assert isinstance(statement.value.arguments[0][1], Convert)


def test_record_of_dprd_dat_is_an_output() -> None:
    text = in_block(
        "ret : INT; rec : ARRAY[0..7] OF BYTE;",
        "#ret := DPRD_DAT(LADDR := 16#100, RECORD := #rec);",
    )
    assert [one.code for one in errors_of(text, "tia")] == ["FB4041"]


def test_tia_function_needs_all_inputs() -> None:
    text = """
FUNCTION "F" : INT
VAR_INPUT a : INT; b : INT := 3; END_VAR
BEGIN
  #F := #a + #b;
END_FUNCTION
"""
    found = errors_of(text + in_block("x : INT;", '#x := "F"(a := 1);'), "tia")
    assert [one.code for one in found] == ["FB4040"]


def test_unquoted_name_in_tia_means_the_instruction() -> None:
    text = """
FUNCTION "ABS" : INT
VAR_INPUT IN : INT; END_VAR
BEGIN
  #ABS := #IN;
END_FUNCTION
"""
    own = first_statement(text + in_block("x : INT;", '#x := "ABS"(IN := #x);'), "test", "tia")
    built_in = first_statement(text + in_block("x : INT;", "#x := ABS(#x);"), "test", "tia")
    assert isinstance(own, Assignment)
    assert isinstance(own.value, FunctionCall)
    assert isinstance(built_in, Assignment)
    assert not isinstance(built_in.value, FunctionCall)


GLOBAL_INSTANCES = """
FUNCTION_BLOCK "Motor"
VAR_INPUT
  speed : INT;
END_VAR
BEGIN
  ;
END_FUNCTION_BLOCK
FUNCTION_BLOCK "Valve"
VAR_INPUT
  speed : INT;
END_VAR
BEGIN
  ;
END_FUNCTION_BLOCK
DATA_BLOCK "Motor_DB"
"Motor"
BEGIN
END_DATA_BLOCK
FUNCTION "main" : VOID
BEGIN
  {call}
END_FUNCTION
"""


def test_a_global_instance_of_step7_is_called_behind_its_block() -> None:
    text = GLOBAL_INSTANCES.replace("{call}", '"Motor"."Motor_DB"(speed := 1);')
    statement = first_statement(text, dialect="step7")
    assert isinstance(statement, InstanceCall)
    assert isinstance(statement.block, Block)
    assert statement.block.name == "Motor"


@pytest.mark.parametrize(
    ("call", "code"),
    [
        ('"Valve"."Motor_DB"(speed := 1);', "FB4047"),
        ('"Motor"."Other_DB"(speed := 1);', "FB4001"),
        ('"Motor"."Motor_DB"(power := 1);', "FB4006"),
    ],
)
def test_wrong_calls_of_global_instances_in_step7(call: str, code: str) -> None:
    found = errors_of(GLOBAL_INSTANCES.replace("{call}", call), "step7")
    assert [item.code for item in found] == [code]
