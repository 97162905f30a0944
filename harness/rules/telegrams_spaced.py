"""Telegrams to different drives are never closer than the gateway's manual allows (section 9).

What a gateway sends once more by itself, while it was always there for the PLC, does not count:
zeros of a master in CLEAR make it forget its trigger, and the PLC cannot know.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.line_log import LineLog, Sent, line_logs
from harness.rules.rule import Rule, Watch


class _Unnoticed:
    """When the gateway of a line began to send something that the PLC could not know of."""

    def __init__(self, log: LineLog) -> None:
        self.starts_ns: set[int] = set()
        log.on_sent.append(self._sent)

    def _sent(self, sent: Sent) -> None:
        if sent.is_unnoticed:
            self.starts_ns.add(sent.start_ns)


def _watch(plant: Installation) -> Watch:
    logs = line_logs(plant)
    unnoticed = {log.gateway: _Unnoticed(log) for log in logs}
    seen = dict.fromkeys(plant.spacing, 0)

    def broken() -> Iterator[str]:
        for log in logs:
            log.look()
        for gateway, spacing in plant.spacing.items():
            for item in spacing.too_close[seen[gateway] :]:
                both = {item.time_ns, item.time_ns - item.distance_ns}
                if both.isdisjoint(unnoticed[gateway].starts_ns):
                    yield (
                        f"{gateway}: a telegram to drive {item.inv_no} began "
                        f"{item.distance_ns / NS_PER_MS:.3f} ms behind one to drive {item.before}"
                    )
            seen[gateway] = len(spacing.too_close)

    return broken


RULE = Rule("telegrams_spaced", "Telegrams to different drives keep their distance", _watch)
