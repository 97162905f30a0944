"""Where results are kept: the cache folder of the user, as each operating system has one.

Linux and others: `$XDG_CACHE_HOME/fbgen` or `~/.cache/fbgen` (XDG Base Directory Specification
0.8). macOS: `~/Library/Caches/fbgen`. Windows: `%LOCALAPPDATA%\\fbgen\\Cache`. `FBGEN_CACHE` names
another folder, or is `off`.

What lies there steers what is simulated, so on systems with file modes the folder must belong to
the user, and nobody else may write into it.
"""

import os
import stat
import sys
from pathlib import Path

SETTING = "FBGEN_CACHE"
OFF = "off"


def cache_folder() -> Path | None:
    """The folder, made if need be; None if nothing is to be kept or there is no safe place."""
    setting = os.environ.get(SETTING, "")
    if setting == OFF:
        return None
    try:
        folder = Path(setting).absolute() if setting else _usual()
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        return folder if _is_ours(folder) else None
    except (OSError, RuntimeError, ValueError):
        # No home, no rights, a file in the way, or a name that the system does not take.
        return None


def _usual() -> Path:
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA", "")
        return (Path(local) if local else Path.home() / "AppData" / "Local") / "fbgen" / "Cache"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Caches" / "fbgen"
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    return (named if named.is_absolute() else Path.home() / ".cache") / "fbgen"


def _is_ours(folder: Path) -> bool:
    """Whether nobody but the user can have put something there."""
    if sys.platform == "win32":
        return True
    found = folder.stat()
    return found.st_uid == os.geteuid() and not found.st_mode & (stat.S_IWGRP | stat.S_IWOTH)
