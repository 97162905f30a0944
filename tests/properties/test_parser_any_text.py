"""The parser gives a tree and findings for any text whatever, and nothing but diagnostics."""

import re
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from fbgen.diagnostics import DiagnosticError, Severity, render
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.encoding import decode
from fbgen.lang.parser import parse_recovering
from fbgen.lang.printer import print_file
from fbgen.source import Source

_TESTS = Path(__file__).parent.parent
_SAMPLES = _TESTS / "unit" / "lang" / "samples"
_PIECES = [
    re.findall(r"\s+|\w+|.", path.read_text(encoding="utf-8"))
    for path in sorted([*_SAMPLES.glob("*.scl"), *(_TESTS / "corpus").glob("*/*.*")])
]
_ALL_PIECES = sorted({piece for pieces in _PIECES for piece in pieces})
_DIALECT = st.sampled_from(sorted(DIALECTS))
_NASTY = st.sampled_from(
    (
        *("(*", "*)", '"', "'", "{", "}", "(", "[", "$", "%", "#", "16#", "//", "..", ":=", "T#"),
        *(":P", "^", "?=", "P#", "B#(", "M0.", "DB1.", "%DB1.", "CONST", "END_CONST", "LABEL"),
        *("REGION ", "END_REGION", "END_IF", "ELSE", "BEGIN", "D#1-1-1", "§", "¼"),
        *("\x00", "\u2028", "\ue000", "\n"),
    )
)


def _read(text: str, dialect: str) -> None:
    file, findings = parse_recovering(Source("any", text), dialect)
    for found in findings[:5]:
        assert found.span is not None
        assert 0 <= found.span.start <= found.span.end <= len(text)
        assert render(found)
    if not any(found.severity is Severity.ERROR for found in findings):
        once = print_file(file).text
        again, later = parse_recovering(Source("again", once), dialect)
        assert not [found for found in later if found.severity is Severity.ERROR]
        assert print_file(again).text == once


@given(st.binary(max_size=400), _DIALECT)
def test_any_bytes(data: bytes, dialect: str) -> None:
    try:
        text = decode(data, "any")
    except DiagnosticError:
        return
    _read(text, dialect)


@given(st.lists(st.one_of(_NASTY, st.sampled_from(_ALL_PIECES)), max_size=60), _DIALECT)
def test_any_mix_of_tokens(pieces: list[str], dialect: str) -> None:
    _read("".join(pieces), dialect)


@settings(max_examples=150)
@given(
    st.sampled_from(range(len(_PIECES))),
    st.lists(
        st.tuples(st.floats(0, 1), st.sampled_from(["drop", "copy", "put"]), _NASTY),
        min_size=1,
        max_size=8,
    ),
    _DIALECT,
)
def test_real_text_with_damage(
    sample: int, damage: list[tuple[float, str, str]], dialect: str
) -> None:
    pieces = list(_PIECES[sample])
    for where, what, nasty in damage:
        at = int(where * (len(pieces) - 1))
        if what == "drop":
            del pieces[at]
        elif what == "copy":
            pieces.insert(at, pieces[len(pieces) // 2])
        else:
            pieces[at] = nasty
    _read("".join(pieces), dialect)
