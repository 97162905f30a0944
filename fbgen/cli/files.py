"""Single files that commands write: whole or not at all, and never over somebody's work."""

import os
from pathlib import Path

from fbgen.diagnostics import error


def write_file(path: Path, text: str, *, overwrite: bool) -> None:
    """Write a text file, with the folders it needs.

    It goes to a temporary name first and is renamed, so a file is never half written. Raises
    DiagnosticError FB9001 if the file is there with another content and `overwrite` is not given,
    FB9002 if it cannot be written.
    """
    data = text.encode()
    try:
        if path.exists() and not overwrite and path.read_bytes() != data:
            raise error(
                "FB9001",
                f"{path} is already there",
                help="choose another folder; --force overwrites it",
            )
        path.parent.mkdir(parents=True, exist_ok=True)
        temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
        try:
            temporary.write_bytes(data)
            temporary.replace(path)
        finally:
            temporary.unlink(missing_ok=True)
    except OSError as problem:
        reason = problem.strerror or type(problem).__name__
        raise error(
            "FB9002",
            f"{path} cannot be written: {reason}",
            help="choose a place that you may write to",
        ) from None
