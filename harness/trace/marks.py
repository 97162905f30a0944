"""What a scenario does and demands, on the time axis of the trace."""

from dataclasses import replace

from fbgen.source import Span
from harness.kernel import Kernel
from harness.trace.model import Mark, MarkKind, Verdict
from harness.trace.places import Places


class Marks:
    """Steps, checks and faults, in the order in which they began."""

    __slots__ = ("_kernel", "_places", "found")

    def __init__(self, kernel: Kernel, places: Places) -> None:
        self._kernel = kernel
        self._places = places
        self.found: list[Mark] = []

    def begin(self, kind: MarkKind, title: str, place: Span | None, target: str = "") -> int:
        """Something begins now; its number, for `end`."""
        number = self._places.of(place)
        self.found.append(Mark(self._kernel.now_ns, kind, title, None, target, number))
        return len(self.found) - 1

    def add_fault(
        self, title: str, target: str, place: Span | None, start_ns: int, end_ns: int | None
    ) -> None:
        """A fault of another time than now; `end_ns` None if it is still there."""
        number = self._places.of(place)
        self.found.append(Mark(start_ns, "fault", title, end_ns, target, number))
        self.found.sort(key=lambda mark: mark.start_ns)

    def end(self, number: int, verdict: Verdict | None = None) -> None:
        """What has this number is over now."""
        now_ns = self._kernel.now_ns
        self.found[number] = replace(self.found[number], end_ns=now_ns, verdict=verdict)
