"""Expressions, places and calls, with precedence climbing.

Precedence from loosest: OR, XOR, AND, `= <>`, `< > <= >=`, `+ -`, `* / MOD DIV`, then signs, NOT
and `**`: a sign binds looser than `**` where the dialect says so (TIA), tighter in IEC.
Source: TIA Portal help, "Operators and order of evaluation"; IEC 61131-3, operators of ST.
"""

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    ArrayLiteral,
    Binary,
    Call,
    Dereference,
    Expression,
    Literal,
    LiteralKind,
    Member,
    Name,
    Parenthesized,
    Repeated,
    Slice,
    StructLiteral,
    TriviaList,
    Unary,
)
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.literals import BadLiteralError, LiteralValue, read_literal
from fbgen.lang.parser.places import NAMES, AddressParser
from fbgen.lang.parser.soft_words import SOFT_WORDS
from fbgen.source import Source, Span

PRECEDENCE = {
    "OR": 1,
    "OR_ELSE": 1,
    "XOR": 2,
    "AND": 3,
    "AND_THEN": 3,
    "=": 4,
    "<>": 4,
    "<": 5,
    ">": 5,
    "<=": 5,
    ">=": 5,
    "+": 6,
    "-": 6,
    "*": 7,
    "/": 7,
    "MOD": 7,
    "DIV": 7,
    "**": 8,
}
SOFT_KEYWORDS = SOFT_WORDS | words(
    "TYPE PROGRAM RESOURCE CONFIGURATION BEGIN STRUCT ARRAY REGION DATA_BLOCK FUNCTION "
    "ORGANIZATION_BLOCK LABEL CONST"
)
"""Keywords that can only be names where an expression is wanted."""

_POSTFIX = frozenset({".", "[", "(", "^", ":"})
_SIGNS = frozenset({"-", "+", "NOT"})
_FUNCTIONS = frozenset({"AND", "OR", "XOR", "MOD"})
"""Operators that are functions, too: `AND(a, b)`, as it comes from function block diagrams."""
_NOTHING = LiteralValue(LiteralKind.INTEGER, 0)
_make = tuple.__new__


