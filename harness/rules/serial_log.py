"""What a PLC asks of its drives on a serial line and what goes over the line, told together.

The PLC's side is read behind each scan: the face of TIP_Telegram or MB_Telegram. The other side is
the line. All rules about telegrams listen to the same log of a line.
"""

from collections import deque
from collections.abc import Callable

from fbgen.dataclass import dataclass
from fbgen.plant import SerialLine, with_prefix
from fbgen.wire.single_words import Said, Wanted, said_in, wanted_in
from fbgen.wire.toshiba import Command
from harness.drives.communication import Communication
from harness.engine.interface import Value
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.line import Transmission
from harness.plc import CpuMode

_FACE = ("busy", "done", "invNo", "cmd", "comNo", "data", "replyExpected", "retries", "replyData")
_ON_ITS_WAY_NS = 200 * NS_PER_MS
"""So long a telegram may be on its way from the block to the line when its job has ended."""
_KEPT = 16


@dataclass(slots=True)
class SerialJob:
    """What the telegram block was asked for, how often that went out, and what came of it."""

    begun_ns: int
    wanted: Wanted
    cmd: int
    reply_expected: bool
    retries: int
    ended_ns: int | None = None
    attempts: int = 0
    done: bool = False
    data: int = 0

    @property
    def telegram(self) -> bytes:
        """INV-NO, CMD, ComNo and DATA."""
        wanted = self.wanted
        words = wanted.com_no.to_bytes(2, "big") + wanted.data.to_bytes(2, "big")
        return bytes((wanted.inv_no, self.cmd)) + words


@dataclass(frozen=True, slots=True)
class SerialSent:
    """A telegram of the PLC on the line; without a job nobody has asked for it."""

    start_ns: int
    end_ns: int
    wanted: Wanted | None
    frame: bytes
    job: SerialJob | None


@dataclass(frozen=True, slots=True)
class SerialAnswer:
    """What a drive has said, to a telegram that it had heard at `heard_ns`."""

    start_ns: int
    end_ns: int
    said: Said | None
    heard_ns: int


class SerialLog:
    """The log of one line. `look` tells the functions in `on_sent`, `on_answer` and `on_end` what
    there was since the last time, what was on the line first."""

    def __init__(self, plant: Installation, line: SerialLine) -> None:
        self.line = line
        self.on_sent: list[Callable[[SerialSent], None]] = []
        self.on_answer: list[Callable[[SerialAnswer], None]] = []
        self.on_end: list[Callable[[SerialJob], None]] = []
        self._kernel = plant.kernel
        self._cpu = plant.cpu
        self._port = plant.devices.modules[line.name].port
        block = with_prefix(f"TIP_Serial_{line.name}_DB", plant.plan.prefix)
        paths = [f"{block}.instLine.instTelegram.{name}" for name in _FACE]
        self._read = plant.cpu.engine.reader(paths)
        self._heard: list[tuple[Transmission, bytes]] = []
        self._jobs: deque[SerialJob] = deque(maxlen=_KEPT)
        self._job: SerialJob | None = None
        self._looked_ns = plant.kernel.now_ns
        plant.lines[line.name].taps.append(self._listen)
        plant.cpu.on_mode.append(self._cpu_changed)

    def look(self) -> None:
        """Tell everything up to now. At the same instant there is nothing new."""
        busy, done, inv_no, cmd, com_no, data, expected, retries, result = self._read()
        if busy and self._job is None:
            wanted = _wanted(inv_no, cmd, com_no, data)
            assert isinstance(cmd, int)
            assert isinstance(retries, int)
            self._job = SerialJob(self._looked_ns, wanted, cmd, bool(expected), retries)
            self._jobs.append(self._job)
        for transmission, heard in self._heard:
            self._tell(transmission, heard)
        self._heard.clear()
        if not busy and self._job is not None:
            job, self._job = self._job, None
            assert isinstance(result, int)
            job.ended_ns, job.done, job.data = self._kernel.now_ns, bool(done), result
            for ended in self.on_end:
                ended(job)
        self._looked_ns = self._kernel.now_ns

    def _listen(self, transmission: Transmission) -> None:
        heard = transmission.heard
        is_cut_off = transmission.sender is self._port and self._cpu.mode is not CpuMode.RUN
        if not transmission.data or is_cut_off:
            return
        self._heard.append((transmission, transmission.data if heard is None else heard.data))

    def _tell(self, transmission: Transmission, heard: bytes) -> None:
        start_ns, end_ns = transmission.start_ns, transmission.end_ns
        if transmission.sender is self._port:
            wanted = wanted_in(self.line.family, transmission.data)
            job = None if wanted is None else self._job_of(wanted, start_ns)
            if job is not None:
                job.attempts += 1
            sent = SerialSent(start_ns, end_ns, wanted, transmission.data, job)
            for told in self.on_sent:
                told(sent)
            return
        node = transmission.sender.node if transmission.sender is not None else None
        heard_ns = node.heard_ns if isinstance(node, Communication) else start_ns
        answer = SerialAnswer(start_ns, end_ns, said_in(self.line.family, heard), heard_ns)
        for answered in self.on_answer:
            answered(answer)

    def _job_of(self, wanted: Wanted, start_ns: int) -> SerialJob | None:
        for job in reversed(self._jobs):
            until_ns = start_ns if job.ended_ns is None else job.ended_ns + _ON_ITS_WAY_NS
            if job.wanted == wanted and job.begun_ns <= start_ns <= until_ns:
                return job
        return None

    def _cpu_changed(self, mode: CpuMode) -> None:
        """A CPU that stops cuts off what its module sends, and knows of no job when it starts."""
        if mode is not CpuMode.RUN:
            if self._job is not None:
                self._job.ended_ns = self._kernel.now_ns
            self._job = None
            self._heard = [item for item in self._heard if item[0].sender is not self._port]


def _wanted(inv_no: Value, cmd: Value, com_no: Value, data: Value) -> Wanted:
    assert isinstance(inv_no, int)
    assert isinstance(com_no, int)
    assert isinstance(data, int)
    writes = cmd != Command.G
    return Wanted(inv_no, writes, com_no, data if writes else 0)


def serial_logs(plant: Installation) -> tuple[SerialLog, ...]:
    """The log of each serial line; whoever comes second gets those that are there already."""
    return tuple(_serial_log(plant, line) for line in plant.plan.serial)


def _serial_log(plant: Installation, line: SerialLine) -> SerialLog:
    for tap in plant.lines[line.name].taps:
        owner = getattr(tap, "__self__", None)
        if isinstance(owner, SerialLog):
            return owner
    return SerialLog(plant, line)
