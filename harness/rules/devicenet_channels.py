"""What comes back through the parameter channel of a drive on DeviceNet, and to what request.

A response counts for a job if the option has taken the request behind it since the job began.
"""

from collections import deque
from collections.abc import Iterator

from fbgen.catalog.devicenet_gateways import AssemblyField, RegisterChannel
from fbgen.dataclass import dataclass
from fbgen.plant import DeviceNetDrive
from fbgen.wire.devicenet import Frame
from harness.engine.interface import Value
from harness.fieldbus.devicenet import CanPort
from harness.installation import Installation
from harness.installation.devicenet import DeviceNet
from harness.rules.parameter_jobs import READ, Job

_KEPT = 256


@dataclass(frozen=True, slots=True)
class _Response:
    """What has come, and since when the request to it stands in the data of the option."""

    asked_ns: int
    writes: bool
    number: int
    data: int


class DeviceNetChannel:
    """Listens to one drive."""

    def __init__(
        self,
        plant: Installation,
        network: DeviceNet,
        entry: DeviceNetDrive,
        channel: RegisterChannel,
    ) -> None:
        self._kernel = plant.kernel
        option = self._option = network.options[entry.name]
        self._slave = network.scanner.slaves[entry.mac]
        self._pair = option.assemblies.chosen
        self._channel = channel
        words = {word.name: word for word in option.gateway.words}
        request = words[self._pair.output.field(channel.request).word or ""]
        response = words[self._pair.input.field(channel.response).word or ""]
        self._write = request.field("write").mask
        self._error = response.field("error").mask
        shared = channel.index == channel.request
        self._numbers = request.field("index").mask if shared else 0xFFFF
        self._asked: tuple[bool, int] = (False, 0)
        self._asked_ns = 0
        self._heard: deque[_Response] = deque(maxlen=_KEPT)
        network.bus.taps.append(self._passed)

    def answered(self, job: Job, result: Value) -> bool:
        """Whether a job was answered with this result."""
        assert isinstance(job.number, int)
        wanted = (job.mode != READ, job.number & self._numbers, result)
        return job.fits(result) and any(
            heard.asked_ns >= job.begun_ns and (heard.writes, heard.number, heard.data) == wanted
            for heard in self._heard
        )

    def _passed(self, now_ns: int, _: Frame, __: CanPort) -> None:
        """A frame is over; what the option took last and what the scanner has is looked at."""
        option, pair, channel = self._option, self._pair, self._channel
        if option.assemblies.chosen is not pair:
            return
        outputs, inputs = option.assemblies.outputs(pair), self._slave.inputs
        writes = bool(_value(pair.output.field(channel.request), outputs) & self._write)
        number = _value(pair.output.field(channel.index), outputs) & self._numbers
        if (writes, number) != self._asked:
            self._asked, self._asked_ns = (writes, number), now_ns
        response = _value(pair.input.field(channel.response), inputs)
        found = _Response(
            self._asked_ns,
            writes,
            _value(pair.input.field(channel.index), inputs) & self._numbers,
            _value(pair.input.field(channel.data), inputs),
        )
        if not response & self._error and (not self._heard or self._heard[-1] != found):
            self._heard.append(found)


def channels_of(plant: Installation) -> Iterator[tuple[str, DeviceNetChannel]]:
    """The drives on DeviceNet whose assemblies have a parameter channel."""
    for network in plant.networks.values():
        for entry in network.entry.drives:
            option = network.options[entry.name]
            pair = option.assemblies.chosen
            for channel in option.gateway.register_channels:
                if channel.assemblies == pair.name:
                    yield entry.name, DeviceNetChannel(plant, network, entry, channel)


def _value(field: AssemblyField, data: bytes) -> int:
    return int.from_bytes(data[field.offset : field.offset + field.length], "little")
