"""Jobs of parameter channels as rules follow them, from their begin to their end."""

from collections.abc import Callable

from fbgen.dataclass import dataclass
from harness.engine.interface import Value

VARIABLES = tuple(
    f"parameter.{name}" for name in ("busy", "done", "mode", "number", "value", "result")
)
READ = 1
"""`mode` of a job; greater ones write."""


@dataclass(slots=True)
class Job:
    """What a channel was asked for."""

    begun_ns: int
    mode: Value
    number: Value
    value: Value

    def fits(self, result: Value) -> bool:
        """Whether it can have this result: what is written comes back."""
        return self.mode == READ or result == self.value


class JobFollower:
    """One channel, and the job that is under way; `answered` says whether somebody has answered a
    job with a result."""

    def __init__(self, answered: Callable[[Job, Value], bool]) -> None:
        self._answered = answered
        self._job: Job | None = None

    def wrong(self, busy: bool, done: bool, job: Job, result: Value) -> bool:
        """Whether a job has ended well that nobody has answered. `job` as it is asked for now."""
        if busy:
            self._job = self._job or job
            return False
        ended, self._job = self._job, None
        return ended is not None and done and not self._answered(ended, result)
