"""What the solver proves, what it must not prove, and that its terms do what the engine does."""

import random
from pathlib import Path

import pytest
import z3

from fbgen.catalog import load_catalog
from fbgen.lang.checked import Program, Variable, VariableKind
from fbgen.lang.types import Elementary, Family, StructType
from fbgen.plant import load_plant
from fbgen.source import Source
from harness import load_program
from harness.engine.loading import read_program
from harness.installation import generated_sources
from harness.verify.mutation.finding import mutants_of
from harness.verify.mutation.proof.memory import Memory
from harness.verify.mutation.proof.proving import Answer, compare, invariants_of, transition
from harness.verify.mutation.proof.terms import constant
from harness.verify.mutation.texts import mutated_text

ROOT = Path(__file__).parents[3]
HEAD = """FUNCTION "Half" : Int VAR_INPUT x : Int; END_VAR BEGIN #Half := #x / 2; END_FUNCTION
FUNCTION_BLOCK "Other" VAR_INPUT x : Int; END_VAR VAR_OUTPUT y : Int; END_VAR
BEGIN #y := #y + #x; END_FUNCTION_BLOCK
FUNCTION_BLOCK "Try"
VAR_INPUT a, b : Bool; i, j : Int; w : Word; d : DInt; r : Real; END_VAR
VAR_OUTPUT out : Bool; n : Int; v : Word; m : DInt; q : Real; END_VAR
VAR list : ARRAY[0..3] OF Int; timer : TON_TIME; other : "Other"; old : Bool; END_VAR
VAR_TEMP t : Int; k : Int; END_VAR
BEGIN
"""


def try_of(body: str) -> Program:
    text = f"{HEAD}{body}\nEND_FUNCTION_BLOCK\n"
    return read_program([Source("try.scl", text)], "tia")


def answer(first: str, second: str) -> Answer:
    """Whether two bodies are the same: the second is read as a block of its own."""
    text = f"{HEAD}{first}\nEND_FUNCTION_BLOCK\n"
    program = read_program([Source("try.scl", text)], "tia")
    other = try_of(second)
    block = program.blocks["try"]
    body = other.bodies[other.blocks["try"]]
    return compare(program, block, program.bodies[block], _moved(program, other, body)).answer


