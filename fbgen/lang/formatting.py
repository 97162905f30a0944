"""One file in its canonical layout, and proof that nothing else has changed.

    formatted = format_file(Path("pump.scl"))
    formatted.before, formatted.after

The new text is read again before anybody gets it: it has the same tree and the same comments, and
formatting it once more changes nothing.
"""

import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, Severity
from fbgen.lang.ast import File, TriviaKind
from fbgen.lang.containers import Document, read_document
from fbgen.lang.containers.document import document_of
from fbgen.lang.dialects import dialect_named
from fbgen.lang.lexer import tokenize
from fbgen.lang.same_tree import same_tree
from fbgen.source import Span

_COMMENTS = (TriviaKind.LINE_COMMENT, TriviaKind.BLOCK_COMMENT)
_COMMENT_MARKS = re.compile(r"[(*/)\s]+")


@dataclass(frozen=True, slots=True)
class Formatted:
    """A file as it is and as it should be; equal if it is in its canonical layout already.

    Errors in the text stand in `findings`, and the text stays as it is.
    """

    path: Path
    before: bytes
    after: bytes
    findings: tuple[Diagnostic, ...] = ()

    @property
    def is_broken(self) -> bool:
        """True if there are errors."""
        return any(one.severity is Severity.ERROR for one in self.findings)


def format_or_findings(dialect: str | None, path: Path) -> Formatted:
    """As `format_file`, with what it would raise in `findings`."""
    try:
        return format_file(path, dialect)
    except DiagnosticError as failure:
        return Formatted(path, b"", b"", failure.diagnostics)


def format_file(path: Path, dialect: str | None = None) -> Formatted:
    """The file in its canonical layout; encoding, BOM and line ends stay.

    In XML only the code changes. Raises `DiagnosticError` where nothing can be read: FB3011,
    FB3013, FB3014, FB3016, FB3018; FB3041 if the new text would say something else or lose a
    comment.
    """
    document = read_document(path, dialect)
    if any(one.severity is Severity.ERROR for one in document.findings):
        return Formatted(path, document.data, document.data, document.findings)
    data = document.rewritten(document.file)
    if data != document.data:
        _compare(document, data)
    return Formatted(path, document.data, data, document.findings)


def _compare(document: Document, data: bytes) -> None:
    """Raise FB3041 unless the new text says the same and stays as it is."""
    try:
        again = document_of(document.path, data, document.dialect)
    except DiagnosticError as unreadable:
        raise _changed(document, "cannot be read again", unreadable.diagnostics) from None
    errors = tuple(one for one in again.findings if one.severity is Severity.ERROR)
    if errors:
        raise _changed(document, "cannot be read again", errors)
    if not same_tree(again.file, document.file):
        raise _changed(document, "says something else")
    if lost := _lost_comments(document.file, again.file):
        raise _changed(document, "loses a comment", notes=lost)
    if again.rewritten(again.file) != data:
        raise _changed(document, "is not the last word: formatting it changes it again")


def _changed(
    document: Document,
    what: str,
    errors: tuple[Diagnostic, ...] = (),
    notes: tuple[Note, ...] = (),
) -> DiagnosticError:
    found = Diagnostic(
        "FB3041",
        f"{document.path} is left alone: its formatted text {what}",
        help="this is a defect of fbgen: please report it with the file",
        notes=notes,
    )
    return DiagnosticError((found, *errors))


def _lost_comments(file: File, again: File) -> tuple[Note, ...]:
    """A note for each comment of a text that the formatted one does not have."""
    kept = Counter(text for text, _ in _comments(again))
    lost: list[Note] = []
    for text, place in _comments(file):
        kept[text] -= 1
        if kept[text] < 0:
            lost.append(Note("this one", place))
    return tuple(lost)


def _comments(file: File) -> Iterator[tuple[str, Span]]:
    """All comments of a text without their marks, and their places."""
    for extra in tokenize(file.source, dialect_named(file.dialect)).extras:
        if extra.trivia.kind in _COMMENTS:
            yield _COMMENT_MARKS.sub("", extra.trivia.text), extra.trivia.span
