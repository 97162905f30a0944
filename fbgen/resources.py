"""Where the shipped data lies: in a checkout beside the packages, in a wheel inside them.

`catalog`, `templates`, `examples`, `schemas` and the diagnostics pages are plain files that users
read and copy, so they live at the top of the repository. The wheel carries them under
`fbgen/data` (see `pyproject.toml`).
"""

from functools import cache
from pathlib import Path

_PACKAGE = Path(__file__).resolve().parent
_IN_CHECKOUT = {"diagnostics": Path("docs") / "reference" / "diagnostics"}


@cache
def shipped(kind: str) -> Path:
    """The folder of one kind of shipped data.

    `kind` is "catalog", "templates", "examples", "schemas" or "diagnostics".
    """
    installed = _PACKAGE / "data" / kind
    if installed.is_dir():
        return installed
    return _PACKAGE.parent / _IN_CHECKOUT.get(kind, Path(kind))
