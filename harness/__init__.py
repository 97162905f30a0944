"""The harness: runs PLC text scan by scan against simulated gateways and inverters.

Blocks on their own, and a whole simulated plant:

    program = load_program(["conveyor.scl"])
    installation = plant("plant.yaml")
"""

from typing import TYPE_CHECKING

from harness.engine.loading import LoadedProgram, load_program
from harness.engine.organization import ObSettings, Period

if TYPE_CHECKING:
    from harness.installation import plant

__all__ = ["LoadedProgram", "ObSettings", "Period", "load_program", "plant"]


def __getattr__(name: str) -> object:
    """`plant` is imported when it is asked for: blocks on their own need no gateways."""
    if name == "plant":
        from harness.installation import plant  # noqa: PLC0415

        return plant
    raise AttributeError(f"module 'harness' has no attribute '{name}'")
