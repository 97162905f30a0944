"""Every node of a checked tree, without recursion: trees may be very deep."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import Any, TypeAlias

from fbgen.lang.checked import (
    AddressRef,
    Assignment,
    Attempt,
    Binary,
    BoundOf,
    Branch,
    Case,
    CaseArm,
    Convert,
    Dereference,
    ElementCount,
    Evaluate,
    Expression,
    FieldRef,
    For,
    FunctionCall,
    Guarded,
    If,
    IndexRef,
    InstanceCall,
    MemoryRef,
    Place,
    ReferenceTo,
    Repeat,
    RoutineCall,
    SameReference,
    SameTypes,
    SliceRef,
    StandardCall,
    Statement,
    Substituted,
    SystemCall,
    TakenError,
    Try,
    TypeTest,
    Unary,
    Variable,
    VariableRef,
    While,
)
from harness.engine.compiled.statements.instructions import areas

Node: TypeAlias = Expression | Statement | Branch | CaseArm


def _arguments(call: FunctionCall | InstanceCall) -> list[Node]:
    pairs = (*call.inputs, *call.in_outs, *call.outputs)
    return [expression for _, expression in pairs]


_CHILDREN: dict[type, Callable[[Any], Iterable[Node]]] = {
    Assignment: lambda node: (node.target, node.value),
    Binary: lambda node: (node.left, node.right),
    Unary: lambda node: (node.operand,),
    Convert: lambda node: (node.operand,),
    FieldRef: lambda node: (node.base,),
    SliceRef: lambda node: (node.base,),
    IndexRef: lambda node: (node.base, *node.indices),
    MemoryRef: lambda node: [
        one for one in (node.area, node.db, node.byte, node.bit) if one is not None
    ],
    BoundOf: lambda node: (node.base,),
    Dereference: lambda node: (node.base,),
    ReferenceTo: lambda node: () if node.place is None else (node.place,),
    TypeTest: lambda node: (node.variant,),
    SameTypes: lambda node: (node.left, node.right),
    ElementCount: lambda node: (node.variant,),
    SameReference: lambda node: (node.left, node.right),
    StandardCall: lambda node: node.arguments,
    FunctionCall: _arguments,
    SystemCall: lambda node: [expression for _, expression in node.arguments],
    RoutineCall: lambda node: [
        *([] if node.instance is None else [node.instance]),
        *(expression for _, expression in (*node.inputs, *node.outputs)),
    ],
    InstanceCall: lambda node: [node.instance, *_arguments(node)],
    Attempt: lambda node: (node.operand, node.flag),
    Substituted: lambda node: (node.place, node.memory),
    TakenError: lambda node: (node.memory,),
    Guarded: lambda node: (node.statement, node.memory),
    Evaluate: lambda node: (node.call,),
    Branch: lambda node: (node.condition, *node.body),
    CaseArm: lambda node: node.body,
    If: lambda node: (*node.branches, *node.otherwise),
    Case: lambda node: (node.selector, *node.arms, *node.otherwise),
    For: lambda node: (node.variable, node.first, node.last, node.step, *node.body),
    While: lambda node: (node.condition, *node.body),
    Repeat: lambda node: (node.condition, *node.body),
    Try: lambda node: [
        *node.body,
        *([] if node.exception is None else [node.exception]),
        *node.catch,
        *node.final,
    ],
}
"""By type, because trees are walked several times; nodes that are not here have no children."""


def children(node: Node) -> Iterable[Node]:
    """The nodes directly inside a node."""
    inner = _CHILDREN.get(type(node))
    return inner(node) if inner is not None else ()


def every_node(roots: Iterable[Node]) -> Iterator[Node]:
    """All nodes in and under `roots`, in no particular order."""
    stack = list(roots)
    while stack:
        node = stack.pop()
        yield node
        inner = _CHILDREN.get(type(node))
        if inner is not None:
            stack.extend(inner(node))


def nodes_of(kinds: Collection[type], roots: Iterable[Node]) -> Iterator[Any]:
    """All nodes of some types in and under `roots`: faster than to look at each of `every_node`."""
    stack = list(roots)
    while stack:
        node = stack.pop()
        kind = type(node)
        if kind in kinds:
            yield node
        inner = _CHILDREN.get(kind)
        if inner is not None:
            stack.extend(inner(node))


def root_of(place: Place) -> Variable | None:
    """The variable that a place is a part of.

    None for an absolute address, and behind a reference.
    """
    while not isinstance(place, VariableRef):
        if isinstance(place, AddressRef | MemoryRef | Dereference):
            return None
        place = place.base
    return place.variable


_WRITTEN: dict[type, Callable[[Any], list[Place]]] = {
    Assignment: lambda node: [node.target],
    For: lambda node: [node.variable],
    FunctionCall: lambda node: [place for _, place in (*node.in_outs, *node.outputs)],
    InstanceCall: lambda node: [
        node.instance,
        *(place for _, place in (*node.in_outs, *node.outputs)),
    ],
    RoutineCall: lambda node: [
        *([] if node.instance is None else [node.instance]),
        *(place for _, place in node.outputs),
    ],
    SystemCall: lambda node: list(areas(node).values()),
    Attempt: lambda node: [node.flag],
    **dict.fromkeys((Substituted, TakenError, Guarded), lambda node: [node.memory]),
    Try: lambda node: [] if node.exception is None else [node.exception],
}


WRITING = frozenset(_WRITTEN)
"""The nodes that write anything."""


def written_places(node: Node) -> Sequence[Place]:
    """The places that a node itself writes, or hands on to be written."""
    written = _WRITTEN.get(type(node))
    return written(node) if written is not None else ()
