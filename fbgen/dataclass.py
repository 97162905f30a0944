"""`dataclass` as in the standard library, with methods that are written when they are first used.

The `dataclass` of `dataclasses` writes and compiles up to six methods for each class while its
module is imported. A command imports hundreds of such classes and calls few of their methods, and
would spend a fifth of its time on that. Here a method is a descriptor at first; whoever asks for it
has it compiled and put in the descriptor's place, so that every later use costs what it always did.
A frozen instance with slots is filled through its slots, which is a third faster.

Fields are those of `dataclasses`: `field`, `fields`, `replace`, `asdict` and the rest apply. Of its
options there are those that fbgen uses: `frozen`, `slots` and `eq`, and of a field all but
`kw_only`; there is no `InitVar`.
"""

import dataclasses
from collections.abc import Callable, Iterable
from dataclasses import MISSING, Field, FrozenInstanceError
from reprlib import recursive_repr
from types import MemberDescriptorType
from typing import TYPE_CHECKING, Any, TypeAlias

__all__ = ["dataclass"]

if TYPE_CHECKING:
    from dataclasses import dataclass
else:

    def dataclass(cls=None, /, *, frozen=False, slots=False, eq=True):
        """Make a class a dataclass: `@dataclass`, or `@dataclass(frozen=True, slots=True)`."""

        def made(one):
            return _made(one, frozen, slots, eq)

        return made if cls is None else made(cls)


_Writer: TypeAlias = Callable[[type, bool], Callable[..., Any]]
"""Writes a method of a class, which is frozen or not."""


def _made(cls: type, frozen: bool, slots: bool, eq: bool) -> type:
    own = cls.__dict__
    with_fields = dataclasses.dataclass(init=False, repr=False, eq=False, slots=slots)
    made: Any = with_fields(cls)
    if "__init__" not in own:
        made.__init__ = _Late(made, "__init__", _init, frozen)
    if "__repr__" not in own:
        made.__repr__ = _shown
    if eq and "__eq__" not in own:
        made.__eq__ = _Late(made, "__eq__", _eq, frozen)
    if eq and own.get("__hash__") is None:
        made.__hash__ = _Late(made, "__hash__", _hash, frozen) if frozen else None
    if frozen:
        made.__setattr__, made.__delattr__, made.__setstate__ = _assign, _delete, _restore
    found: type = made
    return found


class _Late:
    """A method that takes this one's place in its class as soon as somebody asks for it."""

    __slots__ = ("_frozen", "_name", "_owner", "_write")

    def __init__(self, owner: type, name: str, write: _Writer, frozen: bool) -> None:
        self._owner, self._name = owner, name
        self._write, self._frozen = write, frozen

    def __get__(self, instance: object, asked: type) -> Callable[..., Any]:
        owner = self._owner
        method: Any = self._write(owner, self._frozen)
        method.__qualname__ = f"{owner.__qualname__}.{self._name}"
        method.__module__ = owner.__module__
        setattr(owner, self._name, method)
        found: Callable[..., Any] = method if instance is None else method.__get__(instance, asked)
        return found


class _Fresh:
    """The default of a parameter whose field has a factory."""

    def __repr__(self) -> str:
        return "<factory>"


_FRESH = _Fresh()


def _init(cls: type, frozen: bool) -> Callable[..., Any]:
    """Takes the fields in their order. Names of its own begin with two underscores."""
    fields = dataclasses.fields(cls)
    names: dict[str, Any] = {"__fresh": _FRESH, "__set": object.__setattr__}
    parameters, body = ["self"], []
    for field in fields:
        value = name = field.name
        if field.default is not MISSING:
            names[f"__default_{name}"] = field.default
        if field.default_factory is not MISSING:
            names[f"__make_{name}"] = field.default_factory
            value = f"__make_{name}()"
            if field.init:
                parameters.append(f"{name}=__fresh")
                value = f"{value} if {name} is __fresh else {name}"
        elif field.init:
            default = "" if field.default is MISSING else f"=__default_{name}"
            parameters.append(name + default)
        elif field.default is MISSING:
            continue
        else:
            value = f"__default_{name}"
        body.append(_assignment(cls, name, value, names) if frozen else f"self.{name} = {value}")
    if hasattr(cls, "__post_init__"):
        body.append("self.__post_init__()")
    made = _compiled(cls, "__init__", parameters, body or ["pass"], names)
    made.__annotations__ = {one.name: one.type for one in fields if one.init} | {"return": None}
    return made


def _assignment(cls: type, name: str, value: str, names: dict[str, Any]) -> str:
    """How a field gets its value where assignments are refused."""
    slot = getattr(cls, name, None)
    if isinstance(slot, MemberDescriptorType):
        names[f"__set_{name}"] = slot.__set__
        return f"__set_{name}(self, {value})"
    return f"__set(self, {name!r}, {value})"


def _eq(cls: type, frozen: bool) -> Callable[..., Any]:
    compared = [one for one in dataclasses.fields(cls) if one.compare]
    body = [
        "if other.__class__ is self.__class__:",
        f"    return {_values('self', compared)} == {_values('other', compared)}",
        "return NotImplemented",
    ]
    return _compiled(cls, "__eq__", ["self", "other"], body, {})


def _hash(cls: type, frozen: bool) -> Callable[..., Any]:
    fields = dataclasses.fields(cls)
    hashed = [one for one in fields if (one.compare if one.hash is None else one.hash)]
    return _compiled(cls, "__hash__", ["self"], [f"return hash({_values('self', hashed)})"], {})


def _values(of: str, fields: Iterable[Field[Any]]) -> str:
    return "(" + "".join(f"{of}.{one.name}, " for one in fields) + ")"


def _compiled(
    cls: type, name: str, parameters: Iterable[str], body: Iterable[str], names: dict[str, Any]
) -> Callable[..., Any]:
    text = "\n    ".join([f"def {name}({', '.join(parameters)}):", *body])
    exec(compile(text, f"<{name} of the dataclass {cls.__qualname__}>", "exec"), names)
    made: Callable[..., Any] = names.pop(name)
    return made


@recursive_repr()
def _shown(self: Any) -> str:
    shown = (
        f"{one.name}={getattr(self, one.name)!r}" for one in dataclasses.fields(self) if one.repr
    )
    return f"{self.__class__.__qualname__}({', '.join(shown)})"


def _assign(self: Any, name: str, value: object) -> None:
    if _is_frozen(self, name):
        raise FrozenInstanceError(f"cannot assign to field {name!r}")
    object.__setattr__(self, name, value)


def _delete(self: Any, name: str) -> None:
    if _is_frozen(self, name):
        raise FrozenInstanceError(f"cannot delete field {name!r}")
    object.__delattr__(self, name)


def _is_frozen(self: Any, name: str) -> bool:
    """Everything in a dataclass; in a class that inherits from one, only the fields."""
    return "__dataclass_fields__" in type(self).__dict__ or name in self.__dataclass_fields__


def _restore(self: Any, state: Any) -> None:
    """What `object.__getstate__` has given, for copies and other processes."""
    for values in state if isinstance(state, tuple) else (state,):
        for name, value in (values or {}).items():
            object.__setattr__(self, name, value)
