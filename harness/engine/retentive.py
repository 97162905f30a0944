"""Retentive data: taken out of a program by name, and put back, in this run or in a later one.

What is remanent is what survives a warm restart: RETAIN sections and data blocks. Instances go
variable by variable; of timers and edges only what a program could write comes back.
"""

from collections.abc import Iterator, Mapping, Sequence

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.checked import LIVING, Block, Program, Variable, VariableKind
from fbgen.lang.layout import holds_blocks, holds_values
from fbgen.lang.types import ArrayType, BlockType, StructType, Type, is_area_pointer
from harness.engine.interface import Engine, Value


def retentive_values(engine: Engine) -> dict[str, Value]:
    """The values of all remanent variables by their paths."""
    return {path: engine.global_value(path) for path in _paths(engine.program)}


def restore_retentive(engine: Engine, values: Mapping[str, Value]) -> None:
    """Put values back. Raises DiagnosticError with all that do not fit; then none is written."""
    before = engine.snapshot()
    found: list[Diagnostic] = []
    for path, value in values.items():
        try:
            engine.set_global(path, value)
        except DiagnosticError as refused:
            found += refused.diagnostics
    if found:
        engine.restore(before)
        raise DiagnosticError(found)


def _paths(program: Program) -> Iterator[str]:
    for key, variable in program.globals.items():
        if program.program_variable(key) is not None:
            continue  # comes with the PROGRAMs
        yield from _of_variable(program, f'"{variable.name}"', variable, variable.remanent)
    for name, block in program.program_instances().items():
        for variable in block.variables:
            path = f'"{name}"."{variable.name}"'
            yield from _of_variable(program, path, variable, variable.remanent)


def _of_variable(program: Program, path: str, variable: Variable, is_kept: bool) -> Iterator[str]:
    if variable.kind in (*LIVING, VariableKind.GLOBAL) and variable.overlay is None:
        yield from _parts(program, path, variable.type, is_kept)


def _parts(program: Program, path: str, kind: Type, is_kept: bool) -> Iterator[str]:
    """What is remanent in a variable: all of it, or remanent variables of instances in it."""
    if isinstance(kind, BlockType):
        block = program.block_of(kind.name)
        for variable in block.variables:
            kept = is_kept or (isinstance(block, Block) and variable.remanent)
            yield from _of_variable(program, f'{path}."{variable.name}"', variable, kept)
    elif holds_blocks(kind):
        if isinstance(kind, StructType):
            for field in kind.fields:
                yield from _parts(program, f'{path}."{field.name}"', field.type, is_kept)
        elif isinstance(kind, ArrayType):
            for index in _indices(kind.bounds):
                yield from _parts(program, f"{path}[{index}]", kind.element, is_kept)
    elif is_kept and holds_values(kind) and not is_area_pointer(kind):
        yield path


def _indices(bounds: Sequence[tuple[int, int]]) -> Iterator[str]:
    (first, last), *others = bounds
    for index in range(first, last + 1):
        if others:
            yield from (f"{index}, {rest}" for rest in _indices(others))
        else:
            yield str(index)
