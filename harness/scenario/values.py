"""What a scenario demands of a value, read for the path it belongs to, against what is found."""

from collections.abc import Iterator
from math import isfinite, isnan

from fbgen.catalog import BitField, Catalog, Word
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.scenario.expectations import Expectation, Range
from harness.scenario.kinds import Found, ValueKind, WrongValueError, whole
from harness.scenario.places import at, key_span, value_span
from harness.scenario.scalars import Scalar

_SINGLE_PRECISION = 1e-6
"""A REAL of the PLC has 24 bits, so 43.28 comes back as 43.279998779..."""


@dataclass(frozen=True, slots=True)
class Demand:
    """What a value of one kind must be; None is not demanded. `bits` belong to `word`."""

    kind: ValueKind
    equals: Found | None = None
    tolerance: float = 0.0
    minimum: Found | None = None
    maximum: Found | None = None
    differs_from: Found | None = None
    word: Word | None = None
    bits: tuple[tuple[BitField, int], ...] = ()

    def holds(self, found: Found) -> bool:
        """Whether a found value is what is demanded."""
        equals = self.equals
        if equals is not None and found is not equals and not _equal(equals, found, self.tolerance):
            return False
        if self.differs_from is not None and _equal(self.differs_from, found, 0.0):
            return False
        if self.minimum is not None and not _at_most(self.minimum, found):
            return False
        if self.maximum is not None and not _at_most(found, self.maximum):
            return False
        return not self.bits or (
            isinstance(found, int) and all(bit.extract(found) == value for bit, value in self.bits)
        )

    def describe(self) -> str:
        """What is demanded, for a message."""
        show = self.kind.show
        parts = []
        if self.equals is not None:
            about = f" +- {self.tolerance:g}" if self.tolerance else ""
            parts.append(f"{show(self.equals)}{about}")
        if self.differs_from is not None:
            parts.append(f"other than {show(self.differs_from)}")
        if self.minimum is not None:
            parts.append(f"at least {show(self.minimum)}")
        if self.maximum is not None:
            parts.append(f"at most {show(self.maximum)}")
        if self.bits:
            parts.append(", ".join(f"{bit.name}={value}" for bit, value in self.bits))
        return " and ".join(parts)

    def decoded(self, found: Found) -> str:
        """The fields of a found word by name, where the kind or the demand has names for them.

        Bits that are not set are left out, but for those that are demanded.
        """
        word = self.word or self.kind.word
        if word is None or not isinstance(found, int):
            return ""
        asked = {bit.name for bit, _ in self.bits}
        shown = [
            f"{item.field.name}={item.value}" + (f" ({item.meaning})" if item.meaning else "")
            for item in word.decode(found)
            if item.value or item.field.name in asked
        ]
        return ", ".join(shown) or "no bit is set"


def _equal(expected: Found, found: Found, tolerance: float) -> bool:
    if isinstance(expected, bool) or isinstance(found, bool):
        return expected is found
    if isinstance(expected, int | float) and isinstance(found, int | float):
        if not isfinite(expected):
            return expected == found or (isnan(expected) and isnan(found))
        slack = tolerance or (
            abs(expected) * _SINGLE_PRECISION if isinstance(found, float) else 0.0
        )
        return abs(expected - found) <= slack
    return expected == found


def _at_most(lower: Found, upper: Found) -> bool:
    return isinstance(lower, int | float) and isinstance(upper, int | float) and lower <= upper


