"""The harness: runs PLC text scan by scan against simulated gateways and inverters.

Blocks on their own, a whole simulated plant, and what a run of it leaves:

    program = load_program(["conveyor.scl"])
    installation = plant("plant.yaml")
    recorder = installation.record()
    installation.start()
    installation.run_for(2_000_000_000)
    trace = recorder.finish()

Nothing is imported before it is asked for: pytest looks at this package in every project.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from harness.engine.loading import LoadedProgram, load_program
    from harness.engine.organization import ObSettings, Period
    from harness.installation import PlantSetup, plant
    from harness.trace import Recorder, Trace, read_traces, trace_text

__all__ = [
    "LoadedProgram",
    "ObSettings",
    "Period",
    "PlantSetup",
    "Recorder",
    "Trace",
    "load_program",
    "plant",
    "read_traces",
    "trace_text",
]

_HOMES = {
    "LoadedProgram": "harness.engine.loading",
    "ObSettings": "harness.engine.organization",
    "Period": "harness.engine.organization",
    "PlantSetup": "harness.installation",
    "Recorder": "harness.trace",
    "Trace": "harness.trace",
    "load_program": "harness.engine.loading",
    "plant": "harness.installation",
    "read_traces": "harness.trace",
    "trace_text": "harness.trace",
}


def __getattr__(name: str) -> object:
    if name not in _HOMES:
        raise AttributeError(f"module 'harness' has no attribute '{name}'")
    return getattr(import_module(_HOMES[name]), name)
