"""Files to disk: whole or not at all, whatever ends the program in between."""

import os
import shutil
from pathlib import Path
from threading import get_native_id


def replace_file(path: Path, data: bytes) -> None:
    """Put this content in a file; it keeps its rights. A link is replaced, not followed.

    It goes to a temporary name first, one for each process and thread, which is renamed. Raises
    OSError.
    """
    temporary = path.with_name(f".{path.name}.{os.getpid()}{get_native_id()}.tmp")
    try:
        temporary.write_bytes(data)
        if path.exists():
            shutil.copymode(path, temporary)
        temporary.replace(path)
    except BaseException as problem:
        temporary.unlink(missing_ok=True)
        if isinstance(problem, OSError):  # the temporary name says nothing to a person
            problem.filename, problem.filename2 = str(path), None
        raise


def why_not_written(problem: OSError) -> tuple[str, str]:
    """What the system says about a file that it refuses to write, and what to do."""
    if isinstance(problem, FileExistsError | NotADirectoryError):
        return "a file stands where a folder is meant", "choose another place, or move the file"
    reason = problem.strerror or type(problem).__name__
    return reason, "choose a place that you may write to"
