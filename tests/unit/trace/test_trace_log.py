"""What is noted as a change of a channel."""

from math import nan

from harness.trace.log import ChangeLog
from harness.trace.model import Channel


def test_a_value_that_is_no_number_stays_as_it_is() -> None:
    log = ChangeLog()
    channel = log.add(Channel("plc.a", "a", "real", "plc"))
    for time_ns, value in enumerate((1.0, float("nan"), nan, float("nan"), 2.0)):
        log.note(channel, time_ns, value)
    assert [change.time_ns for change in log.changes] == [0, 1, 4]
