"""Telegrams to different drives are never closer than the gateway's manual allows (section 9)."""

from collections.abc import Iterator

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.rule import Rule, Watch


def _watch(plant: Installation) -> Watch:
    seen = dict.fromkeys(plant.spacing, 0)

    def broken() -> Iterator[str]:
        for gateway, spacing in plant.spacing.items():
            for item in spacing.too_close[seen[gateway] :]:
                yield (
                    f"{gateway}: a telegram to drive {item.inv_no} began "
                    f"{item.distance_ns / NS_PER_MS:.3f} ms behind one to drive {item.before}"
                )
            seen[gateway] = len(spacing.too_close)

    return broken


RULE = Rule("telegrams_spaced", "Telegrams to different drives keep their distance", _watch)
