"""How code is wrapped in files: plain text, TwinCAT's XML, PLCopen's XML.

    document = read_document(Path("Pump.TcPOU"))
    document.file, document.findings, document.dialect
    document.rewritten(document.file)                   # formatted: only the code changes
    for new in new_files([file], "plcopen", "plant"):   # converted
        new.name, new.data

Places in trees and findings are those in the file on disk. Nothing is imported before it is asked
for: plain text needs no XML.
"""

from typing import TYPE_CHECKING

from fbgen.faces import member

if TYPE_CHECKING:
    from fbgen.lang.containers.dialect_of_files import SUFFIXES, XML_SUFFIXES, told_dialect
    from fbgen.lang.containers.document import Document, read_document, read_text
    from fbgen.lang.containers.written_files import CONTAINERS, NewFile, new_files

__all__ = [
    "CONTAINERS",
    "Document",
    "NewFile",
    "SUFFIXES",
    "XML_SUFFIXES",
    "new_files",
    "read_document",
    "read_text",
    "told_dialect",
]

_HOMES = {
    "CONTAINERS": "written_files",
    "Document": "document",
    "NewFile": "written_files",
    "SUFFIXES": "dialect_of_files",
    "XML_SUFFIXES": "dialect_of_files",
    "new_files": "written_files",
    "read_document": "document",
    "read_text": "document",
    "told_dialect": "dialect_of_files",
}


def __getattr__(name: str) -> object:
    return member(__name__, _HOMES, name)