def demand(
    path: str, expected: Expectation, kind: ValueKind, place: Span | None, catalog: Catalog
) -> Demand:
    """What a scenario demands of a path.

    Raises DiagnosticError FB8002, FB8009 and FB8010 with everything that is wrong in it. `place`
    is where the expectation stands.
    """
    found: list[Diagnostic] = []
    if not isinstance(expected, Range):
        equals = _read(path, kind, expected, place, found)
        _raise(found)
        return Demand(kind, equals=equals)
    word, bits = _bits(path, expected, kind, catalog, found)
    values: dict[str, Found | None] = {}
    for name in ("equals", "differs_from", "min", "max"):
        value = getattr(expected, name)
        place = expected.span_of(name)
        if value is not None and name in ("min", "max") and not kind.is_number:
            message = f"{path} is {kind.title}, which has no {name}"
            found.append(Diagnostic("FB8009", message, place, "write equals instead"))
        elif value is not None:
            values[name] = _read(path, kind, value, place, found)
            if name in ("min", "max") and values[name] != values[name]:
                message = f"nothing is less or greater than {value}"
                found.append(Diagnostic("FB8009", message, place, "write equals instead"))
    low, high = values.get("min"), values.get("max")
    if low is not None and high is not None and not _at_most(low, high):
        message = f"nothing is at least {kind.show(low)} and at most {kind.show(high)}"
        found.append(Diagnostic("FB8002", message, expected.span_of("min"), "exchange min and max"))
    _raise(found)
    return Demand(
        kind,
        values.get("equals"),
        expected.tolerance,
        low,
        high,
        values.get("differs_from"),
        word,
        bits,
    )


def _raise(found: list[Diagnostic]) -> None:
    if found:
        raise DiagnosticError(found)


def _read(
    path: str, kind: ValueKind, value: Scalar, place: Span | None, found: list[Diagnostic]
) -> Found | None:
    try:
        return kind.read(value)
    except WrongValueError as wrong:
        found.append(wrong_value(path, kind, value, place, wrong))
        return None


def wrong_value(
    path: str, kind: ValueKind, value: Scalar, place: Span | None, wrong: WrongValueError
) -> Diagnostic:
    """FB8009: a value that a path can neither be set to nor ever have."""
    if isinstance(value, bool):
        shown = str(value).lower()
    else:
        shown = f"'{value}'" if isinstance(value, str) else f"{value}"
    return Diagnostic("FB8009", f"{path} is {kind.title} and never {shown}", place, wrong.help)


def _bits(
    path: str, expected: Range, kind: ValueKind, catalog: Catalog, found: list[Diagnostic]
) -> tuple[Word | None, tuple[tuple[BitField, int], ...]]:
    if expected.bits is None:
        return None, ()
    word = kind.word
    if expected.word is not None:
        try:
            word = catalog.word(expected.word)
        except DiagnosticError as unknown:
            for item in at(expected.span_of("word"), unknown.diagnostics):
                found.append(Diagnostic("FB8010", item.message, item.span, item.help))
            return None, ()
    if not kind.is_number:
        message = f"{path} is {kind.title} and has no bits"
        found.append(Diagnostic("FB8010", message, expected.span_of("bits"), "write equals"))
    if word is None:
        message = f"nothing says how the bits of {path} are called"
        advice = "name the word of the catalogue as well: word: tospbdp001.status"
        found.append(Diagnostic("FB8010", message, expected.span_of("bits"), advice))
        return None, ()
    return word, tuple(_fields(expected, expected.bits, word, found))


def _fields(
    expected: Range, wanted: dict[str, Scalar], word: Word, found: list[Diagnostic]
) -> Iterator[tuple[BitField, int]]:
    by_name = {field.name: field for field in word.bits}
    for name, value in wanted.items():
        if name not in by_name:
            message = f"the word '{word.name}' has no '{name}'"
            place = key_span(expected, "bits", name)
            found.append(Diagnostic("FB8010", message, place, nearest(name, by_name)))
            continue
        field = by_name[name]
        try:
            number = int(value) if isinstance(value, bool) else whole(value)
        except WrongValueError:
            number = -1
        if not 0 <= number <= field.maximum:
            place = value_span(expected, "bits", name)
            message = f"'{name}' (bit {field.bit}) is never {value}"
            found.append(Diagnostic("FB8010", message, place, f"write 0 to {field.maximum}"))
        else:
            yield field, number
