"""From TIA Portal SCL to the classic SCL of STEP 7 V5.

Source: TIA Portal help, "Migrating SCL programs"; published S7-SCL sources; documentation of S7-SCL
for S7-300/400: constants in CONST, jump labels declared in LABEL, AUTHOR and FAMILY of up to eight
characters, TITLE and VERSION in quotes, names behind the parameters of shifts. A global instance is
called behind its block, `"FB"."DB"(...)`, and its outputs are read behind the call. The blocks of
the system have their numbers: their symbols are in the project only if somebody put them there.
"""

from collections.abc import Mapping, Sequence
from itertools import chain
from typing import ClassVar

from fbgen.dataclass import dataclass
from fbgen.lang.ast import (
    ArgumentKind,
    Assignment,
    Binary,
    Block,
    Bounds,
    Call,
    CallStatement,
    DataBlock,
    Declaration,
    DeclaredName,
    Dereference,
    Expression,
    File,
    HeaderItem,
    Label,
    LabelSection,
    Literal,
    LiteralKind,
    Member,
    Name,
    NamedType,
    Parenthesized,
    Peripheral,
    ReferenceSpec,
    Region,
    Slice,
    Statement,
    StringSpec,
    StructSpec,
    Trivia,
    TriviaKind,
    TypeDeclaration,
    VarSection,
)
from fbgen.lang.checker.supplied.system_instructions import ALIASES
from fbgen.lang.conversion.bit_literals import BitLiterals, typed_bits
from fbgen.lang.conversion.handed_on import with_copies
from fbgen.lang.dialects import dialect_named
from fbgen.lang.dialects.step7 import is_absolute
from fbgen.lang.lowering.chains import links
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.names import is_identifier
from fbgen.lang.lowering.plant import BlockScope, PlantText
from fbgen.lang.lowering.slices import can_be_sliced, read_slice, write_slice
from fbgen.lang.lowering.spelling import TYPES
from fbgen.lang.rewriting import Inlined, Rewriter, Rule, replaced, rewritten
from fbgen.lang.standard_parameters import standard_with_names
from fbgen.lang.walk import walk
from fbgen.source import Span

_SYSTEM_BLOCKS = {
    "CTU": "SFB0",
    "CTD": "SFB1",
    "CTUD": "SFB2",
    "TP": "SFB3",
    "TON": "SFB4",
    "TOF": "SFB5",
}
_COUNTERS = frozenset({"CTU", "CTD", "CTUD"})
_SYSTEM_FUNCTIONS = {name.upper(): number.upper() for number, name in ALIASES.items()}
_EDGES = frozenset({"R_TRIG", "F_TRIG"})
_SHORT_TEXTS = frozenset({"AUTHOR", "FAMILY", "NAME"})
_SHORT = 8


def to_step7(files: Sequence[File], findings: Findings) -> list[File]:
    """The same files in dialect step7. What STEP 7 has not is noted in the findings."""
    own = with_copies(files)
    plant = PlantText(own)
    typed = rewritten(own, "tia", lambda unit: BitLiterals(plant, unit))
    return rewritten(typed, "step7", lambda unit: _ToStep7(plant, findings, unit))


