"""Names that a dialect does not take, told by the names of the plant or the catalogue in them.

A name such as TOS_ConsistentIo_conveyor has a part that the user can change. STEP 7 V5 takes 24
characters in a symbol or a variable, and reads M1 and DB10 as addresses wherever they stand.
"""

from collections.abc import Iterator, Sequence

from fbgen.catalog import Catalog, Parameter, Result
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.lang import ast
from fbgen.lang.dialects import dialect_named
from fbgen.lang.dialects.step7 import is_absolute
from fbgen.lang.walk import walk
from fbgen.plant import Plant
from fbgen.plant.prefix import USUAL_PREFIX
from fbgen.source import Span


@dataclass(frozen=True, slots=True)
class _Part:
    """A name that somebody chose, and where."""

    name: str
    what: str
    place: Span | None


def names_that_do_not_fit(
    units: Sequence[ast.File], plant: Plant, catalog: Catalog
) -> Iterator[Diagnostic]:
    """FB5010 for each name of the plant that makes a name too long, or is an address."""
    dialect = dialect_named(plant.code_dialect)
    parts = sorted(_parts(plant, catalog), key=lambda part: -len(part.name))
    prefix = _Part(plant.prefix, "prefix", plant.span_of("prefix"))
    otherwise = None if plant.prefix == USUAL_PREFIX else prefix
    longest: dict[_Part | None, tuple[str, Span]] = {}
    for name, place in declared(units):
        if len(name) > dialect.identifier_length:
            part = next((one for one in parts if one.name in name), otherwise)
            if part not in longest or len(name) > len(longest[part][0]):
                longest[part] = (name, place)
    for part, (name, place) in longest.items():
        room = dialect.identifier_length - len(name) + (len(part.name) if part else 0)
        yield Diagnostic(
            "FB5010",
            f"the name '{name}' has {len(name)} characters, and {dialect.title} takes "
            f"{dialect.identifier_length}",
            part.place if part else place,
            _way_out(part, room, plant) if part else "",
        )
    for part in parts:
        if dialect.name == "step7" and is_absolute(part.name):
            yield Diagnostic(
                "FB5010",
                f"'{part.name}' is an address or a block to {dialect.title}",
                part.place,
                f"give the {part.what} another name, such as {part.name}_1",
            )


def _way_out(part: _Part, room: int, plant: Plant) -> str:
    if part.what == "prefix":
        return f"choose a prefix of at most {room} characters, the underscore included"
    spare = len(plant.prefix) - len(USUAL_PREFIX)
    if spare <= 0:
        return f"give the {part.what} a name of at most {room} characters"
    if room <= 0:
        return f"choose a prefix that is shorter than {plant.prefix}"
    return (
        f"give the {part.what} a name of at most {room} characters, or the blocks a prefix "
        f"shorter than {plant.prefix}"
    )


def _parts(plant: Plant, catalog: Catalog) -> Iterator[_Part]:
    for gateway in plant.gateways:
        yield _Part(gateway.name, "gateway", gateway.span_of("name"))
    for line in plant.serial:
        yield _Part(line.name, "line", line.span_of("name"))
    for drive in plant.drives:
        yield _Part(drive.name, "drive", drive.span_of("name"))
    for name in plant.sequences:
        sequence = catalog.sequence(name)
        yield _Part(name, "sequence", sequence.span_of("id"))
        interface: tuple[Parameter | Result, ...] = (*sequence.parameters, *sequence.results)
        for item in interface:
            yield _Part(item.name, "parameter or result", item.span_of("name"))


def declared(units: Sequence[ast.File]) -> Iterator[tuple[str, Span]]:
    """The names of all units, variables and fields."""
    for file in units:
        for unit in file.units:
            if isinstance(unit, ast.TypeDeclaration):
                inside: object = unit.type
            elif isinstance(unit, ast.Block | ast.DataBlock):
                inside = (unit.sections, getattr(unit, "struct", None))
            else:
                continue
            yield unit.name.name, unit.name.span
            for item in walk(inside):
                if isinstance(item, ast.DeclaredName):
                    yield item.name, item.span
