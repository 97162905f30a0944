"""The server: time passes before a telegram is answered, silence ends what was not completed."""

from fbgen.wire.dp import SlaveSap
from harness.kernel import NS_PER_MS
from harness.serial import Server
from tests.unit.fieldbus.wire_bench import WireBench

STATUS, REPLY = bytes.fromhex("10 07 01 49 51 16"), bytes.fromhex("10 01 07 00 08 16")


class ScriptedPort:
    """Gives what the script says; `sent` is what was written."""

    name = "script"

    def __init__(self) -> None:
        self.script: list[bytes] = []
        self.sent = b""
        self.now_ns = 1_000_000_000

    def read(self) -> bytes:
        self.now_ns += 10 * NS_PER_MS
        return self.script.pop(0) if self.script else b""

    def write(self, data: bytes) -> None:
        self.sent += data

    def close(self) -> None:
        pass


def served(bench: WireBench, *script: bytes) -> bytes:
    port = ScriptedPort()
    port.script += script
    server = Server(bench.kernel, bench.segment, port, lambda: port.now_ns)
    server.serve(lambda: bool(port.script))
    return port.sent


def test_a_telegram_is_answered_however_its_bytes_come() -> None:
    assert served(WireBench(), STATUS) == REPLY
    assert served(WireBench(), STATUS[:2], b"", STATUS[2:]) == REPLY
    assert served(WireBench(), STATUS + STATUS) == REPLY + REPLY


def test_after_silence_the_beginning_of_a_telegram_is_forgotten() -> None:
    begun = bytes.fromhex("68 20 20 68")
    assert served(WireBench(), begun, STATUS) == b""
    assert served(WireBench(), begun, b"", b"", b"", STATUS) == REPLY
    assert served(WireBench(), begun + STATUS, b"", b"", b"", b"") == REPLY


def test_what_was_due_happens_before_a_telegram_is_answered() -> None:
    bench = WireBench().running()
    inputs = b"\x01\x02\x03"
    bench.kernel.after(15 * NS_PER_MS, lambda: bench.slave.set_inputs(inputs))
    exchange = bytes.fromhex("68 08 08 68 07 01 4D 00 00 00 00 00 55 16")
    assert inputs not in served(bench, exchange)
    assert inputs in served(bench, exchange)


def test_the_watchdog_runs_in_real_time() -> None:
    bench = WireBench().running()
    served(bench, *[b""] * 9)
    assert bench.slave.online
    served(bench, *[b""] * 2)
    assert not bench.slave.online
    assert bench.ask(SlaveSap.SLAVE_DIAG) is not None
