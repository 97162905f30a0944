"""What is on trial: a function block, a function, or a block that a CPU would run.

They are called differently and their variables are found differently; a trial need not know.
"""

from collections.abc import Mapping
from typing import Protocol

from fbgen.diagnostics import error
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import IN_OUTS, Block, Variable, VariableKind
from fbgen.lang.start_information import START_BYTES, start_places
from fbgen.lang.types import BlockType, Type
from fbgen.nearest import nearest
from harness.engine.compiled.watching.last_writes import LastWrite, last_write, last_write_in
from harness.engine.faults import unknown_name
from harness.engine.interface import Engine, Value
from harness.engine.layout import S7
from harness.engine.path_types import part_type, type_at
from harness.engine.paths import parse_path
from harness.engine.values import accept


class Subject(Protocol):
    """One block with its state. Paths are those of the block: `status`, `timer.ET`."""

    @property
    def name(self) -> str:
        """Its name, as it is declared."""
        ...

    @property
    def outputs(self) -> tuple[str, ...]:
        """What it gives: its outputs, in-outs and its result, by name."""
        ...

    def call(self) -> None:
        """One call."""
        ...

    def type_of(self, path: str) -> Type:
        """The type of a variable or a part of it. Raises DiagnosticError."""
        ...

    def value(self, path: str) -> Value:
        """What a variable holds. Raises DiagnosticError."""
        ...

    def set(self, path: str, value: Value) -> None:
        """Set a variable for the calls that follow. Raises DiagnosticError."""
        ...

    def last_write(self, path: str) -> LastWrite | None:
        """The line that wrote a variable last; None where nobody takes notes."""
        ...


def subject_named(engine: Engine, name: str = "") -> Subject:
    """The block of that name, or the only one that there is.

    Raises DiagnosticError FB6020 for an unknown name, FB9011 if no name is given and it is not
    clear which block is meant.
    """
    blocks = engine.program.blocks
    if name:
        block = blocks.get(name.casefold())
        if block is None:
            raise unknown_name("block", name, [block.name for block in blocks.values()])
    else:
        block = _only_block(tuple(blocks.values()))
    if block.kind is BlockKind.FUNCTION:
        return FunctionSubject(engine, block)
    if block.kind is BlockKind.FUNCTION_BLOCK:
        return InstanceSubject(engine, block)
    return CyclicSubject(engine, block)


def _only_block(blocks: tuple[Block, ...]) -> Block:
    """The block to run where nobody names one: the one that calls the others, if there is one."""
    runnable = (BlockKind.PROGRAM, BlockKind.ORGANIZATION_BLOCK)
    for chosen in ([block for block in blocks if block.kind in runnable], list(blocks)):
        if len(chosen) == 1:
            return chosen[0]
    if not blocks:
        raise error("FB9011", "there is no block in these files", help="give a file with a block")
    raise error(
        "FB9011",
        f"which of the {len(blocks)} blocks shall run?",
        help="name it with --block; " + nearest("", (block.name for block in blocks)),
    )


class InstanceSubject:
    """A function block with an instance of its own."""

    def __init__(self, engine: Engine, block: Block) -> None:
        self._engine = engine
        self._program = engine.program
        self._instance = engine.instance(block.name)
        self._type = BlockType(block.name)
        self.name = block.name
        self.outputs = _names(block, VariableKind.OUTPUT, *IN_OUTS)

    def call(self) -> None:
        self._instance.call({})

    def type_of(self, path: str) -> Type:
        self._instance.get(path)
        kind: Type = self._type
        for step in parse_path(path):
            kind = part_type(self._program, kind, step)
        return kind

    def value(self, path: str) -> Value:
        return self._instance.get(path)

    def set(self, path: str, value: Value) -> None:
        self._instance.set(path, value)

    def last_write(self, path: str) -> LastWrite | None:
        return last_write_in(self._engine, self._instance, path)


class FunctionSubject:
    """A FUNCTION: its inputs are kept from call to call, its outputs are those of the last one."""

    def __init__(self, engine: Engine, block: Block) -> None:
        self._engine = engine
        self._block = block
        self._variables = {variable.name.casefold(): variable for variable in block.variables}
        self._arguments: dict[str, Value] = {}
        self._results: Mapping[str, Value] = {}
        result = (block.name,) if block.result is not None else ()
        self.name = block.name
        self.outputs = result + _names(block, VariableKind.OUTPUT, VariableKind.IN_OUT)

    def call(self) -> None:
        done = self._engine.call_function(self._block.name, self._arguments)
        self._results = dict(done.outputs)
        if done.value is not None:
            self._results[self._block.name] = done.value

    def type_of(self, path: str) -> Type:
        return self._variable(path).type

    def value(self, path: str) -> Value:
        variable = self._variable(path)
        if variable.name in self._results:
            return self._results[variable.name]
        if variable.name in self._arguments:
            return self._arguments[variable.name]
        raise error(
            "FB9012",
            f"'{path}' of {self._block.name} cannot be watched",
            help="a function keeps nothing: watch its result or its outputs, "
            + ", ".join(self.outputs),
        )

    def set(self, path: str, value: Value) -> None:
        self._arguments[self._variable(path).name] = value

    def last_write(self, path: str) -> LastWrite | None:
        return None

    def _variable(self, path: str) -> Variable:
        variable = self._variables.get(path.strip().strip('#"').casefold())
        if variable is None:
            names = [variable.name for variable in self._block.variables]
            raise unknown_name(f"variable of {self._block.name}", path, names)
        return variable


class CyclicSubject:
    """An organization block or PROGRAM: sees global variables, a PROGRAM also its own.

    What the operating system tells an organization block can be set by the names that the block
    has for it; zeros without.
    """

    def __init__(self, engine: Engine, block: Block) -> None:
        self._engine = engine
        self._block = block
        kept = () if block.kind is BlockKind.ORGANIZATION_BLOCK else block.variables
        self._own = {variable.name.casefold() for variable in kept}
        self._places = {
            variable.name.casefold(): (variable.type, bit) for variable, bit in start_places(block)
        }
        self._start = bytearray(START_BYTES)
        self.name = block.name
        self.outputs = tuple(
            variable.name for variable in kept if variable.kind is not VariableKind.TEMP
        ) or tuple(variable.name for variable in engine.program.globals.values())

    def call(self) -> None:
        self._engine.run_block(self._block.name, bytes(self._start) if self._places else b"")

    def type_of(self, path: str) -> Type:
        if path.casefold() in self._places:
            return self._places[path.casefold()][0]
        self.value(path)
        return type_at(self._engine.program, self._path(path))

    def value(self, path: str) -> Value:
        if path.casefold() in self._places:
            kind, bit = self._places[path.casefold()]
            return S7.read(self._start, bit, kind)
        return self._engine.global_value(self._path(path))

    def set(self, path: str, value: Value) -> None:
        if path.casefold() in self._places:
            kind, bit = self._places[path.casefold()]
            S7.write(self._start, bit, kind, accept(self._engine.program, path, kind, value))
            return
        self._engine.set_global(self._path(path), value)

    def last_write(self, path: str) -> LastWrite | None:
        if path.casefold() in self._places:
            return None
        return last_write(self._engine, self._path(path))

    def _path(self, path: str) -> str:
        first = str(parse_path(path)[0]).casefold()
        return f'"{self._block.name}".{path}' if first in self._own else path


def _names(block: Block, *kinds: VariableKind) -> tuple[str, ...]:
    return tuple(variable.name for variable in block.variables if variable.kind in kinds)
