"""Entries in the cache folder: one file each, whole or not there, the oldest removed in time.

A file has a hash of its content in front. Processes share the folder without waiting for each
other: an entry is written under another name and renamed, and two that write the same entry write
the same content.
"""

import contextlib
import os
import re
import zlib
from collections.abc import Iterator
from hashlib import sha256
from pathlib import Path
from time import time

from fbgen.cache.folder import cache_folder
from fbgen.writing import replace_file

MOST_BYTES = 64 * 1024 * 1024
"""How large the folder may become. Then those that were not used for longest are removed."""

_SUFFIX = ".kept"
_UNFINISHED = re.compile(rf"\..+{re.escape(_SUFFIX)}\.\d+\.tmp")
_GONE_S = 3600.0
"""A file under a temporary name that is older than this belongs to a process that is gone."""
_DIGEST_BYTES = 32


def kept(key: str) -> bytes | None:
    """What was kept under this key; None if there is nothing, or it is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    path = folder / f"{key}{_SUFFIX}"
    try:
        data = path.read_bytes()
        content = _content(data)
        if content is None:
            path.unlink()
            return None
        os.utime(path)
    except OSError:
        return None
    return content


def keep(key: str, content: bytes) -> None:
    """Keep this for whoever asks for the key later, if that can be done."""
    folder = cache_folder()
    if folder is None:
        return
    packed = zlib.compress(content, 1)
    with contextlib.suppress(OSError):
        replace_file(folder / f"{key}{_SUFFIX}", sha256(packed).digest() + packed)
        _make_room(folder)


def _content(data: bytes) -> bytes | None:
    digest, packed = data[:_DIGEST_BYTES], data[_DIGEST_BYTES:]
    return zlib.decompress(packed) if sha256(packed).digest() == digest else None


def _make_room(folder: Path) -> None:
    """Remove what was not used for longest until three quarters of the room are enough."""
    files = sorted(_files(folder))
    total = sum(size for _, size, _ in files)
    if total <= MOST_BYTES:
        return
    for _, size, path in files:
        with contextlib.suppress(OSError):
            path.unlink()
        total -= size
        if total <= MOST_BYTES * 3 // 4:
            return


def _files(folder: Path) -> Iterator[tuple[float, int, Path]]:
    """The entries: when they were used, their size. What a process left unfinished is removed."""
    with os.scandir(folder) as entries:
        for entry in entries:
            with contextlib.suppress(OSError):
                found = entry.stat(follow_symlinks=False)
                path = Path(entry.path)
                if entry.name.endswith(_SUFFIX):
                    yield found.st_mtime, found.st_size, path
                elif _UNFINISHED.fullmatch(entry.name) and time() - found.st_mtime > _GONE_S:
                    path.unlink()
