"""The checked program of a plant. Tests run many scenarios on one plant, and generating, reading
and checking its text takes longer than simulating a minute of it: so programs are kept."""

from collections import OrderedDict
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog
from fbgen.lang.checked import Program
from fbgen.plant import Plant
from fbgen.source import Origin, Source
from harness.engine.loading import read_program

if TYPE_CHECKING:
    from fbgen.emit.generated import GeneratedFile

_KEPT = 32
_programs: OrderedDict[tuple[str, int], tuple[Catalog, Program]] = OrderedDict()


def generated_sources(plan: Plant, catalog: Catalog) -> list[Source]:
    """What fbgen generates for a plant, in the plant's dialect; lines know where they are from."""
    from fbgen.emit.generator import generate  # noqa: PLC0415 - not for a program that is kept

    files = generate(plan, catalog).files
    return [Source(file.name, file.text, _origins(file)) for file in files if file.is_program]


def generated_program(plan: Plant, catalog: Catalog) -> Program:
    """The program that the generated text of a plant is. Programs never change, so they are shared.

    Raises DiagnosticError for what is wrong in the plant or the text.
    """
    key = (plan.model_dump_json(), id(catalog))
    if key not in _programs:
        program = read_program(generated_sources(plan, catalog), plan.code_dialect)
        _programs[key] = (catalog, program)
        while len(_programs) > _KEPT:
            _programs.popitem(last=False)
    _programs.move_to_end(key)
    return _programs[key][1]


def _origins(file: "GeneratedFile") -> tuple[tuple[int, Origin | None], ...]:
    """A line of a template stands in front of the value that the line is said to be from."""
    places: list[tuple[int, Origin | None]] = []
    offset = 0
    for line, origins in zip(file.text.splitlines(keepends=True), file.origins, strict=False):
        values = [origin for origin in origins if not origin.is_template]
        places += [(offset, origin) for origin in origins if origin.is_template]
        if values or not origins:
            places.append((offset, next(iter(values), None)))
        offset += len(line)
    return tuple(places)
