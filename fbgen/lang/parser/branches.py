"""IF and CASE.

Source: IEC 61131-3, selection statements; published sources for `ELSE:`.
"""

from fbgen.lang.ast import (
    Branch,
    Case,
    CaseArm,
    ElseBranch,
    Expression,
    If,
    LabelRange,
    Name,
    TriviaList,
)
from fbgen.lang.parser.cursor import Unexpected
from fbgen.lang.parser.declarations import UNITS
from fbgen.lang.parser.simple_statements import SimpleStatementParser
from fbgen.lang.parser.statement_lists import ENDS, STARTS, enter

_HEAD_ENDS = ("THEN", "DO", "OF")
_BEHIND_HEADS = ENDS | UNITS | STARTS | {";", "end", *_HEAD_ENDS}
"""What does not stand between the first word of a statement and the last one of its head."""


class BranchParser(SimpleStatementParser):
    """Reads statements that choose."""

    def _if(self) -> If:
        leading = self.take_leading()
        first = self.at
        branches: list[Branch] = []
        otherwise: ElseBranch | None = None
        ends = {"ELSIF", "ELSE", "END_IF"}
        branch_leading: TriviaList = ()
        hint = ""
        while True:
            start = self.at
            self.at += 1
            condition = self.condition("THEN", "IF condition THEN")
            if branches:
                # Comments inside the condition go to its statements: above ELSIF they would
                # belong to the branch before.
                trailing = self.take_same_line()
            else:
                branch_leading, trailing = self.finish(())
            body = self.inside(ends, self.statements)
            closing = self.take_leading()
            branches.append(
                Branch(self.span(start), condition, body, branch_leading, trailing, closing)
            )
            if self.kinds[self.at] != "ELSIF":
                break
            branch_leading = ()
        if self.kinds[self.at] == "ELSE":
            in_line = self.kinds[self.at + 1] == "IF" and not self.starts_line(self.at + 1)
            otherwise = self._else({"END_IF"})
            hint = "ELSE IF needs an END_IF of its own: write ELSIF" if in_line else ""
        self.end("END_IF", first, hint)
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return If(place, tuple(branches), otherwise, leading, trailing)

    def condition(self, end: str, example: str) -> Expression:
        """A condition and the keyword behind it; a broken condition does not hide what follows."""
        first = self.at
        depth = self.depth
        try:
            condition = self.expression()
            if self.kinds[self.at] == ":=":
                raise self.failed(end, "a comparison is written '=', ':=' assigns")
            if self.kinds[self.at] == ";" and self.kinds[self.at + 1] == end:
                self.unexpected(end, f"no ';' stands in front of {end}")
                self.at += 1
            self.expect(end, f"{end} or an operator", f"write {example}")
            return condition
        except Unexpected:
            self.depth = depth
            self.skip_behind(end)
            return Name(self.span(first), "")

    def skip_behind(self, end: str) -> None:
        """Go on behind the next `end` of this statement.

        If it has none, what stands in the next line is inside of the statement all the same, as
        its END_x shows that is still to come.
        """
        kinds, at = self.kinds, self.at
        while kinds[at] not in _BEHIND_HEADS and kinds[at] != end:
            at += 1
        if kinds[at] != end:
            at = self.at
            while kinds[at] not in _BEHIND_HEADS and not self.starts_line(at):
                at += 1
        self.at = at + 1 if kinds[at] in (end, ";", *_HEAD_ENDS) else at

    def _else(self, ends: set[str]) -> ElseBranch:
        first = self.at
        self.at += 1
        self.accept(":")
        trailing = self.take_same_line()
        body = self.inside(ends, self.statements)
        closing = self.take_leading()
        return ElseBranch(self.span(first), body, (), trailing, closing)

    def _case(self) -> Case:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        selector = self.condition("OF", "CASE variable OF")
        opening = self.take_same_line()
        arms: list[CaseArm] = []
        otherwise: ElseBranch | None = None
        while True:
            kind = self.kinds[self.at]
            if kind in ("ELSE", "END_CASE", "end") or kind in ENDS:
                break
            start, depth, levels = self.at, self.depth, len(self.open_lists)
            try:
                arms.append(self._case_arm())
            except Unexpected:
                self.recover(start, depth, levels)
                self.inside({"ELSE", "END_CASE"}, self.arm_statements)
        if self.extra_at <= self.at and arms:
            self._close_arm(arms)
        if self.kinds[self.at] == "ELSE":
            otherwise = self._else({"END_CASE"})
        self.end("END_CASE", first)
        place = self.span(first)
        leading, trailing = self.finish(leading)
        return Case(place, selector, tuple(arms), otherwise, leading, trailing, opening)

    def _close_arm(self, arms: list[CaseArm]) -> None:
        """Comments in front of ELSE and END_CASE belong to the last arm."""
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
        leading, trailing = self.finish(leading)
        body = self.inside({"ELSE", "END_CASE"}, self.arm_statements)
        return CaseArm(self.span(first), tuple(labels), body, leading, trailing)

    def _case_label(self) -> Expression | LabelRange:
        first = self.at
        value = self.expression()
        if self.accept(".."):
            last = self.expression()
            return LabelRange(self.span(first), value, last)
        return value


enter({"IF": BranchParser._if, "CASE": BranchParser._case})
