"""One file on disk: what tree is in it, and how it looks with another one.

document = read_document(Path("Pump.TcPOU"))
document.file, document.findings
document.rewritten(document.file)      # the bytes of the formatted file
"""

from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.lang.ast import File
from fbgen.lang.containers import s7dcl, statement_lists
from fbgen.lang.containers.age import Age, age_of
from fbgen.lang.containers.dialect_of_files import XML_SUFFIXES, told_dialect
from fbgen.lang.containers.embedded import in_order
from fbgen.lang.encoding import Encoding, encoding_of, read_bytes
from fbgen.lang.parser import parse_recovering
from fbgen.lang.printer import print_file
from fbgen.source import Source

_TEXTS = 128
"""How many texts are remembered as they were read: those of a plant of some gateways."""


@dataclass(frozen=True, slots=True, eq=False)
class Document:
    """A file that was read. Places in `file` and `findings` are those in the file on disk."""

    path: Path
    dialect: str
    file: File
    findings: tuple[Diagnostic, ...]
    _text: str
    _written: Callable[[File], str]
    _encoding: Encoding

    @property
    def data(self) -> bytes:
        """The bytes that were read."""
        return self._encoding.encode(self._text)

    def rewritten(self, file: File) -> bytes:
        """The bytes of the file with this tree, which has the units and members of `self.file`.

        Encoding and line ends stay. In XML only the code changes, in a `.s7dcl` and a
        source with instruction lists nothing.
        """
        return self._encoding.encode(self._written(file))


def read_document(path: Path, dialect: str | None = None) -> Document:
    """Read any file by its suffix; a text of unknown suffix needs a dialect.

    Raises `DiagnosticError`: FB3011 unknown dialect, FB3013, FB3014 no text, FB3016 broken XML,
    FB3018 no code in it.
    """
    return document_of(path, read_bytes(path), dialect)


def document_of(path: Path, data: bytes, dialect: str | None = None) -> Document:
    """As `read_document`, for a file with these bytes."""
    encoding, text = encoding_of(data, str(path))
    source = Source(str(path), text)
    chosen = dialect or told_dialect(path, text) or "tia"
    is_text = path.suffix.lower() != s7dcl.SUFFIX
    if dialect is None and chosen == "tia" and is_text and age_of(data) is Age.CLASSIC:
        chosen = "step7"
    return _document(path, source, chosen, encoding, path.suffix.lower() in XML_SUFFIXES)


@lru_cache(maxsize=_TEXTS)
def read_text(source: Source, dialect: str, is_xml: bool = False) -> Document:
    """As `read_document`, for a text that is there already.

    The rules for what was generated read it before the harness does: it is read once.
    """
    return _document(Path(source.name), source, dialect, Encoding("utf-8", b""), is_xml)


def _document(
    path: Path, source: Source, dialect: str, encoding: Encoding, is_xml: bool
) -> Document:
    if is_xml:
        from fbgen.lang.containers.xml_document import read_code  # noqa: PLC0415 - only for XML

        file, found, written = read_code(source, dialect)
        return Document(path, dialect, file, found, source.text, written, encoding)
    if path.suffix.lower() == s7dcl.SUFFIX:
        return _declared_document(path, s7dcl.read_declared(source), source, dialect, encoding)
    if dialect in ("tia", "step7") and (lists := statement_lists.read_lists(source)):
        return _declared_document(path, lists, source, dialect, encoding)
    file, findings = parse_recovering(source, dialect)
    crlf = "\r\n" in source.text

    def printed(tree: File) -> str:
        text = print_file(tree).text
        return text.replace("\n", "\r\n") if crlf else text

    return Document(path, dialect, file, tuple(findings), source.text, printed, encoding)


def _declared_document(
    path: Path, declared: s7dcl.Declared, source: Source, dialect: str, encoding: Encoding
) -> Document:
    """A `.s7dcl`, or a source with instruction lists: it is written back as it is."""
    file, findings = parse_recovering(declared.source, dialect)
    found = in_order((*findings, *declared.findings))
    return Document(path, dialect, file, found, source.text, lambda _: source.text, encoding)
