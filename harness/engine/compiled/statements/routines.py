"""Carries out the calls that `routine_calls` writes: who does it is found when the call runs."""

from collections.abc import Callable, Mapping
from typing import Any

from fbgen.lang.checked import Expression, Program, RoutineCall, StandardBlock
from fbgen.lang.checker.supplied.standard_blocks import STANDARD_BLOCKS
from fbgen.lang.checker.types.literals import default_value
from fbgen.lang.types import VOID, Elementary, Family, StringType, Type
from harness.engine.compiled.data.memory import Memory
from harness.engine.compiled.data.model import is_scalar
from harness.engine.compiled.library.clocks import CLOCKS
from harness.engine.compiled.library.reals import rounded
from harness.engine.compiled.library.s5 import S5, S5Counters
from harness.engine.compiled.library.several import CALCULATIONS
from harness.engine.compiled.library.timers import Timer, control
from harness.engine.compiled.shortening.ranges import limits
from harness.engine.environment import Environment
from harness.engine.faults import stop_requested
from harness.engine.interface import Value
from harness.engine.stub_calls import call_stub, with_eno
from harness.engine.stubs import StubState


class Routines:
    """Carries the calls out: the user's stubs first, then the library."""

    __slots__ = ("_environment", "_memory", "_program", "_retrigger", "counters")

    def __init__(
        self,
        program: Program,
        environment: Environment,
        memory: Memory,
        retrigger: Callable[[], None],
    ) -> None:
        self._program = program
        self._environment = environment
        self._memory = memory
        self._retrigger = retrigger
        self.counters = S5Counters()

    def call(self, node: RoutineCall, instance: Any, *values: Any) -> list[Any]:
        """The result, then the outputs in their order; None for what is not written."""
        inputs = {
            name: self._exported(expression, data)
            for (name, expression), data in zip(node.inputs, values, strict=True)
        }
        if isinstance(instance, Timer):
            control(instance, inputs.get("PT"))
            return []
        if instance is not None:
            self._keep(node, instance, inputs)
        results = with_eno(node, self._results(node, instance, inputs))
        if instance is not None:
            for variable in self._program.block_of(instance_name(node)).variables:
                if (key := variable.name.casefold()) in results:
                    setattr(instance, variable.name, results[key])
        given: list[Any] = []
        if node.type != VOID:
            given.append(_fitted(results["ret_val"], node.type))
        else:
            given.append(None)
        for name, target in node.outputs:
            result = results.get(name.casefold())
            if result is None and instance is not None:
                result = getattr(instance, name.upper(), None)
            given.append(None if result is None else _fitted(result, target.type))
        return given

    def _keep(self, node: RoutineCall, instance: Any, inputs: Mapping[str, Any]) -> None:
        """The inputs that are given stay in the instance."""
        known = {
            one.name.casefold(): one
            for one in self._program.block_of(instance_name(node)).variables
        }
        for name, expression in node.inputs:
            variable = known.get(name.casefold())
            if variable is not None and variable.type == expression.type:
                setattr(instance, variable.name, inputs[name])

    def _exported(self, expression: Expression, data: Any) -> Any:
        return data if is_scalar(expression.type) else self._memory.export(expression.type, data)

    def _results(
        self, node: RoutineCall, instance: Any, inputs: Mapping[str, Any]
    ) -> Mapping[str, Value]:
        name, environment = node.name, self._environment
        stubs = environment.services.stubs
        if stubs.find(name) is None:
            kinds = {one: expression.type for one, expression in (*node.inputs, *node.outputs)}
            if name in CALCULATIONS:
                return CALCULATIONS[name](inputs, kinds)
            if name == "STP":
                raise stop_requested(node.span)
            if name == "RE_TRIGR":
                self._retrigger()
                return {}
            if name in CLOCKS:
                return CLOCKS[name](inputs, kinds, environment.services, environment.now_ns)
            if name in S5:
                return self._counted(node, inputs)
        state: StubState | None = None if instance is None else instance._stub
        return call_stub(self._program, stubs, node, inputs, state)

    def _counted(self, node: RoutineCall, inputs: Mapping[str, Any]) -> Mapping[str, Value]:
        return S5[node.name](self.counters, inputs, self._environment.now_ns)


def instance_name(node: RoutineCall) -> str:
    """The block of which the call has an instance."""
    assert node.instance is not None
    return node.instance.type.name


def _fitted(result: Any, kind: Type) -> Any:
    """A value that the library gave, in the type of what takes it."""
    if isinstance(kind, StringType):
        return result[: kind.length]
    if not isinstance(kind, Elementary):
        return result
    if kind.family is Family.REAL:
        return rounded(float(result)) if kind.bits == 32 else float(result)
    if type(result) is int:
        low, high = limits(kind)
        return result if low <= result <= high else (result - low) % (high - low + 1) + low
    return result


def unmodelled_classes(program: Program) -> dict[str, type]:
    """The Python classes of the blocks that only a stub carries out, by canonical name."""
    return {
        block.name: _unmodelled_class(block)
        for key, block in program.standard_blocks.items()
        if key not in STANDARD_BLOCKS
    }


def _unmodelled_class(block: StandardBlock) -> type:
    first = {
        variable.name: default_value(variable.type)
        for variable in block.variables
        if isinstance(variable.type, Elementary | StringType)
    }

    class Unmodelled:
        __slots__ = ("_stub", *first)

        def __init__(self) -> None:
            self._stub = StubState()
            for name, content in first.items():
                setattr(self, name, content)

        def _run(self) -> None:
            """Called from outside there is nothing to do."""

    Unmodelled.__name__ = block.name
    return Unmodelled
