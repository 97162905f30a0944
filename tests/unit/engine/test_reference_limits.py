"""How deep and how long programs may be in the reference evaluator, and that nothing is missing."""

from fbgen.lang.checked import VariableKind
from fbgen.lang.checker.supplied.standard_blocks import STANDARD_BLOCKS
from fbgen.lang.checker.supplied.standard_functions import canonical_names
from fbgen.source import Source
from harness import load_program
from harness.engine.reference.expressions import STANDARD_FUNCTIONS


def run(body: str) -> int:
    text = f"""
FUNCTION_BLOCK "Deep"
VAR_INPUT
    one : DINT := 1;
END_VAR
VAR_OUTPUT
    result : DINT;
END_VAR
BEGIN
{body}
END_FUNCTION_BLOCK
"""
    block = load_program([Source("deep", text)], engine="reference").instance("Deep")
    block()
    result = block.result
    assert isinstance(result, int)
    return result


def test_a_sum_of_ten_thousand_operands() -> None:
    assert run(f"#result := {' + '.join(['#one'] * 10_000)};") == 10_000


def test_a_long_sum_of_mixed_types() -> None:
    assert run(f"#result := REAL_TO_DINT({' + '.join(['#one', '1.0'] * 2_000)});") == 4_000


def test_parentheses_as_deep_as_the_parser_allows() -> None:
    depth = 230
    assert run(f"#result := {'(#one + ' * depth}0{')' * depth};") == depth


def test_statements_as_deep_as_the_parser_allows() -> None:
    depth = 230
    assert run("IF #one = 1 THEN " * depth + "#result := 5;" + " END_IF;" * depth) == 5


def test_an_if_with_thousands_of_branches() -> None:
    branches = " ".join(f"ELSIF #one = {n} THEN #result := {n};" for n in range(2, 3000))
    assert run(f"#one := 2999; IF #one = 1 THEN ; {branches} END_IF;") == 2999


def test_every_standard_function_is_there() -> None:
    assert canonical_names() == set(STANDARD_FUNCTIONS)


def test_every_standard_block_runs() -> None:
    program = load_program([], engine="reference")
    for block in STANDARD_BLOCKS.values():
        instance = program.engine.instance(block.name)
        instance.call({})
        outputs = [one.name for one in block.variables if one.kind is VariableKind.OUTPUT]
        assert outputs
        assert all(instance.get(name) in (False, True, 0) for name in outputs)
