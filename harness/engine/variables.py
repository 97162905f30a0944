"""Variables of a running program as Python attributes and items.

`fb.status`, `fb.telegram.data[3]`, `fb.table[1, 2]`, `fb["telegram.data[3]"]`: whatever the case of
the names, and with the indices of the PLC text. A scalar reads as its value; a structure, array or
instance as a view that follows the program. A name that is no Python name, or that starts with
`_`, is reached by an item. A method is called like one of Python, `fb.Bump(amount=3)`, which gives
its result; `fb.Bump.with_outputs(amount=3)` has its outputs as well. A property reads and writes
like a variable.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Protocol, TypeAlias

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Block, Program, Variable, VariableKind
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    OpenArrayType,
    ReferenceType,
    StructType,
    Type,
)
from harness.engine.interface import Engine, FunctionResult, Instance, Value
from harness.engine.methods import BoundMethod, members_of, written_by
from harness.engine.paths import FOLLOW, Step, parse_path
from harness.engine.values import shown


class UnknownVariableError(DiagnosticError, AttributeError):
    """An attribute that the program does not have; the message names the nearest one."""


class Access(Protocol):
    """Reads and writes by paths."""

    def get(self, path: str) -> Value:
        """The value at a path."""
        ...

    def set(self, path: str, value: Value) -> None:
        """Write the value at a path."""
        ...

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        """Call a method of the instance at a path."""
        ...


class View:
    """A structure, array or instance inside the program."""

    __slots__ = ("_access", "_kind", "_path", "_program")

    _access: Access
    _kind: Type
    _path: str
    _program: Program

    def __init__(self, access: Access, path: str, kind: Type, program: Program) -> None:
        object.__setattr__(self, "_access", access)
        object.__setattr__(self, "_path", path)
        object.__setattr__(self, "_kind", kind)
        object.__setattr__(self, "_program", program)

    def __getattr__(self, name: str) -> "Item":
        if name.startswith("_"):
            raise AttributeError(name)
        member = self._member(name)  # a fault in a property is no missing attribute
        if member is not None:
            return member
        try:
            return self[name]
        except DiagnosticError as failure:
            raise UnknownVariableError(failure.diagnostics) from None

    def __setattr__(self, name: str, value: "Value | View") -> None:
        self[name] = value

    def __getitem__(self, item: "str | int | tuple[int, ...]") -> "Item":
        """A part by its name or path, or an element by its index or indices.

        A method comes as a function, a property as its value.
        """
        member = self._member(item)
        if member is not None:
            return member
        kind: Type | None = self._kind
        for step in parse_path(item) if isinstance(item, str) else (_indices(item),):
            kind = None if kind is None else self._part_kind(kind, step)
        path = self._path_to(item)
        if isinstance(kind, StructType | ArrayType | OpenArrayType | BlockType):
            return View(self._access, path, kind, self._program)
        value = self._access.get(path)
        assert isinstance(value, bool | int | float | str)
        return bool(value) if isinstance(kind, ReferenceType) else shown(kind, value)

    def _member(self, item: "str | int | tuple[int, ...]") -> "Item | None":
        """A method or an action as a function, the value of a property; None for other names."""
        members = members_of(self._program, self._kind)
        if members is None or not isinstance(item, str):
            return None
        key = item.casefold()
        method = members.methods.get(key) or members.actions.get(key)
        if method is not None:
            return BoundMethod(self._access, self._path, method)
        getter = members.getters.get(key)
        if getter is None or getter.result is None:
            return None
        value = self._access.call_method(self._path, getter, {}).value
        if isinstance(value, bool | int | float | str):
            return shown(getter.result.type, value)
        return value

    def __setitem__(self, item: "str | int | tuple[int, ...]", value: "Value | View") -> None:
        members = members_of(self._program, self._kind)
        setter = members.setters.get(item.casefold()) if members and isinstance(item, str) else None
        if setter is not None:
            self._access.call_method(self._path, setter, written_by(setter, plain(value)))
            return
        self._access.set(self._path_to(item), plain(value))

    def __len__(self) -> int:
        """How many parts or elements there are."""
        return len(self._value())

    def __iter__(self) -> Iterator[Value]:
        """The elements of an array in flat order; of anything else the names of the parts."""
        return iter(self._value())

    def __eq__(self, other: object) -> bool:
        """Compares the values."""
        return self._value() == (other._value() if isinstance(other, View) else other)

    __hash__ = None  # type: ignore[assignment]  # the way Python marks what cannot be hashed

    def __repr__(self) -> str:
        """The type and the values."""
        return f"{self._kind} {self._value()!r}"

    def _value(self) -> dict[str, Value] | list[Value]:
        value = self._access.get(self._path)
        assert isinstance(value, dict | list)
        return value

    def _path_to(self, item: "str | int | tuple[int, ...]") -> str:
        if isinstance(item, str):
            return f"{self._path}.{item}" if self._path else item
        return f"{self._path}[{', '.join(str(index) for index in _indices(item))}]"

    def _part_kind(self, kind: Type, step: Step) -> Type | None:
        """The type of a part; None if there is no such part, which reading it will report."""
        if step == FOLLOW:
            return kind.target if isinstance(kind, ReferenceType) else None
        if isinstance(step, tuple):
            return kind.element if isinstance(kind, ArrayType | OpenArrayType) else None
        if isinstance(kind, StructType):
            field = kind.field(step)
            return None if field is None else field.type
        if isinstance(kind, BlockType):
            variables = self._program.block_of(kind.name).variables
            return _type_of(variables, step)
        return None


Item: TypeAlias = Value | View | BoundMethod


class BlockInstance(View):
    """A function block with its own state: a call `fb(execute=True)`, and its variables.

    Inputs and in-outs that are not given keep their value. Each instance is of a class of its own,
    because that is how Python finds `__call__`; whoever calls one instance very often saves a third
    by `call = fb.__call__`.
    """

    __slots__ = ("_instance",)

    __call__: Callable[..., None]
    _instance: Instance

    def __new__(cls, instance: Instance, program: Program) -> "BlockInstance":
        """An instance whose call is the engine's own function."""
        call = staticmethod(instance.keyword_call(_plain_values))
        own: type[BlockInstance] = type(cls.__name__, (cls,), {"__slots__": (), "__call__": call})
        return object.__new__(own)

    def __init__(self, instance: Instance, program: Program) -> None:
        super().__init__(instance, "", BlockType(instance.block.name), program)
        object.__setattr__(self, "_instance", instance)

    def _value(self) -> dict[str, Value]:
        return {
            variable.name: self._instance.get(f'"{variable.name}"')
            for variable in self._instance.block.variables
            if variable.kind not in (VariableKind.TEMP, VariableKind.RESULT)
        }


