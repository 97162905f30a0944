"""A DEV003Z in a simulated inverter, with a bus that keeps all frames, and a master by hand."""

from collections.abc import Mapping
from dataclasses import field

from fbgen.catalog import OptionValue, load_catalog
from fbgen.dataclass import dataclass
from fbgen.wire.devicenet import BodyFormat, Choice, Frame, Service
from fbgen.wire.devicenet_ids import Group2, SlaveMessage, group_2, slave_message
from fbgen.wire.devicenet_messages import (
    ErrorResponse,
    Request,
    Response,
    encode_request,
    parse_response,
)
from harness.drives import Inverter, InverterSettings
from harness.fieldbus.devicenet import ConnectionState, NodeSettings
from harness.gateways.dev003z import Dev003z, Dev003zSettings
from harness.kernel import NS_PER_MS, Kernel
from harness.line import Line

CATALOG = load_catalog()
GATEWAY = CATALOG.devicenet_gateway("dev003z")
MAC = 5
C203 = {20: 0, 21: 1, 100: 2, 101: 3, 102: 4, 105: 5}
"""Output instance -> value of c203."""
FAST = {"0009": 0.1, "0010": 0.1}


@dataclass(slots=True)
class Bench:
    """`frames` is what the option sent since they were taken last."""

    kernel: Kernel
    drive: Inverter
    option: Dev003z
    frames: list[Frame] = field(default_factory=list)

    def run(self, ms: float) -> None:
        """Let time pass."""
        self.kernel.run_for(round(ms * NS_PER_MS))

    def taken(self) -> list[Frame]:
        """What was sent."""
        found = list(self.frames)
        self.frames.clear()
        return found

    def put(self, identifier: int, data: bytes) -> None:
        """Send the option a frame."""
        self.option.receive(Frame(identifier, data))

    def ask(
        self, request: Request, *, unconnected: bool = False
    ) -> Response | ErrorResponse | None:
        """An explicit request in a single frame; None without an answer in a single frame."""
        form = BodyFormat.C8_I8 if unconnected else BodyFormat.C8_I16
        message = Group2.UNCONNECTED_REQUEST if unconnected else Group2.EXPLICIT_REQUEST
        self.taken()
        self.put(group_2(message, MAC), b"\x00" + encode_request(request, form))
        self.run(2)
        wanted = group_2(Group2.EXPLICIT_RESPONSE, MAC)
        found = [frame.data for frame in self.taken() if frame.identifier == wanted]
        assert len(found) <= 1
        return parse_response(found[0][1:]) if found else None

    def allocate(self, choice: int, master: int = 0) -> Response | ErrorResponse | None:
        """Allocate, unconnected."""
        request = Request(Service.ALLOCATE, 3, 1, bytes([choice, master]))
        return self.ask(request, unconnected=True)

    def get(self, class_id: int, instance: int, attribute: int) -> bytes | int:
        """An attribute, or the general status code of the refusal."""
        answer = self.ask(
            Request(Service.GET_ATTRIBUTE_SINGLE, class_id, instance, bytes([attribute]))
        )
        assert answer is not None
        return answer.data if isinstance(answer, Response) else answer.status

    def set(self, class_id: int, instance: int, attribute: int, value: bytes) -> int:
        """Set an attribute; 0 or the general status code of the refusal."""
        data = bytes([attribute]) + value
        answer = self.ask(Request(Service.SET_ATTRIBUTE_SINGLE, class_id, instance, data))
        assert answer is not None
        return 0 if isinstance(answer, Response) else answer.status

    def connect(self, choice: int = Choice.POLLED, rate_ms: int = 100) -> None:
        """Allocate I/O, and set the expected packet rates."""
        assert isinstance(self.allocate(choice | Choice.EXPLICIT), Response)
        for bits, instance in ((Choice.POLLED, 2), (Choice.CHANGE_OF_STATE | Choice.CYCLIC, 4)):
            if choice & bits:
                assert self.set(5, instance, 9, rate_ms.to_bytes(2, "little")) == 0
                connection = self.option.node.connections[instance]
                assert connection.state is ConnectionState.ESTABLISHED

    def poll(self, data: bytes) -> bytes | None:
        """Send I/O data, in fragments if need be, and take the answer."""
        size = self.option.output_length
        identifier = group_2(Group2.POLL, MAC)
        self.taken()
        if size <= 8:
            self.put(identifier, data)
        else:
            pieces = [data[at : at + 7] for at in range(0, len(data), 7)]
            if len(pieces) < 2:
                self.put(identifier, b"\x3f" + data)
                pieces = []
            for number, piece in enumerate(pieces):
                last = number == len(pieces) - 1
                kind = 0 if number == 0 else 2 if last else 1
                self.put(identifier, bytes([kind << 6 | number]) + piece)
        self.run(2)
        wanted = slave_message(SlaveMessage.POLL_RESPONSE, MAC)
        found = [frame.data for frame in self.taken() if frame.identifier == wanted]
        if not found:
            return None
        if self.option.input_length <= 8:
            (only,) = found
            return only
        assert [piece[0] & 0x3F for piece in found] == list(range(len(found)))
        return b"".join(piece[1:] for piece in found)

    def keep_polling(self, data: bytes, ms: float) -> bytes:
        """Poll every 10 ms; the last answer."""
        answer = b""
        for _ in range(round(ms / 10)):
            found = self.poll(data)
            assert found is not None
            answer = found
            self.run(8)
        return answer


def bench(
    c203: int = 0,
    *,
    series: str = "vf-s15",
    parameters: Mapping[str, int] | None = None,
    drive: Mapping[str, float] | None = None,
    options: Mapping[str, OptionValue] | None = None,
    online: bool = True,
) -> Bench:
    """An option on line (unless told otherwise) with the assemblies that c203 chooses."""
    kernel = Kernel()
    settings = InverterSettings(parameters={**FAST, **(drive or {})})
    inverter = Inverter(kernel, Line(kernel), CATALOG.drive(series), settings)
    frames: list[Frame] = []
    own = {"assembly_instances": c203, **(parameters or {})}
    option = Dev003z(
        kernel,
        GATEWAY,
        inverter,
        frames.append,
        Dev003zSettings(series=series, mac=MAC, parameters=own, options=options or {}),
    )
    made = Bench(kernel, inverter, option, frames)
    if online:
        made.run(2200)
        made.taken()
    return made


def words(*values: int) -> bytes:
    """Words, low byte first."""
    return b"".join(value.to_bytes(2, "little") for value in values)


NODE = NodeSettings(mac=MAC, vendor=GATEWAY.devicenet.vendor_id, serial=1)
