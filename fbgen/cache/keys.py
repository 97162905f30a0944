"""The key of what is kept: a hash of everything that it was made from.

fbgen itself is among it: its version, and the size and times of each Python file of its packages,
so that in a checkout the next edit counts. So are the Python that runs it and the libraries that it
uses.
"""

import os
import sys
from collections.abc import Iterable, Iterator
from functools import cache
from hashlib import sha256
from importlib.util import find_spec
from pathlib import Path

import fbgen

_PACKAGES = ("fbgen", "harness")
_LIBRARIES = ("jinja2", "markupsafe", "pydantic", "pydantic_core", "yaml")
"""What the text of a plant goes through, beside fbgen."""


def key_of(parts: Iterable[str | bytes]) -> str:
    """The key for what these parts and this fbgen give, in hexadecimal.

    Each part counts with its length, so that nothing can move from one to the next.
    """
    digest = sha256(_made_by().encode())
    for part in parts:
        data = part.encode("utf-8", "surrogatepass") if isinstance(part, str) else part
        digest.update(b"%d:" % len(data))
        digest.update(data)
    return digest.hexdigest()


@cache
def _made_by() -> str:
    """fbgen, its libraries and Python, as they are now. They are looked at once in a process."""
    around = Path(fbgen.__file__).parents[1]
    folders = [around / name for name in _PACKAGES]
    files = (path for folder in folders if folder.is_dir() for path in _python_files(folder))
    stamps = [_stamp(path) for path in sorted(files)]
    for name in _LIBRARIES:
        found = find_spec(name)
        stamps.append(_stamp(found.origin) if found and found.origin else name)
    return "\n".join((fbgen.__version__, sys.version, sys.platform, *stamps))


def _python_files(folder: str | Path) -> Iterator[str]:
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir():
                yield from _python_files(entry.path)
            elif entry.name.endswith(".py"):
                yield entry.path


def _stamp(path: str) -> str:
    """A file as far as the file system tells it. A program can set the second time, not the third;
    on Windows that one is the time when the file was made."""
    found = os.stat(path)  # noqa: PTH116 - some hundred of them in each process
    return f"{path} {found.st_size} {found.st_mtime_ns} {found.st_ctime_ns}"
