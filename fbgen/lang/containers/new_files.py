"""New files from trees: what `convert` writes. The same trees give the same bytes."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from fbgen.diagnostics import error
from fbgen.lang.ast import File
from fbgen.lang.containers.plcopen_writing import project
from fbgen.lang.containers.twincat_writing import objects
from fbgen.lang.printer import print_file
from fbgen.source import Source, Span

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
    text = "\n".join(print_file(file).text for file in files)
    encode = _ENCODERS.get(dialect, _utf8)
    return NewFile(stem + _TEXT_SUFFIXES.get(dialect, ".st"), encode(text))


def _for_tia(text: str) -> bytes:
    """UTF-8, with BOM where there is more than ASCII, else TIA Portal reads it as ANSI."""
    return text.encode("ascii" if text.isascii() else "utf-8-sig")


def _for_step7(text: str) -> bytes:
    """ANSI: STEP 7 V5 reads nothing else. Raises FB3056."""
    try:
        return text.encode("cp1252")
    except UnicodeEncodeError as problem:
        char = text[problem.start]
        raise error(
            "FB3056",
            f"the text for step7 has the character '{char}' (U+{ord(char):04X}), which is not ANSI",
            Span(Source("text for step7", text), problem.start, problem.start + 1),
            "STEP 7 V5 reads sources in ANSI (Windows-1252): use another character",
        ) from None


def _utf8(text: str) -> bytes:
    return text.encode()


_ENCODERS: dict[str, Callable[[str], bytes]] = {"tia": _for_tia, "step7": _for_step7}
