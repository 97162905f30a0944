"""The file of reasons why mutants are equivalent, and what they are called in it."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from harness.verify.mutation.equivalents import fingerprints, load_equivalents
from tests.unit.mutation.test_operators import mutants

BAD = Path(__file__).parents[1] / "bad"


def test_what_stands_there_twice_is_reported_at_its_place() -> None:
    with pytest.raises(DiagnosticError) as wrong:
        load_equivalents(BAD / "FB8068_twice.yaml")
    (found,) = wrong.value.diagnostics
    assert found.span is not None
    assert (found.code, found.span.line, found.span.column) == ("FB8068", 6, 5)


def test_each_mutant_has_a_name_of_its_own() -> None:
    found = fingerprints(mutants("#out := #on AND #other;\n#out := #on AND #other;"))
    assert len(found) == len(set(found)) == 4


def test_a_name_stays_where_other_lines_and_spaces_come_and_go() -> None:
    before = fingerprints(mutants("#out := #on AND #other;"))
    after = fingerprints(mutants("#result := 5;\n\n   #out :=  #on AND #other;"))
    assert set(before) < set(after)


def test_a_name_belongs_to_the_change_of_the_line() -> None:
    before = fingerprints(mutants("#out := #on AND #other;"))
    after = fingerprints(mutants("#out := #on AND NOT #other;"))
    assert not set(before) & set(after)
