"""What blocks have besides variables and a body: methods, properties, actions, and a base block.

A method becomes a FUNCTION whose first in-out, THIS, is the instance; the two sides of a property
are methods; an action is a block with the variables of its own one. A derived block has the
variables of its base in front of its own, and its methods unless it overrides them.
Sources: IEC 61131-3 third edition, sections 6.6.5 to 6.6.8; CODESYS online help, "Object METHOD",
"Object PROPERTY", "Object ACTION", "Extending function blocks".
"""

from collections.abc import Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, BlockMembers, Variable, VariableKind
from fbgen.lang.checked.variables import RECEIVER
from fbgen.lang.checker.declared.object_interfaces import ObjectInterfaces
from fbgen.lang.life_cycle import LIFE_CYCLE
from fbgen.lang.types import BlockType
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

_WITH_MEMBERS = (BlockKind.FUNCTION_BLOCK, BlockKind.PROGRAM)
"""Derived blocks may give them more parameters."""
_INHERITED = (*(VariableKind.INPUT, VariableKind.OUTPUT, VariableKind.IN_OUT, VariableKind.STATIC),)


@dataclass(frozen=True, slots=True, eq=False)
class Method:
    """A method as the block `owner` has written it; `block` is its code."""

    name: str
    span: Span
    owner: Block
    block: Block
    modifiers: tuple[str, ...]

    @property
    def is_abstract(self) -> bool:
        """True if derived blocks have to write it."""
        return "ABSTRACT" in self.modifiers


@dataclass(slots=True)
class Members:
    """What a block has, its bases included; by casefolded name."""

    methods: dict[str, Method] = field(default_factory=dict)
    getters: dict[str, Method] = field(default_factory=dict)
    setters: dict[str, Method] = field(default_factory=dict)
    actions: dict[str, Block] = field(default_factory=dict)

    def copy(self) -> "Members":
        """The same members in mappings of their own."""
        return Members(
            dict(self.methods), dict(self.getters), dict(self.setters), dict(self.actions)
        )

    def tables(self) -> tuple[dict[str, Method], dict[str, Method], dict[str, Method]]:
        """Methods, GETs and SETs."""
        return self.methods, self.getters, self.setters

    def names(self) -> list[str]:
        """All names as written, for a help text."""
        return [one.name for one in (*self.methods.values(), *self.getters.values())]


