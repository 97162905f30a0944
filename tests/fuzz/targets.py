"""What is fuzzed, each with its corpus. A target may raise DiagnosticError and nothing else."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from fbgen.catalog import load_yaml, validate
from fbgen.lang.checker import check_reporting
from fbgen.lang.containers import new_files, read_text
from fbgen.lang.encoding import decode
from fbgen.lang.parser import parse_recovering
from fbgen.lang.printer import print_file
from fbgen.plant.loading import read_plant
from fbgen.source import Source
from fbgen.wire import modbus_rtu, toshiba_stream
from fbgen.wire.gsd import read_gsd
from fbgen.wire.modbus import seal
from fbgen.wire.modbus_lengths import reply_length, request_length
from harness.scenario.model import Scenario
from harness.serial.traffic import traffic_of
from tests.frames import ASCII_CHECKED, MODBUS, TOSHIBA_BINARY

_ROOT = Path(__file__).parents[2]


@dataclass(frozen=True, slots=True)
class Target:
    """A function that takes any bytes, and real inputs to begin with."""

    run: Callable[[bytes], object]
    corpus: Sequence[bytes]


def _plc_text(dialect: str) -> Callable[[bytes], object]:
    def run(data: bytes) -> None:
        file, found = parse_recovering(Source("fuzz", decode(data, "fuzz")), dialect)
        if not found:
            print_file(file)
            check_reporting([file], dialect)

    return run


def _xml(data: bytes) -> None:
    document = read_text(Source("fuzz.xml", decode(data, "fuzz")), "twincat", is_xml=True)
    if not document.findings:
        document.rewritten(document.file)
        new_files([document.file], "plcopen", "fuzz")


def _text(data: bytes) -> str:
    return data.decode("utf-8", "replace")


def _frames(data: bytes) -> None:
    toshiba_stream.parse_request(data)
    toshiba_stream.parse_reply(data)
    for frame in (data, seal(data)):
        modbus_rtu.parse_request(frame)
        modbus_rtu.parse_reply(frame)
        request_length(frame)
        reply_length(frame)


def _files(*patterns: str) -> list[bytes]:
    return [path.read_bytes() for pattern in patterns for path in sorted(_ROOT.glob(pattern))]


_TRAFFIC = b"""\
{"format": "fbgen line traffic", "version": 1, "protocol": "toshiba", "baud": 9600, "parity": "odd"}
{"t_us": 0, "end_us": 3125, "direction": "request", "bytes": "2F 0B 52 FD 01 8A"}
{"t_us": 20000, "end_us": 25000, "direction": "reply", "bytes": "2F 0B 52 FD 01 60 00 EA"}
"""


def targets() -> Mapping[str, Target]:
    """All targets by name."""
    texts = _files("tests/golden/manual_example_gsd10.tia.txt", "tests/unit/bad/FB[34]*.scl")
    texts += _files("tests/conformance/*/*.scl")
    return {
        "tia": Target(_plc_text("tia"), texts + _files("tests/corpus/tia/*")),
        "step7": Target(_plc_text("step7"), _files("tests/corpus/step7/*")),
        "iec": Target(
            _plc_text("iec"),
            _files("bench/handshake.st", "tests/unit/bad/FB[34]*.st", "tests/corpus/iec/*"),
        ),
        "twincat": Target(_plc_text("twincat"), _files("tests/corpus/twincat/*")),
        "xml": Target(_xml, _files("tests/unit/lang/objects/*", "tests/unit/bad/FB3*.[Tx]*")),
        "plant": Target(
            lambda data: read_plant(Source("fuzz.yaml", _text(data))),
            _files("examples/*/plant.yaml", "tests/unit/bad/FB[12]*.yaml"),
        ),
        "scenario": Target(
            lambda data: validate(load_yaml(Source("fuzz.yaml", _text(data))), Scenario),
            _files("tests/scenarios/*.scenario.yaml"),
        ),
        "line traffic": Target(lambda data: traffic_of(Source("a", _text(data))), [_TRAFFIC]),
        "gsd": Target(
            lambda data: read_gsd(data, "fuzz.gsd"),
            _files("examples/*/*.gsd", "tests/unit/wire/*.gsd", "tests/unit/bad/FB13*.gsd"),
        ),
        "frames": Target(
            _frames,
            [*TOSHIBA_BINARY.values(), *ASCII_CHECKED.values(), *MODBUS.values()],
        ),
    }
