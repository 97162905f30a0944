"""Telegrams to different drives are never closer than the gateway's manual allows (section 9).

What a gateway sends once more by itself, while it was always there for the PLC, does not count:
zeros of a master in CLEAR make it forget its trigger, and the PLC cannot know. Nor does a telegram
that it sent later than its manual says: the PLC has given that up by then, and the next one may be
close behind.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.line_log import LineLog, Sent, line_logs
from harness.rules.rule import Rule, Watch


class _Unseen:
    """Telegrams of a line that began when the PLC could not know, by the instant at which they
    did: what it could not know of at all, and what came late."""

    def __init__(self, log: LineLog) -> None:
        self.unnoticed: set[int] = set()
        self.late: set[int] = set()
        log.on_sent.append(self._sent)

    def _sent(self, sent: Sent) -> None:
        if sent.is_unnoticed:
            self.unnoticed.add(sent.start_ns)
        if sent.is_late:
            self.late.add(sent.start_ns)

    def excuses(self, before_ns: int, time_ns: int) -> bool:
        """Whether the PLC could not know that a telegram lay so close behind the one before."""
        return before_ns in self.late or not self.unnoticed.isdisjoint((before_ns, time_ns))


def _watch(plant: Installation) -> Watch:
    logs = line_logs(plant)
    unseen = {log.gateway: _Unseen(log) for log in logs}
    seen = dict.fromkeys(plant.spacing, 0)

    def broken() -> Iterator[str]:
        for log in logs:
            log.look()
        for gateway, spacing in plant.spacing.items():
            for item in spacing.too_close[seen[gateway] :]:
                before_ns = item.time_ns - item.distance_ns
                if not unseen[gateway].excuses(before_ns, item.time_ns):
                    yield (
                        f"{gateway}: a telegram to drive {item.inv_no} began "
                        f"{item.distance_ns / NS_PER_MS:.3f} ms behind one to drive {item.before}"
                    )
            seen[gateway] = len(spacing.too_close)

    return broken


RULE = Rule("telegrams_spaced", "Telegrams to different drives keep their distance", _watch)
