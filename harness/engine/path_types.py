"""The types of what paths lead to: `"DB".telegram[3].value` is a WORD."""

from fbgen.lang.checked import Program
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from harness.engine.paths import Step, parse_path


def type_at(program: Program, path: str) -> Type:
    """The type of what stands at a path that the engine can read."""
    first, *rest = parse_path(path)
    key = str(first).casefold()
    kind: Type
    if key in program.globals:
        kind = program.globals[key].type
    else:
        kind = BlockType(program.program_instances()[key].name)
    for step in rest:
        kind = part_type(program, kind, step)
    return kind


def part_type(program: Program, kind: Type, step: Step) -> Type:
    """The type of a part that is there."""
    if isinstance(kind, ArrayType):
        return kind.element
    key = str(step).casefold()
    if isinstance(kind, StructType):
        return next(field.type for field in kind.fields if field.name.casefold() == key)
    assert isinstance(kind, BlockType), "the engine has read the path"
    variables = program.block_of(kind.name).variables
    return next(item.type for item in variables if item.name.casefold() == key)
