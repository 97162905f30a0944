"""Statements of one line: assignments, calls, jumps, labels.

Source: IEC 61131-3, statements of ST; TIA Portal help, "Value assignments" and "SCL instructions".
"""

from fbgen.lang.ast import (
    Assignment,
    Branch,
    Call,
    CallStatement,
    Chained,
    Dereference,
    DirectAddress,
    Empty,
    Expression,
    Goto,
    If,
    Index,
    IndexedAddress,
    Jump,
    Label,
    Member,
    Name,
    Peripheral,
    Slice,
    Statement,
)
from fbgen.lang.depth import DEEPEST
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.parser.statement_lists import ASSIGNMENTS, JUMPS, StatementListParser, enter
from fbgen.source import Span

_PLACES = (
    Name, Member, Index, Slice, DirectAddress, IndexedAddress, Peripheral, Dereference,
)  # fmt: skip
_SETS = frozenset({"S=", "R=", "REF="})
_FEATURES = {
    **dict.fromkeys(ASSIGNMENTS, Feature.COMPOUND_ASSIGNMENTS),
    "?=": Feature.ASSIGNMENT_ATTEMPTS,
}
_CHAINS = frozenset({*ASSIGNMENTS, "name"})
_make = tuple.__new__


class SimpleStatementParser(StatementListParser):
    """Reads statements without statements in them."""

    def simple(self) -> Statement:
        """An assignment, a call or a label."""
        first = self.at
        leading = self.take_leading() if self.extra_at <= first else ()
        target = self.operand()
        kind = self.kinds[self.at]
        if kind == "name":
            kind = self.set_operator() or kind
        if kind == ":=" or kind in ASSIGNMENTS or kind in _SETS:
            self.at += 1
            if kind != ":=" and kind not in _SETS:
                self.need(_FEATURES[kind], self.at - 1)
            value = self.expression()
            if self.kinds[self.at] != ";" and self.kinds[self.at] in _CHAINS:
                value = self._chained(value)
            if self.kinds[self.at] == ";":
                self.at += 1
            else:
                self.semicolon()
            place = _make(Span, (self.source, self.starts[first], self.ends[self.at - 1]))
            if self.extra_at > self.at:
                return Assignment(place, target, kind, value, leading)
            leading, trailing = self.settle(leading)
            return Assignment(place, target, kind, value, leading, trailing)
        if isinstance(target, Call):
            self.semicolon()
            place = self.span(first)
            leading, trailing = self.finish(leading)
            return CallStatement(place, target, leading, trailing)
        if kind == ":" and isinstance(target, Name) and not target.quoted:
            self.at += 1
            if not self.dialect.has(Feature.JUMPS):
                self.need(Feature.GOTO, first)
            self.accept(";")
            place = self.span(first)
            leading, trailing = self.finish(leading)
            return Label(place, target.name, leading, trailing)
        raise self.no_statement(target, first)

    def _chained(self, value: Expression) -> Expression:
        """The `b := c` of `a := b := c`, where `b` has been read."""
        targets: list[tuple[Expression, str]] = []
        while operator := self._next_sign():
            if not targets:
                self.need(Feature.CHAINED_ASSIGNMENTS, self.at)
            if not isinstance(value, _PLACES):
                raise self.failed("';'", "only variables stand in front of ':='")
            if self.depth + len(targets) > DEEPEST:
                self.too_deep()
            targets.append((value, operator))
            self.at += 1
            if operator != ":=" and operator not in _SETS:
                self.need(_FEATURES[operator], self.at - 1)
            value = self.expression()
        for target, operator in reversed(targets):
            place = _make(Span, (self.source, target.span[1], value.span[2]))
            value = Chained(place, target, operator, value)
        return value

    def _next_sign(self) -> str:
        """The sign of a further assignment in the statement, "" at its end."""
        kind = self.kinds[self.at]
        if kind == "name":
            return self.set_operator()
        return kind if kind in ASSIGNMENTS else ""

    def _empty(self) -> Empty:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return Empty(place, leading, trailing)

    def _jump(self) -> Jump:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.semicolon()
        place = self.span(first)
        keyword = self.kinds[first]
        leading, trailing = self.finish(leading)
        return Jump(place, keyword, leading, trailing)

    def _return(self) -> Jump | If:
        """RETURN; of CODESYS also `RETURN(condition);`, the same as an IF around it."""
        if self.kinds[self.at + 1] != "(" or not self.dialect.has(Feature.JUMPS):
            return self._jump()
        leading = self.take_leading()
        first = self.at
        self.at += 1
        condition = self.expression()
        self.semicolon()
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return If(
            place, (Branch(place, condition, (Jump(place, "RETURN"),)),), None, leading, trailing
        )

    def _goto(self) -> Goto:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        label = self.name().name
        self.need(JUMPS[self.kinds[first]], first)
        self.semicolon()
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return Goto(place, label, leading, trailing)


enter(
    {
        **dict.fromkeys(("name", "#", '"', '#"', "address", "."), SimpleStatementParser.simple),
        "EXIT": SimpleStatementParser._jump,
        "CONTINUE": SimpleStatementParser._jump,
        "RETURN": SimpleStatementParser._return,
        "GOTO": SimpleStatementParser._goto,
        "JMP": SimpleStatementParser._goto,
        ";": SimpleStatementParser._empty,
    }
)
