"""Single files that commands write: whole or not at all, and never over somebody's work."""

from collections.abc import Mapping
from pathlib import Path

from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.writing import replace_file, why_not_written


def write_file(path: Path, text: str, *, overwrite: bool) -> None:
    """Write a text file, with the folders it needs.

    It goes to a temporary name first and is renamed, so a file is never half written. Raises
    DiagnosticError FB9001 if the file is there with another content and `overwrite` is not given,
    FB9002 if it cannot be written.
    """
    write_files({path: text.encode()}, overwrite=overwrite)


def write_files(contents: Mapping[Path, bytes], *, overwrite: bool) -> None:
    """As `write_file` for several; if one of them is somebody's work, none is written."""
    if not overwrite and (theirs := [path for path in contents if _differs(path, contents[path])]):
        raise DiagnosticError(
            Diagnostic(
                "FB9001",
                f"{path} is already there",
                help="choose another folder; --force overwrites it",
            )
            for path in theirs
        )
    for path, data in contents.items():
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
        except OSError as problem:
            raise _not_writable(path, problem) from None
        rewrite_file(path, data)


def rewrite_file(path: Path, data: bytes) -> None:
    """Put this content in a file, whole or not at all; it keeps its rights.

    Links stay links: what they lead to is replaced. Raises DiagnosticError FB9002.
    """
    try:
        replace_file(path.resolve(), data)
    except OSError as problem:
        raise _not_writable(path, problem) from None


def _differs(path: Path, data: bytes) -> bool:
    try:
        return path.exists() and path.read_bytes() != data
    except OSError as problem:
        raise _not_writable(path, problem) from None


def _not_writable(path: Path, problem: OSError) -> DiagnosticError:
    reason, remedy = why_not_written(problem)
    return error("FB9002", f"{path} cannot be written: {reason}", help=remedy)
