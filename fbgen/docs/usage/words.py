"""Which places of a program hold which word of the catalogue, told by the bits they are used with.

A place holds a word if it is combined with a mask of that word's bits, or if everything that flows
into it holds it. So a user's own block that reads `drive.polled.statusWord.%X10` reads a bit of the
inverter's status word, though nothing there names it.
"""

from collections.abc import Callable, Mapping

from fbgen.docs.usage.catalogue_items import BitItem, Item
from fbgen.docs.usage.places import PlaceKey, Places, inside, nodes, operands
from fbgen.lang.checked import Assignment, Binary, Constant, Expression, Program

WordName = tuple[str, str]
"""Device and word."""

Named = Callable[[Constant], tuple[Item, ...]]
_NUMBER = ("", "ComNo")
_NOTHING, _MIXED = ("", ""), ("", "?")


class WordPlaces:
    """What places hold: a word of a device, a communication number, or nothing that is known."""

    def __init__(self, program: Program, places: Places, named: Named) -> None:
        self._places, self._named = places, named
        self._held: dict[PlaceKey, WordName] = {}
        for body in program.bodies.values():
            for node in nodes(body):
                self._look(node)
        seeds = dict(self._held)
        self._spread(places.flows(program), seeds)

    def word(self, place: object) -> WordName | None:
        """The word that a place holds."""
        held = self._held.get(key) if (key := self._places.key(place)) is not None else None
        return held if held is not None and held[0] else None

    def is_number(self, place: object) -> bool:
        """Whether a place holds a communication number."""
        return (key := self._places.key(place)) is not None and self._held.get(key) == _NUMBER

    def _look(self, node: object) -> None:
        """A place beside a value of the catalogue."""
        if isinstance(node, Binary):
            for one, other in ((node.left, node.right), (node.right, node.left)):
                self._seed(inside(one), inside(other))
        elif isinstance(node, Assignment):
            for part in self._parts(node.value):
                self._seed(node.target, part)

    def _parts(self, value: Expression) -> list[Expression]:
        """The constants that a bitwise value is made of, as far as its whole is not masked out."""
        value = inside(value)
        if isinstance(value, Binary) and value.operator == "AND":
            return []
        found = operands(value)
        return [part for one in found for part in self._parts(one)] if found else [value]

    def _seed(self, place: object, value: Expression) -> None:
        key = self._places.key(place)
        if key is None or not isinstance(value, Constant):
            return
        words = {
            (item.device, item.word) if isinstance(item, BitItem) else _NUMBER
            for item in self._named(value)
        }
        if words:
            self._held.setdefault(key, min(words))

    def _spread(
        self, flows: Mapping[PlaceKey, list[Expression]], seeds: Mapping[PlaceKey, WordName]
    ) -> None:
        """Until nothing changes: a place holds what all that flows into it holds."""
        changed = True
        while changed:
            changed = False
            for key, values in flows.items():
                if key in seeds:
                    continue
                kinds = {self._kind(value) for value in values} - {_NOTHING}
                kind = _NOTHING if not kinds else kinds.pop() if len(kinds) == 1 else _MIXED
                before = self._held.get(key, _NOTHING)
                if kind not in (before, _NOTHING) and before != _MIXED:
                    self._held[key] = kind if before == _NOTHING else _MIXED
                    changed = True

    def _kind(self, value: Expression) -> WordName:
        value = inside(value)
        if isinstance(value, Constant):
            return _NOTHING
        parts = operands(value)
        if parts:
            kinds = {self._kind(part) for part in parts} - {_NOTHING}
            return kinds.pop() if len(kinds) == 1 else _MIXED if kinds else _NOTHING
        key = self._places.key(value)
        return _MIXED if key is None else self._held.get(key, _NOTHING)
