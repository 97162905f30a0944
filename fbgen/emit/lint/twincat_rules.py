"""Rules of TwinCAT 3 for its objects.

Names and addresses in code are those of `iec_rules`; here stands what is TwinCAT's own. Source:
Beckhoff Information System, "TwinCAT 3 PLC"; objects that TwinCAT writes, in published projects.
"""

from collections.abc import Iterator
from pathlib import PurePath

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang import ast
from fbgen.lang.walk import walk


def one_object_named_as_its_file(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5061: TwinCAT looks for an object in the file of its name, and finds one there."""
    stem = PurePath(emitted.source.name).stem
    for unit in emitted.file.units:
        if isinstance(unit, ast.Block | ast.TypeDeclaration):
            name, place = unit.name.name, unit.name.span
        elif isinstance(unit, ast.Globals):
            name, place = unit.name, unit.span
        else:
            continue
        if name.casefold() != stem.casefold():
            yield Diagnostic(
                "FB5061",
                f"'{name}' stands in the file of '{stem}'",
                place,
                "write each object into a file of its name",
            )


def addresses_in_global_lists(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5062: two instances of a block with an address in it would share that address."""
    for unit in emitted.file.units:
        if not isinstance(unit, ast.Block | ast.TypeDeclaration):
            continue
        for item in walk(unit):
            if isinstance(item, ast.Declaration) and isinstance(item.at, ast.DirectAddress):
                yield Diagnostic(
                    "FB5062",
                    f"'{item.names[0].name}' has an address in '{unit.name.name}'",
                    item.span,
                    "declare it in a list of global variables",
                )


RULES = (one_object_named_as_its_file, addresses_in_global_lists)
