"""What files are called in messages and reports: as a person would write them in a command."""

import os.path
from pathlib import Path


def near(path: Path) -> Path:
    """The path from the working folder on, if it is in there."""
    relative = Path(os.path.relpath(path))
    return path if relative.parts[:1] == ("..",) else relative
