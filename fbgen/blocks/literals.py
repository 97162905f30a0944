"""Catalogue values as they stand in SCL, each with the place it came from."""

from fbgen.catalog import ComNo, Located, origin
from fbgen.dataclass import dataclass
from fbgen.source import Origin


@dataclass(frozen=True, slots=True)
class SclText:
    """A piece of SCL that came from the catalogue or the plant file.

    A template that prints it marks what it prints with `origin`.
    """

    text: str
    origin: Origin | None = None

    def __str__(self) -> str:
        return self.text


_UMLAUTS = str.maketrans(
    {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue"}
)

NOTHING = SclText("")
"""What prints as nothing."""


@dataclass(frozen=True, slots=True)
class ComNoText(SclText):
    """A communication number: prints as `16#FC90`."""

    hex: str = ""
    comment: SclText = NOTHING


def word(value: int, source: Origin | None = None) -> SclText:
    """`16#C400`."""
    return SclText(f"16#{value:04X}", source)


def byte(value: int, source: Origin | None = None) -> SclText:
    """`16#0B`."""
    return SclText(f"16#{value:02X}", source)


def real(value: float, source: Origin | None = None) -> SclText:
    """`50.0`; what has a short decimal form is written so."""
    text = repr(float(value))
    return SclText(text if "e" not in text else f"{value:.9f}".rstrip("0"), source)


def truth(value: bool, source: Origin | None = None) -> SclText:
    """`TRUE` or `FALSE`."""
    return SclText("TRUE" if value else "FALSE", source)


def milliseconds(value: float, source: Origin | None = None) -> SclText:
    """`T#100ms`, rounded up to whole milliseconds."""
    return SclText(f"T#{-int(-value // 1)}ms", source)


def comno(number: ComNo) -> ComNoText:
    """A communication number with its name for comments."""
    place = origin(f"ComNo {number.hex} {number.name}", number, number.source or "")
    return ComNoText(
        f"16#{number.hex}",
        place,
        hex=f"{number.hex}h",
        comment=SclText(f"ComNo {number.hex}, {one_line(number.title)}", place),
    )


def source_text(entry: Located, source: str | None) -> SclText:
    """The manual section of an entry, for a comment."""
    return SclText(one_line(source or "no source, unverified"), origin("source", entry))


def one_line(text: str) -> str:
    """A text for a comment: one line, ASCII, and nothing in it that could end the comment."""
    flat = " ".join(text.translate(_UMLAUTS).split())
    ascii_text = "".join(char if " " <= char <= "~" else "?" for char in flat)
    for mark in ("*)", "(*", "*/", "/*"):
        ascii_text = ascii_text.replace(mark, f"{mark[0]} {mark[1]}")
    return ascii_text
