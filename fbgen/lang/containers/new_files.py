"""New files from trees: what `convert` writes. The same trees give the same bytes."""

from collections.abc import Sequence
from dataclasses import dataclass

from fbgen.diagnostics import error
from fbgen.lang.ast import File
from fbgen.lang.containers.plcopen_writing import project
from fbgen.lang.containers.twincat_writing import objects
from fbgen.lang.printer import print_file

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

    Raises `DiagnosticError`: FB3019 for what the container has no place for.
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
    return NewFile(stem + _TEXT_SUFFIXES.get(dialect, ".st"), text.encode())


def _utf8(text: str) -> bytes:
    return text.encode()
