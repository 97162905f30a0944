"""What goes out on a line is what the PLC has put out, whole, and once for each trigger.

A gateway that has forgotten what it had sent, after its supply was away or the master was in CLEAR,
sends what it finds once more: that is its own doing and allowed.
"""

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.line_log import LineLog, Sent, line_logs, telling
from harness.rules.put_out import Sending
from harness.rules.rule import Rule, Watch
from harness.rules.serial_log import SerialLog, SerialSent, serial_logs

_WRONG = {
    Sending.REPEATED: "went out once more without a new trigger",
    Sending.FOREIGN: "went out, and the PLC has never put it out like that",
}


class _Telegrams:
    """What goes over one line."""

    def __init__(self, log: LineLog, found: list[str]) -> None:
        self._log = log
        self._found = found
        log.on_sent.append(self._sent)

    def _sent(self, sent: Sent) -> None:
        if sent.sending in _WRONG:
            shown = sent.telegram.hex(" ").upper()
            when = f"{sent.start_ns / NS_PER_MS:.3f} ms"
            self._found.append(f"{self._log.gateway}: {shown} at {when} {_WRONG[sent.sending]}")


class _SerialTelegrams:
    """What goes over one serial line: each telegram is of the job of that time."""

    def __init__(self, log: SerialLog, found: list[str]) -> None:
        self._name = log.line.name
        self._found = found
        log.on_sent.append(self._sent)

    def _sent(self, sent: SerialSent) -> None:
        if sent.job is None:
            shown = sent.frame.hex(" ").upper()
            when = f"{sent.start_ns / NS_PER_MS:.3f} ms"
            self._found.append(f"{self._name}: {shown} at {when} {_WRONG[Sending.FOREIGN]}")


def _watch(plant: Installation) -> Watch:
    logs, serial = line_logs(plant), serial_logs(plant)
    found: list[str] = []
    for log in logs:
        _Telegrams(log, found)
    for line in serial:
        _SerialTelegrams(line, found)
    return telling((*logs, *serial), found)


RULE = Rule(
    "telegrams_asked_for", "What goes out is what the PLC has put out, whole, and once", _watch
)
