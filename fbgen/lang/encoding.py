"""Files of PLC text as they come: UTF-8 with and without BOM, UTF-16 with BOM, ANSI.

Source: TIA Portal help, "Rules for external source files": ANSI, UTF-8 and UTF-16 with BOM.
"""

import codecs
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.source import Source

_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)


@dataclass(frozen=True, slots=True)
class Encoding:
    """How a file was written: its codec and its byte order mark."""

    codec: str
    bom: bytes

    def encode(self, text: str) -> bytes:
        """The text as it is written in this encoding."""
        return self.bom + text.encode(self.codec)


def read_source(path: Path) -> Source:
    """The text of a file, named by its path.

    Raises `DiagnosticError`: FB3014 if it cannot be opened, FB3013 if it is no text.
    """
    return Source(str(path), decode(read_bytes(path), str(path)))


def read_bytes(path: Path) -> bytes:
    """What is in a file. Raises `DiagnosticError` (FB3014) if it cannot be opened."""
    try:
        return path.read_bytes()
    except OSError as problem:
        reason = (problem.strerror or str(problem)).lower()
        raise error(
            "FB3014", f"cannot read {path}: {reason}", help="name a file that you may read"
        ) from None


def decode(data: bytes, name: str) -> str:
    """The text of these bytes, without BOM. Raises `DiagnosticError` (FB3013)."""
    return encoding_of(data, name)[1]


def encoding_of(data: bytes, name: str) -> tuple[Encoding, str]:
    """The encoding of these bytes, and their text without BOM. Raises as `decode` does."""
    try:
        for bom, codec in _BOMS:
            if data.startswith(bom):
                return Encoding(codec, bom), data[len(bom) :].decode(codec)
        try:
            return Encoding("utf-8", b""), data.decode("utf-8")
        except UnicodeDecodeError:
            return Encoding("cp1252", b""), data.decode("cp1252")
    except UnicodeDecodeError as problem:
        raise error(
            "FB3013",
            f"{name} is no text in UTF-8, UTF-16 or ANSI (byte {problem.start} does not fit)",
            help="save the file as UTF-8 with BOM",
        ) from None
