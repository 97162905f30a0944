"""Calls of blocks: frames, parameters, and how deep blocks may be inside each other."""

from fbgen.lang.checked import (
    LIVING,
    Block,
    Expression,
    FunctionCall,
    InstanceCall,
    Place,
    Program,
    RoutineCall,
    StandardBlock,
    Variable,
    VariableKind,
)
from fbgen.lang.start_information import start_places
from fbgen.lang.types import VOID, AnyType, OpenArrayType
from fbgen.source import Span
from harness.engine.faults import nesting_too_deep
from harness.engine.interface import Limits, Value
from harness.engine.layout import S7
from harness.engine.leftovers import left_over, values_left
from harness.engine.reference.addresses import Addresses
from harness.engine.reference.allocation import Allocator
from harness.engine.reference.expressions import Expressions
from harness.engine.reference.frames import Frame
from harness.engine.reference.memory import Memory
from harness.engine.reference.places import Places
from harness.engine.reference.routines import Routines, fitted
from harness.engine.reference.standard_blocks import run_standard_block
from harness.engine.reference.statements import Statements, Watchdog
from harness.engine.reference.storage import InstanceStorage, Storage
from harness.engine.reference.timers import Timer, control_timer
from harness.engine.reference.unmodelled import Unmodelled, keep_inputs
from harness.engine.stub_calls import with_eno
from harness.engine.stubs import StubState


