"""The harness: runs PLC text scan by scan against simulated gateways and inverters.

Blocks on their own, and a whole simulated plant:

    program = load_program(["conveyor.scl"])
    installation = plant("plant.yaml")

Nothing is imported before it is asked for: pytest looks at this package in every project.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from harness.engine.loading import LoadedProgram, load_program
    from harness.engine.organization import ObSettings, Period
    from harness.installation import plant

__all__ = ["LoadedProgram", "ObSettings", "Period", "load_program", "plant"]

_HOMES = {
    "LoadedProgram": "harness.engine.loading",
    "ObSettings": "harness.engine.organization",
    "Period": "harness.engine.organization",
    "load_program": "harness.engine.loading",
    "plant": "harness.installation",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'harness' has no attribute '{name}'")
    return getattr(import_module(_HOMES[name]), name)
