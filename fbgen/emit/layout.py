"""Which files the text of a plant goes to: each dialect has its own habit.

* tia: one external source for each block, data block and type.
* step7: three sources in the order in which they compile, and the symbol table: everything in
  front of the parameters, these, and what uses them. No name is used before it is there.
* tia and step7: error blocks in sources of their own: who has such blocks leaves them alone.
* iec: one file with everything, in the order in which it compiles.
* twincat: one object for each block and data type, and a list of the global variables.
* plcopen: the text of iec in one project.

`files:` of the plant file turns that round where the dialect's tools leave it open.
"""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from fbgen.emit.container_origins import origins_of_lines
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.parameter_files import (
    PARAMETER_LIST,
    PARAMETERS,
    split_at_parameters,
    with_parameter_list,
)
from fbgen.emit.symbol_table import LINE_END, symbol_table
from fbgen.lang import ast
from fbgen.lang.containers import new_files
from fbgen.lang.conversion import Schedule, convert, with_copies
from fbgen.lang.printer import print_generated
from fbgen.plant import FILE_LAYOUTS, FileLayout, Plant, PlantDialect, with_prefix

GLOBALS = "TOS_Globals"
"""The list of the global variables of dialect twincat."""

Layout = Callable[[Sequence[ast.File], Plant], tuple[GeneratedFile, ...]]
"""Lays converted files out."""


def laid_out(units: Sequence[ast.File], plant: Plant) -> tuple[GeneratedFile, ...]:
    """The files of a plant, from its units in canonical SCL.

    Raises DiagnosticError for what the dialect cannot say: FB3040, FB3050 to FB3053, FB5011.
    """
    schedule = Schedule(interval_ns=round(plant.cycle_time_ms * 1_000_000))
    if plant.family.classic:
        units = with_copies(units)
    converted = convert(units, plant.code_dialect, schedule)
    layout = plant.files or FILE_LAYOUTS[plant.dialect][0]
    blocks = [file for file in converted if not _is_error_block(file)]
    errors = [file for file in converted if _is_error_block(file)]
    files = _LAYOUTS[plant.dialect, layout](blocks, plant)
    files = tuple(replace(file, is_owned=_is_owned(file, plant)) for file in files)
    if plant.dialect == "step7":
        files = (_symbols(units, plant), *files)
        errors = [_by_its_number(file) for file in errors]
    if errors and layout == "one":
        files += _one_text(errors, plant, "_error_obs.scl")
    elif errors:
        files += _one_file_a_unit(errors, plant, ".scl")
    return files


def has_file_for_each_unit(plant: Plant) -> bool:
    """Whether each unit becomes a file of its own, in the language of the templates."""
    layout = plant.files or FILE_LAYOUTS[plant.dialect][0]
    return (plant.dialect, layout) == ("tia", "per_block") and not plant.family.classic


def _is_owned(file: GeneratedFile, plant: Plant) -> bool:
    """Whether it has the parameter block, and nothing else."""
    names = [f"{with_prefix(PARAMETERS, plant.prefix)}{suffix}" for suffix in (".db", ".scl")]
    names += [f"{with_prefix(PARAMETER_LIST, plant.prefix)}.TcGVL", f"{plant.name}_parameters.scl"]
    return file.name in names


def _by_its_number(file: ast.File) -> ast.File:
    """Its blocks without quotes: OB86 is no symbol to STEP 7."""
    units = tuple(
        replace(unit, name=replace(unit.name, quoted=False))
        if isinstance(unit, ast.Block)
        else unit
        for unit in file.units
    )
    return replace(file, units=units)


def _is_error_block(file: ast.File) -> bool:
    return any(
        isinstance(unit, ast.Block) and unit.kind is ast.BlockKind.ORGANIZATION_BLOCK
        for unit in file.units
    )


def _symbols(units: Sequence[ast.File], plant: Plant) -> GeneratedFile:
    symbols = symbol_table([unit for file in units for unit in file.units], plant)
    return GeneratedFile(f"{plant.name}.sdf", symbols, (), LINE_END, is_program=False)


def _one_text_and_parameters(
    converted: Sequence[ast.File], plant: Plant
) -> tuple[GeneratedFile, ...]:
    front, parameters, behind = split_at_parameters(converted, plant)
    own = _printed(parameters, parameters.source.name)
    return (*_one_text([*front, *behind], plant, ".scl"), own)


def _texts_in_order(converted: Sequence[ast.File], plant: Plant) -> tuple[GeneratedFile, ...]:
    front, parameters, behind = split_at_parameters(converted, plant)
    return (
        *_one_text(front, plant, ".scl"),
        *_one_text([parameters], plant, "_parameters.scl"),
        *_one_text(behind, plant, "_calls.scl"),
    )


def _one_file_a_source(converted: Sequence[ast.File], plant: Plant) -> tuple[GeneratedFile, ...]:
    return tuple(_printed(file, file.source.name) for file in converted)


def _one_file_a_unit(
    converted: Sequence[ast.File], plant: Plant, suffix: str
) -> tuple[GeneratedFile, ...]:
    """A file for each unit that has a name, what has none in one with the name of the plant."""
    files: dict[str, list[ast.Unit]] = {}
    for file in converted:
        for unit in file.units:
            if isinstance(unit, ast.Block | ast.DataBlock | ast.TypeDeclaration):
                files.setdefault(unit.name.name, []).append(unit)
            else:
                files.setdefault(plant.name, []).append(unit)
    first = converted[0]
    return tuple(
        _printed(ast.File(first.source, first.dialect, tuple(inside), ()), f"{stem}{suffix}")
        for stem, inside in files.items()
    )


def _one_text(
    converted: Sequence[ast.File], plant: Plant, suffix: str
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


_LAYOUTS: dict[tuple[PlantDialect, FileLayout], Layout] = {
    ("tia", "per_block"): _one_file_a_source,
    ("tia", "one"): _one_text_and_parameters,
    ("step7", "one"): _texts_in_order,
    ("step7", "per_block"): partial(_one_file_a_unit, suffix=".scl"),
    ("iec", "one"): partial(_one_text, suffix=".st"),
    ("iec", "per_block"): partial(_one_file_a_unit, suffix=".st"),
    ("twincat", "per_block"): lambda converted, plant: _in_container(
        "twincat", with_prefix(GLOBALS, plant.prefix), with_parameter_list(converted, plant)
    ),
    ("plcopen", "one"): lambda converted, plant: _in_container("plcopen", plant.name, converted),
}
