"""What differs between two readings of the same kind of file: catalogues or plant files.

Entries of a list are told by what names them (`id`, `name`, what a panel displays), so a list in
another order is no change. Lists whose entries have no names, as the steps of a sequence, are laid
beside each other.
"""

from collections.abc import Iterator, Mapping, Sequence
from difflib import SequenceMatcher
from itertools import zip_longest
from typing import Literal

from fbgen.catalog.catalog import Catalog
from fbgen.catalog.located import Located
from fbgen.dataclass import dataclass
from fbgen.source import Span

_NAMES = ("id", "name", "display", "code")
_LONGEST = 100

Kind = Literal["changed", "added", "removed"]


@dataclass(frozen=True, slots=True)
class Difference:
    """A field with another value, or an entry that is new or gone.

    `path` leads to it, `before` and `after` are its texts in the files. `old` and `new` are the
    entries around it, the innermost first: origins name the lines at which these begin.
    """

    kind: Kind
    path: str
    before: str
    after: str
    old: tuple[Span, ...]
    new: tuple[Span, ...]
    place: Span | None

    def as_json(self) -> dict[str, object]:
        """As plain data."""
        data: dict[str, object] = {"kind": self.kind, "entry": self.path}
        if self.place is not None:
            data |= {"file": self.place.source.name, "line": self.place.line}
        return data | {"before": self.before, "after": self.after}


@dataclass(frozen=True, slots=True)
class _Place:
    """Where the comparison is: the path, and the entries around it on both sides."""

    path: str
    old: tuple[Located, ...] = ()
    new: tuple[Located, ...] = ()

    def inside(self, name: str, old: Located | None = None, new: Located | None = None) -> "_Place":
        path = f"{self.path}.{name}" if self.path else name
        return _Place(
            path,
            (old, *self.old) if old is not None else self.old,
            (new, *self.new) if new is not None else self.new,
        )


def catalogue_differences(old: Catalog, new: Catalog) -> Iterator[Difference]:
    """What differs between two catalogues, file by file."""
    for kind in ("gateways", "drives", "protocols", "sequences"):
        before: Mapping[str, Located] = getattr(old, kind)
        after: Mapping[str, Located] = getattr(new, kind)
        for name in sorted({*before, *after}):
            yield from _values(before.get(name), after.get(name), _Place("").inside(name))


def differences(old: Located, new: Located) -> Iterator[Difference]:
    """What differs between two models of one kind."""
    yield from _models(old, new, _Place("", (old,), (new,)))


def _models(old: Located, new: Located, place: _Place) -> Iterator[Difference]:
    for name in type(old).model_fields:
        before, after = getattr(old, name), getattr(new, name)
        if before != after:
            yield from _field(name, before, after, place)


def _field(name: str, before: object, after: object, place: _Place) -> Iterator[Difference]:
    inner = place.inside(name)
    if _is_entries(before) or _is_entries(after):
        assert isinstance(before, tuple)
        assert isinstance(after, tuple)
        yield from _entries(before, after, inner)
    elif isinstance(before, Located) or isinstance(after, Located):
        both = type(before) is type(after)
        yield from (
            _values(
                before if isinstance(before, Located) else None,
                after if isinstance(after, Located) else None,
                inner,
            )
            if both or before is None or after is None
            else _replaced(before, after, inner)
        )
    else:
        texts = _text(place.old[0], name, before), _text(place.new[0], name, after)
        if texts[0] == texts[1]:
            texts = str(before), str(after)
        where = place.new[0].span_of(name) or place.old[0].span_of(name)
        yield Difference("changed", inner.path, *texts, _spans(place.old), _spans(place.new), where)


def _values(old: Located | None, new: Located | None, place: _Place) -> Iterator[Difference]:
    """An entry on both sides, or on one."""
    if old is not None and new is not None and type(old) is type(new):
        if old != new:
            yield from _models(old, new, _Place(place.path, (old, *place.old), (new, *place.new)))
        return
    if old is not None:
        yield Difference(
            "removed", place.path, _shown(old), "",
            _spans((old, *place.old)), _spans(place.new), old.span,
        )  # fmt: skip
    if new is not None:
        yield Difference(
            "added", place.path, "", _shown(new),
            _spans(place.old), _spans((new, *place.new)), new.span,
        )  # fmt: skip


def _replaced(before: object, after: object, place: _Place) -> Iterator[Difference]:
    yield from _values(before if isinstance(before, Located) else None, None, place)
    yield from _values(None, after if isinstance(after, Located) else None, place)


def _entries(old: Sequence[Located], new: Sequence[Located], place: _Place) -> Iterator[Difference]:
    before, after = _by_name(old), _by_name(new)
    if before is not None and after is not None:
        for name in dict.fromkeys((*before, *after)):
            yield from _values(before.get(name), after.get(name), place.inside(name))
        return
    texts = [item.model_dump_json() for item in old], [item.model_dump_json() for item in new]
    for tag, a, b, c, d in SequenceMatcher(None, *texts, autojunk=False).get_opcodes():
        if tag != "equal":
            for number, (one, other) in enumerate(zip_longest(old[a:b], new[c:d])):
                at = c + number if other is not None else a + number
                yield from _values(one, other, place.inside(str(at + 1)))


def _by_name(items: Sequence[Located]) -> dict[str, Located] | None:
    """The entries by their names; None where they have none, or one stands twice."""
    for field in _NAMES:
        names = [getattr(item, field, None) for item in items]
        known = {str(name): item for name, item in zip(names, items, strict=True)}
        if None not in names and len(known) == len(items):
            return known
    return None


def _is_entries(value: object) -> bool:
    return isinstance(value, tuple) and any(isinstance(item, Located) for item in value)


def _text(owner: Located, name: str, value: object) -> str:
    """How a field is written in its file; its value where it is not written."""
    written = name in owner.model_fields_set
    span = owner.span_of(name) if written else None
    return _one_line(span.text) if span is not None else str(value)


def _shown(entry: Located) -> str:
    return _one_line(entry.span.text) if entry.span is not None else type(entry).__name__


def _one_line(text: str) -> str:
    flat = " ".join(text.split())
    return flat if len(flat) <= _LONGEST else f"{flat[: _LONGEST - 3]}..."


def _spans(entries: Sequence[Located]) -> tuple[Span, ...]:
    return tuple(entry.span for entry in entries if entry.span is not None)
