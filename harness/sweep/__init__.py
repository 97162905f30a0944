"""The phase sweep: a line's blocks in every phase of scan, PROFIBUS, gateway and drives.

`python -m harness.sweep plant.yaml` runs it for a plant with one gateway.
"""

from harness.sweep.conditions import Axes, Conditions, between_accesses
from harness.sweep.report import report
from harness.sweep.result import SweepResult
from harness.sweep.rig import Alteration, Observation, Rig
from harness.sweep.rules import Violation
from harness.sweep.running import Progressed, SweepRun
from harness.sweep.sweeping import Sweep

__all__ = [
    "Alteration",
    "Axes",
    "Conditions",
    "Observation",
    "Progressed",
    "Rig",
    "Sweep",
    "SweepResult",
    "SweepRun",
    "Violation",
    "between_accesses",
    "report",
]
