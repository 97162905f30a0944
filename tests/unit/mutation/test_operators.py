"""Each operator on a block of its own, and that text and tree of a mutant say the same."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.lang.checked import Program
from fbgen.plant import load_plant
from fbgen.source import Source
from harness.engine.loading import read_program
from harness.installation import generated_sources
from harness.verify.mutation.finding import mutants_of
from harness.verify.mutation.mutant import Mutant, Operator
from harness.verify.mutation.texts import difference, mutated_text
from tests.unit.mutation.meaning import meaning

ROOT = Path(__file__).parents[3]
HEAD = """FUNCTION_BLOCK "Try"
VAR_INPUT
   on, other : Bool;
   word : Word;
   count : Int;
   level : Real;
   limit : Time;
END_VAR
VAR_OUTPUT
   out : Bool;
   result : Int;
   sent : Word;
   height : Real;
END_VAR
VAR_IN_OUT
   frame : Word;
END_VAR
VAR
   timer : TON_TIME;
   edge : R_TRIG;
   statOn : Bool;
   list : ARRAY[0..2] OF Int;
END_VAR
BEGIN
"""


def program_of(body: str) -> Program:
    return read_program([Source("try.scl", f"{HEAD}{body}\nEND_FUNCTION_BLOCK\n")], "tia")


def mutants(body: str) -> tuple[Mutant, ...]:
    program = program_of(body)
    block = program.blocks["try"]
    return mutants_of(block, program.bodies[block])


def changed(body: str, operator: Operator) -> list[str]:
    """The statements as the mutants of one operator have them."""
    found = [mutated_text(one) for one in mutants(body) if one.operator is operator]
    return [text.removeprefix(HEAD).removesuffix("\nEND_FUNCTION_BLOCK\n") for text in found]


@pytest.mark.parametrize(
    ("operator", "body", "expected"),
    [
        ("relational", "#out := #count < 3;", ["#out := #count <= 3;", "#out := #count <> 3;"]),
        ("relational", "#out := #word = 16#0001;", ["#out := #word <> 16#0001;"]),
        ("relational", "#out := #on <> #other;", ["#out := #on = #other;"]),
        ("logical", "#out := #on AND #other;", ["#out := #on OR #other;"]),
        ("logical", "#out := NOT #on;", ["#out := #on;"]),
        (
            "logical",
            "#out := #on OR #other AND #statOn;",
            ["#out := #on AND (#other AND #statOn);", "#out := #on OR (#other OR #statOn);"],
        ),
        (
            "arithmetic",
            "#result := #count - 2 * #count;",
            ["#result := #count + (2 * #count);", "#result := #count - (2 / #count);"],
        ),
        ("arithmetic", "#result := -#count;", ["#result := #count;"]),
        ("constant", "#result := 5;", ["#result := 6;", "#result := 4;"]),
        ("constant", "#out := #count = 5;", ["#out := #count = 6;"]),
        ("constant", "#out := TRUE;", ["#out := FALSE;"]),
        ("constant", "#height := 2.5;", ["#height := 3.5;"]),
        ("constant", "#list[2] := #count;", ["#list[1] := #count;"]),
        (
            "mask",
            "#sent := #word AND 16#0100;",
            ["#sent := #word OR 16#0100;", "#sent := #word AND 16#0000;"],
        ),
        ("bits", "#sent := 16#0300;", ["#sent := 16#0600;", "#sent := 16#0180;"]),
        ("byte_order", "#sent := 16#FC90;", ["#sent := 16#90FC;"]),
        ("byte_order", "#frame := #word;", []),
        (
            "byte_order",
            "#sent := SHL(IN := #word, N := 8) OR #frame;",
            ["#sent := SHL(IN := #frame, N := 8) OR #word;"],
        ),
        (
            "negate",
            "IF #on THEN\n   #out := TRUE;\nEND_IF;",
            ["IF NOT #on THEN\n   #out := TRUE;\nEND_IF;"],
        ),
        (
            "negate",
            "IF #on AND #other THEN\n   ;\nELSIF #count > 2 THEN\n   ;\nEND_IF;",
            [
                "IF NOT (#on AND #other) THEN\n   ;\nELSIF #count > 2 THEN\n   ;\nEND_IF;",
                "IF #on AND #other THEN\n   ;\nELSIF NOT (#count > 2) THEN\n   ;\nEND_IF;",
            ],
        ),
        ("drop", "#out := #on;", [";"]),
        ("drop", "#edge(CLK := #on);", [";"]),
        (
            "case",
            "CASE #count OF\n   1, 2: #out := #on;\n   5: #out := #other;\nEND_CASE;",
            ["CASE #count OF\n   5: #out := #on;\n   1, 2: #out := #other;\nEND_CASE;"],
        ),
        (
            "timer",
            "#timer(IN := #on, PT := T#2s);",
            ["#timer(IN := #on, PT := T#0ms);", "#timer(IN := #on, PT := T#4000ms);"],
        ),
        (
            "timer",
            "#timer(IN := #on, PT := #limit);",
            ["#timer(IN := #on, PT := T#0ms);", "#timer(IN := #on, PT := #limit + #limit);"],
        ),
        (
            "edge",
            "#out := #on AND NOT #statOn;\n#statOn := #on;",
            ["#out := #on;\n#statOn := #on;"],
        ),
        (
            "edge",
            "#edge(CLK := #on);\n#out := #edge.Q;",
            ["#edge(CLK := #on);\n#out := #edge.CLK;"],
        ),
    ],
)
def test_an_operator_makes_these_changes(operator: str, body: str, expected: list[str]) -> None:
    assert sorted(changed(body, Operator(operator))) == sorted(expected)


def test_a_word_that_goes_out_in_a_structure_is_turned() -> None:
    text = (
        'TYPE "Frame" : STRUCT data : Word; END_STRUCT; END_TYPE\n'
        'FUNCTION_BLOCK "Try" VAR_IN_OUT frame : "Frame"; END_VAR VAR_INPUT word : Word; END_VAR\n'
        "BEGIN\n   #frame.data := #word;\nEND_FUNCTION_BLOCK\n"
    )
    program = read_program([Source("try.scl", text)], "tia")
    block = program.blocks["try"]
    found = [
        one
        for one in mutants_of(block, program.bodies[block])
        if one.operator is Operator.BYTE_ORDER
    ]
    assert [difference(one).splitlines()[-2] for one in found] == [
        "+   #frame.data := ROL(IN := #word, N := 8);"
    ]


def test_ids_name_block_line_operator_and_number_and_stay() -> None:
    body = "#out := #count < 3;\n#result := 5;"
    line = HEAD.count("\n") + 1
    ids = [one.id for one in mutants(body)]
    assert ids == [one.id for one in mutants(body)]
    assert len(set(ids)) == len(ids)
    assert f"Try:{line}:relational:2" in ids
    assert f"Try:{line + 1}:constant:1" in ids


def test_only_the_wanted_operators_keep_their_numbers() -> None:
    program = program_of("#out := #count < 3 AND #word = 16#0003;")
    block = program.blocks["try"]
    every = mutants_of(block, program.bodies[block])
    some = mutants_of(block, program.bodies[block], [Operator.MASK])
    assert [one.id for one in some] == [one.id for one in every if one.operator is Operator.MASK]


def sources_of(plant: str) -> list[Source]:
    catalog = load_catalog()
    return generated_sources(load_plant(ROOT / plant, catalog), catalog)


def check_rounds(sources: list[Source], dialect: str, rounds: range) -> None:
    """One mutant of each block at a time, read again from its text."""
    program = read_program(sources, dialect)
    every = [mutants_of(block, body) for block, body in program.bodies.items()]
    for number in rounds:
        chosen = [found[number] for found in every if number < len(found)]
        texts = {one.place.source.name: mutated_text(one) for one in chosen}
        again = read_program(
            [Source(one.name, texts.get(one.name, one.text)) for one in sources], dialect
        )
        for one in chosen:
            body = one.body(program.bodies[one.block])
            read = again.bodies[again.blocks[one.block.name.casefold()]]
            assert meaning(body) == meaning(read), one.id


def test_the_text_of_a_mutant_means_what_its_tree_means() -> None:
    check_rounds(sources_of("tests/scenarios/one_drive.yaml"), "tia", range(0, 160, 80))


@pytest.mark.slow
@pytest.mark.parametrize(
    "plant", ["tests/scenarios/one_drive.yaml", "examples/five_drives/plant.yaml"]
)
def test_the_text_of_every_mutant_means_what_its_tree_means(plant: str) -> None:
    check_rounds(sources_of(plant), "tia", range(800))