class Calls:
    """Runs the blocks of one program."""

    __slots__ = (
        *("_allocator", "_depth", "_environment", "_expressions", "_limits", "_places"),
        *("_program", "_statements", "_watchdog", "routines"),
    )

    def __init__(
        self,
        program: Program,
        memory: Memory,
        limits: Limits,
        allocator: Allocator,
        program_globals: dict[Variable, Storage],
    ) -> None:
        self._program = program
        self._environment = memory.environment
        self._limits = limits
        self._allocator = allocator
        self._watchdog = Watchdog(limits.loop_passes)
        addresses = Addresses(memory, self._index, allocator.view)
        self._places = Places(memory, addresses, program_globals, self._index)
        self._expressions = Expressions(
            program.dialect,
            memory.environment,
            self._places,
            self._call_function,
            self.call_routine,
        )
        self._statements = Statements(
            *(self._expressions, self._places, self._watchdog),
            call_function=self._call_function,
            call_instance=self._call_instance,
            call_routine=self.call_routine,
        )
        self._depth = 0
        self.routines = Routines(program, memory.environment, self._watchdog)

    def begin(self) -> tuple[int, int]:
        """A call from outside begins: no loop passes yet, no block inside another.

        Gives what `resume` takes when it is through, if it interrupted another one.
        """
        before = self._watchdog.passes, self._depth
        self._watchdog.restart()
        self._depth = 0
        return before

    def resume(self, before: tuple[int, int]) -> None:
        """Go on with what a call from outside interrupted."""
        self._watchdog.passes, self._depth = before

    def frame(self, block: Block) -> Frame:
        """A frame for a call, with the variables that lie in bytes."""
        frame = Frame()
        frame.storages.update(self._allocator.frame(block))
        return frame

    def run_function(self, block: Block, arguments: Frame, span: Span | None) -> None:
        """A FUNCTION; its other variables start anew in the frame of its arguments."""
        for variable in block.variables:
            if variable not in arguments.storages and variable.kind is not VariableKind.IN_OUT:
                arguments.storages[variable] = self._allocator.variable(variable)
        self._leave_over(block, arguments)
        self._run_body(block, arguments, span)

    def run_instance(
        self,
        instance: InstanceStorage,
        span: Span | None,
        body: Block | None = None,
        start: bytes = b"",
    ) -> None:
        """A block with variables that live on; its inputs and in-outs have been set.

        `body` is the block whose statements run, if it is not that of the instance; `start` the
        start information of an organization block.
        """
        block = body or instance.block
        assert isinstance(block, Block)
        frame = self.frame(block)
        frame.instance = instance
        for variable in block.variables:
            key = variable.name.casefold()
            if variable in frame.storages:
                continue
            if variable.kind in LIVING:
                frame.storages[variable] = instance.parts[key]
            elif variable.kind is not VariableKind.IN_OUT:
                frame.storages[variable] = self._allocator.variable(variable)
            elif key in instance.connections:
                frame.storages[variable] = instance.connections[key]
        self._leave_over(block, frame)
        if start:
            for variable, bit in start_places(block):
                frame.storages[variable].write(S7.read(start, bit, variable.type))
        self._run_body(block, frame, span)

    def run_standard(self, instance: InstanceStorage, block: StandardBlock) -> None:
        """A block of the controller; its inputs have been set."""
        run_standard_block(instance, block, self._environment.now_ns)

    def _leave_over(self, block: Block, frame: Frame) -> None:
        """Give temporaries what stood in their places before, if the controller clears none."""
        environment = self._environment
        if environment.services.leftovers is None:
            return
        variables = left_over(block, self._program.dialect)
        values = values_left(block, variables, environment)
        for variable, value in zip(variables, values, strict=True):
            frame.storages[variable].write(value)

    def _run_body(self, block: Block, frame: Frame, span: Span | None) -> None:
        if self._depth >= self._limits.call_depth:
            raise nesting_too_deep(span, block.name, self._limits.call_depth)
        for variable in self._program.temporaries.get(block, ()):
            frame.storages[variable] = self._allocator.variable(variable)
        self._depth += 1
        try:
            self._statements.run(self._program.bodies[block], frame)
        finally:
            self._depth -= 1

    def _call_function(self, call: FunctionCall, frame: Frame) -> Value | None:
        inputs = [
            (variable, self._argument(variable, expression, frame))
            for variable, expression in call.inputs
        ]
        in_outs = [(variable, self._places.find(place, frame)) for variable, place in call.in_outs]
        function = call.function
        if call.overrides:
            function = _meant(call, in_outs[0][1])
        inner = self.frame(function)
        own = {variable.name.casefold(): variable for variable in function.variables}
        for parameter, argument in inputs:
            variable = own[parameter.name.casefold()]
            if variable in inner.storages:
                inner.storages[variable].write(argument.read())
            else:
                inner.storages[variable] = argument
        for parameter, storage in in_outs:
            inner.storages[own[parameter.name.casefold()]] = storage
        self.run_function(function, inner, call.span)
        for variable, place in call.outputs:
            value = inner.storages[own[variable.name.casefold()]].read()
            self._places.find(place, frame).write(value)
        result = function.result
        return None if result is None else inner.storages[result].read()

    def call_routine(self, call: RoutineCall, frame: Frame) -> Value | None:
        """An instruction with several outputs, or a stub; its result if it has one.

        An output that is left out keeps its value, or has that of the instance.
        """
        inputs = {
            name: self._expressions.value(expression, frame) for name, expression in call.inputs
        }
        instance: InstanceStorage | None = None
        state: StubState | None = None
        if call.instance is not None:
            found = self._places.find(call.instance, frame)
            assert isinstance(found, InstanceStorage)
            if isinstance(found.standard, Timer):
                control_timer(found, inputs)
                return None
            assert isinstance(found.standard, Unmodelled)
            instance, state = found, found.standard.state
            keep_inputs(instance, call, inputs)
        results = with_eno(call, self.routines.run(call, inputs, state))
        if instance is not None:
            for key, part in instance.parts.items():
                if key in results:
                    part.write(fitted(results[key], part.kind))
        for name, place in call.outputs:
            key = name.casefold()
            value: Value | None = results.get(key)
            if value is None and instance is not None and key in instance.parts:
                value = instance.parts[key].read()
            if value is not None:
                target = self._places.find(place, frame)
                target.write(fitted(value, target.kind))
        return None if call.type == VOID else fitted(results["ret_val"], call.type)

    def _argument(self, variable: Variable, expression: Expression, frame: Frame) -> Storage:
        """A cell of its own with the value; an area is passed by reference."""
        if isinstance(variable.type, AnyType):
            assert isinstance(expression, Place)
            return self._places.find(expression, frame)
        value = self._expressions.value(expression, frame)
        if isinstance(variable.type, OpenArrayType):
            assert isinstance(expression, Place)
            storage = self._allocator.of_type(self._places.find(expression, frame).kind)
        else:
            storage = self._allocator.variable(variable)
        storage.write(value)
        return storage

    def _call_instance(self, call: InstanceCall, frame: Frame) -> None:
        instance = self._places.find(call.instance, frame)
        assert isinstance(instance, InstanceStorage)
        values = [
            (variable, self._expressions.value(expression, frame))
            for variable, expression in call.inputs
        ]
        connections = [
            (variable, self._places.find(place, frame)) for variable, place in call.in_outs
        ]
        for variable, value in values:
            instance.parts[variable.name.casefold()].write(value)
        for variable, storage in connections:
            key = variable.name.casefold()
            if variable.kind is VariableKind.KEPT:
                instance.parts[key].write(storage.read())
            else:
                instance.connections[key] = storage
        if isinstance(call.block, StandardBlock):
            self.run_standard(instance, call.block)
        else:
            self.run_instance(instance, call.span, call.block)
        self._disconnect(instance)
        for variable, storage in connections:
            if variable.kind is VariableKind.KEPT:
                storage.write(instance.parts[variable.name.casefold()].read())
        for variable, place in call.outputs:
            value = instance.parts[variable.name.casefold()].read()
            self._places.find(place, frame).write(value)

    def _disconnect(self, instance: InstanceStorage) -> None:
        """Behind a call an in-out shows what the call left, whatever the caller does with it."""
        for key, storage in instance.connections.items():
            left = self._allocator.of_type(storage.kind)
            if isinstance(storage, InstanceStorage):
                left.restore(storage.snapshot())
            else:
                left.write(storage.read())
            instance.connections[key] = left

    def _index(self, expression: Expression, frame: Frame) -> int:
        return self._expressions.integer(expression, frame)


def _meant(call: FunctionCall, instance: Storage) -> Block:
    """The method that the block of the instance has."""
    assert isinstance(instance, InstanceStorage)
    return dict(call.overrides)[instance.block.name]
