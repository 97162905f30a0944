"""Expressions in IEC: plain names, shifts for slices, constants where IEC wants literals."""

from collections.abc import Callable
from typing import Any

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    ArrayLiteral,
    Binary,
    Call,
    Chained,
    Dereference,
    DirectAddress,
    Expression,
    Index,
    IndexedAddress,
    Literal,
    LiteralKind,
    Member,
    Name,
    Parenthesized,
    Peripheral,
    Repeated,
    Slice,
    StructLiteral,
    Unary,
)
from fbgen.lang.lowering.build import integer
from fbgen.lang.lowering.context import Context
from fbgen.lang.lowering.plant import BlockScope
from fbgen.lang.lowering.slices import can_be_sliced, read_slice
from fbgen.lang.lowering.spelling import (
    RENAMED_FUNCTIONS,
    is_standard_function,
    literal_text,
)
from fbgen.lang.lowering.truth import same_truth
from fbgen.lang.standard_parameters import standard_without_names

_HARDWARE_HINT = "put the access into a block of its own for each dialect"


class ExpressionLowering:
    """Rewrites the expressions of one block; notes the globals that they use."""

    def __init__(self, context: Context, scope: BlockScope | None) -> None:
        self.context = context
        self.scope = scope
        self.used_globals: dict[str, str] = {}

    def expression(self, node: Expression) -> Expression:
        """The same in IEC. What cannot be said is reported and comes back as it was."""
        lowerer = _LOWERERS.get(type(node))
        if lowerer is None:
            self.context.findings.refuse(node.span.text, node.span, _HARDWARE_HINT)
            return node
        return lowerer(self, node)

    def constant(self, node: Expression) -> Expression:
        """An expression where IEC wants a literal: bounds, lengths, labels."""
        value = self._folded(node)
        if isinstance(value, int):
            return integer(node.span, value)
        return self.expression(node)

    def _folded(self, node: Expression) -> int | None:
        """The whole number that an expression of constants and literals gives."""
        if isinstance(node, Literal) and node.kind is LiteralKind.INTEGER:
            return int(node.value)
        if isinstance(node, Parenthesized):
            return self._folded(node.inner)
        if isinstance(node, Name) and self.scope:
            initial = self.scope.constants.get(node.name.casefold())
            return self._folded(initial) if initial is not None else None
        if isinstance(node, Unary) and node.operator == "-":
            value = self._folded(node.operand)
            return None if value is None else -value
        if isinstance(node, Binary) and node.operator in ("+", "-", "*"):
            left, right = self._folded(node.left), self._folded(node.right)
            if left is not None and right is not None:
                return {"+": left + right, "-": left - right, "*": left * right}[node.operator]
        return None

    # --- one method a kind of node ------------------------------------------------------------

    def _literal(self, node: Literal) -> Expression:
        text = literal_text(node, self.context.target)
        if text is None:
            self.context.findings.refuse(
                f"the literal {node.text}", node.span, "use a type that IEC has, such as TIME"
            )
            return node
        return Literal(node.span, node.kind, node.value, text, node.type_name, node.base)

    def _name(self, node: Name) -> Expression:
        name = self.context.names.check(node.name, node.span)
        if self.scope is None or self.scope.is_declared(node):
            return Name(node.span, name)
        if self.context.plant.is_data_block(node):
            self.used_globals[name.casefold()] = self.context.global_name(name)
        elif name.upper() in ("EN", "ENO"):
            self.context.findings.refuse(name.upper(), node.span, "use an output for errors")
        else:
            self.context.findings.report(
                "FB3051",
                f"'{node.name}' is declared in none of the files",
                node.span,
                "convert the files that declare it together with this one",
            )
        return Name(node.span, name)

    def _member(self, node: Member) -> Expression:
        name = self.context.names.check(node.name, node.span)
        return Member(node.span, self.expression(node.base), name)

    def _index(self, node: Index) -> Expression:
        indices = tuple(self.expression(one) for one in node.indices)
        return Index(node.span, self.expression(node.base), indices)

    def _slice(self, node: Slice) -> Expression:
        type_name = self.scope.elementary_of(node.base) if self.scope else ""
        base = self.expression(node.base)
        if not can_be_sliced(type_name, node):
            self.context.findings.refuse(
                f"the slice .%{node.size}{node.index} of {type_name or 'an unknown type'}",
                node.span,
                "copy the value into a variable of type BYTE, WORD or DWORD first",
            )
            return node
        return read_slice(node.span, base, type_name, node)

    def _address(self, node: DirectAddress) -> Expression:
        if node.area == "DB":
            self.context.findings.refuse(node.span.text, node.span, "use names in data blocks")
        elif node.peripheral:
            self.context.findings.refuse(f"{node.span.text}", node.span, _HARDWARE_HINT)
        elif node.size not in ("X", "B"):
            self.context.findings.refuse(
                node.span.text,
                node.span,
                "IEC counts words, S7 bytes: address single bytes and put them together",
            )
        else:
            name = self.context.located(node)
            self.used_globals[name.casefold()] = name
            return Name(node.span, name)
        return node

    def _call(self, node: Call) -> Expression:
        arguments = tuple(self._argument(one) for one in node.arguments)
        callee = node.callee
        if not isinstance(callee, Name) or (self.scope and self.scope.is_declared(callee)):
            return Call(node.span, self.expression(callee), arguments)
        function = self.context.plant.function(callee.name)
        upper = callee.name.upper()
        if function is not None:
            if self.context.is_program(function):
                self.context.findings.report(
                    "FB3053",
                    f"'{callee.name}' becomes a PROGRAM, which nobody can call",
                    node.span,
                    "give it what it needs as VAR_IN_OUT, or leave the call out",
                )
            return Call(node.span, Name(callee.span, callee.name), arguments)
        if self.context.plant.is_data_block(callee):
            return Call(node.span, self._name(callee), arguments)
        if not callee.quoted and (
            is_standard_function(upper, self.context.target) or upper in RENAMED_FUNCTIONS
        ):
            name = Name(callee.span, RENAMED_FUNCTIONS.get(upper, upper))
            call = standard_without_names(Call(node.span, name, arguments))
            return same_truth(call, "tia", self.context.target.dialect.name, self.context.findings)
        self.context.findings.refuse(f"the instruction {callee.name}", callee.span, _HARDWARE_HINT)
        return node

    def _argument(self, node: Argument) -> Argument:
        value = node.value
        if node.kind is ArgumentKind.OUTPUT and isinstance(value, Slice):
            self.context.findings.refuse(
                "a slice as the place of an output",
                value.span,
                "give the output to a variable and assign that",
            )
            return node
        lowered = None if value is None else self.expression(value)
        return Argument(node.span, node.kind, node.name, lowered, node.leading, node.trailing)

    def _unary(self, node: Unary) -> Expression:
        return Unary(node.span, node.operator, self.expression(node.operand))

    def _binary(self, node: Binary) -> Expression:
        steps: list[Binary] = []
        left: Expression = node
        while isinstance(left, Binary):
            steps.append(left)
            left = left.left
        result = self.expression(left)
        for step in reversed(steps):
            operator = "/" if step.operator == "DIV" else step.operator
            result = Binary(step.span, operator, result, self.expression(step.right))
        return result

    def _parenthesized(self, node: Parenthesized) -> Expression:
        return Parenthesized(node.span, self.expression(node.inner))

    def _array(self, node: ArrayLiteral) -> Expression:
        return ArrayLiteral(node.span, tuple(self.expression(one) for one in node.items))

    def _repeated(self, node: Repeated) -> Expression:
        value = None if node.value is None else self.expression(node.value)
        return Repeated(node.span, self.constant(node.count), value)

    def _struct(self, node: StructLiteral) -> Expression:
        for field in node.fields:
            if field.kind is ArgumentKind.POSITIONAL:
                self.context.findings.refuse(
                    "a structure's value without names", field.span, "write (name := value)"
                )
                return node
        return StructLiteral(node.span, tuple(self._argument(one) for one in node.fields))

    def _without_counterpart(self, node: Expression) -> Expression:
        what, hint = _WITHOUT_COUNTERPART[type(node)]
        self.context.findings.refuse(what, node.span, hint)
        return node


_WITHOUT_COUNTERPART: dict[type, tuple[str, str]] = {
    Chained: ("an assignment in an assignment", "write one assignment a statement"),
    Dereference: ("what a reference points to", "hand the variable over as VAR_IN_OUT"),
    IndexedAddress: ("an absolute address with an index", "use an array"),
    Peripheral: ("peripheral access", _HARDWARE_HINT),
}

_LOWERERS: dict[type, Callable[[ExpressionLowering, Any], Expression]] = {
    Literal: ExpressionLowering._literal,
    Name: ExpressionLowering._name,
    Member: ExpressionLowering._member,
    Index: ExpressionLowering._index,
    Slice: ExpressionLowering._slice,
    DirectAddress: ExpressionLowering._address,
    Call: ExpressionLowering._call,
    Unary: ExpressionLowering._unary,
    Binary: ExpressionLowering._binary,
    Parenthesized: ExpressionLowering._parenthesized,
    ArrayLiteral: ExpressionLowering._array,
    Repeated: ExpressionLowering._repeated,
    StructLiteral: ExpressionLowering._struct,
    **dict.fromkeys(_WITHOUT_COUNTERPART, ExpressionLowering._without_counterpart),
}
