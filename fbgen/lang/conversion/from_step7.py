"""From the classic SCL of STEP 7 V5 to that of TIA Portal.

Source: TIA Portal help, "Migrating SCL programs": `#` in front of locals, quotes around everything
that belongs to the whole program, ENO for the OK flag, constants with a type, labels undeclared.
"""

import re
from collections.abc import Mapping, Sequence
from math import inf
from typing import ClassVar

from fbgen.lang.ast import (
    Block,
    Call,
    DataBlock,
    Declaration,
    DirectAddress,
    Expression,
    File,
    HeaderItem,
    IndexedAddress,
    Literal,
    LiteralKind,
    Member,
    Name,
    NamedType,
    Parenthesized,
    StringSpec,
    TypeDeclaration,
    TypeSpec,
    Unary,
    VarSection,
)
from fbgen.lang.checker.calls.standard_calls import CLASSIC_NAMES, is_standard_function
from fbgen.lang.checker.supplied.routines import routine_named
from fbgen.lang.checker.supplied.system_instructions import instruction_named
from fbgen.lang.conversion.output_arrows import with_arrows
from fbgen.lang.literals import full_year
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.plant import BlockScope, PlantText
from fbgen.lang.lowering.spelling import S7_NAMES
from fbgen.lang.rewriting import Rewriter, Rule, replaced, rewritten

_TIMERS = {
    "SFB0": "CTU_INT",
    "SFB1": "CTD_INT",
    "SFB2": "CTUD_INT",
    "SFB3": "TP_TIME",
    "SFB4": "TON_TIME",
    "SFB5": "TOF_TIME",
    **S7_NAMES,
}
_NUMBERED = re.compile(r"SFC[0-9]+", re.IGNORECASE)
"""TIA Portal knows an instruction by its name only."""
_SHORT_YEAR = re.compile(r"DT#([0-9]{2})-", re.IGNORECASE)
_ABSENT = {
    "NIL": "NULL exists for references only: use a flag of your own",
    "BLOCK_FB": "call the block by its name",
    "BLOCK_FC": "call the block by its name",
    "BLOCK_SDB": "leave it out",
}
_INT_RANGE = range(-(1 << 15), 1 << 15)
_FLAGS = {"OK": "ENO"}


def from_step7(files: Sequence[File], findings: Findings) -> list[File]:
    """The same files in dialect tia."""
    plant = PlantText(files)
    return rewritten(files, "tia", lambda unit: _FromStep7(plant, findings, unit))


