"""Statements.

Source: IEC 61131-3, statements of ST; TIA Portal help, "SCL instructions"; published sources for
jump labels inside CASE, `ELSE:` and raw REGION lines.
"""

from collections.abc import Callable
from typing import TypeVar

from fbgen.lang.ast import (
    Assignment,
    Branch,
    Call,
    CallStatement,
    Case,
    CaseArm,
    ElseBranch,
    Empty,
    Expression,
    For,
    Goto,
    If,
    Jump,
    Label,
    LabelRange,
    Name,
    Region,
    Repeat,
    Statement,
    Trivia,
    TriviaList,
    While,
)
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.declarations import UNITS, DeclarationParser
from fbgen.lang.parser.expressions import NAMES, SOFT_KEYWORDS
from fbgen.source import Source, Span

_ASSIGNMENTS = frozenset({":=", "+=", "-=", "*=", "/="})
_LABEL_PARTS = NAMES | {".", "+", "-", "literal"}
_ENDS = (
    frozenset(f"END_{unit}" for unit in UNITS)
    | {"END_IF", "END_CASE", "END_FOR", "END_WHILE", "END_REPEAT", "END_REGION", "END_RESOURCE"}
    | {"END_VAR", "END_STRUCT", "ELSE", "ELSIF", "UNTIL"}
)
_STARTS = words("IF CASE FOR WHILE REPEAT REGION EXIT CONTINUE RETURN GOTO")
_OPENERS = {
    "ELSE": "IF or CASE",
    "ELSIF": "IF",
    "UNTIL": "REPEAT",
}
_S = TypeVar("_S")
_make = tuple.__new__


