"""The code in an XML file: TwinCAT's objects and PLCopen's projects.

Apart from `document`, which most often reads plain text and then needs none of it.
"""

from collections.abc import Callable

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.ast import File
from fbgen.lang.containers import plcopen, twincat
from fbgen.lang.containers.embedded import in_order
from fbgen.lang.containers.places import rewritten
from fbgen.lang.containers.xml_tree import read_xml
from fbgen.lang.parser import parse_recovering
from fbgen.source import Source, Span


def read_code(
    source: Source, dialect: str
) -> tuple[File, tuple[Diagnostic, ...], Callable[[File], str]]:
    """The tree, what is wrong in it, and a function that gives the file with another tree.

    Raises `DiagnosticError`: FB3016 broken XML, FB3018 no code in it.
    """
    root = read_xml(source)
    code = None
    if root.tag == twincat.ROOT:
        code = twincat.read_object(root, dialect)
    elif root.tag == plcopen.ROOT:
        code = plcopen.read_project(root, dialect)
    if code is None:
        raise DiagnosticError(
            [
                Diagnostic(
                    "FB3018",
                    f"<{root.tag}> holds no code that can be read",
                    Span(source, root.start, root.inner_start),
                    "PLCopen TC6 XML is read, and TwinCAT's .TcPOU, .TcDUT, .TcGVL, .TcIO, .TcTTO",
                )
            ]
        )
    file, findings = parse_recovering(code.source, dialect)
    if code.list_names:
        file = twincat.with_list_names(file, code.list_names)
    slots = code.slots

    def written(tree: File) -> str:
        return rewritten(source, slots, tree)

    return file, in_order((*findings, *code.findings)), written
