"""The compiled engine: one call of a block, loading a program, very long and very deep blocks."""

from collections.abc import Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from fbgen.lang.checker import check
from fbgen.lang.parser import parse
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import StandaloneEnvironment

_HANDSHAKE = Path(__file__).with_name("handshake.st")
_SCAN_NS = 10_000_000
_PERIOD = 512
"""Scans after which the inputs of `main` repeat."""


def load(text: str, name: str = "bench.st") -> CompiledEngine:
    """From source text to a program that can run."""
    program = check([parse(Source(name, text), "iec")], "iec")
    return CompiledEngine(program, StandaloneEnvironment())


def _drive(engine: CompiledEngine, scans: int) -> None:
    """What PROGRAM main does, from outside: so that the calls themselves are measured."""
    kernel = engine.environment.kernel
    block = engine.instance("FB_HS")
    call, get = block.call, block.get
    for i in range(scans):
        word = 0x3001
        if get("wControl") & 1 and i % 256 < 240:
            word |= 0x400
        if i % 64 > 58:
            word |= 8
        kernel.now_ns += _SCAN_NS
        call({"xStart": i % 8 != 0, "xReset": i % 128 == 127, "wStatus": word})


def _long(statements: int) -> str:
    lines = "\n".join(f"  a := a + {n % 7}; b := a XOR b;" for n in range(statements // 2))
    return f"FUNCTION_BLOCK Long\nVAR a : INT; b : INT; END_VAR\n{lines}\nEND_FUNCTION_BLOCK\n"


def figures() -> Iterator[Figure]:
    """All figures of the engine."""
    text = _HANDSHAKE.read_text(encoding="ascii")
    engine = load(text)
    environment = engine.environment
    assert isinstance(environment, StandaloneEnvironment)
    kernel = environment.kernel

    def period() -> None:
        for _ in range(_PERIOD):
            kernel.now_ns += _SCAN_NS
            engine.run_block("main")

    yield measure("scan of PROGRAM main with FB_HS inside", period, per=_PERIOD)