class _ToStep7(Rewriter):
    """Rewrites one unit."""

    def __init__(self, plant: PlantText, findings: Findings, unit: object) -> None:
        self._plant = plant
        self._findings = findings
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else None
        self._dialect = dialect_named("step7")
        self._called = frozenset(
            part.callee.name.casefold()
            for part in (walk(unit.body) if isinstance(unit, Block) else ())
            if isinstance(part, Call) and isinstance(part.callee, Name)
            if not part.callee.local and not part.callee.quoted
        )

    # --- units --------------------------------------------------------------------------------

    def _block(self, node: Block) -> Block:
        block: Block = self.inside(node)
        labels = tuple(
            Name(item.span, item.name) for item in walk(block.body) if isinstance(item, Label)
        )
        if labels and not node.labels:
            labels = tuple(sorted(labels, key=lambda name: name.span.start))
            block = replaced(block, labels=(LabelSection(node.span, labels),))
        self._check_length(block.name)
        return replaced(block, header=_header(block.header))

    def _data_block(self, node: DataBlock) -> DataBlock:
        block: DataBlock = self.inside(node)
        self._check_length(block.name)
        if block.sections:
            fields = tuple(one for section in block.sections for one in section.declarations)
            block = replaced(block, sections=(), struct=StructSpec(node.span, fields))
        return replaced(block, header=_header(block.header))

    def _type_declaration(self, node: TypeDeclaration) -> TypeDeclaration:
        """A UDT, which has no header: what stands in it is said above."""
        declaration: TypeDeclaration = self.inside(node)
        self._check_length(node.name)
        titles = [_comment(one.span, one.text) for one in node.header if one.keyword == "TITLE"]
        leading = (*node.leading, *chain(*titles), *node.header_comments)
        return replaced(declaration, leading=leading, header=(), header_comments=())

    def _section(self, node: VarSection) -> VarSection:
        section: VarSection = self.inside(node)
        if "CONSTANT" in section.qualifiers:
            declarations = tuple(self._constant(item) for item in section.declarations)
            return replaced(section, qualifiers=("CONSTANT",), declarations=declarations)
        return replaced(section, qualifiers=()) if section.qualifiers else section

    def _constant(self, node: Declaration) -> Declaration:
        """A constant, which has the type of its value; the literal says it."""
        spec, value = node.type, node.initial
        if not isinstance(spec, (NamedType, StringSpec)) or value is None:
            self._findings.refuse("a constant array or structure", node.span, "declare it in VAR")
            return node
        no_type = NamedType(spec.span, "")
        if isinstance(spec, StringSpec) or not isinstance(value, Literal) or value.type_name:
            return replaced(node, type=no_type)
        return replaced(node, type=no_type, initial=_typed(value, spec.name.upper()))

    def _declared(self, node: DeclaredName) -> DeclaredName:
        self._check(node.name, node.span)
        if node.name.casefold() in self._called:
            self._findings.report(
                "FB3050",
                f"'{node.name}' is also the name of a function that this block calls",
                node.span,
                "rename the variable; STEP 7 does not tell the two apart",
            )
        if not node.quoted and not node.attributes:
            return node
        return DeclaredName(node.span, node.name)

    def _check(self, name: str, place: Span) -> None:
        """A local name: no quotes can save it."""
        upper = name.upper()
        is_taken = upper in self._dialect.reserved or is_absolute(name)
        if is_taken or not is_identifier(name):
            self._findings.report(
                "FB3050",
                f"the name '{name}' is none that STEP 7 takes without quotes",
                place,
                "rename it: letters, digits and single underscores, no reserved word, no address",
            )
        self._check_length(Name(place, name))

    def _check_length(self, name: Name) -> None:
        if len(name.name) > self._dialect.identifier_length:
            self._findings.report(
                "FB3050",
                f"the name '{name.name}' is longer than {self._dialect.identifier_length} "
                "characters",
                name.span,
                "give it a shorter name",
            )

    # --- types --------------------------------------------------------------------------------

    def _type(self, node: NamedType) -> NamedType:
        upper = node.name.upper()
        number = _SYSTEM_BLOCKS.get(TYPES.get(upper, upper))
        if not node.quoted and number is not None:
            return NamedType(node.span, number)
        if upper in _EDGES:
            self._findings.refuse(
                f"the block {node.name}", node.span, "keep the last value and compare with it"
            )
        if not node.quoted and upper in self._dialect.absent_types:
            self._findings.report(
                "FB3052",
                f"the type {node.name} is none of dialect step7",
                node.span,
                self._dialect.absent_types[upper],
            )
        return node

    def _string(self, node: StringSpec) -> StringSpec:
        if node.wide:
            self._findings.report(
                "FB3052",
                "the type WSTRING is none of dialect step7",
                node.span,
                self._dialect.absent_types["WSTRING"],
            )
        spec: StringSpec = self.inside(node)
        return spec

    def _bounds(self, node: Bounds) -> Bounds:
        if node.first is None:
            self._findings.refuse("ARRAY[*]", node.span, "give the bounds")
            return node
        bounds: Bounds = self.inside(node)
        return bounds

    def _reference_type(self, node: ReferenceSpec) -> ReferenceSpec:
        self._findings.refuse(node.keyword, node.span, "hand the variable over as VAR_IN_OUT")
        return node

    # --- statements ---------------------------------------------------------------------------

    def _call_statement(self, node: CallStatement) -> object:
        """The call of an instance, whose outputs are read behind it; or that of a function."""
        instance = self._instance(node.call.callee)
        if instance is None:
            return self.inside(node)
        given = [one for one in node.call.arguments if one.kind is not ArgumentKind.OUTPUT]
        call = Call(node.call.span, instance.called, tuple(self.rewrite(one) for one in given))
        statements: list[Statement] = [CallStatement(node.span, call, node.leading, node.trailing)]
        for one in node.call.arguments:
            if one.kind is ArgumentKind.OUTPUT and one.value is not None:
                value = Member(one.span, instance.place, one.name)
                taken = Assignment(one.span, one.value, ":=", value, one.leading, one.trailing)
                statements.append(self._assigned(taken, value))
        return tuple(statements)

    def _instance(self, callee: Expression) -> "_Instance | None":
        """The instance that is called; None for a function."""
        if isinstance(callee, Member) and callee.name.upper() in _SYSTEM_BLOCKS:
            if callee.name.upper() in _COUNTERS:
                what = f"the call {callee.span.text}(...)"
                self._findings.refuse(
                    what, callee.span, "declare it as what it counts, and call that"
                )
            callee = callee.base  # `timer.TON(...)`
        if not isinstance(callee, Name) or (self._scope and self._scope.is_declared(callee)):
            place = self.rewrite(callee)
            return _Instance(place, place)
        block = self._plant.data_blocks.get(callee.name.casefold())
        if block is None or block.type is None:
            return None
        kind = self._type(block.type)
        called = Member(callee.span, Name(callee.span, kind.name, kind.quoted), callee.name, True)
        return _Instance(called, Name(callee.span, callee.name, True))

    def _region(self, node: Region) -> Inlined:
        title = _comment(node.span, node.title)
        note = _comment(node.span, node.end_text.strip("; \t").removeprefix("//"))
        return Inlined((*node.leading, *title), node.body, (*node.closing, *note))

    def _assignment(self, node: Assignment) -> object:
        if node.operator == "?=":
            self._findings.refuse("?=", node.span, "hand the variable over with its own type")
            return node
        return tuple(self._assigned(one) for one in links(node))

    def _assigned(self, node: Assignment, lowered: Expression | None = None) -> Assignment:
        """One assignment with `:=` to something that STEP 7 can name.

        `lowered` is its value where that is in dialect step7 already.
        """
        value = node.value
        if node.operator != ":=":
            if any(isinstance(part, Call) for part in walk(node.target)):
                self._findings.refuse(
                    f"{node.operator} to a place that calls a function",
                    node.span,
                    "work out the index first",
                )
            value = Binary(node.span, node.operator[0], node.target, _operand(value))
        value = lowered or self.rewrite(value)
        if isinstance(node.target, Slice):
            type_name = self._sliced(node.target)
            if not type_name:
                return node
            base = self.rewrite(node.target.base)
            plain = Assignment(node.span, node.target, ":=", value, node.leading, node.trailing)
            written = write_slice(plain, base, type_name, node.target, value)
            return replaced(written, value=_name_arguments(written.value))
        return Assignment(
            node.span, self.rewrite(node.target), ":=", value, node.leading, node.trailing
        )

    # --- expressions --------------------------------------------------------------------------

    def _name(self, node: Name) -> Name:
        if not node.local:
            return node
        return Name(node.span, node.name)

    def _member(self, node: Member) -> Member:
        base = self.rewrite(node.base)
        if node.quoted:
            self._check(node.name, node.span)
            return Member(node.span, base, node.name)
        return node if base is node.base else Member(node.span, base, node.name)

    def _sliced(self, node: Slice) -> str:
        """The type whose part a slice is; "" after refusing it."""
        type_name = self._scope.elementary_of(node.base) if self._scope else ""
        if can_be_sliced(type_name, node):
            return type_name
        self._findings.refuse(
            f"the slice .%{node.size}{node.index} of {type_name or 'an unknown type'}",
            node.span,
            "copy the value into a variable of type BYTE, WORD or DWORD first",
        )
        return ""

    def _slice(self, node: Slice) -> Expression:
        type_name = self._sliced(node)
        if not type_name:
            return node
        return _name_arguments(read_slice(node.span, self.rewrite(node.base), type_name, node))

    def _call(self, node: Call) -> Call:
        """A function, whose outputs are given by `:=` as all parameters are."""
        call: Call = self.inside(node)
        arguments = tuple(
            replaced(one, kind=ArgumentKind.INPUT) if one.kind is ArgumentKind.OUTPUT else one
            for one in call.arguments
        )
        callee = call.callee
        if isinstance(callee, Name) and not callee.quoted and not callee.local:
            callee = Name(callee.span, _SYSTEM_FUNCTIONS.get(callee.name.upper(), callee.name))
        return standard_with_names(Call(call.span, callee, arguments))

    def _peripheral(self, node: Peripheral) -> Expression:
        self._findings.refuse(
            f"{node.span.text}", node.span, "write the peripheral address: PIB256 or PEB256"
        )
        return node

    def _dereference(self, node: Dereference) -> Expression:
        self._findings.refuse("'^'", node.span, "hand the variable over as VAR_IN_OUT")
        return node

    def _literal(self, node: Literal) -> Literal:
        if node.type_name in self._dialect.absent_types:
            self._findings.refuse(
                f"the literal {node.text}", node.span, self._dialect.absent_types[node.type_name]
            )
        return node

    def link(self, node: Binary, left: Expression, right: Expression) -> Expression:
        """AND_THEN and OR_ELSE leave their right side out, which STEP 7 never does."""
        if node.operator in ("AND_THEN", "OR_ELSE"):
            self._findings.refuse(node.operator, node.span, "nest two IFs")
        return super().link(node, left, right)

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _block,
        DataBlock: _data_block,
        TypeDeclaration: _type_declaration,
        VarSection: _section,
        DeclaredName: _declared,
        NamedType: _type,
        StringSpec: _string,
        Bounds: _bounds,
        ReferenceSpec: _reference_type,
        CallStatement: _call_statement,
        Region: _region,
        Assignment: _assignment,
        Name: _name,
        Member: _member,
        Slice: _slice,
        Call: _call,
        Peripheral: _peripheral,
        Dereference: _dereference,
        Literal: _literal,
    }


