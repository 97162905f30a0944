"""A DeviceNet master that others wrote (devicenet-py 0.0.1) allocates and polls the DEV003Z.

It needs Python 3.12 and bitstring 4; it reaches nothing but connection 2, writes class and instance
with 8 bits, and its Allocate is sent to the unconnected port, where a group 2 only slave listens.
"""

import json
import queue
import subprocess
import threading
from pathlib import Path
from time import monotonic_ns

import pytest

from fbgen.catalog import Catalog, load_catalog
from fbgen.wire.devicenet import Frame
from harness.gateways.dev003z import Dev003zSettings
from harness.kernel import NS_PER_S
from harness.serial import OptionServer
from tests.other_pythons import (
    clean_surroundings,
    find_python,
    install,
    make_environment,
    python_in,
)
from tests.unit.devicenet.bench import C203, GATEWAY, MAC, words

NEEDS = ("devicenet-py==0.0.1", "bitstring>=4.4,<5", "python-can>=4.4")
VERSION = "3.12"
SCRIPT = Path(__file__).with_name("foreign_master.py")
TO_SPEED_NS = 2 * NS_PER_S


class Cable:
    """The streams of the master's process as a CAN interface; what it found out in `results`."""

    name = "pipe"

    def __init__(self, process: "subprocess.Popen[str]") -> None:
        self._process = process
        self._lines: queue.Queue[str | None] = queue.Queue()
        self.results: dict[str, object] = {}
        self.ended = False
        threading.Thread(target=self._listen, daemon=True).start()

    def _listen(self) -> None:
        assert self._process.stdout is not None
        for line in self._process.stdout:
            self._lines.put(line.strip())
        self._lines.put(None)

    def read(self, wait_s: float = 0.005) -> Frame | None:
        try:
            line = self._lines.get(timeout=wait_s)
        except queue.Empty:
            return None
        if line is None:
            self.ended = True
        elif line.startswith("="):
            self.results |= json.loads(line[1:])
        else:
            identifier, _, data = line.partition(" ")
            return Frame(int(identifier, 16), bytes.fromhex(data))
        return None

    def write(self, frame: Frame) -> None:
        assert self._process.stdin is not None
        print(f"{frame.identifier:03X} {frame.data.hex()}", file=self._process.stdin, flush=True)

    def close(self) -> None:
        """The process ends by itself."""


@pytest.fixture
def master_python(pytestconfig: pytest.Config, tmp_path: Path) -> Path:
    interpreter = find_python(VERSION)
    if interpreter is None:
        pytest.skip(f"there is no Python {VERSION} on the path")
    cache = getattr(pytestconfig, "cache", None)
    kept = tmp_path / "env" if cache is None else cache.mkdir("devicenet-py") / "env"
    python = python_in(kept)
    if not python.exists():
        make_environment(interpreter, kept)
    if install(python, *NEEDS, check=False) != 0:
        pytest.skip("PyPI cannot be reached for devicenet-py")
    return python


def with_eight_bits() -> Catalog:
    """The catalogue with an option that takes instances of 8 bits, as this master writes them."""
    known = load_catalog()
    port = GATEWAY.devicenet.model_copy(update={"body_format": "8_8"})
    gateway = GATEWAY.model_copy(update={"devicenet": port})
    copy = type(known)(known.drives, {**known.gateways, "dev003z": gateway}, {}, {})
    assert copy.devicenet_gateway("dev003z").devicenet.body_format == "8_8"
    return copy


@pytest.mark.fact("dev.foreign_master")
def test_a_master_that_others_wrote_runs_the_drive(master_python: Path) -> None:
    forward, stop = words(0x0061, 1800).hex(), words(0x0060, 0).hex()
    began_ns = monotonic_ns()
    ahead_ns = 0

    def clock_ns() -> int:
        return monotonic_ns() - began_ns + ahead_ns

    process = subprocess.Popen(
        [str(master_python), str(SCRIPT), stop, forward, forward],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=clean_surroundings(),
    )
    cable = Cable(process)
    own = {"assembly_instances": C203[21]}
    server = OptionServer(
        with_eight_bits(), "dev003z", Dev003zSettings(mac=MAC, parameters=own), cable,
        clock_ns=clock_ns,
    )  # fmt: skip
    server.drive.set_parameter("0009", 0.1)
    ahead_ns = 3 * NS_PER_S
    server.kernel.run_until(ahead_ns)
    server.serve(lambda: not cable.ended)
    assert process.wait(10) == 0, process.stderr.read() if process.stderr else ""
    for stream in (process.stdin, process.stdout, process.stderr):
        assert stream is not None
        stream.close()
    assert cable.results == {
        "allocated at the connected port": "No response to connection request",
        "body format": 0,
        "STATE": 3,
        "EXPECTED_PACKET_RATE": 1000,
        "PRODUCED_CONNECTION_SIZE": 4,
        stop: words(0x0370, 0).hex(),
        forward: words(0x04F4, 1800).hex(),
    }
