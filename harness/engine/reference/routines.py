"""Instructions with several outputs: finds who carries out a call. A stub of the user comes first.

Names and parameters: `fbgen.lang.checker.supplied.routines`.
"""

from collections.abc import Mapping

from fbgen.lang.checked import Program, RoutineCall
from fbgen.lang.types import Elementary, Family, Type
from harness.engine.environment import Environment
from harness.engine.interface import State, Value
from harness.engine.reference.analog_routines import ANALOG_ROUTINES
from harness.engine.reference.arithmetic import rounded, wrap
from harness.engine.reference.calendar import SPLITTING
from harness.engine.reference.clock_routines import CLOCK_ROUTINES, Clocked
from harness.engine.reference.routine_operands import Operands
from harness.engine.reference.s5 import S5_ROUTINES, S5Memory
from harness.engine.reference.statements import Watchdog
from harness.engine.reference.text_routines import TEXT_ROUTINES
from harness.engine.stub_calls import call_stub
from harness.engine.stubs import StubState

_CALCULATED = {**ANALOG_ROUTINES, **SPLITTING, **TEXT_ROUTINES}


class Routines:
    """The instructions of one controller, with its timers T and counters C."""

    __slots__ = ("_environment", "_program", "_s5", "_watchdog")

    def __init__(self, program: Program, environment: Environment, watchdog: Watchdog) -> None:
        self._program = program
        self._environment = environment
        self._watchdog = watchdog
        self._s5 = S5Memory()

    def run(
        self, call: RoutineCall, inputs: Mapping[str, Value], state: StubState | None
    ) -> Mapping[str, Value]:
        """What the call gives, by casefolded name; what is missing is not written."""
        services = self._environment.services
        if services.stubs.find(call.name) is not None:
            return call_stub(self._program, services.stubs, call, inputs, state)
        kinds: dict[str, Type] = {name: expression.type for name, expression in call.inputs}
        kinds |= {name: place.type for name, place in call.outputs}
        operands = Operands(inputs, kinds, call.span)
        if call.name in _CALCULATED:
            return _CALCULATED[call.name](operands)
        if call.name in CLOCK_ROUTINES:
            now_ns = self._environment.now_ns
            clocked = Clocked(services, now_ns, self._watchdog.restart)
            return CLOCK_ROUTINES[call.name](operands, clocked)
        if call.name in S5_ROUTINES:
            return S5_ROUTINES[call.name](operands, self._s5, self._environment.now_ns)
        return call_stub(self._program, services.stubs, call, inputs, state)

    def snapshot(self) -> State:
        """The timers and counters."""
        return self._s5.snapshot()

    def restore(self, state: State) -> None:
        """Back to a snapshot."""
        self._s5.restore(state)

    def reset(self) -> None:
        """All timers and counters stand at zero."""
        self._s5.reset()


def fitted(value: Value, kind: Type) -> Value:
    """A value that an instruction gave, in the type of the place that takes it."""
    if not isinstance(kind, Elementary):
        return value
    if kind.family is Family.REAL:
        assert isinstance(value, int | float)
        return rounded(kind, float(value))
    if isinstance(value, int) and not isinstance(value, bool):
        return wrap(kind, value)
    return value
