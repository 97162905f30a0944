"""What is held away from its healthy value, so that several faults can hold one thing.

Each holder says at which value it holds the thing; the worst of these counts. When one lets go, the
thing is as the others hold it; when the last one does, it is as it was before the first.
"""

from collections.abc import Callable, Hashable, Iterable
from dataclasses import replace
from typing import Any, Generic, TypeVar

from fbgen.dataclass import dataclass

Value = TypeVar("Value")


@dataclass(frozen=True, slots=True)
class Hold(Generic[Value]):
    """One thing that is to be held at `value`.

    `key` says which thing. `healthy` gives its present value, `put` sets it. `worst` chooses among
    the values at which several hold it: the greatest, so True before False, if nothing is said.
    """

    key: Hashable
    value: Value
    healthy: Callable[[], Value]
    put: Callable[[Value], None]
    worst: Callable[[Iterable[Any]], Any] = max


def attribute(
    place: object, name: str, value: Value, worst: Callable[[Iterable[Any]], Any] = max
) -> Hold[Value]:
    """Hold an attribute of a part of the plant."""

    def healthy() -> Value:
        present: Value = getattr(place, name)
        return present

    def put(new: Value) -> None:
        setattr(place, name, new)

    return Hold((place, name), value, healthy, put, worst)


def setting(place: Any, name: str, value: Value) -> Hold[Value]:
    """Hold a field of the frozen `settings` of a part of the plant."""

    def healthy() -> Value:
        present: Value = getattr(place.settings, name)
        return present

    def put(new: Value) -> None:
        place.settings = replace(place.settings, **{name: new})

    return Hold((place, "settings", name), value, healthy, put)


def switched(
    place: object, name: str, begin: Callable[[], None], end: Callable[[], None]
) -> Hold[bool]:
    """Hold what is no attribute: `begin` is called for the first holder, `end` after the last."""

    def put(held: bool) -> None:
        if held:
            begin()
        else:
            end()

    return Hold((place, name), True, lambda: False, put)


class Holds:
    """Who holds what in one plant."""

    __slots__ = ("_held",)

    def __init__(self) -> None:
        self._held: dict[Hashable, _Held] = {}

    def take(self, owner: object, hold: Hold[Any]) -> None:
        """`owner` holds the thing from now on."""
        held = self._held.get(hold.key)
        if held is None:
            healthy = hold.healthy()
            held = self._held[hold.key] = _Held(healthy, healthy, {})
        held.values[id(owner)] = hold.value
        held.change(hold, hold.worst(held.values.values()))

    def release(self, owner: object, hold: Hold[Any]) -> None:
        """`owner` lets go; nothing happens if it holds nothing there."""
        held = self._held.get(hold.key)
        if held is None or held.values.pop(id(owner), None) is None:
            return
        if held.values:
            held.change(hold, hold.worst(held.values.values()))
        else:
            del self._held[hold.key]
            held.change(hold, held.healthy)


@dataclass(slots=True)
class _Held:
    """A thing that is held: its healthy value, the present one, and those of the holders."""

    healthy: Any
    present: Any
    values: dict[int, Any]

    def change(self, hold: Hold[Any], new: Any) -> None:
        """To another value, if it is another one."""
        if new != self.present:
            self.present = new
            hold.put(new)
