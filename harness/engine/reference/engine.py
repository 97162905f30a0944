"""The reference evaluator as an engine: what is called and looked into from outside."""

import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import MappingProxyType
from typing import Any, cast

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    IN_OUTS,
    AnyBlock,
    Block,
    Program,
    StandardBlock,
    Variable,
    VariableKind,
)
from fbgen.lang.checked.variables import IN_GLOBALS, RECEIVER
from fbgen.lang.types import ArrayType, BlockType, OpenArrayType, Scalar, Type
from harness.engine.environment import Environment
from harness.engine.faults import missing_argument, unknown_name, wrong_kind_of_block
from harness.engine.interface import (
    Convert,
    FunctionResult,
    Limits,
    Reader,
    Reference,
    State,
    Value,
)
from harness.engine.path_types import global_steps
from harness.engine.paths import parse_path
from harness.engine.reference.allocation import Allocator
from harness.engine.reference.calls import Calls
from harness.engine.reference.lookup import find_part
from harness.engine.reference.memory import Memory
from harness.engine.reference.pointers import Pointed
from harness.engine.reference.storage import InstanceStorage, Storage
from harness.engine.starting import own_starts
from harness.engine.values import accept, array_of

_PYTHON_FRAMES = 40_000
"""Enough for the deepest nesting of blocks, statements and expressions that the checker allows."""