class ExpressionParser(AddressParser):
    """Reads expressions at the cursor."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        super().__init__(source, dialect)
        self._literals: dict[str, LiteralValue] = {}
        self._local_marks = dialect.has(Feature.LOCAL_MARKS)
        self._power_first = dialect.has(Feature.POWER_FIRST)
        self._bare_arrays = dialect.has(Feature.BARE_ARRAYS)
        self._has_outer_names = dialect.has(Feature.OUTER_NAMES)
        self._has_empty_arguments = dialect.has(Feature.EMPTY_ARGUMENTS)

    def expression(self) -> Expression:
        """One expression."""
        left = self.operand()
        following = self.kinds[self.at]
        if following != ";" and following in PRECEDENCE:
            return self._climb(left, 0)
        return left

    def _climb(self, left: Expression, lowest: int) -> Expression:
        """Go on from `left` with all operators that bind tighter than `lowest`."""
        kinds = self.kinds
        source, start = self.source, left.span[1]
        operator = kinds[self.at]
        precedence = PRECEDENCE.get(operator, 0)
        while precedence > lowest:
            self.at += 1
            right = self.operand()
            following = kinds[self.at]
            next_precedence = PRECEDENCE.get(following, 0)
            while next_precedence > precedence:
                right = self._climb(right, precedence)
                following = kinds[self.at]
                next_precedence = PRECEDENCE.get(following, 0)
            place = _make(Span, (source, start, right.span[2]))
            left = Binary(place, operator, left, right)
            operator, precedence = following, next_precedence
        return left

    def operand(self) -> Expression:
        """A literal, a place, a call, something in parentheses, or one of these with a sign."""
        at = self.at
        kinds, text = self.kinds, self.texts[at]
        kind = kinds[at]
        place = _make(Span, (self.source, self.starts[at], self.ends[at]))
        if kind == "#":
            name: Expression = Name(place, text[1:], False, True)
            if not self._local_marks:
                self.missing_feature(Feature.LOCAL_MARKS, place)
        elif kind == "name":
            name = Name(place, text)
        elif kind == "literal":
            self.at = at + 1
            value = self._literals.get(text) or self._new_literal(text, place)
            return Literal(place, value.kind, value.value, text, value.type_name, value.base)
        elif kind in NAMES:
            name = self.name()
            self.at = at
        elif kind in _SIGNS:
            return self._signed(kind, place)
        elif kind == "(":
            return self._parenthesized()
        elif kind == "address":
            name = self.address_or_name()
            self.at -= 1
            at = self.at
        elif (kind in SOFT_KEYWORDS and self.word(at)) or (
            kind in _FUNCTIONS and kinds[at + 1] == "("
        ):
            name = Name(place, text)
        elif kind == "." and kinds[at + 1] == "name" and self._has_outer_names:
            at += 1
            place = _make(Span, (self.source, self.starts[at - 1], self.ends[at]))
            name = Name(place, self.texts[at], outer=True)
        else:
            raise self.failed("an expression", "a value, a variable, a call or '(' can stand here")
        self.at = at = at + 1
        if kinds[at] in _POSTFIX:
            return self._postfix(name)
        return name

    def _is_function(self, at: int) -> bool:
        """Whether an operator stands in front of its operands: `AND(a, b)`."""
        return self.kinds[at] in _FUNCTIONS and self.kinds[at + 1] == "("

    def _new_literal(self, text: str, place: Span) -> LiteralValue:
        try:
            value = read_literal(text)
        except BadLiteralError as problem:
            self.report("FB3004", str(problem), place, problem.help)
            return _NOTHING
        if value.kind is LiteralKind.ENUMERATOR and not self.dialect.has(Feature.ENUMERATIONS):
            self.report(
                "FB3004",
                f"'{value.type_name}#' is not the prefix of a type",
                place,
                "use a type such as WORD#, DINT# or T#",
            )
        if value.type_name and self.dialect.absent_types:
            self.check_type(value.type_name, place)
        self._literals[text] = value
        return value

    def _signed(self, operator: str, place: Span) -> Unary:
        self.at += 1
        self.deeper()
        operand = self.operand()
        if self._power_first and self.kinds[self.at] == "**":
            operand = self._climb(operand, PRECEDENCE["**"] - 1)
        self.depth -= 1
        return Unary(_make(Span, (self.source, place[1], operand.span[2])), operator, operand)

    def _parenthesized(self) -> Parenthesized:
        first = self.at
        self.at = first + 1
        self.deeper()
        inner = self.expression()
        self.expect(")", "')'", "each '(' needs its ')'")
        self.depth -= 1
        return Parenthesized(self.span(first), inner)

    def _postfix(self, base: Expression) -> Expression:
        """`base` with all that follows it: members, slices, indices, arguments, `^`, `:P`."""
        source, start = self.source, base.span[1]
        kinds, ends = self.kinds, self.ends
        while True:
            at = self.at
            kind = kinds[at]
            if kind == ".":
                # most members are plain names, and addresses begin with DB
                if kinds[at + 1] == "name" and type(base) is not Call:
                    text = self.texts[at + 1]
                    if text[0] not in "dD" or not self.has_addresses:
                        base = Member(_make(Span, (source, start, ends[at + 1])), base, text)
                        self.at = at + 2
                        continue
                base = self._member(base)
            elif kind == "[":
                self.at += 1
                self.deeper()
                indices = [self.expression()]
                while self.accept(","):
                    indices.append(self.expression())
                self.expect("]", "']' or ','", "each '[' needs its ']'")
                self.depth -= 1
                place = _make(Span, (source, start, self.ends[self.at - 1]))
                base = self.bracketed(base, tuple(indices), place)
            elif kind == "(":
                self.at += 1
                arguments = self.arguments()
                place = _make(Span, (source, start, self.ends[self.at - 1]))
                base = self.called(base, arguments, place)
            elif kind == "^":
                self.at += 1
                self.need(Feature.REFERENCES, self.at - 1)
                base = Dereference(_make(Span, (source, start, self.ends[self.at - 1])), base)
            elif kind == ":" and self.at_peripheral_mark(self.at):
                self.at += 2
                self.need(Feature.PERIPHERAL, self.at - 2)
                base = self.peripheral(base, _make(Span, (source, start, self.ends[self.at - 1])))
            else:
                return base

    def _member(self, base: Expression) -> Expression:
        at = self.at + 1
        kind, text = self.kinds[at], self.texts[at]
        place = _make(Span, (self.source, base.span[1], self.ends[at]))
        self.at = at + 1
        if kind == "name":
            if self.has_addresses and (address := self.member_address(base, text)):
                return address
            return Member(place, base, text)
        if kind == '"':
            self.need(Feature.QUOTED_NAMES, at)
            return Member(place, base, text[1:-1], True)
        if kind == "#":
            return Member(place, base, text[1:])
        if kind == '#"':
            return Member(place, base, text[2:-1], True)
        if kind == "address" and (part := self.marked_member(base, text, at)):
            return part
        if kind == "literal" and (enumerator := self._qualified_enumerator(place, base, text)):
            return enumerator
        if kind == "literal" and text.isdecimal() and len(text) < 3:
            self.need(Feature.BIT_MEMBERS, at)
            return Slice(place, base, "X", int(text))
        if self.word(at):
            return Member(place, base, text)
        self.at = at
        raise self.failed("the name of a member", "behind '.' stands a name, or a slice like %X0")

    def _qualified_enumerator(self, place: Span, base: Expression, text: str) -> Literal | None:
        """`Plant.State#running`, whose part behind the first dot is one token."""
        prefix, mark, name = text.partition("#")
        space = place.text[: base.span.end - base.span.start]
        if not (mark and prefix.isidentifier() and name.isidentifier()):
            return None
        self.need(Feature.ENUMERATIONS, self.at - 1)
        kind = LiteralKind.ENUMERATOR
        return Literal(place, kind, name, place.text, f"{space}.{prefix}")

    def arguments(self) -> tuple[Argument, ...]:
        """The arguments of a call behind its '(', up to and with the ')'."""
        if self.accept(")"):
            return ()
        self.deeper()
        arguments: list[Argument] = []
        while True:
            argument = self._argument()
            more = self.accept(",")
            if self.extra_at <= self.at:
                leading, trailing = self.settle(argument.leading)
                if not more and trailing is None:
                    trailing = self.take_inline()
                argument = Argument(
                    argument.span,
                    argument.kind,
                    argument.name,
                    argument.value,
                    leading,
                    trailing,
                    argument.quoted,
                )
            arguments.append(argument)
            if not more or (self.kinds[self.at] == ")" and self._has_empty_arguments):
                break
        self.expect(")", "')' or ','", "arguments are separated by ',' and end with ')'")
        self.depth -= 1
        return tuple(arguments)

    def _argument(self) -> Argument:
        first = self.at
        leading = self.take_leading() if self.extra_at <= first else ()
        following = self.kinds[first + 1] if self.kinds[first] != "end" else "end"
        if following in (":=", "=>"):
            name, is_quoted = self.texts[first], False
            if self.kinds[first] != "name":
                written = self.name()
                name, is_quoted = written.name, written.quoted
            self.at = first + 2
            kind = ArgumentKind.INPUT if following == ":=" else ArgumentKind.OUTPUT
            value: Expression | None = None
            is_empty = self.kinds[self.at] in (",", ")")
            if not is_empty or (following == ":=" and not self._has_empty_arguments):
                value = self.expression()
            span = self.span(first)
            return Argument(span, kind, name, value, leading, None, is_quoted)
        value = self.expression()
        return Argument(self.span(first), ArgumentKind.POSITIONAL, "", value, leading)

    # --- initial values -----------------------------------------------------------------------

    def initial_value(self) -> Expression:
        """What stands behind ':=' in a declaration: an expression, [..] or (..)."""
        kind = self.kinds[self.at]
        if kind == "[":
            return self._array_literal()
        if kind == "(":
            following = self.kinds[self.at + 1]
            if following in (")", ",", "[", "(") or self.kinds[self.at + 2] in (":=", ","):
                return self._struct_or_parenthesized()
        return self.expression()

    def _array_literal(self) -> ArrayLiteral:
        first = self.expect("[")
        self.deeper()
        items: list[Repeated | Expression] = []
        while self.kinds[self.at] != "]":
            items.append(self.array_item())
            if not self.accept(","):
                break
        self.expect("]", "']' or ','", "initial values of an array look like [1, 2, 3(0)]")
        self.depth -= 1
        return ArrayLiteral(self.span(first), tuple(items))

    def array_value(self) -> Expression:
        """What stands behind ':=' where an array is declared."""
        if self._bare_arrays and self.kinds[self.at] != "[":
            return self._bare_array()
        return self.initial_value()

    def _bare_array(self) -> Expression:
        """`1, 2, 3(0)`: a lone value is that value, all else an array."""
        first = self.at
        items = [self.array_item()]
        while self.accept(","):
            items.append(self.array_item())
        if len(items) == 1 and not isinstance(items[0], Repeated):
            return items[0]
        return ArrayLiteral(self.span(first), tuple(items), True)

    def array_item(self) -> Expression:
        """One item of an array, with a number of repetitions or without."""
        first = self.at
        value = self.initial_value()
        if isinstance(value, Call) and value.arguments and isinstance(value.callee, Name):
            given = [
                one.value
                for one in value.arguments
                if one.kind is ArgumentKind.POSITIONAL and one.value is not None
            ]
            if len(given) == len(value.arguments):
                self.put_back(value.arguments)
                return Repeated(value.span, value.callee, _one_or_bare(value.span, given))
        if isinstance(value, Literal) and self.accept("("):
            self.deeper()
            items: list[Expression] = []
            start = self.at
            while self.kinds[self.at] != ")":
                items.append(self.array_item())
                if not self.accept(","):
                    break
            inside = self.span(start) if items else value.span
            self.depth -= 1
            self.expect(")", "')' or ','", "repeated values of an array look like 2(0) or 2(0, 1)")
            repeated = _one_or_bare(inside, items) if items else None
            return Repeated(self.span(first), value, repeated)
        return value

    def _struct_or_parenthesized(self) -> Expression:
        """`(a := 1)`, `()`, `(1, , 3)`; a single value in parentheses is only that value."""
        first = self.expect("(")
        self.deeper()
        fields: list[Argument] = []
        while self.kinds[self.at] != ")":
            fields.append(self._struct_field())
            if not self.accept(","):
                break
            if self.kinds[self.at] == ")" and not self._has_empty_arguments:
                fields.append(self._empty_field())
        self.expect(")", "')' or ','", "initial values of a structure look like (a := 1, b := 2)")
        self.depth -= 1
        only = fields[0] if len(fields) == 1 else None
        if only and only.kind is ArgumentKind.POSITIONAL and only.value is not None:
            value = only.value
            if not isinstance(value, (StructLiteral, ArrayLiteral)):
                return self._rest_of_expression(Parenthesized(self.span(first), value))
        return StructLiteral(self.span(first), tuple(fields))

    def _rest_of_expression(self, left: Expression) -> Expression:
        return self._climb(left, 0) if self.kinds[self.at] in PRECEDENCE else left

    def _struct_field(self) -> Argument:
        first = self.at
        leading = self.take_leading()
        if self.kinds[first] == ",":
            return self._empty_field(leading)
        if self.kinds[first + 1] == ":=":
            name = self.name()
            self.at = first + 2
            value = self.initial_value()
            span = self.span(first)
            return Argument(span, ArgumentKind.INPUT, name.name, value, leading, None, name.quoted)
        value = self.initial_value()
        return Argument(self.span(first), ArgumentKind.POSITIONAL, "", value, leading)

    def _empty_field(self, leading: TriviaList = ()) -> Argument:
        place = Span(self.source, self.starts[self.at], self.starts[self.at])
        return Argument(place, ArgumentKind.POSITIONAL, "", None, leading)


def _one_or_bare(span: Span, items: list[Expression]) -> Expression:
    """What is repeated: one value, or several without brackets of their own."""
    return items[0] if len(items) == 1 else ArrayLiteral(span, tuple(items), True)
