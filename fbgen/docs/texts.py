"""How numbers, names and times are written on pages, in phrases."""

from collections.abc import Iterable

from fbgen.docs.document import Code, Phrase


def number(value: float) -> str:
    """A physical value without needless digits: 50, 0.01, 4.5."""
    return f"{value:.6f}".rstrip("0").rstrip(".") if value % 1 else str(int(value))


def with_unit(value: float, unit: str) -> str:
    """A value with its unit, if it has one."""
    return f"{number(value)} {unit}" if unit else number(value)


def word(value: int) -> str:
    """Four hexadecimal digits."""
    return f"{value:04X}"


def octets(data: bytes) -> str:
    """Bytes as telegrams are printed: `2F 0B 50`."""
    return data.hex(" ").upper()


def code(text: str) -> Phrase:
    """One name or number; nothing where there is none."""
    return (Code(text),) if text else ()


def listed(phrases: Iterable[Phrase]) -> Phrase:
    """Phrases with commas between them."""
    row: Phrase = ()
    for phrase in phrases:
        row += (", ", *phrase) if row else phrase
    return row