class ReferenceEngine:
    """One program, loaded on a controller. Implements `interface.Engine`."""

    __slots__ = (
        *("_allocator", "_blocks", "_by_key", "_calls", "_environment", "_globals", "_program"),
        "_runnable",
    )

    def __init__(self, program: Program, environment: Environment, limits: Limits) -> None:
        self._program = program
        self._environment = environment
        self._blocks: dict[Variable, bytearray] = {}
        memory = Memory(environment, self.data_block)
        self._allocator = Allocator(program, memory)
        self._globals: dict[Variable, Storage] = {}
        self._by_key: dict[str, Storage] = {}
        for key, variable in program.globals.items():
            if variable in program.byte_memory:
                self._blocks[variable] = self._allocator.memory_of(variable)
            self._globals[variable] = self._by_key[key] = self._fresh(variable, self._blocks)
        self._runnable = self._own_instances()
        self._calls = Calls(program, memory, limits, self._allocator, self._globals)
        self.reset(warm=False)

    @property
    def program(self) -> Program:
        """What is loaded."""
        return self._program

    @property
    def environment(self) -> Environment:
        """The controller around it."""
        return self._environment

    def instance(
        self, block_name: str, arguments: Mapping[str, Value] = MappingProxyType({})
    ) -> "ReferenceInstance":
        """A fresh instance of a function block; its FB_init has run."""
        key = block_name.casefold()
        blocks: dict[str, AnyBlock] = {**self._program.standard_blocks, **self._program.blocks}
        if key not in blocks:
            raise unknown_name("block", block_name, [block.name for block in blocks.values()])
        block = blocks[key]
        if isinstance(block, Block) and block.kind is not BlockKind.FUNCTION_BLOCK:
            raise wrong_kind_of_block(
                block.name, block.kind.value, "only a FUNCTION_BLOCK has instances; call it instead"
            )
        storage = self._allocator.of_type(BlockType(block.name))
        assert isinstance(storage, InstanceStorage)
        self._start_inside(block.name, storage, retains=True)
        for method, values in own_starts(self._program, block.name, arguments):
            self.call_on(storage, method, values)
        return ReferenceInstance(self, self._allocator, self._calls, storage)

    def global_instance(self, name: str) -> "ReferenceInstance":
        """The instance that a data block or a global variable is."""
        storage = self._global(name)
        if not isinstance(storage, InstanceStorage):
            raise wrong_kind_of_block(
                name, "variable without code", "only an instance of a function block can be called"
            )
        return ReferenceInstance(self, self._allocator, self._calls, storage)

    def call_function(self, name: str, arguments: Mapping[str, Value]) -> FunctionResult:
        """Call a FUNCTION with its inputs and in-outs by name."""
        block = self._block(name)
        if block.kind is not BlockKind.FUNCTION:
            use = f"use instance('{block.name}') or run_block('{block.name}')"
            raise wrong_kind_of_block(block.name, block.kind.value, use)
        return self.call_on(None, block, arguments)

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance at a path."""
        return self.call_on(self._global(path), method, arguments)

    def call_on(
        self, this: Storage | None, block: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """A FUNCTION, or a method or an action of an instance."""
        if block.kind is not BlockKind.FUNCTION:
            assert isinstance(this, InstanceStorage)
            with self.running():
                self._calls.run_instance(this, None, block)
            return FunctionResult(None, {})
        frame = self._calls.frame(block)
        if this is not None:
            frame.storages[block.variables[0]] = this
        given = check_arguments(self._program, block, arguments)
        sizes = open_arrays(block, arguments)
        for variable in block.variables:
            if variable in frame.storages and variable.name == RECEIVER:
                continue
            if variable.kind in (VariableKind.INPUT, VariableKind.IN_OUT):
                if isinstance(variable.type, OpenArrayType) and variable.name in sizes:
                    storage = self._allocator.of_type(sizes[variable.name])
                else:
                    storage = frame.storages.get(variable) or self._allocator.variable(variable)
                if variable in given:
                    storage.write(given[variable])
                frame.storages[variable] = storage
        with self.running():
            self._calls.run_function(block, frame, None)
        outputs = {
            variable.name: frame.storages[variable].read()
            for variable in block.variables
            if variable.kind in (VariableKind.OUTPUT, VariableKind.IN_OUT)
            and (this is None or variable.name != RECEIVER)
        }
        value = None if block.result is None else frame.storages[block.result].read()
        return FunctionResult(value, outputs)

    def run_block(self, name: str, start: bytes = b"") -> None:
        """Run an organization block, a PROGRAM or a FUNCTION without parameters."""
        instance = self._runnable.get(name.casefold())
        if instance is not None:
            with self.running():
                self._calls.run_instance(instance, None, start=start)
            return
        block = self._block(name)
        if block.kind is not BlockKind.FUNCTION:
            raise wrong_kind_of_block(block.name, block.kind.value, f"use instance('{block.name}')")
        for variable in block.variables:
            if variable.kind in (VariableKind.INPUT, VariableKind.IN_OUT):
                raise missing_argument(block.name, variable.name)
        self.call_function(name, {})

    def global_value(self, path: str) -> Value:
        """Read a global variable, a data block or a variable of a PROGRAM."""
        return self._global(path).read()

    def set_global(self, path: str, value: Value) -> None:
        """Write what `global_value` reads."""
        storage = self._global(path)
        storage.write(accept(self._program, path, storage.kind, value))

    def reference(self, path: str) -> Reference:
        """What `global_value` reads, to be handed over itself."""
        return self._reference(path, self._global(path))

    def new_variable(self, kind: Type, value: Value | None) -> Reference:
        """A variable of its own, in bytes, so that it has an address."""
        reference = self._reference("value", self._allocator.alone(kind))
        if value is not None:
            reference.value = value
        return reference

    def _reference(self, path: str, storage: Storage) -> Reference:
        def write(value: Value) -> None:
            storage.write(accept(self._program, path, storage.kind, value))

        return Reference(storage.kind, Pointed(storage), storage.read, write)

    def reader(self, paths: Sequence[str]) -> Reader:
        """What reads these single values, again and again."""
        reads = [cast("Callable[[], Scalar]", self._global(path).read) for path in paths]
        return lambda: tuple([read() for read in reads])

    def snapshot(self) -> State:
        """Global variables and the variables of PROGRAMs."""
        storages = (*self._globals.values(), *self._own().values())
        blocks = tuple(bytes(memory) for memory in self._blocks.values())
        values = tuple(storage.snapshot() for storage in storages)
        return blocks, values, self._calls.routines.snapshot()

    def restore(self, state: State) -> None:
        """Go back to a snapshot of the same program."""
        assert isinstance(state, tuple)
        storages = (*self._globals.values(), *self._own().values())
        for storage, saved in zip(storages, state[1], strict=True):
            storage.restore(saved)
        for memory, data in zip(self._blocks.values(), state[0], strict=True):
            memory[:] = data
        self._calls.routines.restore(state[2])

    def reset(self, warm: bool) -> None:
        """Initial values everywhere in the program; after a warm start remanent variables stay."""
        for variable, storage in self._globals.items():
            if not (warm and variable.remanent):
                storage.reset(self._fresh(variable, {}), warm)
        self._calls.routines.reset()
        fresh = self._own_instances()
        for key, instance in self._own().items():
            instance.reset(fresh[key], warm)
        self._start_inside(IN_GLOBALS, None, retains=not warm)
        for instance in self._runnable.values():
            self._start_inside(instance.block.name, instance, retains=not warm)

    def _start_inside(self, name: str, storage: Storage | None, *, retains: bool) -> None:
        """FB_init of the instances in a block or among the global variables."""
        function = self._program.starts.get(name.casefold())
        if function is not None:
            self.call_on(storage, function, {"retains": retains})

    @contextmanager
    def running(self) -> Iterator[None]:
        """Around each call from outside: the counters start anew, and Python allows its depth."""
        interrupted = self._calls.begin()
        before = sys.getrecursionlimit()
        sys.setrecursionlimit(max(before, _PYTHON_FRAMES))
        try:
            yield
        finally:
            sys.setrecursionlimit(before)
            self._calls.resume(interrupted)

    def _own_instances(self) -> dict[str, InstanceStorage]:
        """PROGRAMs and organization blocks by name, and the PROGRAMs that tasks have."""
        instances = {
            key: self._allocator.of_block(block)
            for key, block in self._program.blocks.items()
            if block.kind is BlockKind.ORGANIZATION_BLOCK
        }
        for key, block in self._program.program_instances().items():
            variable = self._program.program_variable(key)
            shared = None if variable is None else self._globals[variable]
            assert shared is None or isinstance(shared, InstanceStorage)
            instances[key] = shared or self._allocator.of_block(block)
        return instances

    def _own(self) -> dict[str, InstanceStorage]:
        """What runs by itself and is no global variable."""
        return {
            key: instance
            for key, instance in self._runnable.items()
            if self._program.program_variable(key) is None
        }

    def _block(self, name: str) -> Block:
        blocks = self._program.blocks
        if name.casefold() not in blocks:
            raise unknown_name("block", name, [block.name for block in blocks.values()])
        return blocks[name.casefold()]

    def _global(self, path: str) -> Storage:
        first, *rest = global_steps(self._program, path)
        key = str(first).casefold()
        storage = self._by_key.get(key) or self._runnable.get(key)
        if storage is None:
            names = [variable.name for variable in self._globals]
            names += [instance.block.name for instance in self._runnable.values()]
            raise unknown_name("global variable", str(first), names)
        return find_part(storage, rest, path)

    def _fresh(self, variable: Variable, blocks: Mapping[Variable, bytearray]) -> Storage:
        """A global variable with its initial values; a data block in its memory, if it has one."""
        if variable not in self._program.byte_memory:
            return self._allocator.variable(variable)
        memory = blocks.get(variable)
        if memory is None:
            memory = self._allocator.memory_of(variable)
        return self._allocator.data_block(variable, memory)

    def data_block(self, number: int) -> bytearray | None:
        """The bytes of a data block; None if there is none with that number in bytes."""
        variable = self._program.data_blocks.get(number)
        return None if variable is None else self._blocks.get(variable)


class ReferenceInstance:
    """A function block with its own state. Implements `interface.Instance`."""

    __slots__ = ("_allocator", "_calls", "_engine", "_storage")

    def __init__(
        self,
        engine: ReferenceEngine,
        allocator: Allocator,
        calls: Calls,
        storage: InstanceStorage,
    ) -> None:
        self._engine = engine
        self._allocator = allocator
        self._calls = calls
        self._storage = storage

    @property
    def block(self) -> AnyBlock:
        """The block of which this is an instance."""
        return self._storage.block

    def call(self, inputs: Mapping[str, Value]) -> None:
        """One call. What is not given keeps its value."""
        block = self._storage.block
        given = check_arguments(self._engine.program, block, inputs)
        for name, kind in open_arrays(block, inputs).items():
            self._storage.connections[name.casefold()] = self._allocator.of_type(kind)
        self._connect()
        for variable, value in given.items():
            self._storage.part(variable.name.casefold()).write(value)
        with self._engine.running():
            if isinstance(block, StandardBlock):
                self._calls.run_standard(self._storage, block)
            else:
                self._calls.run_instance(self._storage, None)

    def keyword_call(self, convert: Convert) -> Callable[..., None]:
        """A function that does the same with the inputs and in-outs as keywords."""

        def call(**inputs: Any) -> None:
            self.call(convert(inputs))

        return call

    def get(self, path: str) -> Value:
        """The value of a variable or of a part of it."""
        return self._part(path).read()

    def set(self, path: str, value: Value) -> None:
        """Write a variable or a part of it."""
        part = self._part(path)
        part.write(accept(self._engine.program, path, part.kind, value))

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance, or of the one at a path."""
        this = self._part(path) if path else self._storage
        return self._engine.call_on(this, method, arguments)

    def snapshot(self) -> State:
        """Everything that the next call depends on."""
        return self._storage.snapshot()

    def restore(self, state: State) -> None:
        """Go back to a snapshot of an instance of the same block."""
        self._storage.restore(state)

    def _part(self, path: str) -> Storage:
        self._connect()
        return find_part(self._storage, list(parse_path(path)), path)

    def _connect(self) -> None:
        """In-outs that nobody has connected get a place of their own."""
        for variable in self._storage.block.variables:
            key = variable.name.casefold()
            if variable.kind is VariableKind.IN_OUT and key not in self._storage.connections:
                self._storage.connections[key] = self._allocator.variable(variable)


def check_arguments(
    program: Program, block: AnyBlock, arguments: Mapping[str, Value]
) -> dict[Variable, Value]:
    """The arguments of a call from outside, by parameter. Raises FB6020 and FB6021."""
    parameters = {
        variable.name.casefold(): variable
        for variable in block.variables
        if variable.kind in (VariableKind.INPUT, *IN_OUTS)
    }
    given: dict[Variable, Value] = {}
    for name, value in arguments.items():
        variable = parameters.get(name.casefold())
        if variable is None:
            names = [parameter.name for parameter in parameters.values()]
            raise unknown_name(f"input of {block.name}", name, names)
        given[variable] = accept(program, variable.name, variable.type, value)
    return given


def open_arrays(block: AnyBlock, arguments: Mapping[str, Value]) -> dict[str, ArrayType]:
    """The arrays that stand for the ARRAY[*] parameters of a call, by declared name."""
    by_key = {name.casefold(): value for name, value in arguments.items()}
    return {
        variable.name: array_of(variable.name, variable.type, by_key[variable.name.casefold()])
        for variable in block.variables
        if isinstance(variable.type, OpenArrayType) and variable.name.casefold() in by_key
    }
