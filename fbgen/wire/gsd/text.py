"""The bytes of a GSD file as a text.

GSD files are written in the Windows code page; newer tools write UTF-8. Neither has to be told:
what is valid UTF-8 is read as that, all else as Windows-1252, where every byte means something.
"""

import codecs

from fbgen.diagnostics import error
from fbgen.source import Source

MAX_BYTES = 8_000_000
"""More than ten times the largest GSD files, those of modular stations with all their texts."""

_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


def gsd_source(data: bytes, name: str) -> Source:
    """The text of a file, its lines ended by LF alone. Raises DiagnosticError FB1301: too large."""
    if len(data) > MAX_BYTES:
        raise error(
            "FB1301",
            f"{name} has {len(data):,} bytes, which is more than any GSD file",
            help=f"GSD files have up to some 100,000 bytes; {MAX_BYTES:,} are read",
        )
    return Source(name, _decoded(data).replace("\r\n", "\n").replace("\r", "\n"))


def _decoded(data: bytes) -> str:
    for bom, codec in _BOMS:
        if data.startswith(bom):
            return data[len(bom) :].decode(codec, "replace")
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError:
        return "".join(_WINDOWS[byte] for byte in data)


def _windows(byte: int) -> str:
    """A character of Windows-1252; the five places that it leaves free are those of Latin-1."""
    try:
        return bytes((byte,)).decode("cp1252")
    except UnicodeDecodeError:
        return chr(byte)


_WINDOWS = tuple(_windows(byte) for byte in range(256))
