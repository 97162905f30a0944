"""Whatever a conversion does not refuse is right in the other dialect."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError, render
from fbgen.lang.checker import check_reporting
from fbgen.lang.containers import read_document
from fbgen.lang.conversion import convert
from fbgen.lang.conversion_proof import errors_among, mistakes_in

_TESTS = Path(__file__).parents[2]
_DIALECTS = {".scl": ("tia", "step7"), ".st": ("iec", "twincat")}
# What only tia takes: the command refuses it with FB3055 when it has read its own text again.
_REFUSED_BY_THE_PROOF = frozenset({"same_structure.scl", "same_width.scl"})
_PROGRAMS = [
    pytest.param(path, id=f"{path.parent.name}-{path.name}")
    for folder in ("conformance", "corpus")
    for path in sorted((_TESTS / folder).rglob("*"))
    if path.suffix in _DIALECTS
]


@pytest.mark.parametrize("path", _PROGRAMS)
def test_a_program_is_refused_or_right(path: Path) -> None:
    for source in _DIALECTS[path.suffix]:
        document = read_document(path, source)
        file = document.file
        if errors_among(document.findings) or check_reporting([file], source)[0] is None:
            continue
        for target in {"tia", "step7", "iec", "twincat"} - {source}:
            try:
                converted = convert([file], target)
            except DiagnosticError as refused:
                codes = {found.code for found in refused.diagnostics}
                assert codes <= {"FB3050", "FB3051", "FB3052", "FB3053"}
            else:
                mistakes = [render(found) for found in mistakes_in(converted, target)]
                assert path.name in _REFUSED_BY_THE_PROOF or mistakes == []
