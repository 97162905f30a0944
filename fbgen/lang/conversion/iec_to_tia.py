"""From IEC 61131-3 and TwinCAT Structured Text to the SCL of TIA Portal.

Source: TIA Portal help, "SCL" and "Block interface": `#` and quotes, named arguments, temporary
variables without initial values, data blocks for global data. Objects (methods, interfaces,
inheritance) have no counterpart and are refused by name.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import (
    ArgumentKind,
    Assignment,
    Binary,
    Block,
    BlockKind,
    Branch,
    Call,
    Configuration,
    Declaration,
    DeclaredName,
    Dereference,
    DirectAddress,
    EnumSpec,
    Expression,
    File,
    Globals,
    If,
    Interface,
    Literal,
    LiteralKind,
    Member,
    Name,
    NamedType,
    Namespace,
    ReferenceSpec,
    Statement,
    StringSpec,
    SubrangeSpec,
    Trivia,
    TriviaKind,
    Try,
    TypeDeclaration,
    TypeSpec,
    UnionSpec,
    Unit,
    Using,
    VarSection,
)
from fbgen.lang.conversion.iec_program import GLOBALS, IecProgram, number
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.plant import BlockScope, PlantText
from fbgen.lang.lowering.spelling import S7_NAMES
from fbgen.lang.lowering.truth import same_truth
from fbgen.lang.rewriting import Rewriter, Rule, replaced
from fbgen.lang.standard_parameters import standard_with_names, with_names

_SET = {"S=": True, "R=": False}
_GONE = (Globals, Configuration)


def iec_to_tia(files: Sequence[File], findings: Findings) -> list[File]:
    """The same files in dialect tia; what belongs to all of them goes to the last one."""
    program = IecProgram(files, findings)
    plant = PlantText(files)
    result: list[File] = []
    for file in files:
        units: list[Unit] = []
        for unit in file.units:
            if isinstance(unit, _GONE) or unit in program.aliases.values():
                continue
            units.append(_IecToTia(program, plant, findings, unit).rewrite(unit))
        result.append(File(file.source, "tia", tuple(units), file.closing))
    shared = _IecToTia(program, plant, findings, None)
    declarations = [
        shared.rewrite(declaration)
        for section in program.sections
        for declaration in section.declarations
        if not isinstance(declaration.at, DirectAddress)
    ]
    last = result[-1]
    units = [*last.units, *program.new_units(declarations)]
    result[-1] = File(last.source, "tia", tuple(units), last.closing)
    return [file for file in result if file.units]


class _IecToTia(Rewriter):
    """Rewrites one unit."""

    def __init__(
        self, program: IecProgram, plant: PlantText, findings: Findings, unit: object
    ) -> None:
        self._program = program
        self._plant = plant
        self._findings = findings
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else None
        self._external: set[str] = set()
        if isinstance(unit, Block):
            self._external = {
                name.name.casefold()
                for section in unit.sections
                if section.keyword == "VAR_EXTERNAL"
                for declaration in section.declarations
                for name in declaration.names
            }
        self._in_function = isinstance(unit, Block) and unit.kind is BlockKind.FUNCTION

    # --- units --------------------------------------------------------------------------------

    def _block(self, node: Block) -> Block:
        for what, present in (
            ("EXTENDS", node.extends),
            ("IMPLEMENTS", node.implements),
            (", ".join(type(item).__name__.upper() for item in node.members), node.members),
            ("CLASS", node.kind is BlockKind.CLASS),
        ):
            if present:
                self._findings.refuse(
                    f"{what} of {node.name.name}",
                    node.name.span,
                    "write a FUNCTION_BLOCK without objects",
                )
        starts = self._start_values(node.sections)
        block: Block = self.inside(node)
        sections = tuple(item for item in block.sections if item.keyword != "VAR_EXTERNAL")
        kind = BlockKind.FUNCTION_BLOCK if node.kind is BlockKind.PROGRAM else node.kind
        result = block.return_type
        if self._in_function and result is None:
            result = NamedType(node.name.span, "Void")
        return replaced(
            block,
            kind=kind,
            name=Name(node.name.span, node.name.name, True),
            return_type=result,
            modifiers=(),
            sections=sections,
            body=(*starts, *block.body),
        )

    def _start_values(self, sections: tuple[VarSection, ...]) -> tuple[Statement, ...]:
        """What temporary variables begin with: TIA wants statements for it."""
        starts: list[Statement] = []
        for section in sections:
            if not self._is_temporary(section) or "CONSTANT" in section.qualifiers:
                continue
            for node in section.declarations:
                if node.initial is None:
                    continue
                value = self.rewrite(node.initial)
                starts += (
                    Assignment(node.span, Name(name.span, name.name, False, True), ":=", value)
                    for name in node.names
                )
        return tuple(starts)

    def _is_temporary(self, section: VarSection) -> bool:
        return section.keyword == "VAR_TEMP" or (self._in_function and section.keyword == "VAR")

    def _section(self, node: VarSection) -> VarSection:
        section: VarSection = self.inside(node)
        if section.keyword in ("VAR_STAT", "VAR_INST"):
            self._findings.refuse(section.keyword, node.span, "write VAR in a FUNCTION_BLOCK")
        kept = tuple(item for item in section.qualifiers if item in ("CONSTANT", "RETAIN"))
        if not self._is_temporary(node) or "CONSTANT" in kept:
            return replaced(section, qualifiers=kept)
        declarations = tuple(replaced(item, initial=None) for item in section.declarations)
        return replaced(section, keyword="VAR_TEMP", qualifiers=(), declarations=declarations)

    def _declaration(self, node: Declaration) -> Declaration:
        if isinstance(node.at, DirectAddress) and self._scope is not None:
            return replaced(self.inside(node), at=None)
        if node.initial is None and (default := self._program.default(node.type)) is not None:
            node = replaced(node, initial=default)
        if node.arguments:
            self._findings.refuse("an argument of FB_init", node.span, "set the input in a call")
        declaration: Declaration = self.inside(node)
        return declaration

    def _declared(self, node: DeclaredName) -> DeclaredName:
        return DeclaredName(node.span, node.name, node.quoted) if node.attributes else node

    def _type_declaration(self, node: TypeDeclaration) -> TypeDeclaration:
        declaration: TypeDeclaration = self.inside(node)
        if node.extends is not None:
            self._findings.refuse("EXTENDS of a structure", node.span, "repeat its fields")
        name = Name(node.name.span, node.name.name, True)
        return replaced(declaration, name=name, modifiers=())

    def _refused_unit(self, node: Interface | Namespace | Using) -> object:
        what = {Interface: "INTERFACE", Namespace: "NAMESPACE", Using: "USING"}[type(node)]
        self._findings.refuse(what, node.span, "write blocks and types without it")
        return node

    # --- types --------------------------------------------------------------------------------

    def _type(self, node: NamedType) -> TypeSpec:
        key, upper = node.name.casefold(), node.name.upper()
        if key in self._program.aliases:
            spec: TypeSpec = self.rewrite(self._program.aliases[key].type)
            return spec
        if key in self._plant.types or key in self._plant.blocks:
            return NamedType(node.span, node.name, True)
        return NamedType(node.span, S7_NAMES[upper]) if upper in S7_NAMES else node

    def _subrange(self, node: SubrangeSpec) -> TypeSpec:
        return self._type(node.base)

    def _enumeration(self, node: EnumSpec) -> NamedType:
        return NamedType(node.span, "Int")

    def _refused_type(self, node: ReferenceSpec | UnionSpec) -> object:
        what = node.keyword if isinstance(node, ReferenceSpec) else "UNION"
        hint = "use VAR_IN_OUT" if isinstance(node, ReferenceSpec) else "lay an AT view over it"
        self._findings.refuse(what, node.span, hint)
        return NamedType(node.span, "Int")

    def _string(self, node: StringSpec) -> StringSpec:
        spec: StringSpec = self.inside(node)
        return spec

    # --- statements ---------------------------------------------------------------------------

    def _assignment(self, node: Assignment) -> Statement:
        if node.operator in ("REF=", "?="):
            self._findings.refuse(node.operator, node.span, "hand the variable over as VAR_IN_OUT")
            return node
        if node.operator not in _SET:
            statement: Statement = self.inside(node)
            return statement
        truth = _SET[node.operator]
        constant = Literal(node.span, LiteralKind.BOOL, truth, "TRUE" if truth else "FALSE")
        done = Assignment(node.span, self.rewrite(node.target), ":=", constant)
        branch = Branch(node.span, self.rewrite(node.value), (done,))
        return If(node.span, (branch,), None, node.leading, node.trailing)

    # --- expressions --------------------------------------------------------------------------

    def _name(self, node: Name) -> Expression:
        key = node.name.casefold()
        is_own = self._scope is not None and self._scope.is_declared(node) and not node.outer
        if is_own and key not in self._external:
            located = self._located(key)
            if located is not None:
                return self._address(replaced(located, span=node.span))
            return Name(node.span, node.name, False, True)
        if key in self._program.addresses:
            return self._address(replaced(self._program.addresses[key], span=node.span))
        if key in self._program.variables:
            base = Name(node.span, GLOBALS, True)
            return Member(node.span, base, self._program.variables[key])
        if self._program.is_ambiguous(node.name):
            self._findings.refuse(
                f"the name {node.name} of several enumerations",
                node.span,
                "write the type in front of it: Colour#red",
            )
        value = self._program.enumerator("", node.name)
        if value is not None:
            return number(node.span, value)
        if instance := self._program.instance_of(key):
            return Name(node.span, instance, True)
        known = key in self._plant.blocks or key in self._plant.types
        return Name(node.span, node.name, True) if known else node

    def _located(self, key: str) -> DirectAddress | None:
        """The address of a variable that the block itself declares AT one."""
        assert self._scope is not None
        for section in self._scope.block.sections:
            for declaration in section.declarations:
                if isinstance(declaration.at, DirectAddress) and any(
                    name.name.casefold() == key for name in declaration.names
                ):
                    return declaration.at
        return None

    def _address(self, node: DirectAddress) -> Expression:
        if node.byte < 0:
            self._findings.refuse(node.span.text, node.span, "give the address")
        elif node.size not in ("X", "B"):
            self._findings.refuse(
                node.span.text,
                node.span,
                "IEC counts words, S7 bytes: address single bytes and put them together",
            )
        return node

    def _member(self, node: Member) -> Expression:
        if isinstance(node.base, Name):
            value = self._program.enumerator(node.base.name, node.name)
            if value is not None:
                return number(node.span, value)
            is_own = self._scope is not None and self._scope.is_declared(node.base)
            if not is_own and self._program.in_list(node.base.name, node.name):
                return self._name(Name(node.span, node.name))
        expression: Expression = self.inside(node)
        return expression

    def _call(self, node: Call) -> Expression:
        callee = node.callee
        call: Call = self.inside(node)
        if not isinstance(callee, Name) or (self._scope and self._scope.is_declared(callee)):
            return call
        if self._program.instance_of(callee.name.casefold()):
            return call
        function = self._plant.function(callee.name)
        if function is None:
            plain = Call(call.span, Name(callee.span, callee.name), call.arguments)
            return same_truth(
                standard_with_names(plain), self._program.dialect, "tia", self._findings
            )
        inputs = tuple(
            name.name
            for section in function.sections
            if section.keyword in ("VAR_INPUT", "VAR_IN_OUT")
            for declaration in section.declarations
            for name in declaration.names
        )
        if any(item.kind is ArgumentKind.POSITIONAL for item in call.arguments):
            call = with_names(call, inputs)
        return call

    def _try(self, node: Try) -> Statement:
        self._findings.refuse("__TRY", node.span, "check for the fault beforehand")
        return node

    def _dereference(self, node: Dereference) -> Expression:
        self._findings.refuse(node.span.text, node.span, "hand the variable over as VAR_IN_OUT")
        return node

    def _literal(self, node: Literal) -> Expression:
        if node.kind is LiteralKind.ENUMERATOR:
            value = self._program.enumerator(node.type_name, str(node.value))
            if value is not None:
                return number(node.span, value)
        if node.kind is LiteralKind.WSTRING and node.text.startswith('"'):
            inner = node.text[1:-1].replace('$"', '"').replace("'", "$'")
            return replaced(node, text=f"WSTRING#'{inner}'")
        return node

    def link(self, node: Binary, left: Expression, right: Expression) -> Expression:
        """AND_THEN and OR_ELSE leave their right side out, which SCL does not promise."""
        if node.operator in ("AND_THEN", "OR_ELSE"):
            self._findings.refuse(node.operator, node.span, "nest two IFs")
        return super().link(node, left, right)

    def _trivia(self, node: Trivia) -> Trivia:
        """Pragmas of other systems stay as comments."""
        if node.kind is not TriviaKind.PRAGMA:
            return node
        text = " ".join(node.text.split())
        return Trivia(node.span, TriviaKind.LINE_COMMENT, f"// {text}")

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _block,
        VarSection: _section,
        Declaration: _declaration,
        DeclaredName: _declared,
        TypeDeclaration: _type_declaration,
        Interface: _refused_unit,
        Namespace: _refused_unit,
        Using: _refused_unit,
        NamedType: _type,
        SubrangeSpec: _subrange,
        EnumSpec: _enumeration,
        ReferenceSpec: _refused_type,
        UnionSpec: _refused_type,
        StringSpec: _string,
        Assignment: _assignment,
        Try: _try,
        Name: _name,
        Member: _member,
        Call: _call,
        DirectAddress: _address,
        Dereference: _dereference,
        Literal: _literal,
        Trivia: _trivia,
    }
