"""What a PLC asks of a gateway and what goes over its line, told telegram by telegram.

The PLC's side is read behind each scan: the frame that it puts out, whose trigger says that there
is something new, and the face of TOS_Telegram, its inputs and outputs. The other side is the line.
All rules about telegrams listen to the same log of a line.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

from fbgen.blocks.line_times import HEARTBEAT_CHARACTERS, LONGEST_BUS_CYCLE_MS
from fbgen.dataclass import dataclass
from fbgen.plant import with_prefix
from fbgen.wire.toshiba import BINARY_START
from harness.engine.interface import Value
from harness.fieldbus import MasterMode
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.line import Transmission
from harness.plc import CpuMode
from harness.rules.answers import Answer, answer_in
from harness.rules.put_out import PutOuts, Sending
from harness.rules.rule import Watch

_FRAME_BYTES = 8
_NOTHING = bytes(6)
"""What goes out while the master is in CLEAR: nobody obeys it, nobody answers."""
_FRAME = ("trigger", "invNo", "cmd", "comNo", "data")
_FACE = ("online", "busy", "done", "invNo", "cmd", "comNo", "data", "replyExpected", "retries")
_RESULT = "replyData"


@dataclass(frozen=True, slots=True)
class Sent:
    """A telegram of the gateway on the line: INV-NO, CMD, ComNo and DATA.

    `put_ns` is when the PLC had put it out. `is_first` tells that it was before the PLC took the
    gateway as there, `is_late` that it took longer to get here than bus, gateway and a heartbeat of
    the gateway's may take, `is_unnoticed` that the gateway sent it once more and was always there
    for the PLC.
    """

    start_ns: int
    end_ns: int
    telegram: bytes
    sending: Sending
    put_ns: int
    is_first: bool
    is_late: bool
    is_unnoticed: bool


@dataclass(slots=True)
class Job:
    """What TOS_Telegram was asked for: how often it was put out, and what came of it."""

    begun_ns: int
    ended_ns: int
    telegram: bytes
    reply_expected: bool
    retries: int
    attempts: int = 0
    done: bool = False
    data: int = 0


class LineLog:
    """The log of one line. `look` tells the functions in `on_sent`, `on_answer`, `on_attempt` and
    `on_end` what there was since the last time, what was on the line first."""

    def __init__(self, plant: Installation, gateway: str) -> None:
        self.gateway = gateway
        self.on_sent: list[Callable[[Sent], None]] = []
        self.on_answer: list[Callable[[Answer], None]] = []
        self.on_attempt: list[Callable[[Job], None]] = []
        self.on_end: list[Callable[[Job], None]] = []
        self._master = plant.master
        self._kernel = plant.kernel
        self._device = plant.gateways[gateway]
        block = with_prefix(f"TOS_Gateway_{gateway}_DB", plant.plan.prefix)
        paths = [f"{block}.statFrameOut.{name}" for name in _FRAME]
        paths += [f"{block}.instLine.instTelegram.{name}" for name in (*_FACE, _RESULT)]
        self._read = plant.cpu.engine.reader(paths)
        self._longest_way_ns = _longest_way_ns(plant, gateway)
        self._put = PutOuts(self._device.settings.processing_ns)
        self._heard: list[Transmission | Answer] = []
        self._trigger: Value = 0
        self._job: Job | None = None
        self._was_online = False
        self._looked_ns = self._sent_ns = 0
        self._overwritten = 0
        plant.lines[gateway].taps.append(self._listen)
        plant.master.on_mode.append(self._master_changed)
        plant.cpu.on_mode.append(self._cpu_changed)

    def look(self) -> None:
        """Tell everything up to now. At the same instant there is nothing new."""
        for heard in self._heard:
            if isinstance(heard, Answer):
                for answered in self.on_answer:
                    answered(heard)
            else:
                self._judge(heard)
        self._heard.clear()
        trigger, inv_no, cmd, com_no, data, *face = self._read()
        telegram = _telegram(inv_no, cmd, com_no, data)
        is_new, self._trigger = trigger != self._trigger, trigger
        if is_new and trigger:
            is_first = not (self._was_online and face[0])
            self._put.new_trigger(self._kernel.now_ns, telegram, is_first=is_first)
        else:
            self._put.stands(telegram)
        self._follow(face)
        if is_new and self._job is not None and self._job.telegram == telegram:
            self._job.attempts += 1
            for attempted in self.on_attempt:
                attempted(self._job)
        self._looked_ns = self._kernel.now_ns

    def _follow(self, face: Sequence[Value]) -> None:
        """The face of TOS_Telegram, as `_FACE` names it: a job begins with busy, ends with it."""
        online, busy, done, inv_no, cmd, com_no, data, reply_expected, retries, result = face
        self._was_online = bool(online)
        job = self._job
        if busy and job is None:
            assert isinstance(retries, int)
            telegram = _telegram(inv_no, cmd, com_no, data)
            self._job = Job(self._looked_ns, 0, telegram, bool(reply_expected), retries)
        elif not busy and job is not None:
            assert isinstance(result, int)
            job.done, job.data, job.ended_ns = bool(done), result, self._kernel.now_ns
            self._job = None
            for ended in self.on_end:
                ended(job)

    # --- what is on the line ------------------------------------------------------------------

    def _listen(self, transmission: Transmission) -> None:
        if transmission.sender is self._device.port:
            if len(transmission.data) == _FRAME_BYTES and transmission.data[0] == BINARY_START:
                self._heard.append(transmission)
            return
        if (answer := answer_in(transmission)) is not None:
            self._heard.append(answer)

    def _judge(self, transmission: Transmission) -> None:
        telegram, start_ns = transmission.data[1:-1], transmission.start_ns
        if telegram == _NOTHING:
            self._put.forgets()
            return
        device = self._device
        if device.powered_on_ns > self._sent_ns or device.overwritten != self._overwritten:
            self._put.forgets()
        self._sent_ns, self._overwritten = start_ns, device.overwritten
        sending, put = self._put.on_line(telegram, start_ns)
        is_first, put_ns = (put.is_first, put.put_ns) if put is not None else (False, start_ns)
        sent = Sent(
            *(start_ns, transmission.end_ns, telegram, sending, put_ns, is_first),
            is_late=start_ns - put_ns > self._longest_way_ns,
            is_unnoticed=sending is Sending.RESENT and self._was_online,
        )
        for told in self.on_sent:
            told(sent)

    def _master_changed(self) -> None:
        if self._master.mode is MasterMode.CLEAR:
            self._put.forgets()

    def _cpu_changed(self, mode: CpuMode) -> None:
        if mode is not CpuMode.RUN:
            self._job = None
            self._put.forgets()


class Log(Protocol):
    """What notes what is on a line, until somebody looks."""

    def look(self) -> None:
        """Tell everything up to now."""
        ...


def telling(logs: Sequence[Log], found: list[str]) -> Watch:
    """What tells, behind each scan, everything that the listeners of the logs have found."""

    def broken() -> Iterator[str]:
        for log in logs:
            log.look()
        yield from found
        found.clear()

    return broken


def line_logs(plant: Installation) -> tuple[LineLog, ...]:
    """The log of each line of a plant; whoever comes second gets those that are there already."""
    return tuple(_line_log(plant, entry.name) for entry in plant.telegram_entries)


def _line_log(plant: Installation, gateway: str) -> LineLog:
    for tap in plant.lines[gateway].taps:
        owner = getattr(tap, "__self__", None)
        if isinstance(owner, LineLog):
            return owner
    return LineLog(plant, gateway)


def _longest_way_ns(plant: Installation, gateway: str) -> int:
    """From the PLC to the line; in the process image the trigger leaves a cycle behind its data."""
    entry = next(item for item in plant.telegram_entries if item.name == gateway)
    device = plant.catalog.telegram_gateway(entry.type)
    times, wire = device.times, device.subnetwork
    heartbeat_ms = 1000 * HEARTBEAT_CHARACTERS * wire.character_bits / wire.baud
    way_ms = 2 * plant.plan.cycle_time_ms + LONGEST_BUS_CYCLE_MS + heartbeat_ms
    return round(way_ms * NS_PER_MS) + times.trigger_poll.ns + times.processing.ns


def _telegram(inv_no: Value, cmd: Value, com_no: Value, data: Value) -> bytes:
    assert isinstance(inv_no, int)
    assert isinstance(cmd, int)
    assert isinstance(com_no, int)
    assert isinstance(data, int)
    return (inv_no << 40 | cmd << 32 | com_no << 16 | data).to_bytes(6, "big")