def _moved(program: Program, other: Program, body: tuple[object, ...]) -> tuple:  # type: ignore[type-arg]
    """The statements of the other program with the variables and blocks of this one."""
    from dataclasses import replace  # noqa: PLC0415 - used here only

    from harness.verify.mutation.rebuilding import is_node, parts_of  # noqa: PLC0415

    own = {one.name: one for one in program.blocks["try"].variables}
    inner = {one.name: one for one in program.blocks["other"].variables}
    half = {one.name: one for one in program.blocks["half"].variables}

    def moved(item: object) -> object:
        if isinstance(item, tuple) and type(item) is tuple:
            return tuple(moved(part) for part in item)
        if isinstance(item, Variable):
            for names in (own, inner, half):
                found = names.get(item.name)
                if found is not None and found.kind is item.kind:
                    return found
            return item
        if item is other.blocks["other"]:
            return program.blocks["other"]
        if item is other.blocks["half"]:
            return program.blocks["half"]
        if not is_node(item):
            return item
        changes = {name: moved(getattr(item, name)) for name in parts_of(item)}
        if "type" in changes and not isinstance(changes["type"], Elementary):
            variable = changes.get("variable")
            changes["type"] = variable.type if isinstance(variable, Variable) else changes["type"]
        return replace(item, **changes)  # type: ignore[type-var]

    result = moved(body)
    assert isinstance(result, tuple)
    return result


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("#out := #a AND #b;", "#out := #b AND #a;"),
        ("#out := NOT (#a AND #b);", "#out := NOT #a OR NOT #b;"),
        ("#n := #i + #j;", "#n := #j + #i;"),
        ("#t := 5;\n#n := 5;", "#n := 5;"),
        ("#n := 1;\n#n := #i;", "#n := #i;"),
        (
            "IF #a THEN #n := 1; ELSE #n := 2; END_IF;",
            "IF NOT #a THEN #n := 2; ELSE #n := 1; END_IF;",
        ),
        ("#v := #w AND 16#00FF;", "#v := SHR(IN := SHL(IN := #w, N := 8), N := 8);"),
        (
            "FOR #k := 0 TO 3 DO #list[#k] := #i; END_FOR;",
            "#list[3] := #i;\n#list[0] := #i;\n#list[1] := #i;\n#list[2] := #i;",
        ),
        (
            "CASE #i OF 1: #n := 1; 2: #n := 2; END_CASE;",
            "CASE #i OF 2: #n := 2; 1: #n := 1; END_CASE;",
        ),
        ("IF #a THEN RETURN; END_IF;\n#n := 1;", "IF NOT #a THEN #n := 1; END_IF;"),
        ("#out := ABS(#r) > 1.0;", "#out := #r > 1.0 OR #r < -1.0;"),
        ('#n := "Half"(x := #i);', '#t := #i;\n#n := "Half"(x := #t);'),
        (
            "WHILE #n < #i DO #n := #n + 1; END_WHILE;\n#m := INT_TO_DINT(#n);\n#out := #a AND #b;",
            "WHILE #n < #i DO #n := #n + 1; END_WHILE;\n#m := INT_TO_DINT(#n);\n#out := #b AND #a;",
        ),
        (
            "FOR #k := 0 TO #i DO #list[#k] := #j; END_FOR;\n#n := #k + #j;",
            "FOR #k := 0 TO #i DO #list[#k] := #j; END_FOR;\n#n := #j + #k;",
        ),
        (
            "IF #a THEN REPEAT #n := #n - #j; UNTIL #n < 0 END_REPEAT; END_IF;",
            "IF NOT #a THEN ; ELSE REPEAT #n := #n - #j; UNTIL #n < 0 END_REPEAT; END_IF;",
        ),
        ("#other(x := #i, y => #n);", "#t := #i;\n#other(x := #t);\n#n := #other.y;"),
    ],
)
def test_the_same_in_other_words_is_proved(first: str, second: str) -> None:
    assert answer(first, second) is Answer.EQUIVALENT


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("#out := #a AND #b;", "#out := #a OR #b;"),
        ("#n := #i + 1;", "#n := #i - 1;"),
        ("#out := #i < 3;", "#out := #i <= 3;"),
        ("#n := #i / 2;", "#n := WORD_TO_INT(SHR(IN := INT_TO_WORD(#i), N := 1));"),
        ("#out := #r <= 1.0;", "#out := NOT (#r > 1.0);"),
        ("#n := #t;", "#n := 0;"),
        ("#n := #i / #j;", "IF #j <> 0 THEN #n := #i / #j; END_IF;"),
        ("#n := #list[#i];", "IF #i >= 0 AND #i <= 3 THEN #n := #list[#i]; END_IF;"),
        ("#other(x := #i);", ";"),
        ("#other(x := #i);", "#other(x := #i);\n#other(x := #i);"),
        ("#timer(IN := #a, PT := T#1s);", "#timer(IN := #a, PT := T#2s);"),
        (
            "#timer(IN := #a, PT := T#1s);\n#out := #timer.Q;",
            "#timer(IN := #a, PT := T#1s);\n#out := #old;",
        ),
        ("#old := #a;", ";"),
        ("#m := REAL_TO_DINT(#r);", "#m := TRUNC(#r);"),
        ("#list[0] := 1;", "#list[1] := 1;"),
        ("IF #a THEN RETURN; END_IF;\n#n := 1;", "#n := 1;"),
        ("WHILE #n < #i DO #n := #n + 1; END_WHILE;", "WHILE #n <= #i DO #n := #n + 1; END_WHILE;"),
        ("WHILE #n < #i DO #n := #n + 1; END_WHILE;", ";"),
        (
            "#n := 1;\nWHILE #n < #i DO #n := #n + 2; END_WHILE;",
            "#n := 2;\nWHILE #n < #i DO #n := #n + 2; END_WHILE;",
        ),
        (
            "FOR #k := 0 TO #i DO #list[#k] := #j; END_FOR;",
            "IF #i < 4 THEN FOR #k := 0 TO #i DO #list[#k] := #j; END_FOR; END_IF;",
        ),
        (
            "FOR #k := 0 TO #i DO #list[0] := #j; END_FOR;\n#n := #k;",
            "FOR #k := 0 TO #i DO #list[0] := #j; END_FOR;\n#n := #i;",
        ),
        (
            "FOR #k := 0 TO 3 DO IF #a THEN EXIT; END_IF; #list[#k] := 1; END_FOR;",
            "FOR #k := 0 TO 3 DO IF #a THEN CONTINUE; END_IF; #list[#k] := 1; END_FOR;\n"
            "#list[0] := 1;",
        ),
    ],
)
def test_what_makes_a_difference_is_never_proved(first: str, second: str) -> None:
    assert answer(first, second) is not Answer.EQUIVALENT


