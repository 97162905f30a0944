"""A table whose entries stand in one module each, imported when the entry is asked for."""

from collections.abc import Iterable, Iterator, Mapping
from importlib import import_module
from typing import TypeVar

T = TypeVar("T")


class NamedModules(Mapping[str, T]):
    """What the modules of a package have under one name, by the names of the modules."""

    __slots__ = ("_attribute", "_known", "_names", "_package")

    def __init__(self, package: str, attribute: str, names: Iterable[str]) -> None:
        self._package, self._attribute = package, attribute
        self._names = dict.fromkeys(names)
        self._known: dict[str, T] = {}

    def __getitem__(self, name: str) -> T:
        if name not in self._names:
            raise KeyError(name)
        if name not in self._known:
            module = import_module(f"{self._package}.{name}")
            self._known[name] = getattr(module, self._attribute)
        return self._known[name]

    def __contains__(self, name: object) -> bool:
        return name in self._names

    def __iter__(self) -> Iterator[str]:
        return iter(self._names)

    def __len__(self) -> int:
        return len(self._names)
