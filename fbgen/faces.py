"""Faces of packages that import a module only when somebody asks for a name in it (PEP 562).

A command imports what it needs and not what lies beside it: imports are most of a short one.

    _HOMES = {"read_text": "document", "new_files": "written_files"}

    def __getattr__(name: str) -> object:
        return member(__name__, _HOMES, name)

No name may be that of a module of the package: once that was imported, it would be meant.
"""

from collections.abc import Mapping
from importlib import import_module


def member(package: str, homes: Mapping[str, str], name: str) -> object:
    """What a package has under this name: `homes` has the module inside of it for each name.

    Raises AttributeError for a name that is not there, as Python does.
    """
    if name not in homes:
        raise AttributeError(f"module '{package}' has no attribute '{name}'")
    return getattr(import_module(f"{package}.{homes[name]}"), name)
