"""Every standard function gives the same in both engines, for arguments of all its types.

The engines share neither arithmetic nor library, so a difference is an error in one of them. A test
fails for a function or an instruction that has no case here.
"""

import re
from functools import cache

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from routine_cases import ROUTINES, RoutineCase
from standard_function_cases import Case, cases, values

from fbgen.diagnostics import DiagnosticError, Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.checker.supplied.routines import MODELLED
from fbgen.lang.checker.supplied.standard_functions import canonical_names
from fbgen.lang.dates import of_dialect
from fbgen.lang.parser import parse
from fbgen.source import Source
from harness import LoadedProgram, load_program
from harness.engine.interface import Value
from harness.engine.variables import plain

CASES = cases()
DIALECTS = ("tia", "iec")
FEW = settings(max_examples=6, suppress_health_check=list(HealthCheck))
MANY = settings(FEW, max_examples=400)
ENGINES = ("compiled", "reference")


@cache
def accepted(name: str, dialect: str) -> tuple[Case, ...]:
    """The cases whose types the checker lets through."""
    cases = [case for case in CASES[name] if case.exists_in(dialect)]
    files = [parse(Source(case.block, case.text(dialect)), dialect) for case in cases]
    refused = {
        one.span.source.name
        for one in check_reporting(files, dialect)[1]
        if one.severity is Severity.ERROR and one.span is not None
    }
    return tuple(case for case in cases if case.block not in refused)


@cache
def programs(name: str, dialect: str) -> tuple[LoadedProgram, ...]:
    """One program with all cases of a function, in each engine."""
    texts = [Source(case.block, case.text(dialect)) for case in accepted(name, dialect)]
    return tuple(load_program(texts, dialect=dialect, engine=engine) for engine in ENGINES)


def outcome(program: LoadedProgram, block: str, inputs: dict[str, Value]) -> str:
    instance = program.instance(block)
    try:
        instance(**inputs)
    except DiagnosticError as fault:
        return str(fault)
    return repr(instance["y"])


def compare(name: str, dialect: str, data: st.DataObject) -> None:
    found = accepted(name, dialect)
    if not found:
        return
    case = data.draw(st.sampled_from(found))
    inputs = {
        f"a{number}": data.draw(values(of_dialect(kind, dialect)))
        for number, kind in enumerate(case.arguments)
    }
    compiled, reference = (
        outcome(program, case.block, inputs) for program in programs(name, dialect)
    )
    assert compiled == reference


@pytest.mark.parametrize("name", sorted(CASES))
@FEW
@given(data=st.data(), dialect=st.sampled_from(DIALECTS))
def test_engines_agree_on_a_function(name: str, dialect: str, data: st.DataObject) -> None:
    compare(name, dialect, data)


@pytest.mark.slow
@pytest.mark.parametrize("dialect", DIALECTS)
@pytest.mark.parametrize("name", sorted(CASES))
@MANY
@given(data=st.data())
def test_engines_agree_on_a_function_often(name: str, dialect: str, data: st.DataObject) -> None:
    compare(name, dialect, data)


def test_no_function_is_without_a_case() -> None:
    named = {case.name for found in CASES.values() for case in found}
    aliases = {"CEIL_REAL", "FLOOR_REAL", "ROUND_REAL", "TRUNC_REAL"}
    assert not canonical_names() - named - aliases - {"MUX_ELSE", "LIMIT_OR_IN"}
    assert any(case.names for case in CASES["MUX"])


@pytest.mark.parametrize("name", sorted(CASES))
def test_every_function_can_be_called(name: str) -> None:
    assert any(accepted(name, dialect) for dialect in DIALECTS)


# --- instructions with several outputs --------------------------------------------------------


def history(case: RoutineCase, engine: str, steps: list[tuple[int, dict[str, Value]]]) -> list[str]:
    program = load_program([Source("case", case.text)], dialect="tia", engine=engine)
    block = program.instance("Case")
    seen = []
    for wait_ms, inputs in steps:
        program.clock.advance(ms=wait_ms)
        try:
            block(**inputs)
        except DiagnosticError as fault:
            return [*seen, str(fault)]
        seen.append(repr(plain(block)))
    return seen


@pytest.mark.parametrize("name", sorted(ROUTINES))
@settings(FEW, max_examples=12)
@given(data=st.data())
def test_engines_agree_on_an_instruction(name: str, data: st.DataObject) -> None:
    case = ROUTINES[name]
    inputs = st.fixed_dictionaries(
        {}, optional={key: values(kind) for key, kind in case.inputs.items()}
    )
    wait_ms = st.sampled_from([0, 5, 990, 30_000])
    steps = data.draw(st.lists(st.tuples(wait_ms, inputs), min_size=1, max_size=6))
    assert history(case, "compiled", steps) == history(case, "reference", steps)


def test_no_instruction_is_without_a_case() -> None:
    called = {
        name
        for case in ROUTINES.values()
        for name in re.findall(r"\b([A-Z][A-Z0-9_]+)\(", case.text.upper())
    }
    assert not set(MODELLED) - called