class Globals(View):
    """The data blocks and global variables of a program, and its PROGRAMs by name."""

    __slots__ = ()

    def __init__(self, engine: Engine) -> None:
        super().__init__(_GlobalAccess(engine), "", _NAMESPACE, engine.program)

    def _value(self) -> dict[str, Value]:
        return {
            variable.name: self._access.get(f'"{variable.name}"')
            for variable in self._program.globals.values()
        }

    def _part_kind(self, kind: Type, step: Step) -> Type | None:
        if kind is not _NAMESPACE or isinstance(step, tuple):
            return super()._part_kind(kind, step)
        key = step.casefold()
        if key in self._program.globals:
            return self._program.globals[key].type
        return BlockType(self._program.blocks[key].name) if key in self._program.blocks else None


class _GlobalAccess:
    """The global variables of an engine as `Access`."""

    __slots__ = ("_engine",)

    def __init__(self, engine: Engine) -> None:
        self._engine = engine

    def get(self, path: str) -> Value:
        return self._engine.global_value(path)

    def set(self, path: str, value: Value) -> None:
        self._engine.set_global(path, value)

    def call_method(
        self, path: str, method: Block, arguments: Mapping[str, Value]
    ) -> FunctionResult:
        return self._engine.call_method(path, method, arguments)


_NAMESPACE = StructType("global variables", ())


def plain(value: Value | View) -> Value:
    """A copy of what a view shows: `dict` and `list`; any other value as it is."""
    return value._value() if isinstance(value, View) else value


def _plain_values(values: Mapping[str, Value | View]) -> dict[str, Value]:
    return {name: plain(value) for name, value in values.items()}


def _indices(item: int | tuple[int, ...]) -> tuple[int, ...]:
    return item if isinstance(item, tuple) else (item,)


def _type_of(variables: Sequence[Variable], name: str) -> Type | None:
    key = name.casefold()
    found = (variable.type for variable in variables if variable.name.casefold() == key)
    return next(found, None)
