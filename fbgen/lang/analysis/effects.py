"""What expressions read and write: the places in them, calls, and comparisons.

`Effects` gathers over as many expressions as one step of a block evaluates; the paths through the
block (`flow`) take them from there. A node that is not known here is looked at generically, and
every place in it counts as touched: read or written, nobody knows.
"""

from typing import Any, TypeAlias

from fbgen.lang.checked import (
    AddressRef,
    Attempt,
    Binary,
    Constant,
    Convert,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    MemoryRef,
    Place,
    SliceRef,
    StandardCall,
    SystemCall,
    Unary,
    Variable,
    VariableRef,
)
from fbgen.lang.types import BlockType, Elementary, Family

_COMPARISONS = frozenset(("=", "<>", "<", ">", "<=", ">="))
_PLACES = (VariableRef, FieldRef, IndexRef, SliceRef, AddressRef)
PlaceKey: TypeAlias = Variable | tuple[object, ...]


class Effects:
    """What was evaluated since the last `clear`, in the order of evaluation.

    `reads` are the variables whose value is used. `writes` are places that get a value. `touched`
    are variables handed to something that may read or write them. `members` are the variables of
    instances that are read from outside. `divisions` are divisions of whole numbers whose quotient
    becomes a REAL by itself. `outside`: a value comes from an address or a call, so it
    may be another one the next time.
    """

    __slots__ = ("comparisons", "divisions", "members", "outside", "reads", "touched", "writes")

    def __init__(self) -> None:
        self.reads: list[VariableRef] = []
        self.writes: list[Place] = []
        self.touched: list[VariableRef] = []
        self.members: list[FieldRef] = []
        self.comparisons: list[Binary] = []
        self.divisions: list[Binary] = []
        self.outside = False

    def clear(self) -> None:
        """Forget everything."""
        self.reads.clear()
        self.writes.clear()
        self.touched.clear()
        self.members.clear()
        self.comparisons.clear()
        self.divisions.clear()
        self.outside = False

    def value(self, expression: Expression) -> None:
        """The expression is evaluated."""
        pending: list[Any] = [expression]
        while pending:
            node = pending.pop()
            kind = type(node)
            if kind is VariableRef:
                self.reads.append(node)
            elif kind is Constant:
                pass
            elif kind is Binary:
                pending += (node.right, node.left)
                if node.operator in _COMPARISONS:
                    self.comparisons.append(node)
            elif kind is Convert:
                inner = node.operand
                pending.append(inner)
                if node.implicit and type(inner) is Binary and _cuts(node, inner):
                    self.divisions.append(inner)
            elif kind is Unary:
                pending.append(node.operand)
            elif kind is FieldRef:
                pending.append(node.base)
                if type(node.base.type) is BlockType:
                    self.members.append(node)
            elif kind is IndexRef:
                pending += reversed(node.indices)
                pending.append(node.base)
            elif kind is SliceRef:
                pending.append(node.base)
            elif kind is StandardCall:
                pending += reversed(node.arguments)
            elif kind is FunctionCall:
                self.outside = True
                self.arguments(node)
            elif kind is AddressRef:
                self.outside = True
            elif kind is MemoryRef:
                self.outside = True
                pending += (part for part in _where(node) if part is not None)
            elif kind is Attempt:
                pending.append(node.operand)
                self.writes.append(node.flag)
            else:
                self.outside = True
                self._unknown(node)

    def arguments(self, call: Any) -> None:
        """The arguments of a call of a function or an instance."""
        for _, given in call.inputs:
            self.value(given)
        for _, place in call.in_outs:
            self.unknown_use(place)
        for _, place in call.outputs:
            self.target(place)

    def target(self, place: Place) -> None:
        """The place gets a value; the indices on the way to it are evaluated."""
        self.writes.append(place)
        self._way(place)

    def unknown_use(self, place: Place) -> None:
        """The place is handed over to be read or written."""
        self.writes.append(place)
        root = self._way(place)
        if root is not None:
            self.touched.append(root)

    def _way(self, place: Place) -> VariableRef | None:
        """Evaluates what leads to a place; the reference it begins with."""
        node: Any = place
        while True:
            kind = type(node)
            if kind is IndexRef:
                for index in node.indices:
                    self.value(index)
            elif kind is MemoryRef:
                for part in _where(node):
                    if part is not None:
                        self.value(part)
                return None
            elif kind is VariableRef:
                return node  # type: ignore[no-any-return]  # told apart by its exact type
            elif kind is not FieldRef and kind is not SliceRef:
                if kind is not AddressRef:
                    self._unknown(node)
                return None
            node = node.base

    def _unknown(self, node: Any) -> None:
        if isinstance(node, SystemCall):
            parts: list[Any] = [value for _, value in node.arguments]
        else:
            parts = [getattr(node, name) for name in _slots(type(node))]
        pending = parts
        while pending:
            part = pending.pop()
            if isinstance(part, tuple | list):
                pending += part
            elif isinstance(part, _PLACES):
                self.unknown_use(part)
            elif type(part) in _EXPRESSIONS:
                self.value(part)
            elif hasattr(part, "span") and not isinstance(part, Variable):
                self._unknown(part)


