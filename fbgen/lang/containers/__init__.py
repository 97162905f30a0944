"""How code is wrapped in files: plain text, TwinCAT's XML, PLCopen's XML.

    document = read_document(Path("Pump.TcPOU"))
    document.file, document.findings, document.dialect
    document.rewritten(document.file)                   # formatted: only the code changes
    for new in new_files([file], "plcopen", "plant"):   # converted
        new.name, new.data

Places in trees and findings are those in the file on disk.
"""

from fbgen.lang.containers.document import Document, read_document, read_text
from fbgen.lang.containers.new_files import CONTAINERS, NewFile, new_files
from fbgen.lang.containers.told_dialect import SUFFIXES, XML_SUFFIXES, told_dialect

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