@pytest.mark.parametrize(
    "loop",
    [
        "WHILE #n < 3 DO #other(x := #n);\n#n := #other.y; END_WHILE;",
        "WHILE NOT #timer.Q DO #n := #n + 1; END_WHILE;",
        "REPEAT #n := #n + 1; IF #a THEN RETURN; END_IF; UNTIL #n > #i END_REPEAT;",
    ],
)
def test_a_loop_that_does_more_than_calculate_is_no_proof(loop: str) -> None:
    assert answer(loop, loop) is Answer.UNKNOWN


def test_in_outs_that_may_be_one_variable_are_no_proof() -> None:
    text = (
        'TYPE "One" : STRUCT x : Int; END_STRUCT; END_TYPE\n'
        'FUNCTION_BLOCK "Pair" VAR_IN_OUT x, y : "One"; END_VAR\nBEGIN\n'
        "   #x.x := 1;\n   #y.x := 2;\nEND_FUNCTION_BLOCK\n"
        'FUNCTION_BLOCK "Caller" VAR p : "Pair"; z : "One"; END_VAR\nBEGIN\n'
        "   #p(x := #z, y := #z);\nEND_FUNCTION_BLOCK\n"
    )
    program = read_program([Source("pair.scl", text)], "tia")
    block = program.blocks["pair"]
    first, second = program.bodies[block]
    assert compare(program, block, (first, second), (second, first)).answer is Answer.UNKNOWN


# --- what a block keeps between its calls ---------------------------------------------------------

COUNTER = """FUNCTION_BLOCK "Counter"
VAR_INPUT step : Bool; by : Int; END_VAR
VAR_OUTPUT n : Int; END_VAR
VAR count : Int{initial}; state : Int; END_VAR
BEGIN
   IF #step THEN {statement} END_IF;
   CASE #state OF 0: #state := 3; 3: #state := 7; ELSE #state := 0; END_CASE;
   #n := #count;
END_FUNCTION_BLOCK
"""
WRAPS = "IF #count >= 255 THEN #count := 1; ELSE #count := #count + 1; END_IF;"
USER = 'FUNCTION_BLOCK "User"\nVAR one : "Counter"; END_VAR\nBEGIN\n   {use}\nEND_FUNCTION_BLOCK\n'


def known(statement: str = WRAPS, initial: str = "", more: str = "") -> set[tuple[object, ...]]:
    text = COUNTER.format(statement=statement, initial=initial) + more
    program = read_program([Source("counter.scl", text)], "tia")
    found = invariants_of((program,), program.blocks["counter"])
    return {(one.variable.name, one.relation, *one.values) for one in found}


def test_limits_of_a_counter_and_the_values_of_a_state_are_found() -> None:
    found = known(more=USER.format(use="#one(step := TRUE, by := 5);"))
    assert {("count", ">=", 0), ("count", "<=", 255), ("state", "=", 0, 3, 7)} <= found
    assert ("count", "<=", 1) not in found


@pytest.mark.parametrize(
    ("statement", "initial", "more"),
    [
        ("#count := #count + 1;", "", ""),
        ("#count := #by;", "", ""),
        (WRAPS, " := 300", ""),
        (WRAPS, "", USER.format(use="#one.count := 300;")),
        (WRAPS, "", 'DATA_BLOCK "Own" "Counter" BEGIN count := 300; END_DATA_BLOCK\n'),
    ],
)
def test_no_limit_is_known_of_what_something_else_may_write(
    statement: str, initial: str, more: str
) -> None:
    assert ("count", "<=", 255) not in known(statement, initial, more)