def _where(node: MemoryRef) -> tuple[Expression | None, ...]:
    return node.area, node.db, node.byte, node.bit


def _cuts(conversion: Convert, operand: Binary) -> bool:
    """True if a REAL gets a quotient of whole numbers."""
    source, target = operand.type, conversion.type
    return (
        operand.operator == "/"
        and isinstance(source, Elementary)
        and source.is_integer
        and isinstance(target, Elementary)
        and target.family is Family.REAL
    )


_EXPRESSIONS = frozenset((Binary, Convert, Unary, StandardCall, FunctionCall, SystemCall))
_NOT_PARTS = frozenset(("span", "type", "syntax", "block", "function"))


def _slots(kind: type) -> tuple[str, ...]:
    slots = getattr(kind, "__slots__", ())
    return tuple(name for name in slots if name not in _NOT_PARTS)


def root_of(place: Expression) -> Variable | None:
    """The variable that a place is a part of; None for addresses and references."""
    node: Any = place
    while isinstance(node, FieldRef | IndexRef | SliceRef):
        node = node.base
    return node.variable if isinstance(node, VariableRef) else None


def key_of(place: Expression) -> PlaceKey | None:
    """Equal for two places that are always the same; None where an index is not constant."""
    if isinstance(place, VariableRef):
        return place.variable
    if isinstance(place, FieldRef):
        base = key_of(place.base)
        return None if base is None else (base, place.name)
    if isinstance(place, IndexRef):
        base = key_of(place.base)
        if base is None or not all(isinstance(index, Constant) for index in place.indices):
            return None
        return (base, *(index.value for index in place.indices if isinstance(index, Constant)))
    if isinstance(place, SliceRef):
        base = key_of(place.base)
        return None if base is None else (base, "%", place.type, place.index)
    return None


def same_value(left: Expression, right: Expression) -> bool:
    """True if both are the same place or calculation without calls, so always equal."""
    pending: list[tuple[Any, Any]] = [(left, right)]
    while pending:
        one, other = pending.pop()
        kind = type(one)
        if kind is not type(other):
            return False
        if kind is VariableRef:
            if one.variable is not other.variable:
                return False
        elif kind is Constant:
            if one.value != other.value or one.type != other.type:
                return False
        elif kind is FieldRef:
            if one.name != other.name:
                return False
            pending.append((one.base, other.base))
        elif kind is IndexRef:
            pending += zip(one.indices, other.indices, strict=False)
            pending.append((one.base, other.base))
        elif kind is SliceRef:
            if one.index != other.index or one.type != other.type:
                return False
            pending.append((one.base, other.base))
        elif kind is Binary:
            if one.operator != other.operator:
                return False
            pending += ((one.left, other.left), (one.right, other.right))
        elif kind is Unary:
            if one.operator != other.operator:
                return False
            pending.append((one.operand, other.operand))
        elif kind is Convert:
            if one.type != other.type or one.rounding != other.rounding:
                return False
            pending.append((one.operand, other.operand))
        else:
            return False
    return True
