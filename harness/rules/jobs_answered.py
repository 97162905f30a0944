"""A job in a parameter channel that is done was answered by the drive, and to this very job.

Behind a gateway for process data counts what the drive has said at the cable to the gateway since
the job began. Numbers that the gateway answers by itself have no drive to ask. On DeviceNet counts
what has come to the scanner to a request that the option has taken since then.
"""

from collections import deque
from collections.abc import Iterator, Mapping

from fbgen.plant import PlantDrive, PlantGateway
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import Command, Reply
from harness.engine.interface import Value
from harness.installation import Installation
from harness.line import Transmission
from harness.rules.devicenet_channels import channels_of
from harness.rules.drive_variables import Unit, drive_reader
from harness.rules.parameter_jobs import VARIABLES, Job, JobFollower
from harness.rules.rule import Rule, Watch

_COMMANDS: Mapping[Value, Command] = {1: Command.R, 2: Command.P, 3: Command.W}
_KEPT = 256


class _Channel:
    """One drive at its cable: what it has said lately."""

    def __init__(self, plant: Installation, entry: PlantGateway, drive: PlantDrive) -> None:
        channel = (drive.channel or "").lower()
        known = plant.catalog.process_data_gateway(entry.type)
        self._local = {item.number for item in known.parameter_channel.local}
        self._gateway = plant.interfaces[entry.name].channels[channel].link.port
        self._said: deque[tuple[int, Reply]] = deque(maxlen=_KEPT)
        plant.lines[f"{entry.name}.{channel}"].taps.append(self._listen)

    def _listen(self, transmission: Transmission) -> None:
        if transmission.sender is self._gateway:
            return
        reply = toshiba_binary.parse_reply(transmission.data)
        if isinstance(reply, Reply):
            self._said.append((transmission.end_ns, reply))

    def answered(self, job: Job, result: Value) -> bool:
        """Whether a job was answered with this result."""
        return job.number in self._local or any(
            end_ns >= job.begun_ns
            and reply.command is _COMMANDS.get(job.mode)
            and (reply.com_no, reply.data) == (job.number, result)
            and job.fits(result)
            for end_ns, reply in self._said
        )


def _watch(plant: Installation) -> Watch:
    followers = {
        drive.name: JobFollower(_Channel(plant, entry, drive).answered)
        for entry in plant.interface_entries
        for drive in entry.drives
    }
    followers |= {name: JobFollower(channel.answered) for name, channel in channels_of(plant)}
    units: tuple[Unit, ...] = (*plant.interface_entries, *plant.plan.devicenet)
    read = drive_reader(plant, units, VARIABLES)

    def broken() -> Iterator[str]:
        for name, (busy, done, mode, number, value, result) in read():
            job = Job(plant.kernel.now_ns, mode, number, value)
            follower = followers.get(name)
            if follower is not None and follower.wrong(bool(busy), bool(done), job, result):
                yield f"{name}: a job for {number:04X} gives {result:04X}, which nobody answered"

    return broken


RULE = Rule("jobs_answered", "A parameter job that is done was answered by the drive", _watch)
