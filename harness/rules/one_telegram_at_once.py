"""The PLC asks nothing of a line while somebody may still answer what it asked before.

A reply is waited for until it is there, or until the drive's reply time and that of a frame have
passed (TOSPBDP001 manual v1.1, section 9). Two requests at once may lead to two replies at once, or
to a drive that hears only one of them. What the gateway sends by itself does not count, nor what
was held back on its way to the line, nor a telegram behind which a late reply to the one before has
come before it went out. Nor does the read that goes out first to a gateway that is back, as long as
it goes to the same drive: that hears one telegram at a time, and nothing is lost with a read.
"""

from collections.abc import Mapping

from fbgen.catalog import Catalog
from fbgen.wire.single_words import Wanted
from fbgen.wire.toshiba import BROADCAST, Command
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.rules.answers import Answer
from harness.rules.line_log import LineLog, Sent, line_logs, telling
from harness.rules.put_out import Sending
from harness.rules.rule import Rule, Watch
from harness.rules.serial_log import SerialAnswer, SerialLog, SerialSent, serial_logs

_ANSWERED = (Command.R, Command.G, Command.W, Command.P)


class _Waiting:
    """Until when the reply to the last telegram of a line may come, and when the PLC saw one that
    was late."""

    def __init__(
        self, log: LineLog, reply_ns: Mapping[int, int], processing_ns: int, found: list[str]
    ) -> None:
        self._log = log
        self._processing_ns = processing_ns
        self._reply_ns = reply_ns
        self._found = found
        self._asked, self._answerer = b"", -1
        self._late_ns = -1
        self._open_until_ns = 0
        log.on_sent.append(self._sent)
        log.on_answer.append(self._answered)

    def _sent(self, sent: Sent) -> None:
        if sent.sending is not Sending.NEW:
            return
        early_ns = self._open_until_ns - sent.start_ns
        is_read_again = _answerer(sent) == self._answerer and sent.telegram[1] == Command.G
        if early_ns > 0 and not (sent.is_first and is_read_again):
            asked = self._asked.hex(" ").upper()
            self._found.append(
                f"{self._log.gateway}: {sent.telegram.hex(' ').upper()} began "
                f"{early_ns / NS_PER_MS:.3f} ms before the reply to {asked} was over or out of time"
            )
        self._asked = sent.telegram
        self._answerer = inv_no = _answerer(sent)
        self._open_until_ns = 0
        is_waited_for = not sent.is_late and self._late_ns < sent.put_ns
        if sent.telegram[1] in _ANSWERED and inv_no in self._reply_ns and is_waited_for:
            frame_ns = sent.end_ns - sent.start_ns
            self._open_until_ns = sent.end_ns + self._reply_ns[inv_no] + frame_ns

    def _answered(self, answer: Answer) -> None:
        if answer.end_ns > self._open_until_ns:
            self._late_ns = answer.end_ns + self._processing_ns
        else:
            self._open_until_ns = answer.end_ns


class _SerialWaiting:
    """Until when the reply to the last telegram of a serial line may come."""

    def __init__(self, log: SerialLog, catalog: Catalog, found: list[str]) -> None:
        self._name = log.line.name
        self._reply_ns = {
            item.inv_no: catalog.drive(item.series).times.reply_max.ns for item in log.line.drives
        }
        self._found = found
        self._asked: Wanted | None = None
        self._open_until_ns = 0
        log.on_sent.append(self._sent)
        log.on_answer.append(self._answered)

    def _sent(self, sent: SerialSent) -> None:
        early_ns = self._open_until_ns - sent.start_ns
        if early_ns > 0:
            self._found.append(
                f"{self._name}: {sent.frame.hex(' ').upper()} began {early_ns / NS_PER_MS:.3f} ms "
                f"before the reply to {self._asked} was over or out of time"
            )
        self._asked, self._open_until_ns = sent.wanted, 0
        if sent.wanted is not None and sent.wanted.inv_no in self._reply_ns:
            frame_ns = sent.end_ns - sent.start_ns
            reply_ns = self._reply_ns[sent.wanted.inv_no]
            self._open_until_ns = sent.end_ns + reply_ns + frame_ns

    def _answered(self, answer: SerialAnswer) -> None:
        self._open_until_ns = min(self._open_until_ns, answer.end_ns)


def _answerer(sent: Sent) -> int:
    """A broadcast is answered by drive 00."""
    return 0 if sent.telegram[0] == BROADCAST else sent.telegram[0]


def _watch(plant: Installation) -> Watch:
    logs, serial = line_logs(plant), serial_logs(plant)
    found: list[str] = []
    for line in serial:
        _SerialWaiting(line, plant.catalog, found)
    for log, entry in zip(logs, plant.telegram_entries, strict=True):
        reply_ns = {
            item.inv_no: plant.catalog.drive(item.series).times.reply_max.ns
            for item in entry.drives
        }
        _Waiting(log, reply_ns, plant.gateways[log.gateway].settings.processing_ns, found)
    return telling((*logs, *serial), found)


RULE = Rule("one_telegram_at_once", "Nothing is asked while a reply may still come", _watch)
