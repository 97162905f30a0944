"""New files from trees: what `convert` writes. The same trees give the same bytes."""

from collections.abc import Iterator, Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.lang.ast import File
from fbgen.lang.containers.plcopen_writing import project
from fbgen.lang.containers.twincat_writing import objects
from fbgen.lang.printer import PrintedText, print_file

CONTAINERS = ("text", "twincat", "plcopen")
"""What `new_files` writes."""

_TEXT_SUFFIXES = {"tia": ".scl", "step7": ".scl"}


@dataclass(frozen=True, slots=True)
class NewFile:
    """A file to write: its name with suffix, and its bytes."""

    name: str
    data: bytes


def new_files(files: Sequence[File], container: str, stem: str) -> list[NewFile]:
    """The files that hold these trees: one text or project named `stem`, or one file an object.

    Raises `DiagnosticError`: FB3019 for what the container has no place for, FB3056 for characters
    that sources of STEP 7 cannot have.
    """
    if container == "text":
        return [_text(files, stem)]
    if container == "twincat":
        return [NewFile(name, _utf8(text)) for name, text in objects(files, stem)]
    if container == "plcopen":
        return [NewFile(f"{stem}.xml", _utf8(project(files, stem)))]
    raise error(
        "FB3019",
        f"there is no container '{container}'",
        help=f"choose one of: {', '.join(CONTAINERS)}",
    )


def _text(files: Sequence[File], stem: str) -> NewFile:
    dialect = files[0].dialect if files else "iec"
    printed = [print_file(file) for file in files]
    text = "\n".join(one.text for one in printed)
    name = stem + _TEXT_SUFFIXES.get(dialect, ".st")
    if dialect == "step7":
        if beyond := [found for one in printed for found in _beyond_ansi(one)]:
            raise DiagnosticError(beyond)
        return NewFile(name, text.encode("cp1252"))
    if dialect == "tia" and not text.isascii():
        # Without BOM, TIA Portal would read it as ANSI.
        return NewFile(name, text.encode("utf-8-sig"))
    return NewFile(name, _utf8(text))


def _beyond_ansi(printed: PrintedText) -> Iterator[Diagnostic]:
    """FB3056 for each line with a character that STEP 7 V5 cannot read."""
    for line, place in zip(printed.text.split("\n"), printed.places, strict=False):
        try:
            line.encode("cp1252")
        except UnicodeEncodeError as problem:
            char = line[problem.start]
            yield Diagnostic(
                "FB3056",
                f"this line has the character '{char}' (U+{ord(char):04X}), which is not ANSI",
                place,
                "STEP 7 V5 reads sources in ANSI (Windows-1252): use another character",
            )


def _utf8(text: str) -> bytes:
    return text.encode()
