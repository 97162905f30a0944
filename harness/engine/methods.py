"""Methods of a running program as Python functions, and what properties are read and written by."""

from collections.abc import Mapping
from typing import Protocol

from fbgen.lang.checked import Block, BlockMembers, Program, VariableKind
from fbgen.lang.types import BlockType, Type
from harness.engine.interface import FunctionResult, Value


class Callee(Protocol):
    """Calls methods of the instances that it finds by paths."""

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance at a path."""
        ...


class BoundMethod:
    """A method or an action of one instance: `fb.Bump(amount=3)` gives the result."""

    __slots__ = ("_callee", "_method", "_path")

    def __init__(self, callee: Callee, path: str, method: Block) -> None:
        self._callee = callee
        self._path = path
        self._method = method

    def __call__(self, /, **arguments: Value) -> Value | None:
        """Call it, inputs and in-outs by name; None if it has no result."""
        return self.with_outputs(**arguments).value

    def with_outputs(self, /, **arguments: Value) -> FunctionResult:
        """Call it; the result together with the outputs and in-outs."""
        return self._callee.call_method(self._path, self._method, arguments)

    def __repr__(self) -> str:
        """The name of its block and its own."""
        return f"<method {self._method.name}>"


def members_of(program: Program, kind: Type) -> BlockMembers | None:
    """What instances of a type can be asked for; None for what has no members."""
    return program.members.get(kind.name.casefold()) if isinstance(kind, BlockType) else None


def written_by(setter: Block, value: Value) -> dict[str, Value]:
    """The argument with which SET is called."""
    name = next(one.name for one in setter.variables if one.kind is VariableKind.INPUT)
    return {name: value}
