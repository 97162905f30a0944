"""Our corpus reads without findings, and printing it keeps the tree, the comments and itself."""

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from trees import comments, shape

from fbgen.diagnostics import render
from fbgen.lang.ast import TriviaKind
from fbgen.lang.dialects import dialect_named
from fbgen.lang.encoding import read_source
from fbgen.lang.lexer import tokenize
from fbgen.lang.parser import parse, parse_recovering
from fbgen.lang.printer import print_file
from fbgen.source import Source

_TESTS = Path(__file__).parents[2]
_FILES = sorted((_TESTS / "corpus").glob("*/*.*"))
_CASES = [
    pytest.param(path, path.parent.name, id=f"{path.parent.name}-{path.stem}") for path in _FILES
]

_DIALECTS = {".scl": ("tia", "step7"), ".st": ("iec", "twincat")}


def _first_without_errors(path: Path) -> str:
    """The first dialect of the file's suffix that reads it; the last one if none does."""
    *others, last = _DIALECTS[path.suffix]
    for dialect in others:
        if not parse_recovering(read_source(path), dialect)[1]:
            return dialect
    return last


_PROGRAMS = [
    pytest.param(path, _first_without_errors(path), id=f"{path.parent.name}-{path.name}")
    for path in sorted((_TESTS / "conformance").rglob("*"))
    if path.suffix in _DIALECTS
]


@pytest.mark.parametrize(("path", "dialect"), _CASES)
def test_it_is_read_without_findings(path: Path, dialect: str) -> None:
    _, findings = parse_recovering(read_source(path), dialect)
    assert [render(found) for found in findings] == []


@pytest.mark.parametrize(("path", "dialect"), _CASES + _PROGRAMS)
def test_its_print_has_the_same_tree_and_comments(path: Path, dialect: str) -> None:
    file = parse(read_source(path), dialect)
    again = parse(Source("again", print_file(file).text), dialect)
    assert shape(again) == shape(file)
    assert comments(again) == comments(file)


@pytest.mark.parametrize(("path", "dialect"), _CASES + _PROGRAMS)
def test_printing_twice_changes_nothing_more(path: Path, dialect: str) -> None:
    once = print_file(parse(read_source(path), dialect)).text
    assert print_file(parse(Source("once", once), dialect)).text == once


@pytest.mark.parametrize(("path", "dialect"), _CASES)
def test_no_comment_is_lost(path: Path, dialect: str) -> None:
    source = read_source(path)
    raw_lines = [match.span() for match in re.finditer(r"(?m)^TITLE.*$", source.text)]
    written = sorted(
        extra.trivia.text
        for extra in tokenize(source, dialect_named(dialect)).extras
        if extra.trivia.kind in (TriviaKind.LINE_COMMENT, TriviaKind.BLOCK_COMMENT)
        and not any(start <= extra.trivia.span.start < end for start, end in raw_lines)
    )
    kept = [text for text in comments(parse(source, dialect)) if not text.startswith("{")]
    assert kept == written


def _with_comments(path: Path, dialect: str, step: int) -> Iterator[Source]:
    """The text with one comment more, in front of one token after the other."""
    source = read_source(path)
    starts = tokenize(source, dialect_named(dialect)).starts
    for start in starts[1:-1:step]:
        yield Source("commented", f"{source.text[:start]}(* zz9 *){source.text[start:]}")


def _check_comments(path: Path, dialect: str, step: int) -> None:
    """A comment stays wherever it stands, and printing is stable; some places take none."""
    for source in _with_comments(path, dialect, step):
        file, findings = parse_recovering(source, dialect)
        if findings:
            continue
        once = print_file(file).text
        assert once.count("zz9") == 1, source.text
        assert print_file(parse(Source("once", once), dialect)).text == once, source.text


@pytest.mark.parametrize(("path", "dialect"), _CASES)
def test_a_comment_stays_wherever_it_stands(path: Path, dialect: str) -> None:
    _check_comments(path, dialect, 29)


@pytest.mark.slow
@pytest.mark.parametrize(("path", "dialect"), _CASES)
def test_a_comment_stays_in_front_of_each_token(path: Path, dialect: str) -> None:
    _check_comments(path, dialect, 1)
