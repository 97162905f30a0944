"""Numbers in places for bit strings, with the type of the place: `16#7001` becomes `W#16#7001`.

To STEP 7 V5 a number without a type is an integer, in whatever base it is written, and an integer
does not become a bit string by itself. TIA Portal gives it the type of its place. Source: S7-SCL
V5.3 manual, 9.1.3 "Notation for Constants".
"""

import re
from collections.abc import Mapping
from typing import ClassVar

from fbgen.lang.ast import (
    Argument,
    Assignment,
    Binary,
    Block,
    Call,
    Case,
    CaseArm,
    DataBlock,
    Declaration,
    DirectAddress,
    Expression,
    LabelRange,
    Literal,
    LiteralKind,
    Name,
    NamedType,
    Parenthesized,
    Peripheral,
    Slice,
    TypeSpec,
    Unary,
    Unit,
)
from fbgen.lang.checker.supplied.system_instructions import instruction_named
from fbgen.lang.lowering.build import call, integer
from fbgen.lang.lowering.plant import BlockScope, PlantText, Scope
from fbgen.lang.rewriting import Rewriter, Rule, replaced
from fbgen.lang.types import Elementary

_PREFIXES = {"BYTE": "B", "WORD": "W", "DWORD": "DW"}
_CHOSEN_BY = frozenset({"BYTE", "WORD"})
_HIGHEST_INT = 0x7FFF
_SIZES = {"X": "BOOL", "B": "BYTE", "W": "WORD", "D": "DWORD"}
_BIT_OPERATORS = frozenset({"AND", "&", "OR", "XOR"})
_COMPARISONS = frozenset({"=", "<>", "<", ">", "<=", ">="})
_SHIFTS = frozenset({"SHL", "SHR", "ROL", "ROR"})
_CONVERSION = re.compile(r"\w+_TO_(BYTE|WORD|DWORD)")


def typed_bits(value: Literal, type_name: str) -> Literal:
    """A number as a bit string of this upper-case type; another type gives it back."""
    prefix = _PREFIXES.get(type_name)
    if prefix is None or value.kind is not LiteralKind.INTEGER or value.type_name:
        return value
    return replaced(value, text=f"{prefix}#{value.text}", type_name=type_name)


