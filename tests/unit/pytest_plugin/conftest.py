"""Sessions of pytester in this process forget the modules that they were the first to import, and
with them classes that others know already. So whatever a session may import is imported before."""

from importlib import import_module
from pkgutil import walk_packages

import pytest

import fbgen
import harness

_LEFT_OUT = ("fbgen.cli", "harness.serial", "harness.pytest_plugin")


@pytest.fixture(scope="session", autouse=True)
def everything_is_imported() -> None:
    """All modules that run a plant."""
    for package in (fbgen, harness):
        for module in walk_packages(package.__path__, f"{package.__name__}."):
            if not module.name.startswith(_LEFT_OUT):
                import_module(module.name)
