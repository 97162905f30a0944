"""A drive takes long for each reply."""

from collections.abc import Iterable

from pydantic import Field

from harness.drives import ReplyTime
from harness.durations import PositiveDurationNs
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.faults.on_a_line import require_telegrams
from harness.installation.field_level import FieldLevel
from harness.installation.holds import Hold
from harness.kernel import NS_PER_MS


class SlowDriveSettings(FaultSettings):
    """Every reply after `reply_time`."""

    reply_time: PositiveDurationNs = Field(
        default=30 * NS_PER_MS, json_schema_extra={"default": "30 ms"}
    )


def _make(plant: FieldLevel, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, SlowDriveSettings)
    require_telegrams(plant, on, "no telegrams are answered")
    slow = ReplyTime(settings.reply_time, settings.reply_time)
    port = plant.drives[on].communication

    def present() -> ReplyTime:
        return port.reply_time

    def put(time: ReplyTime) -> None:
        port.reply_time = time

    return Holding(plant, Hold((port, "reply_time"), slow, present, put, _slowest))


def _slowest(times: Iterable[ReplyTime]) -> ReplyTime:
    return max(times, key=lambda time: time.maximum_ns)


FAULT = FaultType(
    "drive_slow", "A drive takes long for each reply", Target.DRIVE, _make, SlowDriveSettings
)
