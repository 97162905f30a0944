"""The text of a scenario that failed: what was found, what it means, and what went before.

A note may carry a place of its own, as those of the CPU do: where the program that wrote a value is
known, its line belongs there.
"""

from collections.abc import Mapping, Sequence

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, Note
from harness.installation import Installation
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.plc import CpuMode
from harness.scenario.actions import Check
from harness.trace.meaning import telegram_meaning
from harness.trace.telegrams import TelegramRecord, TelegramRecorder

_TELEGRAMS_SHOWN = 3


class Failures:
    """Makes the findings of one run."""

    def __init__(
        self, plant: Installation, catalog: Catalog, recorders: Mapping[str, TelegramRecorder]
    ) -> None:
        self._plant = plant
        self._catalog = catalog
        self._recorders = recorders

    def unmet(self, checks: Sequence[Check], when: str) -> list[Diagnostic]:
        """FB8001 for each path that is not as demanded; what went before stands with the last."""
        found = [
            self._unmet(check, when)
            for check in checks
            if not check.demand.holds(check.source.get())
        ]
        last = found[-1]
        notes = (*last.notes, *self._last_telegrams(), *self.cpu_notes())
        return [*found[:-1], Diagnostic(last.code, last.message, last.span, last.help, notes)]

    def _unmet(self, check: Check, when: str) -> Diagnostic:
        value = check.source.get()
        shown = check.source.kind.show(value)
        message = f"{check.path} is {shown}{when}, expected {check.demand.describe()}"
        notes = [Note(f"at {seconds(self._plant.kernel.now_ns)} of the plant's time")]
        wanted = check.demand.equals
        for word in (value, wanted) if wanted is not None else (value,):
            if fields := check.demand.decoded(word):
                notes.append(Note(f"{check.source.kind.show(word)} means: {fields}"))
        return Diagnostic("FB8001", message, check.place, notes=tuple(notes))

    def waited(self, within_ns: int) -> str:
        """How long it was waited, for a message."""
        return f" after {seconds(within_ns)}" if within_ns else ""

    def held(self, held_ns: int, wanted_ns: int) -> str:
        """How long it held, for a message."""
        return f" {seconds(held_ns)} after it was right, of {seconds(wanted_ns)} to stay so"

    def stopped(self) -> Diagnostic:
        """FB8012: the CPU is in STOP and the scenario does not look at it."""
        return Diagnostic(
            "FB8012",
            "the CPU went to STOP by itself, and the scenario does not say that it should",
            None,
            "mend what the notes say, or expect cpu.mode: STOP",
            tuple(self.cpu_notes()),
        )

    def cpu_notes(self) -> list[Note]:
        """Why the CPU went to STOP, with the line of the PLC text; nothing while it runs."""
        cpu = self._plant.cpu
        notes: list[Note] = []
        for found in cpu.diagnostics:
            notes.append(Note(f"the CPU went to STOP: {found.message} [{found.code}]", found.span))
            notes += found.notes
        if not notes and cpu.mode is not CpuMode.RUN:
            notes.append(Note(f"the CPU is in {cpu.mode.name}, so the PLC writes nothing"))
        return notes

    def _last_telegrams(self) -> list[Note]:
        return [
            self.telegram(name, record)
            for name, recorder in self._recorders.items()
            for record in recorder.records[-_TELEGRAMS_SHOWN:]
        ]

    def telegram(self, gateway: str, record: TelegramRecord) -> Note:
        """A telegram in words, in bytes, and what came back."""
        entry = next(item for item in self._plant.plan.gateways if item.name == gateway)
        addressed = [item for item in entry.drives if item.inv_no == record.output[3]]
        series = self._catalog.drive((addressed or entry.drives)[0].series)
        meaning = telegram_meaning(record.output, record.input, series, self._catalog)
        return Note(f"{gateway} at {_ms(record.sent_ns)}: {meaning}{_bytes(record)}")


def _bytes(record: TelegramRecord) -> str:
    sent = record.output.hex(" ").upper()
    if record.input is not None and record.received_ns is not None:
        received = record.input.hex(" ").upper()
        return f"\n      {sent}  ->  {received}  at {_ms(record.received_ns)}"
    line = [
        f"{'drive' if not frame.to_drives else 'gateway'} {frame.data.hex(' ').upper()}"
        for frame in record.frames
    ]
    return f"\n      {sent}  ->  no reply; on the line: {', '.join(line) or 'nothing'}"


def seconds(time_ns: int) -> str:
    """A time for a message."""
    return f"{time_ns / NS_PER_S:.3f} s"


def _ms(time_ns: int) -> str:
    return f"{time_ns / NS_PER_MS:.3f} ms"
