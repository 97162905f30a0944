"""A DEV003Z at interfaces of python-can in real time, and logs that other tools open."""

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import can
import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.wire.devicenet import Frame
from harness.fieldbus.devicenet import CanBus
from harness.gateways.dev003z import Dev003zSettings
from harness.kernel import NS_PER_MS, Kernel
from harness.serial import CanLog, OptionServer, can_interface
from harness.serial.can_interfaces import PythonCan
from tests.unit.devicenet.bench import CATALOG

CHECK = 0x42F
MAC = 5


class Clock:
    """A wall clock that a test sets."""

    def __init__(self) -> None:
        self.ns = 0

    def __call__(self) -> int:
        return self.ns


class Heard:
    """An interface with frames that come one after the other."""

    name = "desk"

    def __init__(self, *frames: Frame) -> None:
        self.come = list(frames)
        self.sent: list[Frame] = []
        self.waits: list[float] = []

    def read(self, wait_s: float = 0.0) -> Frame | None:
        self.waits.append(wait_s)
        return self.come.pop(0) if self.come else None

    def write(self, frame: Frame) -> None:
        self.sent.append(frame)

    def close(self) -> None:
        pass


def served(port: Heard, clock: Clock, log: CanLog | None = None) -> OptionServer:
    return OptionServer(CATALOG, "dev003z", Dev003zSettings(mac=MAC), port, log=log, clock_ns=clock)


def online(server: OptionServer, clock: Clock) -> None:
    for _ in range(25):
        clock.ns += 100 * NS_PER_MS
        server.step()


@pytest.fixture
def desk(request: pytest.FixtureRequest) -> Iterator[can.BusABC]:
    """The other end of a virtual bus of python-can."""
    bus = can.Bus(interface="virtual", channel=request.node.name, bitrate=500_000)
    yield bus
    bus.shutdown()


@pytest.mark.fact("dev.can")
def test_a_master_at_a_virtual_bus_allocates_and_polls(
    desk: can.BusABC, request: pytest.FixtureRequest
) -> None:
    clock = Clock()
    port = can_interface(f"virtual:{request.node.name}", 500_000)
    server = served(port, clock)  # type: ignore[arg-type]
    online(server, clock)
    checks = [desk.recv(0) for _ in range(2)]
    assert [message.arbitration_id for message in checks if message] == [CHECK, CHECK]

    def ask(identifier: int, data: str) -> bytes:
        message = can.Message(
            arbitration_id=identifier, data=bytes.fromhex(data), is_extended_id=False
        )
        desk.send(message)
        for _ in range(3):
            clock.ns += NS_PER_MS
            server.step()
        answer = desk.recv(0)
        assert answer is not None
        return bytes(answer.data)

    assert ask(0x42E, "00 4B 03 01 03 00") == bytes.fromhex("00 CB 01")
    assert ask(0x42C, "00 10 05 02 00 09 64 00") == bytes.fromhex("00 90")
    assert ask(0x42D, "00 00 00 00") == bytes(4)
    assert server.state == "MAC ID 5: MS operational, NS connected; ready; vf-s15 stopped"
    assert (server.received, server.sent) == (3, 5)
    port.close()


@pytest.mark.parametrize(
    "message",
    [
        can.Message(arbitration_id=CHECK, is_extended_id=True),
        can.Message(arbitration_id=CHECK, is_extended_id=False, is_remote_frame=True, dlc=7),
        can.Message(arbitration_id=CHECK, is_extended_id=False, is_error_frame=True),
    ],
)
def test_what_devicenet_does_not_have_is_not_heard(
    desk: can.BusABC, request: pytest.FixtureRequest, message: can.Message
) -> None:
    port = can_interface(f"virtual:{request.node.name}", 500_000)
    desk.send(message)
    assert port.read(0) is None
    desk.send(can.Message(arbitration_id=1, is_extended_id=False, data=b"\x07"))
    assert port.read(0) == Frame(1, b"\x07")
    port.close()


@pytest.mark.parametrize(
    ("name", "code", "message"),
    [
        ("vcan0", "FB9030", "names no interface with its channel"),
        ("virtual:", "FB9030", "names no interface"),
        ("socketkan:can0", "FB9030", "python-can has no interface 'socketkan'"),
        ("serial:/dev/ttyNONE9", "FB9031", "cannot be opened"),
    ],
)
def test_what_cannot_be_opened_is_told(name: str, code: str, message: str) -> None:
    with pytest.raises(DiagnosticError, match=message) as raised:
        can_interface(name, 500_000)
    assert raised.value.diagnostics[0].code == code


def test_without_python_can_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("harness.serial.can_interfaces.find_spec", lambda _: None)
    with pytest.raises(DiagnosticError) as raised:
        can_interface("virtual:desk", 500_000)
    (found,) = raised.value.diagnostics
    assert (found.code, found.help) == ("FB9033", "pip install 'fbgen[devicenet]'")


@pytest.mark.parametrize("failing", ["recv", "send"])
def test_an_interface_that_goes_away_is_told(
    monkeypatch: pytest.MonkeyPatch, request: pytest.FixtureRequest, failing: str
) -> None:
    def gone(*_: object) -> None:
        raise can.CanOperationError("pulled out")

    port = can_interface(f"virtual:{request.node.name}", 500_000)
    monkeypatch.setattr(port._bus, failing, gone)
    with pytest.raises(DiagnosticError, match="pulled out") as raised:
        port.write(Frame(1, b"")) if failing == "send" else port.read()
    assert raised.value.diagnostics[0].code == "FB9031"
    port.close()


class Echoing:
    """A bus that gives back what was sent, as UDP does, between the frames of others."""

    def __init__(self) -> None:
        self.come: list[can.Message] = []

    def send(self, message: can.Message) -> None:
        self.come.append(message)

    def recv(self, _: float) -> can.Message | None:
        return self.come.pop(0) if self.come else None


