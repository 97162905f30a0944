"""What generated code calls to go on behind a fault: for ENO, GET_ERROR, __TRY, and attempts.

`attempts`, `local_errors` and `exceptions` write the calls.
"""

from collections.abc import Callable
from math import isfinite
from typing import Any

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Guarded, Substituted
from fbgen.lang.types import Scalar
from harness.engine.compiled.data.cells import Cell
from harness.engine.compiled.library import stops
from harness.engine.compiled.library.wholes import limit_or_operand
from harness.engine.exception_codes import exception_code
from harness.engine.local_errors import local_error

_BAD = (
    *(ZeroDivisionError, stops.ZeroDivisor, stops.NoFit, stops.NoNumber, stops.NoDecimal),
    stops.NoInput,
)


def going_on(
    cpu: Any, stopped_by: Callable[[Exception], Exception]
) -> dict[str, Callable[..., Any]]:
    """What is called behind a fault; `cpu` counts how deep blocks are nested."""

    def note(fault: Exception, node: Substituted | Guarded, memory: Cell, depth: int) -> None:
        stop = stopped_by(fault)
        number = local_error(stop, node) if isinstance(stop, DiagnosticError) else None
        if number is None:
            raise fault
        cpu.depth = depth
        if not memory.value:
            memory.value = number

    def substituted(
        memory: Cell, read: Callable[[], Scalar], nothing: Scalar, node: Substituted
    ) -> Scalar:
        depth = cpu.depth
        try:
            return read()
        except Exception as fault:
            note(fault, node, memory, depth)
        return nothing

    def taken(memory: Cell) -> int:
        noted = memory.value
        memory.value = 0
        assert isinstance(noted, int)
        return noted & 0xFFFF

    return {
        **_attempts(cpu, stopped_by),
        "_note": note,
        "_substituted": substituted,
        "_taken": taken,
    }


def _attempts(
    cpu: Any, stopped_by: Callable[[Exception], Exception]
) -> dict[str, Callable[..., Any]]:
    """What generated code calls; `cpu` counts how deep blocks are nested."""

    def attempt(flag: Cell, action: Callable[[], Scalar], nothing: Scalar) -> Scalar:
        depth = cpu.depth
        try:
            result = action()
        except _BAD:
            cpu.depth = depth
            flag.value = False
            return nothing
        if isinstance(result, float) and not isfinite(result):
            flag.value = False
        return result

    def attempt_whole(flag: Cell, action: Callable[[], int], low: int, high: int) -> int:
        result = attempt(flag, action, 0)
        assert isinstance(result, int)
        if low <= result <= high:
            return result
        flag.value = False
        return (result - low) % (high - low + 1) + low

    def attempt_limit(flag: Cell, low: Any, operand: Any, high: Any) -> Any:
        if low > high:
            flag.value = False
        return limit_or_operand(low, operand, high)

    return {
        **_catching(cpu, stopped_by),
        "_attempt": attempt,
        "_attempt_whole": attempt_whole,
        "_attempt_limit": attempt_limit,
    }


def _catching(
    cpu: Any, stopped_by: Callable[[Exception], Exception]
) -> dict[str, Callable[..., int]]:
    """What generated code calls; `cpu` counts how deep blocks are nested."""

    def caught(exception: Exception, depth: int) -> int:
        stop = stopped_by(exception)
        code = exception_code(stop) if isinstance(stop, DiagnosticError) else None
        if code is None:
            raise exception
        cpu.depth = depth
        return code

    return {"_caught": caught}
