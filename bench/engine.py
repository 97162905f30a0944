"""The compiled engine: one call of a block, loading a program, very long blocks."""

from collections.abc import Callable, Iterator
from pathlib import Path

from bench.measuring import Figure, measure
from fbgen.lang.checker import check
from fbgen.lang.parser import parse
from fbgen.source import Source
from harness.engine.compiled import CompiledEngine
from harness.engine.environment import StandaloneEnvironment
from harness.engine.interface import Value
from harness.engine.loading import load_program
from harness.kernel import Kernel

_HANDSHAKE = Path(__file__).with_name("handshake.st")
_CALL = "  fb(xStart"
_SCAN_NS = 10_000_000
_PERIOD = 512
"""Scans after which the inputs that PROGRAM main gives repeat."""


def load(text: str, kernel: Kernel | None = None) -> CompiledEngine:
    """From source text to a program that can run."""
    program = check([parse(Source("bench.st", text), "iec")], "iec")
    return CompiledEngine(program, StandaloneEnvironment(kernel))


def _scans(text: str) -> Callable[[], None]:
    """One period of PROGRAM main."""
    kernel = Kernel()
    run_block = load(text, kernel).run_block

    def scans() -> None:
        for _ in range(_PERIOD):
            kernel.now_ns += _SCAN_NS
            run_block("main")

    return scans


def _inputs(text: str) -> list[dict[str, Value]]:
    """What PROGRAM main gives in one period."""
    kernel = Kernel()
    engine = load(text, kernel)
    given: list[dict[str, Value]] = []
    for _ in range(_PERIOD):
        kernel.now_ns += _SCAN_NS
        engine.run_block("main")
        names = ("xStart", "xReset", "wStatus", "usAck")
        given.append({name: engine.global_value(f"main.fb.{name}") for name in names})
    return given


class _Nothing:
    """What Python itself takes for a call like that of an instance: no check, no block."""

    __slots__ = ()

    def __call__(
        self,
        *,
        xStart: Value = False,  # noqa: N803 - the inputs of FB_HS
        xReset: Value = False,  # noqa: N803
        wStatus: Value = 0,  # noqa: N803
        usAck: Value = 0,  # noqa: N803
        tTimeout: Value = 0,  # noqa: N803
        **others: Value,
    ) -> None:
        pass


def _calls(text: str, chosen: str) -> tuple[Callable[[], None], Callable[[], None]]:
    """One period of calls from Python with the inputs as keywords, and the loop without them.

    `chosen` is what is called: "function" looks `fb.__call__` up once before, "instance" is `fb`
    itself, "nothing" an object that does nothing.
    """
    program = load_program([Source("bench.st", text)], "iec")
    fb = program.instance("FB_HS")
    call = {"function": fb.__call__, "instance": fb, "nothing": _Nothing()}[chosen]
    environment = program.engine.environment
    assert isinstance(environment, StandaloneEnvironment)
    kernel = environment.kernel
    given = [tuple(inputs.values()) for inputs in _inputs(text)]

    def calls() -> None:
        for start, reset, status, acknowledge in given:
            kernel.now_ns += _SCAN_NS
            call(xStart=start, xReset=reset, wStatus=status, usAck=acknowledge)

    def without() -> None:
        for _start, _reset, _status, _acknowledge in given:
            kernel.now_ns += _SCAN_NS

    return calls, without


def _long(statements: int) -> Callable[[], None]:
    lines = "  a := a + 1;\n  b := b + a;\n" * (statements // 2)
    text = f"FUNCTION_BLOCK Long\nVAR a : DINT; b : DINT; END_VAR\n{lines}END_FUNCTION_BLOCK\n"
    call = load(text).instance("Long").call
    return lambda: call({})


def _difference(name: str, whole: Figure, rest: Figure, limit: str) -> Figure:
    return Figure(name, whole.seconds - rest.seconds, whole.turns - rest.turns, limit)


def figures() -> Iterator[Figure]:
    """All figures of the engine."""
    text = _HANDSHAKE.read_text(encoding="ascii")
    without = "\n".join(line for line in text.split("\n") if not line.startswith(_CALL))
    whole = measure("scan of PROGRAM main, which calls FB_HS", _scans(text), per=_PERIOD)
    rest = measure("the same without the call", _scans(without), per=_PERIOD)
    yield whole
    yield rest
    name = "call of FB_HS by keyword in PROGRAM main"
    yield _difference(name, whole, rest, "at most 60 turns")
    for name, chosen, limit in (
        ("call(...) in Python, where call = fb.__call__", "function", "at most 60 turns"),
        ("fb(...) in Python", "instance", ""),
        ("the same of an object that does nothing", "nothing", ""),
    ):
        calls, loop = _calls(text, chosen)
        whole, rest = measure("", calls, per=_PERIOD), measure("", loop, per=_PERIOD)
        yield _difference(name, whole, rest, limit)

    def first_scan() -> None:
        load(text).run_block("main")

    yield measure("source text to first scan", first_scan, "at most 50 ms", windows=20)
    for statements in (100, 1_000, 10_000, 100_000):
        name = f"one statement out of {statements:,}"
        yield measure(name, _long(statements), "flat", per=statements, windows=20)
