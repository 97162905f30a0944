"""INTERFACE: what blocks promise to have, who keeps the promise, and variables of such a type.

A variable of an interface type is a reference to any instance whose block implements it. The
methods of an interface are blocks without statements; a call of one means the method of the block
that the instance has.
Sources: IEC 61131-3 third edition, section 6.6.6; CODESYS online help, "Object Interface",
"Implementing interfaces".
"""

from dataclasses import replace
from typing import TYPE_CHECKING

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    Block,
    Dereference,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    Place,
    ReferenceTo,
    VariableRef,
)
from fbgen.lang.types import INTERFACE, BlockType, ReferenceType

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library


_REFERRING = VariableRef | FieldRef | IndexRef | Dereference | FunctionCall
"""What can have a value of an interface type."""


class ObjectInterfaces:
    """The interfaces of a program."""

    def __init__(self, library: "Library") -> None:
        self._library = library
        self._nodes: dict[str, ast.Interface] = {}
        self._blocks: dict[ast.Interface, Block] = {}
        self._parents: dict[ast.Interface, list[ast.Interface]] = {}
        self._own: dict[Block, list[ast.Interface]] = {}

    def declare(self, node: ast.Interface) -> None:
        """Make an INTERFACE of the text known."""
        self._nodes[node.name.name.casefold()] = node

    def find(self, name: str) -> ast.Interface | None:
        """The INTERFACE with that name."""
        return self._nodes.get(name.casefold())

    def blocks(self) -> list[Block]:
        """What stands for each interface where an owner of methods is asked for."""
        return [self.block(node) for node in self._nodes.values()]

    def block(self, node: ast.Interface) -> Block:
        """A block without variables that has the methods of the interface."""
        if node not in self._blocks:
            syntax = ast.Block(
                *(node.span, BlockKind.CLASS, node.name, None, (), (), ()),
                modifiers=("ABSTRACT",),
                members=node.members,
            )
            block = Block(node.span, node.name.name, BlockKind.CLASS, (), None, syntax)
            self._library.add_interface(block)
            self._blocks[node] = block
        return self._blocks[node]

    def node_of(self, block: Block) -> ast.Interface | None:
        """The interface that a block stands for; None for real blocks."""
        return next((node for node, one in self._blocks.items() if one is block), None)

    # --- types ----------------------------------------------------------------------------------

    def type_of(self, node: ast.Interface) -> ReferenceType:
        """The type of variables of an interface."""
        target = self._library.instance_type(self.block(node))
        return ReferenceType(INTERFACE, node.name.name, lambda: target)

    def value_of(self, expression: Expression, target: ReferenceType) -> Expression | None:
        """An instance, or a value of a narrower interface, as one of an interface type.

        None if it does not implement the interface, or is something else.
        """
        wanted = self.find(target.target_name)
        kind = expression.type
        if wanted is None:
            return None
        if isinstance(kind, BlockType) and isinstance(expression, Place):
            block = self._library.user_block(kind.name)
            if block is None or wanted not in self.of_block(block):
                return None
            return ReferenceTo(expression.span, expression, target)
        if isinstance(kind, ReferenceType) and kind.is_interface:
            given = self.find(kind.target_name)
            is_wider = given is not None and wanted in self.with_parents([given])
            if is_wider and isinstance(expression, _REFERRING):
                return replace(expression, type=target)
        return None

    def asked(self, place: Expression) -> tuple[Dereference, Block] | None:
        """The instance behind a variable of an interface type; None for any other expression."""
        kind = place.type
        if not isinstance(kind, ReferenceType) or not kind.is_interface:
            return None
        node = self.find(kind.target_name)
        if node is None or not isinstance(place, Place):
            return None
        return Dereference(place.span, place, kind.target), self.block(node)

    # --- who implements what ----------------------------------------------------------------------

    def parents(self, node: ast.Interface) -> list[ast.Interface]:
        """The interfaces that an interface extends itself."""
        if node not in self._parents:
            self._parents[node] = self._named(node.extends)
        return self._parents[node]

    def with_parents(self, nodes: list[ast.Interface]) -> list[ast.Interface]:
        """Some interfaces, and all that they extend."""
        found: list[ast.Interface] = []
        waiting = list(nodes)
        while waiting:
            node = waiting.pop(0)
            if node not in found:
                found.append(node)
                waiting += self.parents(node)
        return found

    def of_block(self, block: Block) -> list[ast.Interface]:
        """All interfaces of a block and its bases."""
        found: list[ast.Interface] = []
        step: Block | None = block
        while step is not None:
            if step not in self._own:
                self._own[step] = self._named(step.syntax.implements)
            found += self._own[step]
            step = self._library.objects.base_of(step)
        return self.with_parents(found)

    def implementers(self, node: ast.Interface) -> list[Block]:
        """The blocks whose instances a variable of the interface type can refer to."""
        return [
            block
            for block in self._library.own_blocks()
            if "ABSTRACT" not in block.syntax.modifiers and node in self.of_block(block)
        ]

    def _named(self, names: tuple[ast.NamedType, ...]) -> list[ast.Interface]:
        found = []
        for named in names:
            interface = self.find(named.name)
            if interface is not None:
                found.append(interface)
                continue
            self._library.types.report_unknown(named.name, named.span)
        return found
