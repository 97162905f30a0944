"""A whole plant as what a scenario plays on, with the telegrams of its gateways."""

from collections.abc import Callable, Mapping, Sequence

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, Note
from harness.installation import Installation
from harness.kernel import NS_PER_MS, Kernel
from harness.plc import CpuMode
from harness.scenario.paths import Paths
from harness.trace.meaning import telegram_meaning
from harness.trace.telegrams import TelegramRecord, TelegramRecorder

_TELEGRAMS_SHOWN = 3


class PlantStage:
    """A plant with everything that was noted of it for messages."""

    def __init__(self, plant: Installation, catalog: Catalog) -> None:
        self.installation = plant
        self.paths = Paths(plant, catalog)
        self.recorders: Mapping[str, TelegramRecorder] = plant.record_telegrams()
        self.catalog = catalog
        self._seen = dict.fromkeys(self.recorders, 0)

    @property
    def dialect(self) -> str:
        """The dialect of the plant."""
        return self.installation.plan.dialect

    @property
    def kernel(self) -> Kernel:
        """The clock of the plant."""
        return self.installation.kernel

    @property
    def after_scan(self) -> list[Callable[[], None]]:
        """Called when a scan of the CPU is through."""
        return self.installation.cpu.after_scan

    def start(self) -> None:
        """Switch on."""
        self.installation.start()

    def run_for(self, duration_ns: int) -> None:
        """Let time pass."""
        self.installation.run_for(duration_ns)

    def call(self, cycles: int) -> None:
        """A plant runs by itself: `call` is refused while the steps are prepared."""
        raise AssertionError("only blocks are called")

    def new_telegrams(self, gateway: str) -> Sequence[TelegramRecord]:
        """A gateway's telegrams since the start, or since this was asked the last time."""
        records = self.recorders[gateway].records[self._seen[gateway] :]
        self._seen[gateway] += len(records)
        return records

    def past(self) -> Sequence[Note]:
        """The last telegrams of each gateway, and why the CPU is in STOP if it is."""
        telegrams = [
            self.telegram(name, record)
            for name, recorder in self.recorders.items()
            for record in recorder.records[-_TELEGRAMS_SHOWN:]
        ]
        return [*telegrams, *self.cpu_notes()]

    def stopped(self) -> Diagnostic | None:
        """FB8012: the CPU is in STOP by itself."""
        if not self.installation.cpu.diagnostics:
            return None
        return Diagnostic(
            "FB8012",
            "the CPU went to STOP by itself, and the scenario does not say that it should",
            None,
            "mend what the notes say, or expect cpu.mode: STOP",
            tuple(self.cpu_notes()),
        )

    def cpu_notes(self) -> list[Note]:
        """Why the CPU went to STOP, with the line of the PLC text; nothing while it runs."""
        cpu = self.installation.cpu
        notes: list[Note] = []
        for found in cpu.diagnostics:
            notes.append(Note(f"the CPU went to STOP: {found.message} [{found.code}]", found.span))
            notes += found.notes
        if not notes and cpu.mode is not CpuMode.RUN:
            notes.append(Note(f"the CPU is in {cpu.mode.name}, so the PLC writes nothing"))
        return notes

    def telegram(self, gateway: str, record: TelegramRecord) -> Note:
        """A telegram in words, in bytes, and what came back."""
        entry = next(item for item in self.installation.plan.gateways if item.name == gateway)
        addressed = [item for item in entry.drives if item.inv_no == record.output[3]]
        series = self.catalog.drive((addressed or entry.drives)[0].series)
        meaning = telegram_meaning(record.output, record.input, series, self.catalog)
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


def _ms(time_ns: int) -> str:
    return f"{time_ns / NS_PER_MS:.3f} ms"
