"""What happens to a scenario while it runs, for those who look on."""

from enum import Enum

from fbgen.dataclass import dataclass
from harness.scenario.model import Step


class StepMoment(Enum):
    """What a step is told about."""

    BEGUN = "begun"
    DONE = "done"
    FAILED = "failed"


@dataclass(frozen=True, slots=True)
class StepEvent:
    """A step at an instant of the plant's time; `step.span` is its place in the file."""

    time_ns: int
    step: Step
    moment: StepMoment
