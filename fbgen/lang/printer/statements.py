"""Statements as lines."""

from collections.abc import Callable
from typing import Any

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
    Region,
    Repeat,
    Statement,
    Trivia,
    TriviaList,
    Try,
    While,
)
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.printer.expressions import ExpressionPrinter
from fbgen.lang.printer.lines import WIDTH, Lines
from fbgen.source import Span


class StatementPrinter(ExpressionPrinter):
    """Writes lists of statements into `lines`."""

    def __init__(self, dialect: Dialect) -> None:
        super().__init__(dialect)
        self.lines = Lines(dialect)

    def statements(self, statements: tuple[Statement, ...], closing: TriviaList = ()) -> None:
        """Statements one level deeper, and the comments behind the last one."""
        self.lines.level += 1
        for statement in statements:
            self.lines.trivia(statement.leading)
            _WRITERS[type(statement)](self, statement)
        self.lines.trivia(closing)
        self.lines.level -= 1

    # --- pieces of lines ----------------------------------------------------------------------

    def _fits(self, text: str) -> bool:
        return len(self.lines.indentation()) + len(text) <= WIDTH

    def _line_with(self, before: str, expression: Expression, after: str) -> str:
        """A line around an expression, broken in front of its loosest operators if too long."""
        if isinstance(expression, Call):
            return before + self._call_text(before, expression) + after
        text = before + self.expression(expression) + after
        if self._fits(text):
            return text
        first, steps = self.chain(expression)
        pad = self.lines.indentation() + " " * len(before)
        broken = "".join(f"\n{pad}{operator} {operand}" for operator, operand in steps)
        return before + first + broken + after

    def _call_text(self, before: str, call: Call) -> str:
        """A call, with one argument a line if it is long or its arguments have comments."""
        callee = self.expression(call.callee)
        has_comments = any(
            argument.trailing or any(item.text for item in argument.leading)
            for argument in call.arguments
        )
        text = f"{callee}({self.arguments(call.arguments)})"
        if not has_comments and self._fits(f"{before}{text};"):
            return text
        pad = self.lines.indentation() + " " * (len(before) + len(callee) + 1)
        pieces: list[str] = []
        last = len(call.arguments) - 1
        open_line = ""
        for number, argument in enumerate(call.arguments):
            comments = [self.lines.comment(item) for item in argument.leading if item.text]
            line = self.argument(argument) + ("," if number < last else "")
            if argument.trailing and number < last:
                line += "   " + self.lines.comment(argument.trailing)
            elif argument.trailing:
                open_line = self.lines.comment(argument.trailing)
            pieces += [*comments, line]
        text = f"{callee}(" + f"\n{pad}".join(pieces)
        if not open_line:
            return text + ")"
        return f"{text}   {open_line}\n{pad})"

    def _header(
        self, before: str, expression: Expression, after: str, place: Span, opening: Trivia | None
    ) -> None:
        """The first line of a compound statement."""
        line_place = place._replace(end=expression.span.end) if place else place
        self.lines.add(self._line_with(before, expression, after), line_place, opening)

    # --- simple statements --------------------------------------------------------------------

    def _assignment(self, node: Assignment) -> None:
        before = f"{self.expression(node.target)} {node.operator} "
        self.lines.add(self._line_with(before, node.value, ";"), node.span, node.trailing)

    def _call_statement(self, node: CallStatement) -> None:
        self.lines.add(self._call_text("", node.call) + ";", node.span, node.trailing)

    def _jump(self, node: Jump) -> None:
        self.lines.add(f"{node.keyword};", node.span, node.trailing)

    def _goto(self, node: Goto) -> None:
        word = "JMP" if self.dialect.has(Feature.JUMPS) else "GOTO"
        self.lines.add(f"{word} {node.label};", node.span, node.trailing)

    def _label(self, node: Label) -> None:
        self.lines.add(f"{node.name}:", node.span, node.trailing)

    def _empty(self, node: Empty) -> None:
        self.lines.add(";", node.span, node.trailing)

    # --- compound statements ------------------------------------------------------------------

    def _if(self, node: If) -> None:
        for number, branch in enumerate(node.branches):
            self.lines.trivia(branch.leading)
            self._branch("IF " if number == 0 else "ELSIF ", branch)
        if node.otherwise:
            self._else(node.otherwise)
        self.lines.add("END_IF;", _last(node.span), node.trailing)

    def _branch(self, keyword: str, branch: Branch) -> None:
        self._header(keyword, branch.condition, " THEN", branch.span, branch.trailing)
        self.statements(branch.body, branch.closing)

    def _else(self, node: ElseBranch) -> None:
        self.lines.trivia(node.leading)
        self.lines.add("ELSE", _first(node.span), node.trailing)
        self.statements(node.body, node.closing)

    def _case(self, node: Case) -> None:
        self._header("CASE ", node.selector, " OF", node.span, node.opening)
        self.lines.level += 1
        for arm in node.arms:
            self._arm(arm)
        if node.otherwise:
            self._else(node.otherwise)
        self.lines.level -= 1
        self.lines.add("END_CASE;", _last(node.span), node.trailing)

    def _arm(self, arm: CaseArm) -> None:
        self.lines.trivia(arm.leading)
        labels = ", ".join(self.label(label) for label in arm.labels)
        place = arm.span._replace(end=arm.labels[-1].span.end)
        self.lines.add(f"{labels}:", place, arm.trailing)
        self.statements(arm.body, arm.closing)

    def _for(self, node: For) -> None:
        before = f"FOR {self.expression(node.variable)} := {self.expression(node.first)} TO "
        step = f" BY {self.expression(node.step)}" if node.step else ""
        self._header(before, node.last, f"{step} DO", node.span, node.opening)
        self.statements(node.body, node.closing)
        self.lines.add("END_FOR;", _last(node.span), node.trailing)

    def _while(self, node: While) -> None:
        self._header("WHILE ", node.condition, " DO", node.span, node.opening)
        self.statements(node.body, node.closing)
        self.lines.add("END_WHILE;", _last(node.span), node.trailing)

    def _repeat(self, node: Repeat) -> None:
        self.lines.add("REPEAT", _first(node.span), node.opening)
        self.statements(node.body, node.closing)
        self.lines.add(self._line_with("UNTIL ", node.condition, ""), node.condition.span)
        self.lines.add("END_REPEAT;", _last(node.span), node.trailing)

    def _try(self, node: Try) -> None:
        self.lines.add("__TRY", _first(node.span), node.opening)
        self.statements(node.body, node.closing)
        if (catch := node.catch) is not None:
            variable = f"({self.expression(catch.exception)})" if catch.exception else ""
            self.lines.trivia(catch.leading)
            self.lines.add(f"__CATCH{variable}", _first(catch.span), catch.trailing)
            self.statements(catch.body, catch.closing)
        if (final := node.final) is not None:
            self.lines.trivia(final.leading)
            self.lines.add("__FINALLY", _first(final.span), final.trailing)
            self.statements(final.body, final.closing)
        self.lines.add("__ENDTRY", _last(node.span), node.trailing)

    def _region(self, node: Region) -> None:
        self.lines.add(f"REGION {node.title}", _first(node.span))
        self.statements(node.body, node.closing)
        self.lines.add(f"END_REGION {node.end_text}", _last(node.span))


def _first(place: Span) -> Span:
    return place._replace(end=place.start)


def _last(place: Span) -> Span:
    return place._replace(start=max(place.start, place.end - 1))


_WRITERS: dict[type, Callable[[StatementPrinter, Any], None]] = {
    Assignment: StatementPrinter._assignment,
    CallStatement: StatementPrinter._call_statement,
    If: StatementPrinter._if,
    Case: StatementPrinter._case,
    For: StatementPrinter._for,
    While: StatementPrinter._while,
    Repeat: StatementPrinter._repeat,
    Try: StatementPrinter._try,
    Region: StatementPrinter._region,
    Jump: StatementPrinter._jump,
    Goto: StatementPrinter._goto,
    Label: StatementPrinter._label,
    Empty: StatementPrinter._empty,
}
