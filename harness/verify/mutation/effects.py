"""What a change of the program changes in the plant: the first difference between two traces."""

from harness.kernel import NS_PER_MS
from harness.trace import Change, Trace


def first_difference(before: Trace, after: Trace) -> str:
    """The first channel that has another value, in words; "" if the plant does the same."""
    found = None
    ones, others = _by_channel(before), _by_channel(after)
    for channel, one, other in zip(before.channels, ones, others, strict=True):
        place = _first(one, other)
        if place is None:
            continue
        time_ns = min(changes[place].time_ns for changes in (one, other) if place < len(changes))
        if found is None or time_ns < found[0]:
            found = time_ns, channel.path, _at(one, time_ns), _at(other, time_ns)
    if found is None:
        return ""
    time_ns, path, value, changed = found
    values = f"{_shown(changed)} instead of {_shown(value)}"
    return f"{path} is {values} from {time_ns / NS_PER_MS:g} ms on"


def _by_channel(trace: Trace) -> list[list[Change]]:
    changes: list[list[Change]] = [[] for _ in trace.channels]
    for change in trace.changes:
        changes[change.channel].append(change)
    return changes


def _first(one: list[Change], other: list[Change]) -> int | None:
    for place in range(max(len(one), len(other))):
        if place >= min(len(one), len(other)):
            return place
        if (one[place].time_ns, one[place].value) != (other[place].time_ns, other[place].value):
            return place
    return None


def _at(changes: list[Change], time_ns: int) -> object:
    """The value of a channel at an instant."""
    before = [change.value for change in changes if change.time_ns <= time_ns]
    return before[-1] if before else None


def _shown(value: object) -> str:
    return value.hex(" ").upper() if isinstance(value, bytes) else str(value)
