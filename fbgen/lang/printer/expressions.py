"""Expressions as text. Parentheses come back as they were written; where a tree needs them and has
none (it was built, not read) they are added."""

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
    LabelRange,
    Literal,
    Member,
    Name,
    Parenthesized,
    Peripheral,
    Repeated,
    Slice,
    StructLiteral,
    Unary,
)
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.parser.addresses import is_data_block
from fbgen.lang.parser.expressions import PRECEDENCE
from fbgen.lang.printer.lines import inline_comment

_SIGN = 9
_HIGHEST = 10
_GERMAN = {"I": "E", "Q": "A", "C": "Z"}


class ExpressionPrinter:
    """Writes expressions of one dialect, each on one line."""

    def __init__(self, dialect: Dialect) -> None:
        self.dialect = dialect
        self._bit_members = dialect.has(Feature.BIT_MEMBERS)
        self._bare_bits = not dialect.has(Feature.PROGRAMS)
        self._plain_addresses = dialect.has(Feature.PLAIN_ADDRESSES)
        self._bare_arrays = dialect.has(Feature.BARE_ARRAYS)
        self._power_first = dialect.has(Feature.POWER_FIRST)

    def expression(self, expression: Expression) -> str:
        """The text of one expression."""
        return _WRITERS[type(expression)](self, expression)

    def chain(self, expression: Expression) -> tuple[str, list[tuple[str, str]]]:
        """The first operand and all (operator, operand) of the loosest level, left to right."""
        steps: list[tuple[str, str]] = []
        level = _precedence(expression)
        while isinstance(expression, Binary) and PRECEDENCE[expression.operator] == level:
            right = self._wrapped(expression.right, level + 1)
            steps.append((expression.operator, right))
            expression = expression.left
        steps.reverse()
        return self._wrapped(expression, level), steps

    def _wrapped(self, operand: Expression, lowest: int) -> str:
        text = self.expression(operand)
        return f"({text})" if _precedence(operand) < lowest else text

    def name(self, name: Name) -> str:
        """A name with its marks."""
        text = f'"{name.name}"' if name.quoted else name.name
        return f"#{text}" if name.local else f".{text}" if name.outer else text

    def argument(self, argument: Argument) -> str:
        """One argument, without its comments."""
        value = "" if argument.value is None else self.expression(argument.value)
        if argument.kind is ArgumentKind.POSITIONAL:
            return value
        name = f'"{argument.name}"' if argument.quoted else argument.name
        return f"{name} {argument.kind.value} {value}".rstrip()

    def label(self, label: Expression | LabelRange) -> str:
        """One value or range of a CASE."""
        if isinstance(label, LabelRange):
            return f"{self.expression(label.first)}..{self.expression(label.last)}"
        return self.expression(label)

    def arguments(self, arguments: tuple[Argument, ...]) -> str:
        """All arguments on one line, with comments as `(* *)` between them."""
        pieces: list[str] = []
        last = len(arguments) - 1
        for number, argument in enumerate(arguments):
            pieces += [inline_comment(item) for item in argument.leading if item.text]
            pieces.append(self.argument(argument) + ("," if number < last else ""))
            if argument.trailing:
                pieces.append(inline_comment(argument.trailing))
        return " ".join(pieces)

    # --- one method a kind of node ------------------------------------------------------------

    def _literal(self, literal: Literal) -> str:
        return literal.text

    def _member(self, member: Member) -> str:
        name = f'"{member.name}"' if member.quoted else member.name
        return f"{self.expression(member.base)}.{name}"

    def _index(self, index: Index) -> str:
        indices = ", ".join(self.expression(item) for item in index.indices)
        return f"{self.expression(index.base)}[{indices}]"

    def _slice(self, part: Slice) -> str:
        mark = "" if part.size == "X" and self._bit_members else f"%{part.size}"
        return f"{self.expression(part.base)}.{mark}{part.index}"

    def _address(self, address: DirectAddress) -> str:
        bit = f".{address.bit}" if address.size == "X" and address.byte >= 0 else ""
        mark = "" if self._plain_addresses else "%"
        if address.area == "DB":
            peripheral = ":P" if address.peripheral else ""
            part = f"DB{address.size}{address.byte}{bit}"
            return f"{mark}DB{address.db}.{part}{peripheral}"
        area, peripheral = self._area(address)
        number = "*" if address.byte < 0 else str(address.byte)
        return f"{mark}{area}{number}{bit}{peripheral}"

    def _area(self, address: DirectAddress | IndexedAddress) -> tuple[str, str]:
        """Area and size, and what stands behind a peripheral address."""
        area = _GERMAN.get(address.area, address.area) if address.german else address.area
        bare = address.size == "X" and self._bare_bits
        size = "" if bare else address.size
        if address.peripheral and self._plain_addresses:
            return f"P{area}{size}", ""
        return f"{area}{size}", ":P" if address.peripheral else ""

    def _indexed_address(self, address: IndexedAddress) -> str:
        indices = ", ".join(self.expression(item) for item in address.indices)
        opening, closing = ("[", "]") if self._plain_addresses else ("(", ")")
        mark = "" if self._plain_addresses else "%"
        base = address.base
        if base is None:
            area, peripheral = self._area(address)
            return f"{mark}{area}{opening}{indices}{closing}{peripheral}"
        peripheral = ":P" if address.peripheral else ""
        if address.marked:
            numbers = ".".join(self.expression(item) for item in address.indices)
            sign = "D" if self._plain_addresses else "%DB"
            return f"{self.expression(base)}.{sign}{address.size}{numbers}{peripheral}"
        is_absolute = isinstance(base, Name) and not base.quoted and is_data_block(base.name)
        block = f"{mark if is_absolute else ''}{self.expression(base)}"
        return f"{block}.D{address.size}{opening}{indices}{closing}{peripheral}"

    def _peripheral(self, node: Peripheral) -> str:
        return f"{self.expression(node.base)}:P"

    def _dereference(self, node: Dereference) -> str:
        return f"{self.expression(node.base)}^"

    def _chained(self, node: Chained) -> str:
        pieces: list[str] = []
        value: Expression = node
        while isinstance(value, Chained):
            pieces.append(f"{self.expression(value.target)} {value.operator} ")
            value = value.value
        return "".join(pieces) + self.expression(value)

    def _call(self, call: Call) -> str:
        return f"{self.expression(call.callee)}({self.arguments(call.arguments)})"

    def _unary(self, unary: Unary) -> str:
        gap = " " if unary.operator.isalpha() else ""
        lowest = PRECEDENCE["**"] if self._power_first else _SIGN
        return f"{unary.operator}{gap}{self._wrapped(unary.operand, lowest)}"

    def _binary(self, binary: Binary) -> str:
        first, steps = self.chain(binary)
        if self._power_first and binary.operator == "**" and first.startswith(("-", "+", "NOT ")):
            first = f"({first})"
        return first + "".join(f" {operator} {operand}" for operator, operand in steps)

    def _parenthesized(self, inner: Parenthesized) -> str:
        return f"({self.expression(inner.inner)})"

    def _array(self, array: ArrayLiteral) -> str:
        items = ", ".join(self.expression(item) for item in array.items)
        return items if array.bare and self._bare_arrays else f"[{items}]"

    def _repeated(self, repeated: Repeated) -> str:
        value = repeated.value
        if isinstance(value, ArrayLiteral) and value.bare:
            text = ", ".join(self.expression(item) for item in value.items)
        else:
            text = "" if value is None else self.expression(value)
        return f"{self.expression(repeated.count)}({text})"

    def _struct(self, struct: StructLiteral) -> str:
        return f"({self.arguments(struct.fields)})"


def _precedence(expression: Expression) -> int:
    if isinstance(expression, Binary):
        return PRECEDENCE[expression.operator]
    return _SIGN if isinstance(expression, Unary) else _HIGHEST


_WRITERS: dict[type, Callable[[ExpressionPrinter, Any], str]] = {
    Literal: ExpressionPrinter._literal,
    Name: ExpressionPrinter.name,
    Member: ExpressionPrinter._member,
    Index: ExpressionPrinter._index,
    Slice: ExpressionPrinter._slice,
    DirectAddress: ExpressionPrinter._address,
    IndexedAddress: ExpressionPrinter._indexed_address,
    Peripheral: ExpressionPrinter._peripheral,
    Dereference: ExpressionPrinter._dereference,
    Chained: ExpressionPrinter._chained,
    Call: ExpressionPrinter._call,
    Unary: ExpressionPrinter._unary,
    Binary: ExpressionPrinter._binary,
    Parenthesized: ExpressionPrinter._parenthesized,
    ArrayLiteral: ExpressionPrinter._array,
    Repeated: ExpressionPrinter._repeated,
    StructLiteral: ExpressionPrinter._struct,
}
