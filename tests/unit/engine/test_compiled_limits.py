"""How deep and how long blocks may be: Python's own limits must not show."""

from ctypes import c_float

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Branch,
    Constant,
    Expression,
    If,
    Place,
    Program,
    Repeat,
    Statement,
    VariableRef,
)
from fbgen.lang.types import BOOL, DINT
from fbgen.source import Source, Span
from harness import load_program
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Limits
from harness.engine.loading import read_program

NOWHERE = Span(Source("built by hand", "nothing"), 0, 7)


def text_of(body: str, declarations: str = "") -> Source:
    return Source(
        "deep.scl",
        f"""
FUNCTION_BLOCK "Deep"
VAR_INPUT
    one : DINT := 1;
END_VAR
VAR_OUTPUT
    result : DINT;
END_VAR
VAR
    number : DINT;
    flag : BOOL;
    floating : REAL;
    places : ARRAY[0..40] OF INT;
    {declarations}
END_VAR
BEGIN
{body}
END_FUNCTION_BLOCK
""",
    )


def run(body: str, declarations: str = "") -> int:
    block = load_program([text_of(body, declarations)]).instance("Deep")
    block()
    result = block.result
    assert isinstance(result, int)
    return result


def built(body: list[Statement], variables: Program) -> int:
    """The result of a block whose statements were not read from a text."""
    (block,) = variables.blocks.values()
    program = Program(
        variables.dialect,
        variables.blocks,
        {block: tuple(body)},
        variables.structures,
        variables.globals,
        variables.standard_blocks,
    )
    instance = CompiledEngine(program, StandaloneEnvironment(), Limits()).instance("Deep")
    instance.call({})
    result = instance.get("result")
    assert isinstance(result, int)
    return result


def empty_program() -> Program:
    return read_program([text_of(";")])


def place(program: Program, name: str) -> Place:
    (block,) = program.blocks.values()
    variable = next(one for one in block.variables if one.name == name)
    return VariableRef(NOWHERE, variable, variable.type)


def one_plus(depth: int, program: Program) -> Expression:
    """one + (one + (one + ... 0))."""
    code: Expression = Constant(NOWHERE, 0, DINT)
    for _ in range(depth):
        code = Binary(NOWHERE, "+", place(program, "one"), code, DINT)
    return code


# --- expressions --------------------------------------------------------------------------------


def test_a_sum_of_ten_thousand_operands() -> None:
    assert run(f"#result := {' + '.join(['#one'] * 10_000)};") == 10_000


def test_a_sum_of_ten_thousand_operands_wraps_around_like_a_short_one() -> None:
    assert run(f"#one := 2_000_000_000; #result := {' + '.join(['#one'] * 10_000)};") == (
        (20_000_000_000_000 + 2**31) % 2**32 - 2**31
    )


def test_a_long_condition_of_ten_thousand_terms() -> None:
    condition = " AND ".join(["#one = 1"] * 10_000)
    assert run(f"IF {condition} THEN #result := 7; END_IF;") == 7


def test_a_long_product_of_reals_is_rounded_after_each_operation() -> None:
    factors = " * ".join(["#floating"] * 2_000)
    factor = c_float(1.001).value
    product = factor
    for _ in range(1_999):
        product = c_float(product * factor).value
    expected = round(c_float(product * 1_000).value)
    assert run(f"#floating := 1.001; #result := REAL_TO_DINT({factors} * 1000.0);") == expected


def test_a_long_sum_inside_of_a_condition_of_a_loop() -> None:
    total = " + ".join(["#number"] * 500)
    assert (
        run(f"WHILE {total} < 5_000 DO #number := #number + 1; END_WHILE; #result := #number;")
        == 10
    )


@pytest.mark.parametrize("depth", [100, 240])
def test_parentheses_as_deep_as_the_parser_allows(depth: int) -> None:
    assert run(f"#result := {'(#one + ' * depth}0{')' * depth};") == depth


def test_five_hundred_parentheses() -> None:
    program = empty_program()
    body = Assignment(NOWHERE, place(program, "result"), one_plus(500, program))
    assert built([body], program) == 500


def test_deep_expressions_see_what_the_statements_before_have_written() -> None:
    inner = "(#one + " * 100 + "0" + ")" * 100
    body = f"#one := 2; #one := {inner}; #one := {inner}; #result := #one + #one;"
    assert run(body) == 40_000


def test_expressions_nested_deeper_than_the_limit_are_refused() -> None:
    program = empty_program()
    body = Assignment(NOWHERE, place(program, "result"), one_plus(1_001, program))
    with pytest.raises(DiagnosticError) as failure:
        built([body], program)
    (diagnostic,) = failure.value.diagnostics
    assert diagnostic.code == "FB6050"
    assert diagnostic.span == NOWHERE
    assert "1000" in diagnostic.message


# --- statements ---------------------------------------------------------------------------------


def test_150_nested_ifs() -> None:
    assert run("IF #one = 1 THEN " * 150 + "#result := 5;" + " END_IF;" * 150) == 5


