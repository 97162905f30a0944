"""What an ANY or POINTER can point to that the program sees as bytes.

Where an overlay shows the bytes of an ANY, they hold an address, so what it refers to needs one: it
lies in bytes as well. The argument is often far away from the overlay, with in-outs and other ANY
parameters between them, so this looks at all calls together, once they are checked.
"""

from collections.abc import Iterator, Mapping

from fbgen.lang import checked
from fbgen.lang.checked import (
    Assignment,
    Block,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    InstanceCall,
    Place,
    ReferenceTo,
    SliceRef,
    Statement,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.library import Library
from fbgen.lang.layout import holds_blocks, holds_values
from fbgen.lang.types import BlockType, is_area_pointer, refers_to_anything

_PARTS: dict[type, tuple[str, ...]] = {
    kind: tuple(name for name in vars(kind)["__slots__"] if name not in ("span", "type"))
    for name in checked.__all__
    if isinstance(kind := vars(checked)[name], type)
    and "span" in getattr(kind, "__slots__", ())
    and kind not in (Variable, Block)
}


def lay_out_what_is_pointed_to(
    library: Library, bodies: Mapping[Block, tuple[Statement, ...]]
) -> None:
    """Let everything lie in bytes whose address an ANY or POINTER in bytes can hold."""
    memory = library.memory
    waiting = [one for one in memory.byte_memory(library) if is_area_pointer(one.type)]
    if not waiting:
        return
    memory.address_any()
    sources = _sources(library, bodies)
    done: set[Variable] = set()
    while waiting:
        variable = waiting.pop()
        if variable in done:
            continue
        done.add(variable)
        if variable.kind is VariableKind.GLOBAL:
            if variable.address is None and variable not in memory.optimized:
                memory.number_of(variable)
        elif _can_lie_in_bytes(variable):
            memory.overlay(variable, variable.overlay or variable)
        waiting += sources.get(variable, ())


def _can_lie_in_bytes(variable: Variable) -> bool:
    return (
        variable.kind is not VariableKind.IN_OUT
        and variable.address is None
        and holds_values(variable.type)
        and not holds_blocks(variable.type)
    )


def _sources(
    library: Library, bodies: Mapping[Block, tuple[Statement, ...]]
) -> dict[Variable, list[Variable]]:
    """What each in-out and each reference to anything can be bound to."""
    found: dict[Variable, list[Variable]] = {}

    def bind(variable: Variable, bound: Expression) -> None:
        place = bound.place if isinstance(bound, ReferenceTo) else bound
        if isinstance(place, Place) and (owner := _owner(library, place)) is not None:
            found.setdefault(variable, []).append(owner)

    for node in _nodes(bodies):
        if isinstance(node, FunctionCall | InstanceCall):
            for parameter, value in node.inputs:
                if refers_to_anything(parameter.type):
                    bind(parameter, value)
            for parameter, place in node.in_outs:
                bind(parameter, place)
        elif isinstance(node, Assignment) and refers_to_anything(node.target.type):
            target = _owner(library, node.target)
            if target is not None:
                bind(target.overlay or target, node.value)
    return found


def _nodes(bodies: Mapping[Block, tuple[Statement, ...]]) -> Iterator[object]:
    waiting: list[object] = list(bodies.values())
    while waiting:
        item = waiting.pop()
        if isinstance(item, tuple):
            waiting += item
        elif (parts := _PARTS.get(type(item))) is not None:
            yield item
            waiting += [getattr(item, name) for name in parts]


def _owner(library: Library, place: Place) -> Variable | None:
    """The variable that a place is or belongs to: a data block, or one of the innermost block."""
    owner: Variable | None = None
    while isinstance(place, FieldRef | IndexRef | SliceRef):
        if isinstance(place, FieldRef) and isinstance(place.base.type, BlockType):
            block = library.user_block(place.base.type.name)
            key = place.name.casefold()
            if owner is None and block is not None:
                owner = next((one for one in block.variables if one.name.casefold() == key), None)
        place = place.base
    if not isinstance(place, VariableRef):
        return owner
    if owner is None or place.variable.kind is VariableKind.GLOBAL:
        return place.variable
    return owner