class BitLiterals(Rewriter):
    """Gives the numbers in one unit of dialect tia the types of their places."""

    def __init__(self, plant: PlantText, unit: Unit) -> None:
        self._plant = plant
        if isinstance(unit, Block):
            self._scope: Scope = BlockScope(plant, unit)
        elif isinstance(unit, DataBlock):
            self._scope = Scope.of_data_block(plant, unit)
        else:
            self._scope = Scope(plant, {})

    # --- places -------------------------------------------------------------------------------

    def _assignment(self, node: Assignment) -> Assignment:
        plain: Assignment = self.inside(node)
        value = _as_bits(plain.value, self._type(node.target))
        return plain if value is plain.value else replaced(plain, value=value)

    def _declaration(self, node: Declaration) -> Declaration:
        plain: Declaration = self.inside(node)
        if plain.initial is None or not isinstance(plain.type, NamedType):
            return plain
        initial = _as_bits(plain.initial, plain.type.name.upper())
        return plain if initial is plain.initial else replaced(plain, initial=initial)

    def _case(self, node: Case) -> Case:
        """STEP 7 chooses by an INT only."""
        plain: Case = self.inside(node)
        kind = self._type(node.selector)
        if kind not in _CHOSEN_BY:
            return plain
        selector = call(node.selector.span, f"{kind}_TO_INT", plain.selector)
        return replaced(plain, selector=selector, arms=tuple(_arm(arm) for arm in plain.arms))

    def _call(self, node: Call) -> Call:
        plain: Call = self.inside(node)
        parameters = self._scope.parameters_of(node.callee) or _instruction(node.callee)
        if not parameters:
            return plain
        by_name = {name.casefold(): kind for name, kind in parameters}
        given = tuple(
            _given(one, by_name.get(one.name.casefold()) if one.name else kind)
            for one, (_, kind) in zip(plain.arguments, parameters, strict=False)
        )
        return replaced(plain, arguments=(*given, *plain.arguments[len(given) :]))

    def link(self, node: Binary, left: Expression, right: Expression) -> Expression:
        """Both sides of an operator for bit strings, or of a comparison of them."""
        if node.operator in _BIT_OPERATORS or node.operator in _COMPARISONS:
            wanted = self._type(left) or self._type(right)
            left, right = _as_bits(left, wanted), _as_bits(right, wanted)
        return super().link(node, left, right)

    # --- types --------------------------------------------------------------------------------

    def _type(self, node: Expression) -> str:
        """The upper-case elementary type of an expression, "" where it cannot be seen."""
        if isinstance(node, Parenthesized):
            return self._type(node.inner)
        if isinstance(node, Unary):
            return self._type(node.operand)
        if isinstance(node, Binary):
            if node.operator in _BIT_OPERATORS:
                return self._type(node.left) or self._type(node.right)
            return "BOOL" if node.operator in _COMPARISONS else ""
        if isinstance(node, Peripheral):
            return self._type(node.base)
        if isinstance(node, DirectAddress | Slice):
            return _SIZES.get(node.size, "")
        if isinstance(node, Call):
            return self._type_of_call(node)
        return self._scope.elementary_of(node)

    def _type_of_call(self, node: Call) -> str:
        if not isinstance(node.callee, Name):
            return ""
        function = self._plant.function(node.callee.name)
        if function is not None:
            spec = function.return_type
            return spec.name.upper() if isinstance(spec, NamedType) else ""
        upper = node.callee.name.upper()
        if found := _CONVERSION.fullmatch(upper):
            return found[1]
        if upper in _SHIFTS and node.arguments and node.arguments[0].value is not None:
            return self._type(node.arguments[0].value)
        return ""

    rules: ClassVar[Mapping[type, Rule]] = {
        Assignment: _assignment,
        Declaration: _declaration,
        Case: _case,
        Call: _call,
    }


def _instruction(callee: Expression) -> tuple[tuple[str, TypeSpec], ...]:
    """The elementary parameters of an instruction of the controller."""
    instruction = instruction_named(callee.name) if isinstance(callee, Name) else None
    return tuple(
        (one.name, NamedType(callee.span, one.type.name))
        for one in (instruction.parameters if instruction else ())
        if isinstance(one.type, Elementary)
    )


def _as_bits(node: Expression, wanted: str) -> Expression:
    """The numbers in an expression of type `wanted`, as far as they have that type too."""
    if wanted not in _PREFIXES:
        return node
    if isinstance(node, Literal):
        return typed_bits(node, wanted)
    if isinstance(node, Parenthesized):
        inner = _as_bits(node.inner, wanted)
        return node if inner is node.inner else Parenthesized(node.span, inner)
    if isinstance(node, Binary) and node.operator in _BIT_OPERATORS:
        left, right = _as_bits(node.left, wanted), _as_bits(node.right, wanted)
        return Binary(node.span, node.operator, left, right)
    return node


def _arm(arm: CaseArm) -> CaseArm:
    labels = tuple(
        LabelRange(label.span, _as_integer(label.first), _as_integer(label.last))
        if isinstance(label, LabelRange)
        else _as_integer(label)
        for label in arm.labels
    )
    return replaced(arm, labels=labels)


def _as_integer(label: Expression) -> Expression:
    """A label as the INT that WORD_TO_INT gives for it."""
    if not isinstance(label, Literal) or label.kind is not LiteralKind.INTEGER:
        return label
    value = int(label.value)
    if value > _HIGHEST_INT:
        return Unary(label.span, "-", integer(label.span, 0x10000 - value))
    return integer(label.span, value, f"16#{value:X}" if "16#" in label.text else "")


def _given(argument: Argument, kind: TypeSpec | None) -> Argument:
    if argument.value is None or not isinstance(kind, NamedType):
        return argument
    typed = _as_bits(argument.value, kind.name.upper())
    return argument if typed is argument.value else replaced(argument, value=typed)
