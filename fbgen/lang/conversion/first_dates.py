"""Dates that S7 and the other controllers count from another day on: they move as dates.

A DATE or DATE_AND_TIME without an initial value starts with 1990-01-01 on S7 and with 1970-01-01
elsewhere. On the way from S7 it gets that date; on the way there it is refused, because S7 has no
such date. What makes a number of a date, or a date of a number, is refused: the numbers differ.
Sources: as for `fbgen.lang.dates`.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import (
    ArraySpec,
    Block,
    BlockKind,
    Call,
    Declaration,
    Expression,
    File,
    Literal,
    LiteralKind,
    Name,
    NamedType,
    TypeSpec,
    VarSection,
)
from fbgen.lang.checker.calls.conversion_calls import conversion_types
from fbgen.lang.checker.types.conversions import elementary_named
from fbgen.lang.dates import NS_PER_S, instant_of, of_dialect
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.plant import BlockScope, PlantText, Scope
from fbgen.lang.rewriting import Rewriter, Rule, replaced, rewritten
from fbgen.lang.types import (
    DATE,
    DATE_AND_TIME,
    DTL,
    LDATE,
    Elementary,
    Family,
    Type,
)

_DATES = (DATE, DATE_AND_TIME)
_FIRST_TEXTS = {DATE: "D#1990-01-01", DATE_AND_TIME: "DT#1990-01-01-00:00:00"}
_KINDS = {DATE: LiteralKind.DATE, DATE_AND_TIME: LiteralKind.DATE_AND_TIME}
_COUNTS = (Family.SIGNED, Family.UNSIGNED, Family.BITS)
_STARTING = ("VAR", "VAR_INPUT", "VAR_OUTPUT", "VAR_GLOBAL", "VAR_STAT", "VAR_INST")
"""Sections whose variables have their default until somebody writes them."""


def with_same_dates(files: Sequence[File], target: str, findings: Findings) -> list[File]:
    """The files, in their own dialect, with dates that are the same ones in the other."""
    dialect = files[0].dialect
    if of_dialect(DATE, dialect) == of_dialect(DATE, target):
        return list(files)
    from_s7 = of_dialect(DATE, dialect) == DATE
    plant = PlantText(files)
    return rewritten(files, dialect, lambda unit: _Dates(plant, unit, findings, from_s7=from_s7))


class _Dates(Rewriter):
    """Rewrites one unit."""

    def __init__(
        self, plant: PlantText, unit: object, findings: Findings, *, from_s7: bool
    ) -> None:
        self._plant = plant
        self._scope = BlockScope(plant, unit) if isinstance(unit, Block) else Scope(plant, {})
        self._findings = findings
        self._from_s7 = from_s7
        self._starts = True

    def _block(self, node: Block) -> Block:
        before, self._starts = self._starts, node.kind is not BlockKind.FUNCTION
        block = self.inside(node)
        self._starts = before
        return block

    def _section(self, node: VarSection) -> VarSection:
        before = self._starts
        self._starts &= node.keyword in _STARTING and "CONSTANT" not in node.qualifiers
        section = self.inside(node)
        self._starts = before
        return section

    def _declaration(self, node: Declaration) -> Declaration:
        declaration = self.inside(node)
        kind, in_array = self._date(node.type)
        if not self._starts or kind is None or node.initial is not None or node.at is not None:
            return declaration
        if self._from_s7 and not in_array:
            first = Literal(
                node.span, _KINDS[kind], instant_of(DATE, 0), _FIRST_TEXTS[kind], kind.name
            )
            return replaced(declaration, initial=first)
        first_day = "1990-01-01" if self._from_s7 else "1970-01-01"
        self._findings.refuse(
            f"{node.names[0].name}, which starts as {first_day},",
            node.span,
            "give it initial values" + ("" if self._from_s7 else " from 1990 on"),
        )
        return declaration

    def _date(self, spec: TypeSpec | None) -> tuple[Elementary | None, bool]:
        """Which of the two types a variable is made of, and whether there are several."""
        in_array = isinstance(spec, ArraySpec)
        while isinstance(spec, ArraySpec):
            spec = spec.element
        for _ in range(len(self._plant.types) + 1):
            if not isinstance(spec, NamedType) or spec.name.casefold() not in self._plant.types:
                break
            spec = self._plant.types[spec.name.casefold()].type
        kind = elementary_named(spec.name) if isinstance(spec, NamedType) else None
        return next((one for one in _DATES if one == kind), None), in_array

    def _type(self, node: NamedType) -> NamedType:
        if not self._from_s7 and node.name.upper() == LDATE.name:
            self._findings.refuse("the type LDATE", node.span, "use DATE or LDT")
        return node

    def _literal(self, node: Literal) -> Literal:
        if node.type_name == LDATE.name:
            self._findings.refuse(f"the literal {node.text}", node.span, "use DATE or LDT")
        elif self._from_s7 and node.type_name == DATE_AND_TIME.name and int(node.value) % NS_PER_S:
            hint = "write whole seconds: a DATE_AND_TIME counts them there"
            self._findings.refuse(f"the fraction of a second in {node.text}", node.span, hint)
        return node

    def _call(self, node: Call) -> Expression:
        call: Call = self.inside(node)
        callee = call.callee
        if not isinstance(callee, Name) or callee.quoted or self._scope.is_declared(callee):
            return call
        types = conversion_types(callee.name.upper())
        if types is None:
            return call
        source, target = types
        if source is None:
            source = self._type_of_operand(call)
        from_date = isinstance(source, Elementary) and source.family is Family.DATE
        if (target in _DATES and not from_date and source != DTL) or (
            source in _DATES and isinstance(target, Elementary) and target.family in _COUNTS
        ):
            hint = "convert to or from a text, or to the parts of the date"
            what = f"{callee.name}, which counts otherwise there,"
            self._findings.refuse(what, call.span, hint)
        return call

    def _type_of_operand(self, call: Call) -> Type | None:
        operand = call.arguments[0].value if call.arguments else None
        return elementary_named(self._scope.elementary_of(operand)) if operand is not None else None

    rules: ClassVar[Mapping[type, Rule]] = {
        Block: _block,
        VarSection: _section,
        Declaration: _declaration,
        NamedType: _type,
        Literal: _literal,
        Call: _call,
    }
