"""Structured parameters that a block hands on to another block, which S7-300 and S7-400 do not do.

There a structured in-out is a pointer into the data of whoever calls, and a block cannot hand that
pointer on; a function cannot hand on any structured parameter of its own. So the value goes through
a copy in the block's own data: `copy := drive; other(drive := copy); drive := copy;`.
Source: STEP 7 V5.5 manual, "Permitted Data Types when Transferring Parameters" (in-out to in-out:
elementary types only); recalled, not at hand. See docs/decisions/0019.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import (
    Argument,
    ArraySpec,
    Assignment,
    Block,
    BlockKind,
    Call,
    CallStatement,
    Declaration,
    DeclaredName,
    Expression,
    File,
    Index,
    Member,
    Name,
    NamedType,
    Parenthesized,
    Statement,
    StringSpec,
    StructSpec,
    Trivia,
    TriviaKind,
    TypeSpec,
    VarSection,
)
from fbgen.lang.lowering.plant import BlockScope, PlantText
from fbgen.lang.rewriting import Rewriter, Rule, replaced, rewritten, with_leading

_LARGE = frozenset({"DT", "DATE_AND_TIME", "DTL", "LDT", "STRING", "WSTRING"})
_OF_BLOCKS = frozenset({"VAR_IN_OUT"})
_OF_FUNCTIONS = frozenset({"VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT"})
_WHY = "// goes to another block in the place of a structured parameter"


def with_copies(files: Sequence[File]) -> list[File]:
    """The files, of dialect `tia`, in which no block hands a structured parameter on."""
    plant = PlantText(files)
    return rewritten(files, "tia", lambda unit: _HandedOn(plant, unit))


class _HandedOn(Rewriter):
    """Rewrites one unit."""

    def __init__(self, plant: PlantText, unit: object) -> None:
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else None
        self._parameters = _structured(self._scope) if self._scope else frozenset()
        self._copies: dict[tuple[str, int], Declaration] = {}

    def _block(self, node: Block) -> Block:
        block: Block = self.inside(node)
        if not self._copies:
            return block
        keyword = "VAR_TEMP" if block.kind is BlockKind.FUNCTION else "VAR"
        return replaced(block, sections=_with(block, keyword, tuple(self._copies.values())))

    def _call_statement(self, node: CallStatement) -> object:
        return self._around(node, node.call)

    def _assignment(self, node: Assignment) -> object:
        return self._around(node, node.value) if isinstance(node.value, Call) else node

    def _around(self, node: CallStatement | Assignment, call: Call) -> object:
        """The statement with what is copied before and behind it."""
        before: list[Statement] = []
        behind: list[Statement] = []
        arguments: list[Argument] = []
        used: dict[str, int] = {}
        formal = self._formal(call.callee)
        for argument in call.arguments:
            keyword = formal.get(argument.name.casefold(), "")
            place = argument.value
            kind = self._handed_on(place) if keyword else None
            if kind is None or place is None:
                arguments.append(argument)
                continue
            copy = self._copy(argument, kind, used)
            if keyword != "VAR_OUTPUT":
                before.append(Assignment(argument.span, copy, ":=", place))
            if keyword != "VAR_INPUT":
                behind.append(Assignment(argument.span, place, ":=", copy))
            arguments.append(replaced(argument, value=copy))
        if not (before or behind):
            return node
        calling = replaced(call, arguments=tuple(arguments))
        part = "call" if isinstance(node, CallStatement) else "value"
        itself: Statement = replaced(node, **{part: calling})
        if before:
            before[0] = with_leading(before[0], node.leading)
            itself = with_leading(itself, ())
        return (*before, itself, *behind)

    def _formal(self, callee: Expression) -> dict[str, str]:
        """The section of each parameter of a user's block, by casefolded name."""
        block = self._scope.block_called(callee) if self._scope else None
        return {
            declared.name.casefold(): section.keyword
            for section in (block.sections if block else ())
            if section.keyword in _OF_FUNCTIONS
            for declaration in section.declarations
            for declared in declaration.names
        }

    def _handed_on(self, place: Expression | None) -> TypeSpec | None:
        """The type of a structured parameter of this block, or of a structured part of one."""
        root = place
        while isinstance(root, Member | Index | Parenthesized):
            root = root.inner if isinstance(root, Parenthesized) else root.base
        if self._scope is None or place is None or not isinstance(root, Name):
            return None
        if not self._scope.is_declared(root) or root.name.casefold() not in self._parameters:
            return None
        kind = self._scope.type_of(place)
        return kind if kind is not None and _is_structured(self._scope, kind) else None

    def _copy(self, argument: Argument, kind: TypeSpec, used: dict[str, int]) -> Name:
        """The variable through which a value of this type goes in this call."""
        text = " ".join(kind.span.text.split()).casefold()
        used[text] = used.get(text, 0) + 1
        key = (text, used[text])
        if key not in self._copies:
            name = DeclaredName(argument.span, self._free_name(argument.name))
            why = Trivia(argument.span, TriviaKind.LINE_COMMENT, _WHY)
            self._copies[key] = Declaration(argument.span, (name,), kind, None, trailing=why)
        return Name(argument.span, self._copies[key].names[0].name, local=True)

    def _free_name(self, parameter: str) -> str:
        wish = f"copy{parameter[:1].upper()}{parameter[1:]}"
        taken = {one.names[0].name.casefold() for one in self._copies.values()}
        taken |= self._scope.declared.keys() if self._scope else set()
        name, number = wish, 2
        while name.casefold() in taken:
            name, number = f"{wish}{number}", number + 1
        return name

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _block,
        CallStatement: _call_statement,
        Assignment: _assignment,
    }


def _with(block: Block, keyword: str, copies: tuple[Declaration, ...]) -> tuple[VarSection, ...]:
    """The sections of a block with these at the end of the last one of that kind."""
    sections = list(block.sections)
    ends = [number for number, one in enumerate(sections) if _is_plain(one, keyword)]
    if ends:
        last = sections[ends[-1]]
        sections[ends[-1]] = replaced(last, declarations=(*last.declarations, *copies))
        return tuple(sections)
    temporary = [number for number, one in enumerate(sections) if _is_plain(one, "VAR_TEMP")]
    place = temporary[0] if temporary else len(sections)
    sections.insert(place, VarSection(block.span, keyword, (), copies))
    return tuple(sections)


def _is_plain(section: VarSection, keyword: str) -> bool:
    return section.keyword == keyword and not section.qualifiers


def _structured(scope: BlockScope) -> frozenset[str]:
    """The structured parameters of a block that it must not hand on, by casefolded name."""
    block = scope.block
    sections = _OF_FUNCTIONS if block.kind is BlockKind.FUNCTION else _OF_BLOCKS
    return frozenset(
        declared.name.casefold()
        for section in block.sections
        if section.keyword in sections
        for declaration in section.declarations
        if _is_structured(scope, declaration.type)
        for declared in declaration.names
    )


def _is_structured(scope: BlockScope, kind: TypeSpec) -> bool:
    resolved = scope.resolved(kind)
    if isinstance(resolved, ArraySpec):
        return all(bounds.first is not None for bounds in resolved.bounds)
    if isinstance(resolved, StructSpec | StringSpec):
        return True
    return isinstance(resolved, NamedType) and resolved.name.upper() in _LARGE
