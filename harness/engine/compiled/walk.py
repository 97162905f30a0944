"""Every node of a checked tree, without recursion: trees may be very deep."""

from collections.abc import Iterable, Iterator
from typing import TypeAlias

from fbgen.lang.checked import (
    AddressRef,
    Assignment,
    Binary,
    Branch,
    Case,
    CaseArm,
    Convert,
    Evaluate,
    Expression,
    FieldRef,
    For,
    FunctionCall,
    If,
    IndexRef,
    InstanceCall,
    Place,
    Repeat,
    SliceRef,
    StandardCall,
    Statement,
    SystemCall,
    Unary,
    Variable,
    VariableRef,
    While,
)
from harness.engine.compiled.instructions import areas

Node: TypeAlias = Expression | Statement | Branch | CaseArm


def _arguments(call: FunctionCall | InstanceCall) -> list[Node]:
    pairs = (*call.inputs, *call.in_outs, *call.outputs)
    return [expression for _, expression in pairs]


def children(node: Node) -> Iterable[Node]:
    """The nodes directly inside a node."""
    match node:
        case Assignment():
            return (node.target, node.value)
        case Binary():
            return (node.left, node.right)
        case Unary() | Convert():
            return (node.operand,)
        case FieldRef() | SliceRef():
            return (node.base,)
        case IndexRef():
            return (node.base, *node.indices)
        case StandardCall():
            return node.arguments
        case FunctionCall():
            return _arguments(node)
        case SystemCall():
            return [expression for _, expression in node.arguments]
        case InstanceCall():
            return [node.instance, *_arguments(node)]
        case Evaluate():
            return (node.call,)
        case Branch():
            return (node.condition, *node.body)
        case CaseArm():
            return node.body
        case If():
            return (*node.branches, *node.otherwise)
        case Case():
            return (node.selector, *node.arms, *node.otherwise)
        case For():
            return (node.variable, node.first, node.last, node.step, *node.body)
        case While() | Repeat():
            return (node.condition, *node.body)
        case _:
            return ()


def every_node(roots: Iterable[Node]) -> Iterator[Node]:
    """All nodes in and under `roots`, in no particular order."""
    stack = list(roots)
    while stack:
        node = stack.pop()
        yield node
        stack.extend(children(node))


def root_of(place: Place) -> Variable | None:
    """The variable that a place is a part of; None for an absolute address."""
    while not isinstance(place, VariableRef):
        if isinstance(place, AddressRef):
            return None
        place = place.base
    return place.variable


def written_places(node: Node) -> list[Place]:
    """The places that a node itself writes, or hands on to be written."""
    match node:
        case Assignment():
            return [node.target]
        case For():
            return [node.variable]
        case FunctionCall():
            return [place for _, place in (*node.in_outs, *node.outputs)]
        case InstanceCall():
            return [node.instance, *(place for _, place in (*node.in_outs, *node.outputs))]
        case SystemCall():
            return list(areas(node).values())
        case _:
            return []
