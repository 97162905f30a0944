"""Gateways whose blocks differ in the digits of names only: worked on once for all of them.

In a large plant most gateways are alike: the text of `TOS_Gateway_gw12` is that of
`TOS_Gateway_gw11` with other digits in the names of the gateway and its drives. Each text is filled
in from its template. Where it is then that of an earlier gateway, its model, with words exchanged
as `fbgen.emit.exchanged_words` has it, and `fbgen.emit.twin_names` says that the names mean the
same, its code is not read, checked, printed and read back once more: the text of the model, with
which all that was done, gives its own by the same exchange. Declarations are read and checked of
every gateway, because TOS_Plant, TOS_Main and the data blocks use them.

Origins of lines are worked out from the text's own. Where anything does not fit a text is worked on
for itself; and if anything is found in a plant with twins, all is done once more without them, so
that everything is reported at its own place.
"""

import re
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from fbgen.blocks.gateways import GatewayView
from fbgen.dataclass import dataclass
from fbgen.emit.exchanged_words import (
    Pairs,
    exchange,
    exchanged,
    is_address,
    is_one_to_one,
    pieces_of,
    words_of,
)
from fbgen.emit.heading import facts_in
from fbgen.emit.rendering import CANONICAL_DIALECT, FilledUnit, RenderedUnit
from fbgen.lang.parser import parse
from fbgen.source import Origin, Source

_MOST_MODELS = 4
"""With so many gateways of its shape a gateway is compared at most."""

_BEGIN = "\nBEGIN\n"
_END = re.compile(r"\nEND_(?:FUNCTION|FUNCTION_BLOCK)\s*\Z")


@dataclass(frozen=True, slots=True)
class Twin:
    """A unit that is `model` with `words` exchanged; `origins` are its own for those of that."""

    unit: FilledUnit
    model: FilledUnit
    words: Mapping[str, str]
    origins: Mapping[Origin, Origin]

    def without_code(self) -> RenderedUnit:
        """The unit with its declarations. Raises DiagnosticError where these are no SCL."""
        source = self.unit.source
        declarations, code, end = parts_of(source.text)
        if code:
            source = Source(source.name, declarations + end, source.origins)
        return RenderedUnit(self.unit.spec, self.unit.marked, parse(source, CANONICAL_DIALECT))


@dataclass(frozen=True, slots=True)
class GatewayTwins:
    """All units of a gateway, those that are twins, and the gateway that they are like."""

    gateway: str
    units: tuple[FilledUnit, ...]
    model: "GatewayModel"
    twins: tuple[Twin, ...]

    @property
    def words(self) -> Mapping[str, str]:
        """What is exchanged, in all of them."""
        return self.twins[0].words


class Parts(NamedTuple):
    """A text up to its code, the code, and the line behind it; without code all is in front."""

    declarations: str
    code: str
    end: str


def parts_of(text: str) -> Parts:
    """The parts of the text of a unit."""
    begin, last = text.find(_BEGIN), text.rfind("\nEND_")
    if not 0 <= begin < last or not _END.match(text, last):
        return Parts(text, "", "")
    begin += len(_BEGIN)
    return Parts(text[:begin], text[begin : last + 1], text[last + 1 :])


class GatewayModel:
    """The units of a gateway that others may be like."""

    def __init__(self, gateway: str, units: Sequence[FilledUnit]) -> None:
        self.gateway = gateway
        self.units = tuple(units)
        self.parts = [parts_of(unit.source.text) for unit in units]
        self._declarations = [pieces_of(part.declarations + part.end) for part in self.parts]
        self._code = [pieces_of(part.code) for part in self.parts]
        self._facts = [facts_in(unit.source) for unit in units]
        self._words = {word for unit in units for word in words_of(unit.source.text)}
        self._of_facts = words_of(" ".join(fact for facts in self._facts for fact in facts))

    def twins(self, units: Sequence[FilledUnit]) -> tuple[Twin, ...]:
        """The units that are like those of this gateway; none unless all declarations are."""
        parts = [parts_of(unit.source.text) for unit in units]
        pairs: Pairs = set()
        for own, other in zip(self._declarations, parts, strict=True):
            pieces = pieces_of(other.declarations + other.end)
            if len(pieces) != len(own):
                return ()
            pairs.update(zip(own, pieces, strict=True))
        words = exchange(pairs)
        if not words:
            return ()
        alike: list[bool] = []
        for own, other in zip(self._code, parts, strict=True):
            further = _with_addresses(own, other.code, pairs, words)
            alike.append(further is not None)
            words = further or words
        if not is_one_to_one(words, self._words) or not self._of_facts.isdisjoint(
            word.casefold() for pair in words.items() for word in pair
        ):
            return ()
        return tuple(
            Twin(unit, model, words, origins)
            for unit, model, is_alike, facts in zip(
                units, self.units, alike, self._facts, strict=True
            )
            if is_alike
            and (origins := _other_origins(model.source, unit.source)) is not None
            and facts == facts_in(unit.source)
        )


def _with_addresses(
    own: Sequence[str], code: str, pairs: Pairs, words: dict[str, str]
) -> dict[str, str] | None:
    """The words that make this code of that in pieces, further addresses among them."""
    if exchanged(own, words) == code:
        return words
    pieces = pieces_of(code)
    if len(pieces) != len(own):
        return None
    more = exchange({*pairs, *words.items(), *zip(own, pieces, strict=True)})
    if more is None or not all(map(is_address, more.keys() - words.keys())):
        return None
    return more


def _other_origins(model: Source, source: Source) -> dict[Origin, Origin] | None:
    """What a source has for each origin of its model; None unless each has one of its own, at the
    same places, and lines of templates are the same."""
    if model.origin_offsets != source.origin_offsets:
        return None
    own = [origin for _, origin in model.origins]
    others = [origin for _, origin in source.origins]
    same = zip(map(id, own), map(id, others), strict=True)
    pairs = list(dict(zip(same, zip(own, others, strict=True), strict=True)).values())
    known = {one: other for one, other in pairs if one is not None and other is not None}
    if len(known) != len(pairs) or len(set(known.values())) != len(known):
        return None
    if not all(one.is_template == other.is_template for one, other in known.items()):
        return None
    lines = ((one, other) for one, other in known.items() if one.is_template)
    return known if all(one == other for one, other in lines) else None


def twins_among(units: Sequence[FilledUnit]) -> list[GatewayTwins]:
    """The gateways that look like an earlier one."""
    by_gateway: dict[str, list[FilledUnit]] = {}
    for unit in units:
        if isinstance(gateway := unit.spec.context.get("gateway"), GatewayView):
            by_gateway.setdefault(gateway.name, []).append(unit)
    known: dict[object, list[GatewayModel]] = {}
    found: list[GatewayTwins] = []
    for name, group in by_gateway.items():
        shape = tuple((unit.spec.template, len(unit.source.text)) for unit in group)
        models = known.setdefault(shape, [])
        alike = next(((model, twins) for model in models if (twins := model.twins(group))), None)
        if alike is not None:
            found.append(GatewayTwins(name, tuple(group), *alike))
        elif len(models) < _MOST_MODELS:
            models.append(GatewayModel(name, group))
    return found
