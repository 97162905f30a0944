"""A frame taken apart for a person or another program: what `fbgen decode` shows."""

from collections.abc import Sequence

from fbgen.cli.table import table
from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error


@dataclass(frozen=True, slots=True)
class Part:
    """Some bytes of a frame, which field they are, and what they say."""

    data: bytes
    name: str
    text: str


@dataclass(frozen=True, slots=True)
class Reading:
    """A frame with what it says. `right` is the same frame with its right check sum; None where
    there is none."""

    title: str
    direction: str
    frame: bytes
    right: bytes | None
    parts: tuple[Part, ...]
    remarks: tuple[str, ...]


def directions(asked: str | None) -> tuple[str, ...]:
    """The directions to try: the one asked for, or both."""
    return ("request", "reply") if asked is None else (asked,)


def reading_text(reading: Reading) -> str:
    """A head, the fields as a table, and the remarks."""
    rows = [[shown(part.data), part.name, part.text] for part in reading.parts]
    body = table(["bytes", "field", "meaning"], rows)
    head = "\n".join([*_as_text(reading.frame), shown(reading.frame), reading.title])
    return "\n\n".join([head, body, "\n".join(reading.remarks)]).rstrip()


def reading_json(reading: Reading) -> dict[str, object]:
    """The same as plain data; `text` is an ASCII frame as it is written."""
    data: dict[str, object] = {
        "title": reading.title,
        "direction": reading.direction,
        "frame": shown(reading.frame),
    }
    if reading.right is not None:
        data["checksum_right"] = reading.frame == reading.right
        data["right_frame"] = shown(reading.right)
    data |= {
        "fields": [
            {"bytes": shown(part.data), "name": part.name, "meaning": part.text}
            for part in reading.parts
        ],
        "remarks": list(reading.remarks),
    }
    if text := "".join(_as_text(reading.frame)):
        data["text"] = text
    return data


def shown(data: bytes) -> str:
    """Bytes as the manuals write them: `2F 0B 50`."""
    return data.hex(" ").upper()


def _as_text(frame: bytes) -> list[str]:
    """An ASCII frame as a text."""
    if not frame.startswith(b"("):
        return []
    return [frame.decode("ascii", "replace").replace("\r", " CR")]


def size_of(count: int) -> str:
    """`1 byte`, `8 bytes`."""
    return f"{count} byte" if count == 1 else f"{count} bytes"


def wrong_size(frame: bytes, wanted: Sequence[int | None], code: str) -> str | None:
    """Why a frame cannot have this many bytes; None if it can.

    `wanted` are the sizes that its `code` asks for, one for each direction: None while more bytes
    have to come before they say, 0 where the code is none.
    """
    sizes = sorted({size for size in wanted if size})
    if sizes and len(frame) not in sizes:
        needed = " or ".join(size_of(size) for size in sizes)
        return f"it has {size_of(len(frame))}, and with this {code} {needed}"
    return f"{size_of(len(frame))} are too few" if None in wanted else None


def no_frame(title: str, reason: str, help_: str) -> DiagnosticError:
    """FB9041: these bytes are none of the protocol's frames."""
    return error("FB9041", f"this is no {title}: {reason}", help=help_)