class _FromStep7(Rewriter):
    """Rewrites one unit."""

    def __init__(self, plant: PlantText, findings: Findings, unit: object) -> None:
        self._plant = plant
        self._findings = findings
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else None

    # --- units --------------------------------------------------------------------------------

    def _unit(self, node: Block | DataBlock | TypeDeclaration) -> object:
        unit = self.inside(node)
        changes: dict[str, object] = {
            "name": Name(node.name.span, node.name.name, True),
            "header": _header(node.header),
        }
        if isinstance(node, Block):
            changes["labels"] = ()
        return replaced(unit, **changes)

    def _section(self, node: VarSection) -> VarSection:
        section: VarSection = self.inside(node)
        if "CONSTANT" not in node.qualifiers:
            return section
        declarations = tuple(self._typed(item) for item in section.declarations)
        return replaced(section, declarations=declarations)

    def _declaration(self, node: Declaration) -> Declaration:
        """What an overlay lies over stands there without a mark."""
        declaration: Declaration = self.inside(node)
        return replaced(declaration, at=node.at) if isinstance(node.at, Name) else declaration

    def _typed(self, node: Declaration) -> Declaration:
        """A constant with the type of its value."""
        if not isinstance(node.type, NamedType) or node.type.name:
            return node
        found = self._type_of(node.initial)
        if not found:
            self._findings.report(
                "FB3052",
                f"the type of the constant {node.names[0].name} cannot be seen",
                node.span,
                "write its value as a literal",
            )
        spec: TypeSpec = NamedType(node.type.span, found)
        if found == "String":
            spec = StringSpec(node.type.span, False, None)
        return replaced(node, type=spec)

    def _type_of(self, value: Expression | None) -> str:
        if isinstance(value, Parenthesized):
            return self._type_of(value.inner)
        if isinstance(value, Unary):
            return self._type_of(value.operand)
        if isinstance(value, Name) and self._scope is not None:
            return self._type_of(self._scope.constants.get(value.name.casefold()))
        if not isinstance(value, Literal):
            return ""
        if value.type_name:
            return value.type_name.capitalize()
        if value.kind is LiteralKind.INTEGER:
            return "Int" if value.value in _INT_RANGE else "DInt"
        kinds = {LiteralKind.REAL: "Real", LiteralKind.BOOL: "Bool", LiteralKind.STRING: "String"}
        return kinds.get(value.kind, "")

    # --- types --------------------------------------------------------------------------------

    def _type(self, node: NamedType) -> NamedType:
        upper = node.name.upper()
        if not node.quoted and upper in _TIMERS:
            return NamedType(node.span, _TIMERS[upper])
        if upper in _ABSENT:
            self._refuse(upper, node)
        key = node.name.casefold()
        known = key in self._plant.types or key in self._plant.blocks
        return NamedType(node.span, node.name, True) if known else node

    def _refuse(self, word: str, node: NamedType | Name) -> None:
        self._findings.refuse(word, node.span, _ABSENT[word])

    # --- expressions --------------------------------------------------------------------------

    def _name(self, node: Name) -> Name:
        upper = node.name.upper()
        if self._scope is not None and self._scope.is_declared(node):
            is_result = node.name.casefold() == self._scope.block.name.name.casefold()
            quoted = node.quoted and not is_result
            return Name(node.span, node.name, quoted, True)
        if not node.quoted and upper in _FLAGS:
            return Name(node.span, _FLAGS[upper])
        if not node.quoted and upper in ("EN", "ENO"):
            return node
        if upper in _ABSENT:
            self._refuse(upper, node)
            return node
        return Name(node.span, node.name, True)

    def _call(self, node: Call) -> Call:
        """Functions of the controller stand without quotes."""
        callee = node.callee
        if self._is_behind_block(callee):
            assert isinstance(callee, Member)
            callee = Name(callee.span, callee.name, True)
            node = replaced(node, callee=callee)
        call: Call = self.inside(node)
        if not isinstance(callee, Name) or (
            self._scope is not None and self._scope.is_declared(callee)
        ):
            return call
        call = with_arrows(call, callee.name, self._plant.blocks)
        if callee.name.casefold() in self._plant.blocks:
            return call
        known = instruction_named(callee.name) or routine_named(callee.name)
        if known is None and not is_standard_function(callee.name.upper()):
            return call
        name = callee.name
        if known is not None and _NUMBERED.fullmatch(name):
            name = known.name
        names = CLASSIC_NAMES.get(name.upper(), {})
        arguments = tuple(
            replaced(one, name=names.get(one.name.upper(), one.name)) for one in call.arguments
        )
        return Call(call.span, Name(callee.span, name), arguments)

    def _is_behind_block(self, callee: Expression) -> bool:
        """Whether this is `"FB"."DB"`, a global instance behind the block it belongs to."""
        return (
            isinstance(callee, Member)
            and isinstance(callee.base, Name)
            and not (self._scope is not None and self._scope.is_declared(callee.base))
            and callee.name.casefold() in self._plant.data_blocks
        )

    def _indexed(self, node: IndexedAddress) -> Expression:
        """`PIB[4]` is `%IB4:P`; what is worked out at run time stays so."""
        numbers = [item.value for item in node.indices if isinstance(item, Literal)]
        data_block = _number_of(node.base)
        if len(numbers) != len(node.indices) or not all(type(item) is int for item in numbers):
            return self.inside(node)
        if node.base is not None and data_block < 0:
            return self.inside(node)
        byte, bit = (*numbers, 0)[:2]
        assert isinstance(byte, int)
        assert isinstance(bit, int)
        return DirectAddress(
            node.span, node.area, node.size, byte, bit, max(data_block, 0), node.peripheral
        )

    def _address(self, node: DirectAddress) -> DirectAddress:
        return replaced(node, german=False) if node.german else node

    def _literal(self, node: Literal) -> Literal:
        """TIA Portal wants a point in `3E10`, and four digits of a year."""
        if year := _SHORT_YEAR.match(node.text):
            return replaced(node, text=f"DT#{full_year(year[1])}{node.text[year.end(1) :]}")
        if node.kind is not LiteralKind.REAL or "." in node.text:
            return node
        mantissa, _, exponent = node.text.upper().partition("E")
        if not exponent or abs(float(str(node.value))) == inf:
            return node
        return replaced(node, text=f"{mantissa}.0E{exponent}")

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _unit,
        DataBlock: _unit,
        TypeDeclaration: _unit,
        VarSection: _section,
        Declaration: _declaration,
        NamedType: _type,
        Name: _name,
        Call: _call,
        IndexedAddress: _indexed,
        DirectAddress: _address,
        Literal: _literal,
    }


def _number_of(base: Expression | None) -> int:
    """The number of `DB100`; -1 for a data block that has none or is not known yet."""
    if not isinstance(base, Name) or base.quoted or base.name[:2].upper() != "DB":
        return -1
    return int(base.name[2:]) if base.name[2:].isdecimal() else -1


def _header(header: tuple[HeaderItem, ...]) -> tuple[HeaderItem, ...]:
    """VERSION without quotes; the attributes of STEP 7 mean nothing in TIA Portal."""
    return tuple(
        HeaderItem(item.span, item.keyword, item.text.strip("'"))
        if item.keyword == "VERSION"
        else item
        for item in header
        if item.keyword != "{}"
    )