class Objects:
    """The members of the blocks of a program, found when somebody asks."""

    def __init__(self, library: "Library") -> None:
        self._library = library
        self._members: dict[Block, Members] = {}
        self._bases: dict[Block, Block] = {}
        self._instances: dict[Block, Variable] = {}
        self._written: dict[str, Block] = {}
        self._promises: set[Block] = set()
        self._partial: set[str] = set()
        self.interfaces = ObjectInterfaces(library)

    @property
    def are_used(self) -> bool:
        """True if any block of the program has members or a base."""
        return self._library.has_members

    # --- what has to be there -----------------------------------------------------------------

    def check_blocks(self) -> None:
        """Compare all blocks with what their interfaces and bases want of them."""
        for block in self._library.own_blocks():
            if block.kind in _WITH_MEMBERS and "ABSTRACT" not in block.syntax.modifiers:
                self._check_complete(block)

    def _check_complete(self, block: Block) -> None:
        if self.is_partial(block):
            return
        members = self.members_of(block)
        missing = [
            (method.name, f"{method.owner.name} has it as ABSTRACT")
            for table in members.tables()
            for method in table.values()
            if method.is_abstract
        ]
        for interface in self.interfaces.of_block(block):
            wanted = self.members_of(self.interfaces.block(interface))
            for promised, table in zip(wanted.tables(), members.tables(), strict=True):
                for key, method in promised.items():
                    if key not in table:
                        missing.append((method.name, f"{interface.name.name} has it"))
                    else:
                        self._check_promise(interface, method, table[key], block)
            for member in interface.members:
                key = member.name.name.casefold()
                known = key in members.getters or key in members.setters
                if isinstance(member, ast.Property) and not member.accessors and not known:
                    missing.append((member.name.name, f"{interface.name.name} has it"))
        for name, why in dict(missing).items():
            self._library.findings.error(
                "FB4088",
                f"{block.name} lacks '{name}': {why}",
                block.syntax.name.span,
                f"write METHOD {name} (or PROPERTY), or make {block.name} ABSTRACT",
            )

    def _check_promise(
        self, interface: ast.Interface, promised: Method, kept: Method, block: Block
    ) -> None:
        if kept.is_abstract or _shape(promised.block) == _shape(kept.block):
            return
        own = kept.owner is block
        self._library.findings.error(
            "FB4086",
            f"'{kept.name}' of {block.name} has other parameters than {interface.name.name} says",
            kept.span if own else block.syntax.name.span,
            "give it the same parameters in the same order, and the same result",
            (Note("the interface says this", promised.span),),
        )

    # --- bases --------------------------------------------------------------------------------

    def base_of(self, block: Block) -> Block | None:
        """The block that a block extends."""
        return self._bases.get(block)

    def leave_open(self, node: ast.Block) -> None:
        """Say that a block has more than its text shows."""
        self._partial.add(node.name.name.casefold())

    def extend(self, block: Block, base: Block) -> None:
        """Say which block a block extends."""
        self._bases[block] = base

    def find_base(self, node: ast.Block) -> Block | None:
        """The block behind EXTENDS; None without one, and after reporting errors."""
        if node.extends is None:
            return None
        name = node.extends.name
        base = self._library.user_block(name)
        if base is None and not self._library.is_declared(name):
            self._library.types.report_unknown(name, node.extends.span)
            self._partial.add(node.name.name.casefold())
            return None
        if base is not None and self.is_partial(base):
            self._partial.add(node.name.name.casefold())
        if base is None or base.kind is not node.kind or base.kind not in _WITH_MEMBERS:
            self._library.findings.error(
                "FB4087",
                f"{node.name.name} cannot extend '{node.extends.name}'",
                node.extends.span,
                "a FUNCTION_BLOCK extends a FUNCTION_BLOCK of the same program",
            )
            return None
        if "FINAL" in base.syntax.modifiers:
            self._library.findings.error(
                "FB4087",
                f"{base.name} is FINAL and cannot be extended",
                node.extends.span,
                "remove FINAL, or put an instance of it into the block",
            )
        return base

    def is_partial(self, block: Block | None) -> bool:
        """True if some base of the block is in no file: it may have any variable and method."""
        return block is not None and block.name.casefold() in self._partial

    def is_open(self, block: Block) -> bool:
        """True for a block whose variables others see: it is extended, ABSTRACT, or its base is
        in no file.
        """
        is_abstract = "ABSTRACT" in block.syntax.modifiers
        return is_abstract or block in self._bases.values() or self.is_partial(block)

    def inherited(self, base: Block) -> list[Variable]:
        """The variables that a derived block has, too."""
        return [variable for variable in base.variables if variable.kind in _INHERITED]

    def is_kind_of(self, block: Block, other: Block) -> bool:
        """True if `block` is `other` or extends it, directly or over others."""
        step: Block | None = block
        while step is not None and step is not other:
            step = self._bases.get(step)
        return step is other

    def derived(self, block: Block) -> list[Block]:
        """All blocks that extend a block, and itself."""
        return [
            one
            for one in self._library.own_blocks()
            if one.kind is block.kind and self.is_kind_of(one, block)
        ]

    # --- members ------------------------------------------------------------------------------

    def instance_of(self, owner: Block) -> Variable:
        """The variable that means the instance in the body of a block."""
        if owner not in self._instances:
            kind = self._library.instance_type(owner)
            self._instances[owner] = Variable(owner.span, RECEIVER, VariableKind.THIS, kind)
        return self._instances[owner]

    def members_of(self, owner: Block) -> Members:
        """Everything that an instance of the block can be asked for."""
        if owner not in self._members:
            base = self._bases.get(owner)
            members = self.members_of(base).copy() if base is not None else Members()
            self._members[owner] = members
            interface = self.interfaces.node_of(owner)
            for parent in () if interface is None else self.interfaces.parents(interface):
                for own, table in zip(
                    members.tables(),
                    self.members_of(self.interfaces.block(parent)).tables(),
                    strict=True,
                ):
                    own.update(table)
            for node in owner.syntax.members:
                self._add(owner, members, node)
        return self._members[owner]

    def written_blocks(self) -> dict[str, Block]:
        """The methods, accessors and actions of all blocks, with their names."""
        for owner in (*self._library.own_blocks(), *self.interfaces.blocks()):
            self.members_of(owner)
        return self._written

    def members_by_name(self) -> dict[str, BlockMembers]:
        """The members of all blocks that have some, for whoever runs them."""
        found = {}
        for block in self._library.own_blocks():
            members = self.members_of(block)
            if any(members.tables()) or members.actions:
                methods, getters, setters = (
                    {key: method.block for key, method in table.items()}
                    for table in members.tables()
                )
                starts = self._library.starts.chain(block)
                name = block.name.casefold()
                found[name] = BlockMembers(methods, getters, setters, members.actions, starts)
        return found

    def is_promise(self, block: Block) -> bool:
        """True for the methods and accessors of an interface, which have no code."""
        return block in self._promises

    def _add(self, owner: Block, members: Members, node: ast.BlockMember) -> None:
        if isinstance(node, ast.Action):
            members.actions[node.name.name.casefold()] = self._action(owner, node)
        elif isinstance(node, ast.Method):
            self._enter(owner, members.methods, node.name, node.modifiers, self._of_method(node))
        else:
            for accessor in node.accessors:
                table = members.getters if accessor.keyword == "GET" else members.setters
                modifiers = (*node.modifiers, *accessor.modifiers)
                syntax = _of_accessor(node, accessor)
                self._enter(owner, table, node.name, modifiers, syntax)

    def _enter(
        self,
        owner: Block,
        table: dict[str, Method],
        name: ast.Name,
        modifiers: tuple[str, ...],
        syntax: ast.Block,
    ) -> None:
        key = name.name.casefold()
        overridden = table.get(key)
        if overridden is not None and overridden.owner is owner:
            self._library.duplicate(name.name, name.span, overridden.span)
            return
        block = self._method_block(owner, syntax)
        if self.interfaces.node_of(owner) is not None:
            self._promises.add(block)
        method = Method(name.name, name.span, owner, block, modifiers)
        if overridden is not None:
            self._check_override(method, overridden)
        table[key] = method

    def _method_block(self, owner: Block, syntax: ast.Block) -> Block:
        name = syntax.name.name
        kind = self._library.instance_type(owner)
        this = Variable(syntax.name.span, RECEIVER, VariableKind.IN_OUT, kind)
        block = self._library.member_block(owner, this, syntax)
        self._written[f"{owner.name}.{name}".casefold()] = block
        return block

    def _of_method(self, node: ast.Method) -> ast.Block:
        return _syntax(node, node.name, node.return_type, node.sections, node.body)

    def _action(self, owner: Block, node: ast.Action) -> Block:
        syntax = _syntax(node, node.name, None, (), node.body)
        name = f"{owner.name}.{node.name.name}"
        kind = BlockKind.FUNCTION_BLOCK
        block = Block(node.span, name, kind, owner.variables, None, syntax)
        self._library.share_context(owner, block)
        self._written[name.casefold()] = block
        return block

    def _check_override(self, method: Method, overridden: Method) -> None:
        message = ""
        if "FINAL" in overridden.modifiers:
            message = f"{overridden.owner.name}.{overridden.name} is FINAL"
        elif method.name.casefold() in LIFE_CYCLE:
            return
        elif _shape(method.block) != _shape(overridden.block):
            message = f"{overridden.owner.name}.{overridden.name} has other parameters"
        if message:
            self._library.findings.error(
                "FB4086",
                f"'{method.name}' cannot be overridden like this: {message}",
                method.span,
                "give it another name, or the same parameters in the same order",
            )

    def implementations(self, method: Method) -> tuple[tuple[str, Block], ...]:
        """What a call of a method can mean, by the block of the instance; () if it is only one.

        For a method of an interface these are all blocks that implement it, also if it is one only.
        """
        interface = self.interfaces.node_of(method.owner)
        if interface is not None:
            blocks = self.interfaces.implementers(interface)
        else:
            blocks = self.derived(method.owner)
        found = {}
        for block in blocks:
            for table in self.members_of(block).tables():
                one = table.get(method.name.casefold())
                if one is not None and _same_side(one, method):
                    found[block.name] = one.block
        return tuple(found.items()) if interface or len(set(found.values())) > 1 else ()

    def is_abstract(self, kind: BlockType) -> bool:
        """True if there can be no instance of the block itself."""
        block = self._library.user_block(kind.name)
        return block is not None and "ABSTRACT" in block.syntax.modifiers


