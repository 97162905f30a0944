"""What an engine is: a checked program, loaded on a controller, that can be called and looked into.

Two engines implement it. `harness.engine.reference` walks the tree and defines what a program
means; `harness.engine.compiled` is the fast one. They share this face, the faults, the limits and
the layout of memory, and nothing that calculates.
"""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Any, Protocol, TypeAlias

from fbgen.dataclass import dataclass
from fbgen.lang.checked import AnyBlock, Block, Program
from fbgen.lang.types import Scalar, Type
from harness.engine.environment import Environment

Value: TypeAlias = Scalar | Mapping[str, "Value"] | Sequence["Value"]
"""A value as Python sees it.

Scalars are as `fbgen.lang.types` says. A structure or an instance is a mapping from the declared
names to values. An array is a flat sequence, the last index fastest. What an engine gives is a
copy (`dict` and `list`); what it takes it copies.
"""


class Reference:
    """A variable that is handed to a block as it is: for VARIANT, ANY and POINTER.

    `target` is what the engine that made it has for the variable.
    """

    __slots__ = ("_read", "_write", "kind", "target")

    def __init__(
        self, kind: Type, target: Any, read: Callable[[], Value], write: Callable[[Value], None]
    ) -> None:
        self.kind = kind
        self.target = target
        self._read = read
        self._write = write

    @property
    def value(self) -> Value:
        """What the variable holds."""
        return self._read()

    @value.setter
    def value(self, value: Value) -> None:
        self._write(value)


Reader: TypeAlias = Callable[[], tuple[Scalar, ...]]
"""Gives several single values as they are now."""

Convert: TypeAlias = Callable[[Mapping[str, Any]], Mapping[str, Value]]
"""What makes plain values of what a caller gave by name."""

State: TypeAlias = object
"""What `snapshot` gives: to be kept, compared with `==` and given back to `restore`, no more."""


@dataclass(frozen=True, slots=True)
class Limits:
    """How much one call from outside may do before it counts as running away.

    `loop_passes` is the number of passes that all loops together may begin: the part of the cycle
    monitoring time (150 ms on an S7-1500). `call_depth` is how deep blocks of the user may be
    nested, the outermost included (S7-1500 system manual: 24 levels per priority class).
    """

    loop_passes: int = 5_000_000
    call_depth: int = 24


@dataclass(frozen=True, slots=True)
class FunctionResult:
    """What a FUNCTION gave: its value (None without one), its outputs and in-outs by name."""

    value: Value | None
    outputs: Mapping[str, Value]


class Instance(Protocol):
    """A function block with its own state. Names do not depend on case.

    A path is a name with the parts behind it: `status`, `telegram.data[3]`, `table[1, 2]`,
    `timer.ET`. Indices are those of the PLC text.
    """

    @property
    def block(self) -> AnyBlock:
        """The block of which this is an instance."""
        ...

    def call(self, inputs: Mapping[str, Value]) -> None:
        """One call. Inputs and in-outs by name; what is not given keeps its value.

        After a fault the variables hold whatever they held when it was found, and how far the
        call had come is up to the engine.
        """
        ...

    def keyword_call(self, convert: Convert) -> Callable[..., None]:
        """A function that does the same with the inputs and in-outs as keywords.

        What is not simply the value of a single input goes through `convert` first.
        """
        ...

    def get(self, path: str) -> Value:
        """The value of a variable or of a part of it; an in-out as the last call left it.

        For an instance that the program calls, an engine may show instead what the variable behind
        the in-out holds by now.
        """
        ...

    def set(self, path: str, value: Value) -> None:
        """Write a variable or a part of it. Parts of a structure that are not named stay."""
        ...

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance, or of the one at a path, inputs and in-outs by name.

        What is not given has its default. `method` is one of `Program.members`.
        """
        ...

    def snapshot(self) -> State:
        """Everything that the next call depends on: all variables that live on, nested ones too.

        The places that in-outs refer to belong to somebody else and are left out.
        """
        ...

    def restore(self, state: State) -> None:
        """Go back to a snapshot of this instance, or of another one of the same block."""
        ...


class Engine(Protocol):
    """One loaded program on one controller."""

    @property
    def program(self) -> Program:
        """What is loaded."""
        ...

    @property
    def environment(self) -> Environment:
        """The controller around it."""
        ...

    def instance(
        self, block_name: str, arguments: Mapping[str, Value] = MappingProxyType({})
    ) -> Instance:
        """A fresh instance of a function block, the user's or a standard one.

        `arguments` are those of its FB_init.
        """
        ...

    def global_instance(self, name: str) -> Instance:
        """The instance that a data block or a global variable is."""
        ...

    def call_function(self, name: str, arguments: Mapping[str, Value]) -> FunctionResult:
        """Call a FUNCTION, inputs and in-outs by name; what is not given has its default."""
        ...

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance at a path as `global_value` takes it."""
        ...

    def run_block(self, name: str, start: bytes = b"") -> None:
        """Run an organization block, a PROGRAM or a FUNCTION without parameters and result.

        A PROGRAM keeps its variables from run to run. `start` are the 20 bytes of start information
        that an organization block has at the beginning of its temporary data; none for zeros.
        """
        ...

    def global_value(self, path: str) -> Value:
        """Read `DB.member[3]`, a global variable, or a variable of a PROGRAM as `Main.counter`."""
        ...

    def set_global(self, path: str, value: Value) -> None:
        """Write what `global_value` reads."""
        ...

    def reference(self, path: str) -> Reference:
        """What `global_value` reads, to be handed over itself."""
        ...

    def new_variable(self, kind: Type, value: Value | None) -> Reference:
        """A variable of its own; without a value it has the default of its type."""
        ...

    def reader(self, paths: Sequence[str]) -> Reader:
        """What reads single values as `global_value`, in the order of the paths; fast."""
        ...

    def data_block(self, number: int) -> bytearray | None:
        """The bytes of a data block with that number; None if it does not lie in bytes."""
        ...

    def snapshot(self) -> State:
        """All that lives in the program itself: global variables and the variables of PROGRAMs."""
        ...

    def restore(self, state: State) -> None:
        """Go back to a snapshot of the same program."""
        ...

    def reset(self, warm: bool) -> None:
        """Initial values everywhere in the program; after a warm start remanent variables stay."""
        ...


class EngineFactory(Protocol):
    """How an engine is made: `CompiledEngine(program, environment, limits)`."""

    def __call__(self, program: Program, environment: Environment, limits: Limits) -> Engine:
        """Load the program."""
        ...