def test_900_nested_ifs_and_statements_behind_them() -> None:
    program = empty_program()
    result = place(program, "result")
    statements: list[Statement] = [Assignment(NOWHERE, result, Constant(NOWHERE, 0, DINT))]
    for _ in range(900):
        branch = Branch(NOWHERE, Constant(NOWHERE, True, BOOL), tuple(statements))
        more = Binary(NOWHERE, "+", result, Constant(NOWHERE, 1, DINT), DINT)
        statements = [If(NOWHERE, (branch,), ()), Assignment(NOWHERE, result, more)]
    assert built(statements, program) == 900


def test_statements_nested_deeper_than_the_limit_are_refused() -> None:
    program = empty_program()
    statement: Statement = Assignment(NOWHERE, place(program, "result"), Constant(NOWHERE, 0, DINT))
    for _ in range(1_000):
        statement = Repeat(NOWHERE, (statement,), Constant(NOWHERE, True, BOOL))
    with pytest.raises(DiagnosticError, match="FB6050"):
        built([statement], program)


def test_30_nested_loops_with_variables_of_their_own() -> None:
    names = "".join(f"n{number} : INT; " for number in range(30))
    heads = "".join(f"FOR #n{number} := 1 TO {2 if number < 3 else 1} DO " for number in range(30))
    assert run(f"{heads} #result := #result + 1; {'END_FOR; ' * 30}", names) == 8


def test_30_nested_loops_over_elements_of_an_array() -> None:
    heads = "".join(f"FOR #places[{number}] := 1 TO 1 DO " for number in range(30))
    assert run(f"{heads} #result := #result + 1; {'END_FOR; ' * 30}") == 1


def test_30_nested_while_loops() -> None:
    body = "#result := #result + 1; #number := #number + 1; "
    assert run("WHILE #number < 5 DO " * 30 + body + "END_WHILE; " * 30) == 5


def test_exit_leaves_only_its_own_loop_however_deep() -> None:
    heads = "WHILE TRUE DO " * 30
    tails = "END_WHILE; #result := #result + 1; EXIT; " * 29
    body = "#result := #result + 1; EXIT; #result := 100; "
    assert run(f"{heads} {body} {tails} END_WHILE;") == 30


def test_continue_goes_on_with_its_own_loop_however_deep() -> None:
    heads = "".join("REPEAT IF TRUE THEN " for _ in range(60))
    tails = "".join("END_IF; UNTIL TRUE END_REPEAT; " for _ in range(60))
    assert run(f"{heads} #result := #result + 1; CONTINUE; #result := 100; {tails}") == 1


def test_return_leaves_the_block_however_deep() -> None:
    heads = "WHILE TRUE DO IF TRUE THEN " * 60
    tails = "END_IF; END_WHILE; #result := 100; " * 60
    assert run(f"#result := 3; {heads} RETURN; {tails}") == 3


def test_temporaries_are_shared_between_the_pieces_of_a_deep_block() -> None:
    text = """
FUNCTION "Deep" : DINT
VAR_INPUT one : DINT; END_VAR
VAR_OUTPUT twice : DINT; END_VAR
VAR_TEMP kept : DINT; list : ARRAY[1..3] OF DINT; END_VAR
BEGIN
    #kept := #one;
    #list[2] := 5;
    %s #kept := #kept + #list[2]; #twice := 2 * #kept; RETURN; %s
END_FUNCTION
"""
    text = text.replace("RETURN", "#Deep := #kept; RETURN")
    source = Source("deep.scl", text % ("IF #one > 0 THEN " * 150, "END_IF; " * 150))
    result = load_program([source]).call("Deep", one=4)
    assert result == 9


def test_an_if_with_five_thousand_branches() -> None:
    branches = " ".join(f"ELSIF #one = {n} THEN #result := {n};" for n in range(2, 5_001))
    body = f"IF #one = 1 THEN #result := 1; {branches} ELSE #result := -1; END_IF;"
    assert run(f"#one := 5000; {body}") == 5_000
    assert run(f"#one := 41; {body}") == 41
    assert run(f"#one := 1; {body}") == 1
    assert run(f"#one := 5001; {body}") == -1


def test_a_case_with_five_thousand_arms() -> None:
    arms = " ".join(f"{n}: #result := {n} + 1;" for n in range(5_000))
    body = f"CASE #one OF {arms} ELSE #result := -1; END_CASE;"
    assert run(f"#one := 4999; {body}") == 5_000
    assert run(f"#one := 0; {body}") == 1
    assert run(f"#one := 5000; {body}") == -1


def test_a_case_with_wide_ranges() -> None:
    arms = " ".join(f"{n * 1000}..{n * 1000 + 500}: #result := {n};" for n in range(100))
    body = f"CASE #one OF {arms} ELSE #result := -1; END_CASE;"
    assert [run(f"#one := {n}; {body}") for n in (-1, 0, 500, 501, 99_500, 99_501)] == (
        [-1, 0, 0, -1, 99, -1]
    )


@pytest.mark.parametrize("statements", [10_000, pytest.param(100_000, marks=pytest.mark.slow)])
def test_very_many_statements(statements: int) -> None:
    half = statements // 2
    assert run("#number := #number + 1; #result := #result + #number;\n" * half) == (
        (half * (half + 1) // 2 + 2**31) % 2**32 - 2**31
    )


def test_return_in_a_very_long_block() -> None:
    lines = "#result := #result + 1;\n" * 3_000
    body = f"{lines} IF #one = 1 THEN RETURN; END_IF; {lines}"
    assert run(body) == 3_000
