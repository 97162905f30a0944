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
    "LoadedProgram": "engine.loading",
    "ObSettings": "engine.organization",
    "Period": "engine.organization",
    "PlantSetup": "installation",
    "Recorder": "trace",
    "Trace": "trace",
    "load_program": "engine.loading",
    "plant": "installation",
    "read_traces": "trace",
    "trace_text": "trace",
}


def __getattr__(name: str) -> object:
    from fbgen.faces import member  # noqa: PLC0415 - not before it is needed either

    return member(__name__, _HOMES, name)
