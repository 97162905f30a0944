"""Kinds of values: what a path can be compared with or set to, and how its values are shown.

A value of the file means something only together with the path that it stands beside: `16#8401` is
a number for a WORD and a text for a STRING, `T#2s` counts milliseconds for a TIME and nanoseconds
for an LTIME. So each path has a kind, and a value that the kind cannot have is found before the
scenario runs.
"""

from collections.abc import Callable, Mapping
from typing import TypeAlias

from fbgen.catalog import Word
from fbgen.dataclass import dataclass
from fbgen.nearest import nearest
from harness.engine.interface import Value
from harness.scenario.scalars import Scalar

_GREATEST = 1e9

Found: TypeAlias = Value | bytes
"""What a path gives."""


class WrongValueError(ValueError):
    """A value that a kind cannot have; `help` says what it can have."""

    def __init__(self, help: str) -> None:  # noqa: A002 - the word of the diagnostics
        super().__init__(help)
        self.help = help


@dataclass(frozen=True, slots=True)
class ValueKind:
    """What sort of value a path has.

    `title` is for messages. `read` turns a value of the file into one as the path gives it, and
    raises WrongValueError. `show` is a found value for a person. `word` names the bits of a value,
    where the catalogue does. `is_number` tells whether a value can be compared by size.
    """

    title: str
    read: Callable[[Scalar], Found]
    show: Callable[[Found], str]
    is_number: bool = False
    word: Word | None = None


def _flag(value: Scalar) -> bool:
    if not isinstance(value, bool):
        raise WrongValueError("write true or false")
    return value


def _number(value: Scalar) -> int | float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise WrongValueError("write a number without quotes and without unit")
    if abs(value) > _GREATEST:
        raise WrongValueError("nothing in a plant is that great")
    return value


def whole(value: Scalar) -> int:
    """A whole number, also as 16#8401 or 2#1010."""
    if isinstance(value, str):
        base, sharp, digits = value.partition("#")
        if sharp and base in ("2", "8", "16"):
            try:
                return int(digits, int(base))
            except ValueError:
                pass
    elif isinstance(value, int) and not isinstance(value, bool):
        return value
    raise WrongValueError("write a whole number, such as 33793 or 16#8401")


def octets(value: Scalar, length: int) -> bytes:
    """Bytes in hexadecimal, just as many."""
    try:
        data = bytes.fromhex(value) if isinstance(value, str) else b""
    except ValueError:
        data = b""
    if len(data) != length:
        row = " ".join(f"{byte:02X}" for byte in range(min(length, 3)))
        raise WrongValueError(f'write {length} bytes in hexadecimal and in quotes, as "{row} ..."')
    return data


def show(value: Found) -> str:
    """A value for a message, whatever it is."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, bytes):
        return value.hex(" ").upper()
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{name}: {show(part)}" for name, part in value.items()) + "}"
    if isinstance(value, str):
        return f"'{value}'"
    if isinstance(value, int):
        return str(value)
    return "[" + ", ".join(show(item) for item in value) + "]"


def _hexadecimal(value: Found) -> str:
    return f"16#{value:04X} ({value})" if isinstance(value, int) else show(value)


FLAG = ValueKind("true or false", _flag, show)
NUMBER = ValueKind("a number", _number, show, is_number=True)
COUNT = ValueKind("a whole number", whole, show, is_number=True)


def word_kind(word: Word | None) -> ValueKind:
    """A 16-bit word, with the names of its bits where there are any."""
    return ValueKind("a word", whole, _hexadecimal, is_number=True, word=word)


def octets_kind(length: int) -> ValueKind:
    """A row of bytes."""
    return ValueKind(f"{length} bytes", lambda value: octets(value, length), show)


def choice_kind(known: tuple[str, ...]) -> ValueKind:
    """One of some texts; "" is written as two quotes."""

    def read(value: Scalar) -> str:
        if value not in known:
            raise WrongValueError(nearest(str(value), filter(None, known)))
        return str(value)

    return ValueKind("one of a few texts", read, show)


def coded_kind(meanings: Mapping[int, str]) -> ValueKind:
    """A code with its meaning, such as that of a trip."""

    def shown(value: Found) -> str:
        meaning = meanings.get(value) if isinstance(value, int) else None
        return f"{show(value)} ({meaning})" if meaning else show(value)

    return ValueKind("a code", whole, shown, is_number=True)


def no_bytes(value: Found) -> Value:
    """A value that a variable of the PLC can have."""
    assert not isinstance(value, bytes), "the kinds of PLC variables give none"
    return value
