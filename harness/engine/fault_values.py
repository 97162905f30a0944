"""What the variables of a failed expression held: notes on the diagnostic that stopped a program.

Both engines say which places stand in the expression and what they hold; calls and absolute
addresses are left out, because reading them again could do something.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace

from fbgen.diagnostics import DiagnosticError, Note
from fbgen.lang.checked import (
    AddressRef,
    FieldRef,
    FunctionCall,
    IndexRef,
    Place,
    RoutineCall,
    SliceRef,
    Statement,
    SystemCall,
    VariableRef,
)
from fbgen.lang.types import Elementary, StringType
from fbgen.source import Span
from harness.engine.interface import Value
from harness.engine.spelling import spell

_MOST_VALUES = 8
_PLACES = (VariableRef, FieldRef, IndexRef, SliceRef)
_CALLS = (FunctionCall, SystemCall, RoutineCall)


def can_be_shown(place: object) -> bool:
    """Whether a node is a place with a single value that reading does not change."""
    if not isinstance(place, _PLACES) or not isinstance(place.type, Elementary | StringType):
        return False
    waiting: list[object] = [place]
    while waiting:
        node = waiting.pop()
        if isinstance(node, (AddressRef, *_CALLS)):
            return False
        if isinstance(node, VariableRef):
            if node.variable.address is not None:
                return False
        else:
            waiting += _inner(node)
    return True


def places_of(statement: Statement, failed: Span) -> Iterator[Place]:
    """The places in that part of a statement that failed."""
    waiting: list[object] = [statement]
    while waiting:
        node = waiting.pop()
        if can_be_shown(node) and is_inside(node.span, failed):  # type: ignore[attr-defined]
            yield node  # type: ignore[misc]  # `can_be_shown` says that it is a place
        waiting += _inner(node)


def is_inside(place: Span, failed: Span) -> bool:
    """Whether a place stands in what failed."""
    return place.source is failed.source and failed.start <= place.start and place.end <= failed.end


def with_values(
    failure: DiagnosticError, found: Iterable[tuple[Place, Callable[[], Value]]]
) -> DiagnosticError:
    """The failure with one note for each place that can still be read, in the order of the text."""
    diagnostic = failure.diagnostics[0]
    if diagnostic.code == "FB6004":
        # Which pass was stopped is up to the engine: it may count them before the loop begins.
        return failure
    notes: dict[str, Note] = {}
    for place, read in sorted(found, key=lambda item: item[0].span[1:]):
        name = place.span.text
        if name.casefold() in notes:
            continue
        try:
            text = spell(place.type, read())
        except Exception:
            # Whatever stops reading it is most likely what has stopped the program already.
            continue
        notes[name.casefold()] = Note(f"{name} = {text}")
    if not notes:
        return failure
    more = replace(diagnostic, notes=(*diagnostic.notes, *list(notes.values())[:_MOST_VALUES]))
    return DiagnosticError([more, *failure.diagnostics[1:]])


def _inner(node: object) -> list[object]:
    """The nodes directly inside a node of the checked program."""
    found: list[object] = []
    for name in getattr(type(node), "__slots__", ()):
        part = getattr(node, name)
        if isinstance(part, tuple) and not isinstance(part, Span):
            for item in part:
                found += item if isinstance(item, tuple) else (item,)
        elif hasattr(part, "span"):
            found.append(part)
    return [item for item in found if hasattr(item, "span")]
