"""A telegram goes out again only if the drive may get it twice, and no more often than it should.

A read may be repeated, and a write after which the drive is as after one. A reset restarts the
drive each time; a cell of the EEPROM wears out with each write; and nobody says whether a telegram
without a reply was lost. The reads that go in front of a telegram may be like it.
"""

from collections.abc import Collection

from fbgen.blocks.line_times import SPACERS
from fbgen.catalog import Drive
from fbgen.wire.toshiba import Command
from harness.installation import Installation
from harness.rules.line_log import Job, LineLog, line_logs, telling
from harness.rules.rule import Rule, Watch
from harness.rules.serial_log import SerialLog, SerialSent, serial_logs

_COMMAND_WORD, _FAULT_RESET = 0xFA00, 0x2000


def is_repeatable(telegram: bytes) -> bool:
    """Whether a drive may get it twice: INV-NO, CMD, ComNo and DATA."""
    cmd, com_no = telegram[1], int.from_bytes(telegram[2:4], "big")
    resets = com_no == _COMMAND_WORD and int.from_bytes(telegram[4:], "big") & _FAULT_RESET
    return cmd == Command.G or (cmd == Command.P and not resets)


def spacers_of(series: Drive) -> frozenset[int]:
    """What is read in front of a telegram: ComNos."""
    names = (series.link.trip, series.link.status, series.link.output_frequency)
    return frozenset(series.comno(name).number for name in names)


def most_attempts(
    telegram: bytes, retries: int, spacers: Collection[int], *, reply_expected: bool
) -> int:
    """How often it may go out for one request."""
    if not reply_expected or not is_repeatable(telegram):
        return 1
    is_spacer = telegram[1] == Command.G and int.from_bytes(telegram[2:4], "big") in spacers
    return retries + 1 + (SPACERS if is_spacer else 0)


class _Attempts:
    """How often something was put out to a line for one job."""

    def __init__(self, log: LineLog, spacers: Collection[int], found: list[str]) -> None:
        self._log = log
        self._spacers = spacers
        self._found = found
        log.on_attempt.append(self._attempted)

    def _attempted(self, job: Job) -> None:
        expected = job.reply_expected
        most = most_attempts(job.telegram, job.retries, self._spacers, reply_expected=expected)
        if job.attempts > most:
            shown = job.telegram.hex(" ").upper()
            self._found.append(f"{self._log.gateway}: {shown} was put out {job.attempts} times")


class _SerialAttempts:
    """How often something went out on a serial line for one job; nothing is read in front."""

    def __init__(self, log: SerialLog, found: list[str]) -> None:
        self._name = log.line.name
        self._found = found
        log.on_sent.append(self._sent)

    def _sent(self, sent: SerialSent) -> None:
        job = sent.job
        if job is None:
            return
        most = most_attempts(job.telegram, job.retries, (), reply_expected=job.reply_expected)
        if job.attempts > most:
            shown = f"{job.wanted} went out {job.attempts} times"
            self._found.append(f"{self._name}: {shown}")


def _watch(plant: Installation) -> Watch:
    logs, serial = line_logs(plant), serial_logs(plant)
    found: list[str] = []
    for line in serial:
        _SerialAttempts(line, found)
    for log, entry in zip(logs, plant.telegram_entries, strict=True):
        _Attempts(log, spacers_of(plant.catalog.drive(entry.drives[0].series)), found)
    return telling((*logs, *serial), found)


RULE = Rule("repeats_allowed", "Only what a drive may get twice is repeated", _watch)
