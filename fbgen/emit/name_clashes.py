"""Names that are one name in the PLC program, because upper and lower case count as the same."""

from collections.abc import Iterator, Sequence

from fbgen.diagnostics import Diagnostic, Note
from fbgen.lang import ast
from fbgen.lang.walk import walk
from fbgen.plant import Plant
from fbgen.plant.prefix import USUAL_PREFIX
from fbgen.source import Span

Unit = ast.Block | ast.DataBlock | ast.TypeDeclaration


def names_that_clash(units: Sequence[ast.File], plant: Plant) -> Iterator[Diagnostic]:
    """FB5012: two units of one name; a variable that is called like a unit.

    CODESYS, TwinCAT and MATIEC do not tell a variable from the block of its name, and the files of
    two units of one name are one file on Windows.
    """
    first: dict[str, tuple[str, Span]] = {}
    named = [unit for file in units for unit in file.units if isinstance(unit, Unit)]
    for unit in named:
        name, place = unit.name.name, unit.name.span
        known = first.setdefault(name.casefold(), (name, place))
        if known[1] is not place:
            yield _clash(f"two units are called '{name}' and '{known[0]}'", place, known[1], plant)
    for block in named:
        if isinstance(block, ast.Block):
            for item in walk(block.sections):
                if isinstance(item, ast.DeclaredName) and item.name.casefold() in first:
                    message = (
                        f"a variable of '{block.name.name}' is called '{item.name}' like a unit"
                    )
                    yield _clash(message, item.span, first[item.name.casefold()][1], plant)


def _clash(message: str, place: Span, other: Span, plant: Plant) -> Diagnostic:
    return Diagnostic(
        "FB5012",
        message,
        place if plant.prefix == USUAL_PREFIX else plant.span_of("prefix"),
        "choose another prefix, or other names in the plant file",
        (Note("the one", place), Note("the other", other)),
    )