def test_what_an_interface_gives_back_of_what_was_sent_is_not_heard() -> None:
    bus = Echoing()
    port = PythonCan("desk", bus, echoes=True)  # type: ignore[arg-type]
    check, other = Frame(CHECK, bytes(7)), can.Message(arbitration_id=1, is_extended_id=False)
    lost, late = Frame(2, b""), Frame(3, b"")
    for frame in (check, lost, late):
        port.write(frame)
    del bus.come[1]
    bus.come.insert(1, other)
    assert [port.read(0) for _ in range(3)] == [None, Frame(1, b""), None]
    for frame in (check, late, lost):
        bus.send(
            can.Message(arbitration_id=frame.identifier, data=frame.data, is_extended_id=False)
        )
        assert port.read(0) == frame, "nothing is waited for any more: this is somebody else"


def test_with_an_interface_that_echoes_the_option_comes_on_line() -> None:
    clock, bus = Clock(), Echoing()
    server = served(PythonCan("desk", bus, echoes=True), clock)  # type: ignore[arg-type]
    online(server, clock)
    assert server.state.startswith("MAC ID 5: MS operational, NS not connected")
    assert (server.received, server.sent) == (0, 2)


@pytest.mark.parametrize(("cause", "gone"), [(ValueError("unpack"), False), (OSError(), True)])
def test_what_is_no_frame_is_not_heard_where_anybody_can_send(
    monkeypatch: pytest.MonkeyPatch, cause: Exception, gone: bool
) -> None:
    def fails(_: float) -> None:
        raise can.CanOperationError("could not unpack received message") from cause

    bus = Echoing()
    monkeypatch.setattr(bus, "recv", fails)
    port = PythonCan("desk", bus, echoes=True)  # type: ignore[arg-type]
    if gone:
        with pytest.raises(DiagnosticError, match="cannot be used any more"):
            port.read(0)
    else:
        assert port.read(0) is None


@pytest.mark.parametrize(("name", "echoes"), [("virtual:a", False), ("udp_multicast:a", True)])
def test_interfaces_that_echo_are_known(
    monkeypatch: pytest.MonkeyPatch, name: str, echoes: bool
) -> None:
    monkeypatch.setattr(can, "Bus", lambda **_: Echoing())
    port = can_interface(name, 500_000)
    port.write(Frame(1, b""))
    assert (port.read(0) is None) is echoes


@pytest.mark.fact("dev.can")
@pytest.mark.parametrize("ending", [".asc", ".blf", ".log"])
def test_a_log_of_the_served_option_is_read_by_python_can(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"desk{ending}"
    clock = Clock()
    allocate = Frame(0x42E, bytes.fromhex("00 4B 03 01 01 00"))
    port = Heard()
    with CanLog(path, 1_800_000_000.0) as log:
        server = served(port, clock, log)
        online(server, clock)
        port.come.append(allocate)
        for _ in range(3):
            clock.ns += NS_PER_MS
            server.step()
    absolute = {"relative_timestamp": False} if ending == ".asc" else {}
    with can.LogReader(path, **absolute) as reader:
        read = list(reader)
    frames = [Frame(item.arbitration_id, bytes(item.data)) for item in read]
    assert frames == [*port.sent[:2], allocate, port.sent[2]]
    assert not any(item.is_extended_id for item in read)
    gaps = [later.timestamp - earlier.timestamp for earlier, later in pairwise(read)]
    assert gaps[0] == pytest.approx(1.0, abs=0.001)
    assert read[0].timestamp == pytest.approx(1_800_000_000.1, abs=0.002)
    assert {item.channel for item in read} <= {0, "can0"}


@pytest.mark.fact("dev.can")
def test_a_log_of_a_simulated_bus_has_its_times(tmp_path: Path) -> None:
    path = tmp_path / "bus.asc"
    kernel = Kernel()
    bus = CanBus(kernel)
    node = bus.attach(lambda _: None)
    with CanLog(path) as log:
        bus.taps.append(lambda at_ns, frame, _: log.write(at_ns, frame))
        kernel.at(NS_PER_MS, lambda: node.send(Frame(0x3C5, bytes(4))))
        kernel.at(11 * NS_PER_MS, lambda: node.send(Frame(0x3C5, bytes(8))))
        kernel.run_for(20 * NS_PER_MS)
    with can.LogReader(path) as reader:
        read = list(reader)
    assert [len(item.data) for item in read] == [4, 8]
    assert read[1].timestamp - read[0].timestamp == pytest.approx(0.010064, abs=2e-6)


def test_it_waits_no_longer_than_something_is_due() -> None:
    clock = Clock()
    port = Heard()
    server = served(port, clock)
    online(server, clock)
    port.come.append(Frame(0x42E, bytes.fromhex("00 4B 03 01 01 00")))
    server.step()
    sent = len(port.sent)
    clock.ns += NS_PER_MS // 4
    server.step()
    assert port.waits[-1] == pytest.approx(0.00075), "the answer is due after a millisecond"
    clock.ns += NS_PER_MS
    server.step()
    assert len(port.sent) == sent + 1
    server.step()
    assert port.waits[-1] == pytest.approx(0.005)


def test_a_log_needs_a_format_and_a_place(tmp_path: Path) -> None:
    for name, code in (("log.txt", "FB9030"), ("nowhere/log.asc", "FB9031")):
        with pytest.raises(DiagnosticError) as raised:
            CanLog(tmp_path / name)
        assert raised.value.diagnostics[0].code == code


def test_the_catalogue_has_what_is_served() -> None:
    assert load_catalog().devicenet_gateway("dev003z").series[-1] == "vf-s15"
