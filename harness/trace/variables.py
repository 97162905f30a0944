"""Which variables of the PLC are recorded: all single values below a data block or a path.

Durations are left out unless they are asked for by their own path: ages and elapsed times change
with every scan and say nothing.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from fbgen.lang.checked import LIVING, Program
from fbgen.lang.types import (
    LTIME,
    ArrayType,
    BlockType,
    Elementary,
    Family,
    StringType,
    StructType,
    Type,
)
from harness.engine.path_types import type_at
from harness.trace.model import Channel, ChannelKind

_KINDS: dict[Family, ChannelKind] = {
    Family.BOOL: "bool",
    Family.BITS: "word",
    Family.SIGNED: "integer",
    Family.UNSIGNED: "integer",
    Family.REAL: "real",
    Family.DATE: "integer",
    Family.CHAR: "text",
}


def variable_channels(program: Program, path: str) -> Iterator[Channel]:
    """A channel for each single value at a path that the engine can read."""
    key = path.casefold()
    if key not in program.globals and key in program.lists:
        for part in program.lists[key].values():
            variable = program.globals[part]
            yield from _below(program, f"{path}.{_name(variable.name)}", variable.type)
        return
    kind = type_at(program, path)
    if isinstance(kind, Elementary) and kind.family is Family.DURATION:
        yield _channel(path, "integer", "ns" if kind is LTIME else "ms")
    else:
        yield from _below(program, path, kind)


def block_channels(
    program: Program, block: str, variables: Iterable[tuple[str, Type]]
) -> Iterator[Channel]:
    """A channel for each single value of a block's variables, named as scenario files do."""
    for name, kind in variables:
        for channel in _below(program, _name(name), kind):
            path = channel.path.partition(".")[2]
            title = path.replace(".", " ")
            yield replace(channel, path=f"block.{path}", title=title, owner=block)


def _below(program: Program, path: str, kind: Type) -> Iterator[Channel]:
    if isinstance(kind, StringType):
        yield _channel(path, "text")
    elif isinstance(kind, Elementary):
        if kind.family in _KINDS:
            bits = kind.bits if kind.family is Family.BITS else 0
            yield _channel(path, _KINDS[kind.family], bits=bits)
    elif isinstance(kind, StructType):
        for field in kind.fields:
            yield from _below(program, f"{path}.{_name(field.name)}", field.type)
    elif isinstance(kind, ArrayType):
        for index in _indices(kind.bounds):
            yield from _below(program, f"{path}[{index}]", kind.element)
    elif isinstance(kind, BlockType):
        for variable in program.block_of(kind.name).variables:
            if variable.kind in LIVING:
                yield from _below(program, f"{path}.{_name(variable.name)}", variable.type)


def _name(name: str) -> str:
    return name if name.isidentifier() else f'"{name}"'


def _indices(bounds: tuple[tuple[int, int], ...]) -> Iterator[str]:
    (first, last), *rest = bounds
    for index in range(first, last + 1):
        if rest:
            yield from (f"{index}, {more}" for more in _indices(tuple(rest)))
        else:
            yield str(index)


def _channel(path: str, kind: ChannelKind, unit: str = "", bits: int = 0) -> Channel:
    owner, _, rest = path.partition(".")
    title = rest.replace(".", " ") or owner
    return Channel(f"plc.{path}", title, kind, "plc", owner, unit, bits)
