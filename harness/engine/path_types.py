"""The types of what paths lead to: `"DB".telegram[3].value` is a WORD."""

from fbgen.lang.checked import IN_OUTS, Program
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from harness.engine.paths import FOLLOW, Step, parse_path


def type_at(program: Program, path: str) -> Type:
    """The type of what stands at a path that the engine can read."""
    first, *rest = global_steps(program, path)
    key = str(first).casefold()
    kind: Type
    if key in program.globals:
        kind = program.globals[key].type
    else:
        kind = BlockType(program.program_instances()[key].name)
    for step in rest:
        kind = part_type(program, kind, step)
    return kind


def global_steps(program: Program, path: str) -> tuple[Step, ...]:
    """The steps of a path from a global variable on; `GVL.x` is the x of that list."""
    steps = parse_path(path)
    first, *rest = steps
    key = str(first).casefold()
    if not rest or key in program.globals or key not in program.lists:
        return steps
    name = program.lists[key].get(str(rest[0]).casefold())
    return steps if name is None else (program.globals[name].name, *rest[1:])


def stays(program: Program, path: str) -> bool:
    """True if a path leads to the same place at any time.

    False if it goes through a reference or an in-out, which refer to one place after the other.
    """
    first, *rest = global_steps(program, path)
    kind = type_at(program, str(first))
    for step in rest:
        if step == FOLLOW or (isinstance(kind, BlockType) and _is_connected(program, kind, step)):
            return False
        kind = part_type(program, kind, step)
    return True


def _is_connected(program: Program, kind: BlockType, step: Step) -> bool:
    variables = program.block_of(kind.name).variables
    key = str(step).casefold()
    return any(item.name.casefold() == key and item.kind in IN_OUTS for item in variables)


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
