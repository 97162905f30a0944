"""A port and a wall clock that only tests move: what comes when, and when what was written."""

from fbgen.catalog import load_catalog
from harness.drives import ReplyTime
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Parity
from harness.serial import (
    DriveServer,
    DriveToServe,
    LineSetting,
    ServedDrives,
    serve_drives,
)

REPLY_NS = 12 * NS_PER_MS
SETTING = LineSetting("toshiba", 19_200, Parity.EVEN)


class VirtualPort:
    """Bytes by the clock; `written` has what the devices sent, with its instant.

    Nobody waits beyond `limit_ns`.
    """

    name = "virtual"

    def __init__(self) -> None:
        self.now_ns = 5 * NS_PER_S
        self.script: list[tuple[int, bytes]] = []
        self.written: list[tuple[int, bytes]] = []
        self.gone: Exception | None = None
        self.limit_ns: int | None = None

    def clock(self) -> int:
        return self.now_ns

    def read(self, wait_s: float = 0.01) -> bytes:
        if self.gone is not None:
            raise self.gone
        until_ns = self.now_ns + max(1, round(wait_s * NS_PER_S))
        if self.limit_ns is not None:
            until_ns = max(self.now_ns, min(until_ns, self.limit_ns))
        if self.script and self.script[0][0] <= until_ns:
            at_ns, data = self.script.pop(0)
            self.now_ns = max(self.now_ns, at_ns)
            return data
        self.now_ns = until_ns
        return b""

    def write(self, data: bytes) -> None:
        self.written.append((self.now_ns, data))

    def close(self) -> None:
        pass


def drives(*numbers: int, series: str = "vf-s11") -> list[DriveToServe]:
    """Inverters that answer after 12 ms, named vf1, vf2 ..."""
    known = load_catalog().drive(series)
    times = ReplyTime(REPLY_NS, REPLY_NS)
    return [DriveToServe(f"vf{number}", known, number, reply_time=times) for number in numbers]


class ServedLine:
    """Inverters at a virtual port."""

    def __init__(
        self, *numbers: int, byte_times: bool = True, setting: LineSetting = SETTING
    ) -> None:
        self.port = VirtualPort()
        self.served: ServedDrives = serve_drives(
            drives(*numbers or (11,)), setting, self.port, byte_times=byte_times
        )
        self.server = DriveServer(self.served, self.port, self.port.clock)

    def run_ms(self, duration_ms: float) -> None:
        """Serve for a time."""
        end_ns = self.port.now_ns + round(duration_ms * NS_PER_MS)
        while self.port.now_ns < end_ns:
            self.server.step()

    def ask(self, *requests: str, for_ms: float = 60) -> list[str]:
        """Send these bytes, one after the other as soon as one was answered; the answers."""
        answers = []
        for request in requests:
            self.port.written.clear()
            self.port.script.append((self.port.now_ns, bytes.fromhex(request)))
            self.run_ms(for_ms)
            answers.append(b"".join(data for _, data in self.port.written).hex(" ").upper())
        return answers
