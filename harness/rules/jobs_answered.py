"""A job in a parameter channel that is done was answered by the drive, and to this very job.

What counts is what the drive has said at the cable to the gateway since the job began. Numbers that
the gateway answers by itself have no drive to ask.
"""

from collections import deque
from collections.abc import Iterator, Mapping

from fbgen.dataclass import dataclass
from fbgen.plant import PlantDrive, PlantGateway
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import Command, Reply
from harness.engine.interface import Value
from harness.installation import Installation
from harness.line import Transmission
from harness.rules.drive_variables import drive_reader
from harness.rules.rule import Rule, Watch

_VARIABLES = tuple(
    f"parameter.{name}" for name in ("busy", "done", "mode", "number", "value", "result")
)
_COMMANDS: Mapping[Value, Command] = {1: Command.R, 2: Command.P, 3: Command.W}
_KEPT = 256


@dataclass(slots=True)
class _Job:
    """What a channel was asked for."""

    begun_ns: int
    mode: Value
    number: Value
    value: Value


class _Channel:
    """One drive at its cable: what it has said lately, and the job that is under way."""

    def __init__(self, plant: Installation, entry: PlantGateway, drive: PlantDrive) -> None:
        channel = (drive.channel or "").lower()
        known = plant.catalog.process_data_gateway(entry.type)
        self._kernel = plant.kernel
        self._local = {item.number for item in known.parameter_channel.local}
        self._gateway = plant.interfaces[entry.name].channels[channel].link.port
        self._said: deque[tuple[int, Reply]] = deque(maxlen=_KEPT)
        self._job: _Job | None = None
        plant.lines[f"{entry.name}.{channel}"].taps.append(self._listen)

    def _listen(self, transmission: Transmission) -> None:
        if transmission.sender is self._gateway:
            return
        reply = toshiba_binary.parse_reply(transmission.data)
        if isinstance(reply, Reply):
            self._said.append((transmission.end_ns, reply))

    def wrong(self, busy: bool, done: bool, job: _Job, result: Value) -> bool:
        """Whether a job has ended well that nobody has answered. `job` as it is asked for now."""
        if busy:
            self._job = self._job or job
            return False
        ended, self._job = self._job, None
        if ended is None or not done or ended.number in self._local:
            return False
        return not any(
            end_ns >= ended.begun_ns
            and reply.command is _COMMANDS.get(ended.mode)
            and (reply.com_no, reply.data) == (ended.number, result)
            and (ended.mode == 1 or result == ended.value)
            for end_ns, reply in self._said
        )


def _watch(plant: Installation) -> Watch:
    entries = plant.interface_entries
    read = drive_reader(plant, entries, _VARIABLES)
    channels = {
        drive.name: _Channel(plant, entry, drive) for entry in entries for drive in entry.drives
    }

    def broken() -> Iterator[str]:
        for name, (busy, done, mode, number, value, result) in read():
            job = _Job(plant.kernel.now_ns, mode, number, value)
            if channels[name].wrong(bool(busy), bool(done), job, result):
                yield f"{name}: a job for {number:04X} gives {result:04X}, which nobody answered"

    return broken


RULE = Rule("jobs_answered", "A parameter job that is done was answered by the drive", _watch)
