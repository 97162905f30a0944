"""The list of instructions: nothing in it is unknown, its page is up to date, it is tested."""

import re
from functools import cache

import pytest

from fbgen.diagnostics import Severity
from fbgen.lang.checker import check_reporting
from fbgen.lang.checker.supplied.instruction_list import CATEGORIES, Treatment, treatment_of
from fbgen.lang.checker.supplied.instruction_page import page
from fbgen.lang.checker.supplied.refused_instructions import WRITTEN_OTHERWISE
from fbgen.lang.parser import parse
from fbgen.source import Source
from tests.architecture.sources import ROOT

NAMES = [name for names in CATEGORIES.values() for name in names]


@cache
def conformance_words() -> frozenset[str]:
    words: set[str] = set()
    for path in (ROOT / "tests" / "conformance").rglob("*.*"):
        if path.suffix in (".py", ".scl", ".st", ".step7"):
            words |= set(re.findall(r"\w+", path.read_text("utf-8").upper()))
    return frozenset(words)


def test_the_page_is_up_to_date() -> None:
    text = (ROOT / "docs" / "reference" / "instructions.md").read_text("utf-8")
    assert text == page(), "run python tools/instruction_index.py"


def test_no_instruction_stands_there_twice() -> None:
    assert len(NAMES) == len({name.upper() for name in NAMES})


def test_every_instruction_is_known() -> None:
    assert [name for name in NAMES if treatment_of(name) is None] == []


def test_what_runs_has_a_conformance_test() -> None:
    running = [name for name in NAMES if treatment_of(name) is Treatment.RUNS]
    assert [name for name in running if name.upper() not in conformance_words()] == []


@pytest.mark.parametrize(
    "name", [name for name in NAMES if treatment_of(name) is Treatment.REFUSED]
)
def test_what_is_refused_says_so_by_name(name: str) -> None:
    text = f'FUNCTION "F" : Void\nVAR_TEMP x : Int; END_VAR\n#x := {name}(IN := #x);\nEND_FUNCTION'
    _, findings = check_reporting([parse(Source("f.scl", text), "tia")], "tia")
    (found,) = [one for one in findings if one.code == "FB4141"]
    assert name in found.message
    assert found.help


@pytest.mark.parametrize("name", sorted(WRITTEN_OTHERWISE))
def test_what_is_written_otherwise_says_how(name: str) -> None:
    text = f'FUNCTION "F" : Void\nVAR_TEMP x : Int; END_VAR\n#x := {name}(#x);\nEND_FUNCTION'
    _, findings = check_reporting([parse(Source("f.scl", text), "tia")], "tia")
    (found,) = [one for one in findings if one.severity is Severity.ERROR]
    assert (found.code, found.help) == ("FB4004", WRITTEN_OTHERWISE[name])
