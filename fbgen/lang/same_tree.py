"""Whether two syntax trees say the same: without places, comments and blank lines."""

from fbgen.lang.ast import HeaderItem, Trivia
from fbgen.source import Source, Span

_UNSEEN = frozenset({"leading", "trailing", "closing", "opening"})


def same_tree(left: object, right: object) -> bool:
    """True if both trees have the same nodes with the same texts and values.

    Header lines may stand in another order. Deep trees are no problem.
    """
    waiting = [(left, right)]
    while waiting:
        one, other = waiting.pop()
        kind = type(one)
        if kind is not type(other):
            return False
        if kind is Span or kind is Trivia or isinstance(one, Source):
            continue
        if isinstance(one, tuple) and isinstance(other, tuple):
            firsts, seconds = _seen(one), _seen(other)
            if len(firsts) != len(seconds):
                return False
            waiting += zip(firsts, seconds, strict=True)
        elif names := getattr(kind, "__slots__", ()):
            waiting += [
                (getattr(one, name), getattr(other, name)) for name in names if name not in _UNSEEN
            ]
        elif one != other:
            return False
    return True


def _seen(items: tuple[object, ...]) -> list[object]:
    """The items that count, header lines in one order."""
    seen = [item for item in items if type(item) is not Trivia]
    if seen and type(seen[0]) is HeaderItem:
        return sorted(seen, key=_header_text)
    return seen


def _header_text(item: object) -> str:
    return f"{item.keyword} {item.text}" if isinstance(item, HeaderItem) else ""
