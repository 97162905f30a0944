"""Which files the text of a plant goes to: each dialect has its own habit.

* tia: one external source for each block, data block and type.
* step7: one source with everything in the order in which it compiles, and the symbol table. One
  source needs no compile control file, and no name in it is used before it is there.
* iec: one file with everything, in the order in which it compiles.
* twincat: one object for each block and data type, and a list of the global variables.
* plcopen: the text of iec in one project.
"""

from collections.abc import Callable, Sequence

from fbgen.emit.container_origins import origins_of_lines
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.symbol_table import LINE_END, symbol_table
from fbgen.lang import ast
from fbgen.lang.containers import new_files
from fbgen.lang.conversion import Schedule, convert
from fbgen.lang.printer import print_generated
from fbgen.plant import Plant

GLOBALS = "TOS_Globals"
"""The list of the global variables of dialect twincat."""

Layout = Callable[[Sequence[ast.File], Sequence[ast.File], Plant], tuple[GeneratedFile, ...]]


def laid_out(units: Sequence[ast.File], plant: Plant) -> tuple[GeneratedFile, ...]:
    """The files of a plant, from its units in canonical SCL.

    Raises DiagnosticError for what the dialect cannot say: FB3040, FB3050 to FB3053, FB5011.
    """
    schedule = Schedule(interval_ns=round(plant.cycle_time_ms * 1_000_000))
    converted = convert(units, plant.language, schedule)
    return _LAYOUTS[plant.dialect](units, converted, plant)


def _one_file_a_unit(
    units: Sequence[ast.File], converted: Sequence[ast.File], plant: Plant
) -> tuple[GeneratedFile, ...]:
    return tuple(_printed(file, file.source.name) for file in converted)


def _source_and_symbols(
    units: Sequence[ast.File], converted: Sequence[ast.File], plant: Plant
) -> tuple[GeneratedFile, ...]:
    symbols = symbol_table([unit for file in units for unit in file.units], plant)
    table = GeneratedFile(f"{plant.name}.sdf", symbols, (), LINE_END, is_program=False)
    return (table, *_one_text(units, converted, plant, ".scl"))


def _one_text(
    units: Sequence[ast.File], converted: Sequence[ast.File], plant: Plant, suffix: str = ".st"
) -> tuple[GeneratedFile, ...]:
    first = converted[0]
    inside = tuple(unit for file in converted for unit in file.units)
    closing = tuple(trivia for file in converted for trivia in file.closing)
    whole = ast.File(first.source, first.dialect, inside, closing)
    return (_printed(whole, f"{plant.name}{suffix}"),)


def _printed(file: ast.File, name: str) -> GeneratedFile:
    printed = print_generated(file)
    return GeneratedFile(name, printed.text, printed.origins)


def _in_container(
    container: str, stem: str, converted: Sequence[ast.File]
) -> tuple[GeneratedFile, ...]:
    """The files of a container; lines of code know where they are from."""
    files = []
    for new in new_files(converted, container, stem):
        text = new.data.decode("ascii")
        line_end = "\r\n" if "\r\n" in text else "\n"
        plain = text.replace(line_end, "\n")
        origins = origins_of_lines(new.name, plain, converted)
        files.append(GeneratedFile(new.name, plain, origins, line_end))
    return tuple(files)


_LAYOUTS: dict[str, Layout] = {
    "tia": _one_file_a_unit,
    "step7": _source_and_symbols,
    "iec": _one_text,
    "twincat": lambda _, converted, plant: _in_container("twincat", GLOBALS, converted),
    "plcopen": lambda _, converted, plant: _in_container("plcopen", plant.name, converted),
}