class StatementParser(DeclarationParser):
    """Reads lists of statements. `_open` has, per open statement, what can end a list in it."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        super().__init__(source, dialect)
        self._open: list[frozenset[str]] = []
        self._has_goto = "GOTO" in self.kinds
        self._jump_targets: frozenset[str] = frozenset()

    def body(self, end: str) -> tuple[Statement, ...]:
        """The statements of a block up to its end, which is not read."""
        self._jump_targets = self._targets_of_jumps(end) if self._has_goto else frozenset()
        return self._inside({end}, self._statements)

    def _targets_of_jumps(self, end: str) -> frozenset[str]:
        last = self.kinds.index(end, self.at) if end in self.kinds[self.at :] else len(self.kinds)
        return frozenset(
            self.texts[at + 1].casefold()
            for at in range(self.at, last - 1)
            if self.kinds[at] == "GOTO"
        )

    def _inside(self, ends: set[str], read: Callable[[], _S]) -> _S:
        """Read one level deeper, where the list of statements ends with one of `ends`."""
        self.deeper()
        self._open.append(frozenset(ends))
        try:
            return read()
        finally:
            self._open.pop()
            self.depth -= 1

    def _statements(self) -> tuple[Statement, ...]:
        statements: list[Statement] = []
        kinds, depth, levels = self.kinds, self.depth, len(self._open)
        while True:
            start = self.at
            kind = kinds[start]
            if kind in _READERS:
                try:
                    statements.append(_READERS[kind](self))
                except Unexpected:
                    self._recover(start, depth, levels)
            elif self._at_end(kind):
                return tuple(statements)

    def _arm_statements(self) -> tuple[Statement, ...]:
        """Statements up to the next label of the CASE, or its end."""
        statements: list[Statement] = []
        kinds, depth, levels = self.kinds, self.depth, len(self._open)
        while True:
            start = self.at
            kind = kinds[start]
            if (kind in _LABEL_PARTS or kind in SOFT_KEYWORDS) and self._at_case_label():
                return tuple(statements)
            if kind in _READERS:
                try:
                    statements.append(_READERS[kind](self))
                except Unexpected:
                    self._recover(start, depth, levels)
            elif self._at_end(kind):
                return tuple(statements)

    def _recover(self, start: int, depth: int, levels: int) -> None:
        """Go back to this level of nesting and on to the next statement."""
        self.depth = depth
        del self._open[levels:]
        self._skip_statement(start)

    def _at_end(self, kind: str) -> bool:
        """Whether the list ends here. Anything that is neither end nor statement is skipped."""
        if kind in self._open[-1] or kind == "end":
            return True
        soft = self.kinds[self.at + 1] in (":=", ".", "[", "(")
        if kind in UNITS and not soft:
            return True
        if kind in _ENDS:
            if any(kind in ends for ends in self._open):
                return True
            if kind == "END_REGION" and Feature.REGIONS not in self.dialect.features:
                self.missing_feature(Feature.REGIONS, self.token_span(self.at))
                self._skip_line()
                return False
            opener = _OPENERS.get(kind) or kind.removeprefix("END_")
            self._last_finding_at = self.at
            self.report(
                "FB3008",
                f"{kind} without {opener}",
                self.token_span(self.at),
                f"remove it, or write the {opener} that it ends",
            )
            self.at += 1
            self.accept(";")
            return False
        if soft and self.word(self.at):
            self.kinds[self.at] = "name"
            return False
        start = self.at
        self.unexpected("a statement", "statements begin with a variable, a block or a keyword")
        self._skip_statement(start)
        return False

    def _skip_statement(self, start: int) -> None:
        """Go to the next place where a statement can begin or a list can end."""
        if self.at == start:
            self.at += 1
        kinds = self.kinds
        while True:
            kind = kinds[self.at]
            if kind == ";":
                self.at += 1
                return
            if kind == "end" or kind in _ENDS or kind in _STARTS or kind in UNITS:
                return
            if kind in NAMES and self.starts_line(self.at) and self._begins_statement():
                return
            self.at += 1

    def _begins_statement(self) -> bool:
        """Whether a name at the start of a line is followed as in an assignment or a call."""
        at = self.at + 1
        while self.kinds[at] == "." and self.kinds[at + 1] != "end":
            at += 2
        return self.kinds[at] in _ASSIGNMENTS or self.kinds[at] in ("(", "[")

    # --- ends ---------------------------------------------------------------------------------

    def _end(self, end: str, first: int) -> None:
        """Read END_x and its semicolon."""
        if self.accept(end):
            if not self.accept(";"):
                self.missing_semicolon(end)
        elif self.kinds[self.at] in _ENDS | UNITS | {"end"}:
            self.missing_end(end, first)
        else:
            raise self.failed(end)

    def _finish(self, leading: TriviaList) -> tuple[TriviaList, Trivia | None]:
        return self.settle(leading) if self.extra_at <= self.at else (leading, None)

    def _semicolon(self) -> None:
        if self.kinds[self.at] == ";":
            self.at += 1
        else:
            self.missing_semicolon("the statement")

    # --- simple statements --------------------------------------------------------------------

    def _simple(self) -> Statement:
        """An assignment, a call or a label."""
        first = self.at
        leading = self.take_leading() if self.extra_at <= first else ()
        target = self.operand()
        kind = self.kinds[self.at]
        if kind in _ASSIGNMENTS:
            self.at += 1
            if kind != ":=":
                self.need(Feature.COMPOUND_ASSIGNMENTS, self.at - 1)
            value = self.expression()
            if self.kinds[self.at] in _ASSIGNMENTS:
                raise self.unread(
                    "an assignment in an assignment",
                    self.token_span(self.at),
                    "write one assignment a statement",
                )
            if self.kinds[self.at] == ";":
                self.at += 1
            else:
                self._semicolon()
            place = _make(Span, (self.source, self.starts[first], self.ends[self.at - 1]))
            if self.extra_at > self.at:
                return Assignment(place, target, kind, value, leading)
            leading, trailing = self.settle(leading)
            return Assignment(place, target, kind, value, leading, trailing)
        if isinstance(target, Call):
            self._semicolon()
            place = self.span(first)
            leading, trailing = self._finish(leading)
            return CallStatement(place, target, leading, trailing)
        if kind == ":" and isinstance(target, Name) and not target.quoted:
            self.at += 1
            self.need(Feature.GOTO, first)
            self.accept(";")
            place = self.span(first)
            leading, trailing = self._finish(leading)
            return Label(place, target.name, leading, trailing)
        raise self._no_statement(target)

    def _no_statement(self, target: Expression) -> Unexpected:
        if self.kinds[self.at] == "=":
            return self.failed("':='", "an assignment is written ':=', '=' compares")
        if isinstance(target, Name) and target.name.upper() in ("REGION", "END_REGION"):
            self.missing_feature(Feature.REGIONS, target.span)
            self._skip_line()
            self._last_finding_at = self.at
            return Unexpected()
        return self.failed(
            "':=' or '('", "a statement is an assignment 'x := 1;' or a call 'f(x := 1);'"
        )

    def _skip_line(self) -> None:
        """Step over the rest of the line, at least one token, but not beyond the end."""
        if self.kinds[self.at] != "end":
            self.at += 1
        while self.kinds[self.at] != "end" and not self.starts_line(self.at):
            self.at += 1

    def _empty(self) -> Empty:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        place = self.span(first)
        leading, trailing = self._finish(leading)
        return Empty(place, leading, trailing)

    def _jump(self) -> Jump:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self._semicolon()
        place = self.span(first)
        keyword = self.kinds[first]
        leading, trailing = self._finish(leading)
        return Jump(place, keyword, leading, trailing)

    def _goto(self) -> Goto:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        label = self.name().name
        self.need(Feature.GOTO, first)
        self._semicolon()
        place = self.span(first)
        leading, trailing = self._finish(leading)
        return Goto(place, label, leading, trailing)

    # --- IF and CASE --------------------------------------------------------------------------

    def _if(self) -> If:
        leading = self.take_leading()
        first = self.at
        branches: list[Branch] = []
        otherwise: ElseBranch | None = None
        ends = {"ELSIF", "ELSE", "END_IF"}
        branch_leading: TriviaList = ()
        while True:
            start = self.at
            self.at += 1
            condition = self._condition("THEN", "IF condition THEN")
            branch_leading, trailing = self._finish(branch_leading)
            body = self._inside(ends, self._statements)
            closing = self.take_leading()
            branches.append(
                Branch(self.span(start), condition, body, branch_leading, trailing, closing)
            )
            if self.kinds[self.at] != "ELSIF":
                break
            branch_leading = ()
        if self.kinds[self.at] == "ELSE":
            otherwise = self._else({"END_IF"})
        self._end("END_IF", first)
        place = self.span(first)
        leading, trailing = self._finish(leading)
        return If(place, tuple(branches), otherwise, leading, trailing)

    def _condition(self, end: str, example: str) -> Expression:
        """A condition and the keyword behind it; a broken condition does not hide what follows."""
        first = self.at
        depth = self.depth
        try:
            condition = self.expression()
            if self.kinds[self.at] == ":=":
                raise self.failed(end, "a comparison is written '=', ':=' assigns")
            self.expect(end, f"{end} or an operator", f"write {example}")
            return condition
        except Unexpected:
            self.depth = depth
            at = self.at
            while self.kinds[at] not in (end, ";", "end") and self.kinds[at] not in _ENDS | UNITS:
                at += 1
            if self.kinds[at] != end:
                raise
            self.at = at + 1
            return Name(self.span(first), "")

    def _else(self, ends: set[str]) -> ElseBranch:
        first = self.at
        self.at += 1
        self.accept(":")
        trailing = self.take_same_line()
        body = self._inside(ends, self._statements)
        closing = self.take_leading()
        return ElseBranch(self.span(first), body, (), trailing, closing)

    def _case(self) -> Case:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        selector = self._condition("OF", "CASE variable OF")
        opening = self.take_same_line()
        arms: list[CaseArm] = []
        otherwise: ElseBranch | None = None
        while True:
            kind = self.kinds[self.at]
            if kind in ("ELSE", "END_CASE", "end") or kind in _ENDS:
                break
            start, depth, levels = self.at, self.depth, len(self._open)
            try:
                arms.append(self._case_arm())
            except Unexpected:
                self._recover(start, depth, levels)
                self._inside({"ELSE", "END_CASE"}, self._arm_statements)
        if self.kinds[self.at] == "ELSE":
            otherwise = self._else({"END_CASE"})
        elif self.extra_at <= self.at and arms:
            self._close_arm(arms)
        self._end("END_CASE", first)
        place = self.span(first)
        leading, trailing = self._finish(leading)
        return Case(place, selector, tuple(arms), otherwise, leading, trailing, opening)

    def _close_arm(self, arms: list[CaseArm]) -> None:
        """Comments in front of END_CASE belong to the last arm."""
        arm = arms[-1]
        closing = (*arm.closing, *self.take_leading())
        arms[-1] = CaseArm(arm.span, arm.labels, arm.body, arm.leading, arm.trailing, closing)

    def _case_arm(self) -> CaseArm:
        leading = self.take_leading()
        first = self.at
        labels = [self._case_label()]
        while self.accept(","):
            labels.append(self._case_label())
        self.expect(":", "':' or ','", "the values of a CASE look like 1, 3..5:")
        leading, trailing = self._finish(leading)
        body = self._inside({"ELSE", "END_CASE"}, self._arm_statements)
        return CaseArm(self.span(first), tuple(labels), body, leading, trailing)

    def _case_label(self) -> Expression | LabelRange:
        first = self.at
        value = self.expression()
        if self.accept(".."):
            last = self.expression()
            return LabelRange(self.span(first), value, last)
        return value

    def _at_case_label(self) -> bool:
        """Whether the next tokens are a label of a CASE rather than a statement or a jump label."""
        kinds, at = self.kinds, self.at
        if kinds[at] == "literal":
            return True
        while kinds[at] in _LABEL_PARTS or (kinds[at] in SOFT_KEYWORDS and at == self.at):
            at += 1
        if kinds[at] not in (":", ",", ".."):
            return False
        is_jump_label = (
            at == self.at + 1
            and kinds[at] == ":"
            and self.texts[self.at].casefold() in self._jump_targets
        )
        return not is_jump_label

    # --- loops and regions --------------------------------------------------------------------

    def _for(self) -> For:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        variable = self.operand()
        self.expect(":=", "':='", "write FOR i := 0 TO 7 DO")
        start = self.expression()
        self.expect("TO", "TO or an operator", "write FOR i := 0 TO 7 DO")
        last = self.expression()
        step = self.expression() if self.accept("BY") else None
        self.expect("DO", "DO, BY or an operator", "write FOR i := 0 TO 7 DO")
        leading, opening = self._finish(leading)
        body = self._inside({"END_FOR"}, self._statements)
        closing = self.take_leading()
        self._end("END_FOR", first)
        place = self.span(first)
        trailing = self.take_same_line()
        return For(place, variable, start, last, step, body, leading, opening, closing, trailing)

    def _while(self) -> While:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        condition = self._condition("DO", "WHILE condition DO")
        leading, opening = self._finish(leading)
        body = self._inside({"END_WHILE"}, self._statements)
        closing = self.take_leading()
        self._end("END_WHILE", first)
        place = self.span(first)
        trailing = self.take_same_line()
        return While(place, condition, body, leading, opening, closing, trailing)

    def _repeat(self) -> Repeat:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        opening = self.take_same_line()
        body = self._inside({"UNTIL", "END_REPEAT"}, self._statements)
        closing = self.take_leading()
        self.expect("UNTIL", "UNTIL", "write REPEAT ... UNTIL condition END_REPEAT;")
        condition = self.expression()
        self.accept(";")
        self._end("END_REPEAT", first)
        place = self.span(first)
        leading, trailing = self._finish(leading)
        return Repeat(place, body, condition, leading, opening, closing, trailing)

    def _region(self) -> Region:
        leading = self.take_leading()
        first = self.at
        title = self.texts[first].strip()[len("REGION") :].strip()
        self.at += 1
        body = self._inside({"END_REGION"}, self._statements)
        closing = self.take_leading()
        end_text = ""
        if self.kinds[self.at] == "END_REGION":
            end_text = self.texts[self.at][len("END_REGION") :].strip()
            self.at += 1
        else:
            self.missing_end("END_REGION", first)
        return Region(self.span(first), title, body, end_text, leading, closing)


_READERS: dict[str, Callable[[StatementParser], Statement]] = {
    **dict.fromkeys(("name", "#", '"', '#"', "address"), StatementParser._simple),
    "IF": StatementParser._if,
    "CASE": StatementParser._case,
    "FOR": StatementParser._for,
    "WHILE": StatementParser._while,
    "REPEAT": StatementParser._repeat,
    "REGION": StatementParser._region,
    "EXIT": StatementParser._jump,
    "CONTINUE": StatementParser._jump,
    "RETURN": StatementParser._jump,
    "GOTO": StatementParser._goto,
    ";": StatementParser._empty,
}
