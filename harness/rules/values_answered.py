"""A value that a telegram gives was answered to this telegram, and to none before it.

What is compared is a reply as the gateway heard it, so bytes that were disturbed on the line and
still had the right checksum are no false value of the PLC's.
"""

from collections import deque

from harness.installation import Installation
from harness.rules.answers import Answer, belongs
from harness.rules.line_log import Job, LineLog, line_logs, telling
from harness.rules.rule import Rule, Watch
from harness.rules.serial_log import SerialAnswer, SerialJob, SerialLog, serial_logs

_KEPT = 64


class _Values:
    """What was answered on a line lately. `processing_ns` is the way from there to the PLC."""

    def __init__(self, log: LineLog, processing_ns: int, found: list[str]) -> None:
        self._log = log
        self._processing_ns = processing_ns
        self._found = found
        self._answers: deque[Answer] = deque(maxlen=_KEPT)
        log.on_answer.append(self._answers.append)
        log.on_end.append(self._ended)

    def _ended(self, job: Job) -> None:
        if not job.done or not job.reply_expected:
            return
        until_ns = job.ended_ns - self._processing_ns
        if not belongs(self._answers, job.telegram, job.data, job.begun_ns, until_ns):
            shown = f"{job.telegram.hex(' ').upper()} gives {job.data:04X}"
            self._found.append(f"{self._log.gateway}: {shown}, which nobody answered to it")


class _SerialValues:
    """What was answered on a serial line lately."""

    def __init__(self, log: SerialLog, found: list[str]) -> None:
        self._name = log.line.name
        self._found = found
        self._answers: deque[SerialAnswer] = deque(maxlen=_KEPT)
        log.on_answer.append(self._answers.append)
        log.on_end.append(self._ended)

    def _ended(self, job: SerialJob) -> None:
        if not job.done or not job.reply_expected:
            return
        data = job.wanted.data if job.wanted.writes else job.data
        if not any(
            answer.heard_ns >= job.begun_ns
            and answer.said is not None
            and answer.said.answers(job.wanted, data)
            for answer in self._answers
        ):
            shown = f"{job.wanted} gives {job.data:04X}"
            self._found.append(f"{self._name}: {shown}, which nobody answered to it")


def _watch(plant: Installation) -> Watch:
    logs, serial = line_logs(plant), serial_logs(plant)
    found: list[str] = []
    for line in serial:
        _SerialValues(line, found)
    for log in logs:
        _Values(log, plant.gateways[log.gateway].settings.processing_ns, found)
    return telling((*logs, *serial), found)


RULE = Rule("values_answered", "A value that is read was answered to this very telegram", _watch)
