"""Lists of things that have a name: nothing twice, and one picked by its name."""

from collections.abc import Callable, Collection, Iterable, Iterator
from typing import Protocol, TypeVar

from fbgen.catalog.located import Located
from fbgen.diagnostics import Diagnostic, Note, error
from fbgen.nearest import nearest


class Named(Protocol):
    """Anything with a name."""

    @property
    def name(self) -> str:
        """The name."""
        ...


Item = TypeVar("Item", bound=Located)
NamedItem = TypeVar("NamedItem", bound=Named)


def no_duplicates(
    items: Iterable[Item], field: str, key: Callable[[Item], str], kind: str
) -> Iterator[Diagnostic]:
    """FB1102 for every item whose key an earlier one has; both places are shown."""
    first: dict[str, Item] = {}
    for item in items:
        name = key(item)
        earlier = first.setdefault(name, item)
        if earlier is not item:
            yield Diagnostic(
                "FB1102",
                f"the {kind} '{name}' stands twice",
                item.span_of(field),
                "keep one of the two",
                (Note("first here", earlier.span_of(field)),),
            )


def pick(items: Iterable[NamedItem], name: str, code: str, message: str) -> NamedItem:
    """The item of this name. Raises DiagnosticError with `code` and the nearest names."""
    known = []
    for item in items:
        if item.name == name:
            return item
        known.append(item.name)
    raise error(code, message, help=nearest(name, known))


def named_in(
    owner: Located, field: str, name: str, known: Collection[str], kind: str
) -> Iterator[Diagnostic]:
    """FB1105 for a name in a field of `owner` that nothing has."""
    if name not in known:
        yield Diagnostic(
            "FB1105", f"there is no {kind} '{name}'", owner.span_of(field), nearest(name, known)
        )


def unknown_name(
    owner: Located, field: str, name: str | None, known: Collection[str], kind: str
) -> Iterator[Diagnostic]:
    """FB1105 for a name in a field of a part of a drive that nothing in that drive has."""
    if name is not None and name not in known:
        yield Diagnostic(
            "FB1105",
            f"there is no {kind} '{name}' in this drive",
            owner.span_of(field),
            nearest(name, known),
        )
