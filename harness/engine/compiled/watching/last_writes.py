"""Who was the last to write a variable, for those who ask from outside."""

from collections.abc import Iterator
from typing import Any

from fbgen.dataclass import dataclass
from fbgen.lang.checked import LIVING, Block, Program
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from fbgen.source import Span
from harness.engine.compiled.data.memory import Location
from harness.engine.compiled.engine import CompiledEngine
from harness.engine.compiled.outside.instance import CompiledInstance
from harness.engine.compiled.watching.writers import Entry, Writers
from harness.engine.interface import Engine, Instance


@dataclass(frozen=True, slots=True)
class LastWrite:
    """The last write of a variable by the program.

    `where` stands for the variable, however its path is written. `entry` is another object for
    each write, None if there was none; then there is no `span`. `instance` is the path of the
    instance whose code wrote, empty for a block without one.
    """

    where: tuple[int, str | int]
    entry: Entry | None
    span: Span | None = None
    instance: str = ""


def last_write(engine: Engine, path: str) -> LastWrite | None:
    """The last write of what `global_value` reads; None where nobody takes notes."""
    if not isinstance(engine, CompiledEngine) or engine.writers is None:
        return None
    return _at(engine, engine.writers, engine.location(path))


def last_write_in(engine: Engine, instance: Instance, path: str) -> LastWrite | None:
    """The same for a variable of an instance that was made outside of the program."""
    if not isinstance(engine, CompiledEngine) or engine.writers is None:
        return None
    assert isinstance(instance, CompiledInstance), "a compiled engine makes such ones"
    return _at(engine, engine.writers, instance.location(path))


def _at(engine: CompiledEngine, writers: Writers, where: object) -> LastWrite | None:
    if not isinstance(where, Location) or where.key is None:
        return None
    place = id(where.owner), where.key
    entry = writers.of(where.owner, where.key)
    if entry is None:
        return LastWrite(place, None)
    span = writers.statements[entry[0]].span
    return LastWrite(place, entry, span, instance_name(engine, writers, entry[1]))


def instance_name(engine: CompiledEngine, writers: Writers, instance: Any) -> str:
    """The path of an instance of the program; empty for None and for one from outside."""
    if instance is None:
        return ""
    if not writers.instances:
        for name, (_, data) in engine.programs.items():
            writers.instances[id(data)] = name
        for path in _instances(engine.program):
            where = engine.location(path)
            if isinstance(where, Location):
                writers.instances[id(where.read())] = path
    return writers.instances.get(id(instance), "")


def _instances(program: Program) -> Iterator[str]:
    """The paths of all instances of the program's own function blocks."""
    for variable in program.globals.values():
        yield from _below(program, variable.name, variable.type)
    for key, block in program.program_instances().items():
        yield from _inside(program, key, block)


def _below(program: Program, path: str, kind: Type) -> Iterator[str]:
    if isinstance(kind, ArrayType):
        if len(kind.bounds) == 1 and isinstance(kind.element, BlockType | StructType | ArrayType):
            first, last = kind.bounds[0]
            for index in range(first, last + 1):
                yield from _below(program, f"{path}[{index}]", kind.element)
    elif isinstance(kind, StructType):
        for field in kind.fields:
            yield from _below(program, f"{path}.{field.name}", field.type)
    elif isinstance(kind, BlockType) and isinstance(block := program.block_of(kind.name), Block):
        yield path
        yield from _inside(program, path, block)


def _inside(program: Program, path: str, block: Block) -> Iterator[str]:
    for variable in block.variables:
        if variable.kind in LIVING:
            yield from _below(program, f"{path}.{variable.name}", variable.type)
