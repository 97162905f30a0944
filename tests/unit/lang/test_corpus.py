"""Programs in the style of real projects: read without findings, printed, read again."""

from pathlib import Path

import pytest
from trees import comments, read, shape

from fbgen.lang.encoding import read_source
from fbgen.lang.parser import parse_recovering
from fbgen.lang.printer import print_file

_CORPUS = Path(__file__).parent.parent.parent / "corpus"
_TEXTS = [
    (path.parent.name, path.name)
    for dialect in ("iec", "twincat")
    for path in sorted((_CORPUS / dialect).glob("*.st"))
]


@pytest.mark.parametrize(("dialect", "name"), _TEXTS)
def test_a_program_of_the_corpus_survives_printing(dialect: str, name: str) -> None:
    tree, findings = parse_recovering(read_source(_CORPUS / dialect / name), dialect)
    assert findings == []
    once = print_file(tree).text
    again = read(once, dialect)
    assert shape(again) == shape(tree)
    assert comments(again) == comments(tree)
    assert print_file(again).text == once
