"""What goes out on a line is what the PLC has put out, whole, and once for each trigger.

A gateway that has forgotten what it had sent, after its supply was away or the master was in CLEAR,
sends what it finds once more: that is its own doing and allowed.
"""

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.line_log import LineLog, Sent, line_logs, telling
from harness.rules.put_out import Sending
from harness.rules.rule import Rule, Watch

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


def _watch(plant: Installation) -> Watch:
    logs = line_logs(plant)
    found: list[str] = []
    for log in logs:
        _Telegrams(log, found)
    return telling(logs, found)


RULE = Rule(
    "telegrams_asked_for", "What goes out is what the PLC has put out, whole, and once", _watch
)
