"""Lists of things that have a name: nothing twice, and one picked by its name."""

from collections.abc import Callable, Iterable, Iterator
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
