"""Statements in IEC: no regions, no short assignments, results of functions always taken."""

from collections.abc import Callable
from typing import Any

from fbgen.lang.ast import (
    Assignment,
    Binary,
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
    Index,
    Jump,
    Label,
    LabelRange,
    Member,
    Name,
    NamedType,
    Region,
    Repeat,
    Slice,
    Statement,
    Trivia,
    TriviaList,
    While,
)
from fbgen.lang.lowering.build import comment
from fbgen.lang.lowering.chains import links
from fbgen.lang.lowering.expressions import ExpressionLowering
from fbgen.lang.lowering.slices import can_be_sliced, read_slice, write_slice
from fbgen.lang.lowering.types import TypeLowering

_SIMPLE = frozenset({":=", "+=", "-=", "*=", "/="})


class StatementLowering(ExpressionLowering):
    """Rewrites the statements of one block. `unused_results` are types of results nobody takes."""

    def __init__(self, types: TypeLowering) -> None:
        super().__init__(types.context, types.scope)
        self.unused_results: dict[str, str] = {}

    def body(
        self, statements: tuple[Statement, ...], closing: TriviaList
    ) -> tuple[tuple[Statement, ...], TriviaList]:
        """A list of statements with the comments behind it; regions are taken apart."""
        result: list[Statement] = []
        waiting: list[Trivia] = []
        self._into(result, waiting, statements)
        if not result and statements:
            last = statements[-1]
            result.append(Empty(last.span, tuple(waiting)))
            waiting.clear()
        return tuple(result), (*waiting, *closing)

    def _into(
        self, result: list[Statement], waiting: list[Trivia], statements: tuple[Statement, ...]
    ) -> None:
        """Append lowered statements; comments of what falls away wait for the next one."""
        for statement in statements:
            if isinstance(statement, Region):
                waiting += statement.leading
                if statement.title:
                    waiting.append(comment(statement.span, statement.title))
                self._into(result, waiting, statement.body)
                waiting += statement.closing
                if note := statement.end_text.strip("; \t").removeprefix("//"):
                    waiting.append(comment(statement.span, note))
            elif isinstance(statement, Empty):
                waiting += statement.leading
                if statement.trailing:
                    waiting.append(statement.trailing)
            else:
                pieces = links(statement) if isinstance(statement, Assignment) else (statement,)
                for piece in pieces:
                    leading = (*waiting, *piece.leading)
                    waiting.clear()
                    result.append(_LOWERERS[type(piece)](self, piece, leading))

    # --- simple statements --------------------------------------------------------------------

    def _assignment(self, node: Assignment, leading: TriviaList) -> Statement:
        if node.operator == "?=":
            self.context.findings.refuse(
                "the assignment attempt ?=", node.span, "hand the variable over with its own type"
            )
            return node
        if node.operator not in _SIMPLE:
            self.context.findings.refuse(
                f"the assignment {node.operator}", node.span, "hand the variable over as VAR_IN_OUT"
            )
            return node
        self._check_writable(node.target)
        value = self.expression(node.value)
        if isinstance(node.target, Slice):
            return self._slice_assignment(node, node.target, value, leading)
        target = self.expression(node.target)
        if node.operator != ":=":
            value = Binary(node.span, node.operator[0], target, value)
        return Assignment(node.span, target, ":=", value, leading, node.trailing)

    def _check_writable(self, target: Expression) -> None:
        """An input that the block itself changes."""
        root = target
        while isinstance(root, (Member, Index, Slice)):
            root = root.base
        if (
            self.scope is not None
            and not self.context.target.has_writable_inputs
            and isinstance(root, Name)
            and self.scope.is_declared(root)
            and root.name.casefold() in self.scope.inputs
        ):
            self.context.findings.refuse(
                f"an assignment to the input {root.name}",
                target.span,
                "copy it to a variable of the block and change that",
            )

    def _slice_assignment(
        self, node: Assignment, part: Slice, value: Expression, leading: TriviaList
    ) -> Statement:
        type_name = self.scope.elementary_of(part.base) if self.scope else ""
        if not can_be_sliced(type_name, part):
            self.expression(part)
            return node
        base = self.expression(part.base)
        if node.operator != ":=":
            old = read_slice(part.span, base, type_name, part)
            value = Binary(node.span, node.operator[0], old, value)
        plain = Assignment(node.span, part, ":=", value, leading, node.trailing)
        return write_slice(plain, base, type_name, part, value)

    def _call_statement(self, node: CallStatement, leading: TriviaList) -> Statement:
        call = self.expression(node.call)
        if not isinstance(call, Call):
            return node
        result_type = self._result_of(node.call)
        if not result_type or self.context.target.drops_results:
            return CallStatement(node.span, call, leading, node.trailing)
        name = self.unused_results.setdefault(result_type, self._free(f"unused{result_type}"))
        target = Name(node.span, name)
        return Assignment(node.span, target, ":=", call, leading, node.trailing)

    def _free(self, wish: str) -> str:
        """A name close to the wish that the block does not use."""
        taken = self.scope.declared if self.scope else {}
        name, number = wish, 2
        while name.casefold() in taken:
            name, number = f"{wish}{number}", number + 1
        return name

    def _result_of(self, call: Call) -> str:
        """The type of a function's result that a statement drops; "" for an instance."""
        if not isinstance(call.callee, Name) or (
            self.scope and self.scope.is_declared(call.callee)
        ):
            return ""
        function = self.context.plant.function(call.callee.name)
        if function is None:
            return ""
        spec = function.return_type
        if not isinstance(spec, NamedType) or spec.quoted:
            self.context.findings.refuse(
                f"a call of {function.name.name} that drops its result",
                call.span,
                "assign the result to a variable",
            )
            return ""
        return "BOOL" if spec.name.upper() == "VOID" else spec.name.upper()

    def _jump(self, node: Jump, leading: TriviaList) -> Statement:
        if node.keyword == "CONTINUE" and not self.context.target.has_continue:
            self.context.findings.refuse(
                "CONTINUE", node.span, "put the rest of the loop into an IF"
            )
        return Jump(node.span, node.keyword, leading, node.trailing)

    def _goto(self, node: Goto | Label, leading: TriviaList) -> Statement:
        if not self.context.target.has_jumps:
            hint = "use IF, CASE, loops with EXIT, or RETURN"
            self.context.findings.refuse("GOTO", node.span, hint)
        if isinstance(node, Goto):
            return Goto(node.span, node.label, leading, node.trailing)
        return Label(node.span, node.name, leading, node.trailing)

    # --- compound statements ------------------------------------------------------------------

    def _if(self, node: If, leading: TriviaList) -> Statement:
        branches = tuple(self._branch(one) for one in node.branches)
        otherwise = self._else(node.otherwise) if node.otherwise else None
        return If(node.span, branches, otherwise, leading, node.trailing)

    def _branch(self, node: Branch) -> Branch:
        condition = self.expression(node.condition)
        body, closing = self.body(node.body, node.closing)
        return Branch(node.span, condition, body, node.leading, node.trailing, closing)

    def _else(self, node: ElseBranch) -> ElseBranch:
        body, closing = self.body(node.body, node.closing)
        return ElseBranch(node.span, body, node.leading, node.trailing, closing)

    def _case(self, node: Case, leading: TriviaList) -> Statement:
        selector = self.expression(node.selector)
        arms = tuple(self._arm(arm) for arm in node.arms)
        otherwise = self._else(node.otherwise) if node.otherwise else None
        return Case(node.span, selector, arms, otherwise, leading, node.trailing, node.opening)

    def _arm(self, arm: CaseArm) -> CaseArm:
        labels = tuple(self._case_label(label) for label in arm.labels)
        body, closing = self.body(arm.body, arm.closing)
        return CaseArm(arm.span, labels, body, arm.leading, arm.trailing, closing)

    def _case_label(self, label: Expression | LabelRange) -> Expression | LabelRange:
        if isinstance(label, LabelRange):
            return LabelRange(label.span, self.constant(label.first), self.constant(label.last))
        return self.constant(label)

    def _for(self, node: For, leading: TriviaList) -> Statement:
        self._check_writable(node.variable)
        step = None if node.step is None else self.expression(node.step)
        body, closing = self.body(node.body, node.closing)
        return For(
            node.span,
            self.expression(node.variable),
            self.expression(node.first),
            self.expression(node.last),
            step,
            body,
            leading,
            node.opening,
            closing,
            node.trailing,
        )

    def _while(self, node: While, leading: TriviaList) -> Statement:
        condition = self.expression(node.condition)
        body, closing = self.body(node.body, node.closing)
        return While(node.span, condition, body, leading, node.opening, closing, node.trailing)

    def _repeat(self, node: Repeat, leading: TriviaList) -> Statement:
        body, closing = self.body(node.body, node.closing)
        condition = self.expression(node.condition)
        return Repeat(node.span, body, condition, leading, node.opening, closing, node.trailing)


_LOWERERS: dict[type, Callable[[StatementLowering, Any, TriviaList], Statement]] = {
    Assignment: StatementLowering._assignment,
    CallStatement: StatementLowering._call_statement,
    If: StatementLowering._if,
    Case: StatementLowering._case,
    For: StatementLowering._for,
    While: StatementLowering._while,
    Repeat: StatementLowering._repeat,
    Jump: StatementLowering._jump,
    Goto: StatementLowering._goto,
    Label: StatementLowering._goto,
}