def test_a_flag_that_nobody_sets_is_known_and_one_that_somebody_sets_is_not() -> None:
    text = (
        'FUNCTION_BLOCK "Flags" VAR_INPUT a : Bool; i : Int; END_VAR\n'
        "VAR_OUTPUT never, once, any : Bool; always : Bool := TRUE; END_VAR\nBEGIN\n"
        "   #never := FALSE;\n   #always := TRUE;\n   #any := #a;\n"
        "   IF #never = (#i > 1) THEN #once := TRUE; END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    program = read_program([Source("flags.scl", text)], "tia")
    found = invariants_of((program,), program.blocks["flags"])
    assert {(one.variable.name, one.values) for one in found} == {("never", (0,)), ("always", (1,))}


def test_a_mutant_that_no_reachable_value_shows_is_proved() -> None:
    text = COUNTER.format(statement=WRAPS, initial="")
    program = read_program([Source("counter.scl", text)], "tia")
    block = program.blocks["counter"]
    body = program.bodies[block]
    mutants = mutants_of(block, body)
    other = next(one for one in mutants if "#count = 255" in mutated_text(one)).body(body)
    invariants = invariants_of((program,), block)
    assert compare(program, block, body, other).answer is Answer.DIFFERENT
    assert compare(program, block, body, other, invariants).answer is Answer.EQUIVALENT


# --- against the engine ---------------------------------------------------------------------------


def drawn(kind: Elementary, random_: random.Random) -> bool | int | float:
    if kind.family is Family.BOOL:
        return random_.random() < 0.5
    if kind.family is Family.REAL:
        return float(random_.choice((0.0, 1.5, -2.25, 650.0, 4096.0, random_.randint(-9999, 9999))))
    near = (
        0,
        1,
        2,
        3,
        5,
        255,
        kind.minimum,
        kind.maximum,
        random_.randint(kind.minimum, kind.maximum),
    )
    return max(kind.minimum, min(kind.maximum, random_.choice(near)))


def singles(variable: Variable) -> list[tuple[str, tuple[str, ...], Elementary]]:
    """The single values of a variable: path, names, type."""
    if isinstance(variable.type, Elementary):
        return [(variable.name, (), variable.type)]
    if isinstance(variable.type, StructType):
        return [
            (f"{variable.name}.{part.name}", (part.name.casefold(),), part.type)
            for part in variable.type.fields
            if isinstance(part.type, Elementary)
        ]
    return []


def _start(variable: Variable, names: tuple[str, ...], term: z3.ExprRef) -> tuple[object, object]:
    """What stands for a value at the start, and the value."""
    name = f"{variable.kind.value} {'.'.join((variable.name, *names))}"
    return z3.Const(name, term.sort()), term


def _in_out(name: str, given: dict[str, bool | int | float]) -> object:
    parts = {
        path.partition(".")[2]: value
        for path, value in given.items()
        if path.startswith(f"{name}.")
    }
    return parts or given[name]


def check_against_engine(sources: list[Source], name: str, rounds: int) -> None:
    program = load_program(sources, "tia")
    checked = program.engine.program
    block = checked.blocks[name.casefold()]
    memory: Memory = transition(checked, block, checked.bodies[block])
    random_ = random.Random(1)
    kinds = (VariableKind.INPUT, VariableKind.OUTPUT, VariableKind.STATIC, VariableKind.IN_OUT)
    known = [
        (variable, *one)
        for variable in block.variables
        if variable.kind in kinds
        for one in singles(variable)
    ]
    for _ in range(rounds):
        instance = program.engine.instance(name)
        given = {path: drawn(kind, random_) for _, path, _, kind in known}
        start = [
            _start(variable, names, constant(given[path], kind))
            for variable, path, names, kind in known
        ]
        in_outs = {one.name for one, *_ in known if one.kind is VariableKind.IN_OUT}
        for _, path, _, _ in known:
            if path.partition(".")[0] not in in_outs:
                instance.set(path, given[path])
        instance.call({name: _in_out(name, given) for name in in_outs})
        for variable, path, names, kind in known:
            term = z3.simplify(z3.substitute(memory.values[variable, names], *start))
            expected = z3.simplify(constant(instance.get(path), kind))  # type: ignore[arg-type]
            assert term.eq(expected), (path, given, term, expected)


def test_terms_of_shipped_blocks_give_what_the_engine_gives() -> None:
    catalog = load_catalog()
    sources = generated_sources(
        load_plant(ROOT / "tests/scenarios/one_drive.yaml", catalog), catalog
    )
    for name in ("TOS_TriggerCounter", "TOS_Handshake"):
        check_against_engine(sources, name, 40)


@pytest.mark.parametrize(
    "body",
    [
        "#n := #i / 3 + #j MOD 7 - #i * #j;",
        "#v := SHL(IN := #w, N := #i) OR ROR(IN := #w, N := 3) XOR NOT #w;",
        "#m := INT_TO_DINT(#i) * #d - #m;\n#out := #m < #d;",
        "#q := #r * 2.5 + #q - INT_TO_REAL(#i);\n#out := #q >= #r;",
        "#m := REAL_TO_DINT(#r);\n#n := DINT_TO_INT(#d);\n#v := INT_TO_WORD(#i);",
        "CASE #i OF 0..3: #n := #j; 5, 255: #n := 7; ELSE #n := 9; RETURN; END_CASE;\n#out := #a;",
        "#n := 0;\nFOR #k := 3 TO 9 BY 2 DO\n IF #i = #k THEN EXIT; END_IF;\n"
        " IF #a THEN CONTINUE; END_IF;\n #n := #n + #k;\nEND_FOR;\n#m := INT_TO_DINT(#k);",
    ],
)
def test_terms_give_what_the_engine_gives(body: str) -> None:
    text = f"{HEAD}{body}\nEND_FUNCTION_BLOCK\n"
    check_against_engine([Source("try.scl", text)], "Try", 40)