@dataclass(frozen=True, slots=True)
class _Instance:
    """An instance as a call names it, and as its variables are reached."""

    called: Expression
    place: Expression


def _comment(place: Span, text: str) -> tuple[Trivia, ...]:
    text = text.strip()
    return (Trivia(place, TriviaKind.LINE_COMMENT, f"// {text}"),) if text else ()


def _header(header: tuple[HeaderItem, ...]) -> tuple[HeaderItem, ...]:
    """The lines that STEP 7 takes; attributes of TIA Portal mean nothing to it."""
    items: list[HeaderItem] = []
    for item in header:
        text = item.text.strip("'")
        if item.keyword == "{}":
            continue
        if item.keyword in ("TITLE", "VERSION"):
            text = text.replace("'", "$'") if text else text
            item = HeaderItem(item.span, item.keyword, f"'{text}'")
        elif item.keyword in _SHORT_TEXTS and len(text) > _SHORT:
            item = HeaderItem(item.span, item.keyword, text[:_SHORT])
        items.append(item)
    return tuple(items)


def _typed(value: Literal, type_name: str) -> Literal:
    """A number that has this type wherever it stands."""
    if value.kind is LiteralKind.INTEGER and type_name == "REAL":
        return replaced(
            value, kind=LiteralKind.REAL, value=float(value.value), text=f"{value.value}.0"
        )
    if value.kind is LiteralKind.INTEGER and type_name == "DINT":
        return replaced(value, text=f"L#{value.text}", type_name=type_name)
    return typed_bits(value, type_name)


def _operand(value: Expression) -> Expression:
    """The right side of `x += a - b` keeps together."""
    return Parenthesized(value.span, value) if isinstance(value, Binary) else value


def _name_arguments(built: Expression) -> Expression:
    """What was built for a slice, with the names of all parameters."""
    expression: Expression = _Naming().rewrite(built)
    return expression


class _Naming(Rewriter):
    def _call(self, node: Call) -> Call:
        call: Call = self.inside(node)
        return standard_with_names(call)

    rules: ClassVar[Mapping[type, Rule]] = {Call: _call}