def kept_sections(node: ast.Block) -> list[ast.VarSection]:
    """VAR_INST of the methods: variables of the instance, called `method.name`."""
    found = []
    for member in node.members:
        if not isinstance(member, ast.Method):
            continue
        for section in member.sections:
            if section.keyword == "VAR_INST":
                declarations = tuple(
                    replace(one, names=tuple(_inside(member, name) for name in one.names))
                    for one in section.declarations
                )
                found.append(replace(section, keyword="VAR", declarations=declarations))
    return found


def _inside(method: ast.Method, name: ast.DeclaredName) -> ast.DeclaredName:
    return replace(name, name=f"{method.name.name}.{name.name}")


def _same_side(one: Method, other: Method) -> bool:
    """True for two methods, two GETs or two SETs."""
    return one.block.name.rpartition(".")[2] == other.block.name.rpartition(".")[2]


def _shape(block: Block) -> list[object]:
    """What a caller of a method has to know, without the instance."""
    kinds = (VariableKind.INPUT, VariableKind.OUTPUT, VariableKind.IN_OUT, VariableKind.RESULT)
    return [
        (variable.kind, variable.type, variable.name.casefold())
        for variable in block.variables
        if variable.kind in kinds and variable.name != RECEIVER
    ]


def _syntax(
    node: ast.Method | ast.Action | ast.Accessor,
    name: ast.Name,
    result: ast.TypeSpec | None,
    sections: Sequence[ast.VarSection],
    body: tuple[ast.Statement, ...],
) -> ast.Block:
    return ast.Block(node.span, BlockKind.FUNCTION, name, result, (), tuple(sections), body)


def _of_accessor(node: ast.Property, accessor: ast.Accessor) -> ast.Block:
    """GET is a method with a result, SET one with an input; both are called like the property."""
    name = ast.Name(node.name.span, f"{node.name.name}.{accessor.keyword}")
    if accessor.keyword == "GET":
        return _syntax(accessor, name, node.type, accessor.sections, accessor.body)
    span = node.name.span
    declared = ast.DeclaredName(span, node.name.name)
    declaration = ast.Declaration(span, (declared,), node.type, None)
    section = ast.VarSection(span, "VAR_INPUT", (), (declaration,))
    return _syntax(accessor, name, None, (section, *accessor.sections), accessor.body)
