"""Values of scenario files against values of the running plant."""

from collections.abc import Mapping
from typing import TypeAlias

from fbgen.catalog import Catalog
from fbgen.lang.ast import LiteralKind
from fbgen.lang.literals import BadLiteralError, read_literal
from harness.engine.interface import Value
from harness.kernel import NS_PER_MS
from harness.scenario.model import Expectation, Range, ScalarValue

Found: TypeAlias = Value | bytes
"""What a path gives."""

_SINGLE_PRECISION = 1e-6
"""A REAL of the PLC has 24 bits, so 43.28 comes back as 43.279998779..."""


def plain(value: ScalarValue) -> ScalarValue:
    """A value of the file as the engines count: `16#FF` as a number, `T#2s` in milliseconds."""
    if not isinstance(value, str) or "#" not in value:
        return value
    try:
        literal = read_literal(value)
    except BadLiteralError:
        return value
    if literal.kind is LiteralKind.DURATION and isinstance(literal.value, int):
        return literal.value // NS_PER_MS
    return literal.value


def holds(expected: Expectation, found: Found, catalog: Catalog) -> bool:
    """Whether a found value is what was demanded. Raises DiagnosticError for an unknown bit."""
    if not isinstance(expected, Range):
        return _equal(plain(expected), found, 0.0)
    if expected.equals is not None and not _equal(
        plain(expected.equals), found, expected.tolerance
    ):
        return False
    if expected.differs_from is not None and _equal(plain(expected.differs_from), found, 0.0):
        return False
    number = float(found) if isinstance(found, int | float) else None
    if expected.min is not None and (number is None or number < expected.min):
        return False
    if expected.max is not None and (number is None or number > expected.max):
        return False
    if expected.bits is not None and expected.word is not None:
        word = catalog.word(expected.word)
        return isinstance(found, int) and all(
            word.field(name).extract(found) == value for name, value in expected.bits.items()
        )
    return True


def _equal(expected: ScalarValue, found: Found, tolerance: float) -> bool:
    if isinstance(expected, bool) or isinstance(found, bool):
        return expected is found
    if isinstance(expected, int | float) and isinstance(found, int | float):
        slack = tolerance or (
            abs(expected) * _SINGLE_PRECISION if isinstance(found, float) else 0.0
        )
        return abs(expected - found) <= slack
    if isinstance(found, bytes):
        return isinstance(expected, str) and bytes_match(expected, found)
    return expected == found


def bytes_match(pattern: str, data: bytes | None) -> bool:
    """Whether bytes are as written in hexadecimal, `xx` standing for any byte."""
    parts = pattern.split()
    return (
        data is not None
        and len(parts) == len(data)
        and all(
            part == "xx" or part.upper() == f"{byte:02X}"
            for part, byte in zip(parts, data, strict=True)
        )
    )


def demanded(expected: Expectation) -> str:
    """What was demanded, for a message."""
    if not isinstance(expected, Range):
        return describe(expected)
    parts = []
    if expected.equals is not None:
        about = f" +- {expected.tolerance:g}" if expected.tolerance else ""
        parts.append(f"{describe(expected.equals)}{about}")
    if expected.differs_from is not None:
        parts.append(f"other than {describe(expected.differs_from)}")
    if expected.min is not None:
        parts.append(f"at least {expected.min:g}")
    if expected.max is not None:
        parts.append(f"at most {expected.max:g}")
    if expected.bits is not None:
        bits = ", ".join(f"{name}={value}" for name, value in expected.bits.items())
        parts.append(f"{expected.word} with {bits}")
    return " and ".join(parts)


def describe(value: Found) -> str:
    """A value for a message."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, bytes):
        return value.hex(" ").upper()
    if isinstance(value, int):
        return f"{value} (16#{value:04X})" if value > 9 else str(value)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name}: {describe(part)}" for name, part in value.items()) + "}"
    return str(value)


def decoded(expected: Expectation, found: Found, catalog: Catalog) -> str:
    """The found word bit by bit, where the expectation names a word; else empty."""
    if not (isinstance(expected, Range) and expected.word and isinstance(found, int)):
        return ""
    fields = catalog.word(expected.word).decode(found)
    return ", ".join(f"{item.field.name}={item.value}" for item in fields)
