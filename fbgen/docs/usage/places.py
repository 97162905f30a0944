"""Places of a program, the same wherever they are named, and what flows into them."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence

from fbgen.lang.checked import (
    Assignment,
    Binary,
    Block,
    Constant,
    Convert,
    Evaluate,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    InstanceCall,
    Program,
    Unary,
    Variable,
    VariableRef,
)
from fbgen.lang.types import BlockType, StructType

PlaceKey = Variable | tuple[str, str] | tuple[str, "PlaceKey"]
"""A variable of a block, a part of a structure (type and name), an element of an array."""

BITWISE = frozenset(("AND", "OR", "XOR"))


class Places:
    """The keys of places; parameters of an instance are the variables of its block."""

    def __init__(self, program: Program) -> None:
        self._variables = {
            (key, variable.name.casefold()): variable
            for key, block in program.blocks.items()
            for variable in block.variables
        }

    def key(self, place: object) -> PlaceKey | None:
        """What tells a place; None for addresses and other places without a name."""
        if isinstance(place, VariableRef):
            return place.variable
        if isinstance(place, FieldRef):
            kind = place.base.type
            if isinstance(kind, BlockType):
                return self._variables.get((kind.name.casefold(), place.name.casefold()))
            if isinstance(kind, StructType):
                return kind.name.casefold(), place.name.casefold()
        if isinstance(place, IndexRef) and (base := self.key(place.base)) is not None:
            return "[]", base
        return None

    def flows(self, program: Program) -> Mapping[PlaceKey, list[Expression]]:
        """What each place gets, in the order of the text."""
        found: defaultdict[PlaceKey, list[Expression]] = defaultdict(list)
        for _, statement in statements(program):
            for target, value in self._moves(statement):
                if (key := self.key(target)) is not None:
                    found[key].append(value)
        return found

    def _moves(self, node: object) -> Iterator[tuple[object, Expression]]:
        if isinstance(node, Assignment):
            yield node.target, node.value
        elif isinstance(node, InstanceCall | FunctionCall):
            for variable, value in node.inputs:
                yield VariableRef(node.span, variable, variable.type), value
            for variable, place in node.in_outs:
                own = VariableRef(node.span, variable, variable.type)
                yield own, place
                yield place, own
            for variable, place in node.outputs:
                yield place, VariableRef(node.span, variable, variable.type)


def statements(program: Program) -> Iterator[tuple[Block, object]]:
    """Every statement and every function call of every block, in no particular order."""
    for block, body in program.bodies.items():
        for node in nodes(body):
            if isinstance(node, Assignment | InstanceCall | FunctionCall | Evaluate):
                yield block, node


def nodes(root: object) -> Iterator[object]:
    """The node and everything below it, as it stands in the text."""
    waiting = [root]
    while waiting:
        item = waiting.pop()
        if not isinstance(item, tuple):
            yield item
        waiting += reversed(children(item))


def children(item: object) -> Sequence[object]:
    """What hangs on a node of the checked tree, or stands in a row of them."""
    if isinstance(item, tuple):
        return [one for one in item if isinstance(one, tuple) or type(one).__module__ in _HOMES]
    names = _PARTS.get(type(item))
    if names is None:
        slots = getattr(type(item), "__slots__", ())
        names = _PARTS[type(item)] = tuple(one for one in slots if one not in ("span", "type"))
    return children(tuple(getattr(item, name) for name in names))


_PARTS: dict[type, tuple[str, ...]] = {}
_HOMES = frozenset((Assignment.__module__, Constant.__module__))
"""Where nodes are defined; variables, blocks and types, which nodes name, are elsewhere."""


def inside(value: Expression) -> Expression:
    """An expression without changes of type around it."""
    while isinstance(value, Convert):
        value = value.operand
    return value


def operands(value: Expression) -> tuple[Expression, ...]:
    """What a value is put together from bit by bit; empty for what is no such value."""
    value = inside(value)
    if isinstance(value, Binary) and value.operator in BITWISE:
        return value.left, value.right
    if isinstance(value, Unary) and value.operator == "NOT":
        return (value.operand,)
    return ()
