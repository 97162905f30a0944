"""Finds what there is to be reached in a checked program, and which node it belongs to."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from fbgen.lang.checked import (
    Assignment,
    Block,
    Branch,
    Case,
    Constant,
    Evaluate,
    Expression,
    For,
    FunctionCall,
    Guarded,
    If,
    InstanceCall,
    Label,
    Program,
    Repeat,
    RoutineCall,
    StandardCall,
    Statement,
    Try,
    While,
)
from fbgen.lang.containers.embedded import EmbeddedSource
from fbgen.lang.types import Elementary, Family
from fbgen.source import Source, Span
from harness.engine.compiled.expressions.decisions import Decision, decision
from harness.engine.compiled.walk import Node, every_node
from harness.engine.compiled.watching.probes import Probed
from harness.verify.coverage.excluded import never_deciding
from harness.verify.coverage.kinship import Kinship, TemplateLines, template_lines
from harness.verify.coverage.model import (
    BlockPlaces,
    Branching,
    ConditionPlace,
    DecisionPlace,
    Outcome,
    Place,
    TemplateKeys,
)

_CONSTANT = "the condition is a constant"
_BOUNDS = "the bounds are constants"
_ALL_VALUES = "the arms have every value"
_NEVER_DECIDES = "constants or other conditions decide wherever it could"

Loop = For | While | Repeat


class BlockNodes(NamedTuple):
    """The nodes of a block in the order of `places`.

    `outcomes` has for each branching the nodes whose inside the outcomes are, in their order; a
    loop stands there once for its passes and once for being left.
    """

    places: BlockPlaces
    statements: tuple[tuple[Statement, ...], ...]
    outcomes: tuple[tuple[Probed, ...], ...]
    decisions: tuple[Expression, ...]


def blocks_by_file(program: Program) -> dict[Source, list[BlockNodes]]:
    """What each file of a program has, block by block in the order of the text.

    Text inside of XML has its places there, so the XML is the file.
    """
    found: dict[Source, list[BlockNodes]] = {}
    templates: dict[Source, TemplateLines] = {}
    for block, body in program.bodies.items():
        if body:
            file = block.span.source
            while isinstance(file, EmbeddedSource):
                file = file.container
            if file not in found:
                templates[file] = template_lines(file)
            kin = Kinship(templates[file], block.syntax.span.line, body)
            found.setdefault(file, []).append(_block(block, body, kin))
    for blocks in found.values():
        blocks.sort(key=lambda one: one.places.place)
    return found


def _block(block: Block, body: Sequence[Statement], kin: Kinship) -> BlockNodes:
    source = block.span.source
    nodes = [node for node in every_node(body) if node.span.source is source]
    statements: dict[Place, list[Statement]] = {}
    branchings: list[tuple[Branching, tuple[Probed, ...]]] = []
    decisions: dict[Place, tuple[DecisionPlace, Expression]] = {}
    keys: dict[Place, list[str]] = {}
    for node in sorted(nodes, key=lambda one: (one.span.start, -one.span.end)):
        if isinstance(node, Statement) and not isinstance(node, Label | Guarded):
            statements.setdefault(_place(_head(node)), []).append(node)
        if isinstance(node, If | Case | For | While | Repeat):
            branchings.append(_branching(node))
        for expression in _asked(node):
            found = decision(expression)
            if found is not None:
                where = _place(expression.span)
                if where not in decisions:
                    decisions[where] = _decision(expression, found), expression
                    if kin.template:
                        owner = kin.below(kin.of(node), expression)
                        keys[where] = [kin.below(owner, one) for one in found.conditions]
    ordered = sorted(decisions.values(), key=lambda item: item[0].place)
    places = BlockPlaces(
        block.name,
        block.kind.value,
        _place(block.syntax.span),
        tuple(statements),
        tuple(branching for branching, _ in branchings),
        tuple(where for where, _ in ordered),
        TemplateKeys()
        if not kin.template
        else TemplateKeys(
            kin.template,
            tuple(kin.of(group[0]) for group in statements.values()),
            tuple(key for branching, owners in branchings for key in _ways(kin, branching, owners)),
            tuple(key for where, _ in ordered for key in keys[where.place]),
        ),
    )
    return BlockNodes(
        places,
        tuple(tuple(group) for group in statements.values()),
        tuple(owners for _, owners in branchings),
        tuple(expression for _, expression in ordered),
    )


def _ways(kin: Kinship, branching: Branching, owners: Sequence[Probed]) -> Iterator[str]:
    """The keys of the outcomes of a branching, whose last owner is the statement itself."""
    statement = owners[-1]
    assert isinstance(statement, Statement), "the way on that is left belongs to the statement"
    for number, outcome in enumerate(branching.outcomes):
        way = number if isinstance(statement, If) and owners[number] is not statement else ""
        yield f"{kin.of(statement)}>{way}{outcome.name}"


def _place(span: Span) -> Place:
    return Place(span.line, span.column, span.end_line, span.end_column)


def _head(node: Statement) -> Span:
    """The part of a statement that is its own, without the statements inside."""
    span = node.span
    match node:
        case If():
            return span.to(node.branches[0].condition.span)
        case Case():
            return span.to(node.selector.span)
        case For():
            return span.to(node.last.span)
        case While():
            return span.to(node.condition.span)
        case Repeat() | Try():
            return Span(span.source, span.start, min(span.end, span.start + len("REPEAT")))
        case _:
            return span


def _asked(node: Node) -> Iterator[Expression]:
    """The expressions in a node that may be decisions: those whose value is used as it is."""
    match node:
        case Branch() | While() | Repeat():
            yield node.condition
        case Assignment():
            yield node.value
        case InstanceCall() | FunctionCall():
            yield from (expression for _, expression in node.inputs)
        case StandardCall():
            yield from node.arguments
        case RoutineCall():
            yield from (expression for _, expression in node.inputs)
        case Evaluate():
            pass


# --- branchings ---------------------------------------------------------------------------------


def _branching(node: If | Case | Loop) -> tuple[Branching, tuple[Probed, ...]]:
    head = _place(_head(node))
    if isinstance(node, If):
        return Branching("IF", head, tuple(_if_outcomes(node))), (*node.branches, node)
    if isinstance(node, Case):
        return Branching("CASE", head, tuple(_case_outcomes(node))), (*node.arms, node)
    return Branching(type(node).__name__.upper(), head, _loop_outcomes(node)), (node, node)


def _if_outcomes(node: If) -> Iterator[Outcome]:
    known: bool | None = None
    for number, branch in enumerate(node.branches):
        condition = branch.condition
        name = "IF is TRUE" if number == 0 else "ELSIF is TRUE"
        reason = _CONSTANT if known else ""
        if isinstance(condition, Constant):
            reason = reason or ("" if condition.value else _CONSTANT)
            known = known or bool(condition.value)
        yield Outcome(name, _place(condition.span), reason)
    yield Outcome("ELSE", _otherwise(node, node.otherwise), _CONSTANT if known else "")


def _case_outcomes(node: Case) -> Iterator[Outcome]:
    for arm in node.arms:
        shown = ", ".join(
            str(first) if first == last else f"{first}..{last}" for first, last in arm.ranges
        )
        line, column = arm.span.source.line_column(arm.span.start)
        yield Outcome(f"CASE {shown}", Place(line, column, line, column + 1))
    kind = node.selector.type
    count = sum(last - first + 1 for arm in node.arms for first, last in arm.ranges)
    whole = (
        isinstance(kind, Elementary)
        and kind.family in (Family.BITS, Family.SIGNED, Family.UNSIGNED)
        and count == 1 << kind.bits
    )
    yield Outcome("no CASE", _otherwise(node, node.otherwise), _ALL_VALUES if whole else "")


def _otherwise(node: If | Case, body: Sequence[Statement]) -> Place:
    """The statements for what is left, or the head where there are none."""
    return _place(_head(body[0])) if body else _place(_head(node))


def _loop_outcomes(node: Loop) -> tuple[Outcome, Outcome]:
    head = _place(_head(node))
    if isinstance(node, Repeat):
        until = _place(node.condition.span)
        never: tuple[str, str] = ("", "")
        if isinstance(node.condition, Constant):
            never = (_CONSTANT, "") if node.condition.value else ("", _CONSTANT)
        return (
            Outcome("UNTIL is FALSE: once more", until, never[0]),
            Outcome("UNTIL is TRUE: the end", until, never[1]),
        )
    reasons = ("", "")
    if isinstance(node, While) and isinstance(node.condition, Constant):
        reasons = ("", _CONSTANT) if node.condition.value else (_CONSTANT, "")
    elif isinstance(node, For):
        reasons = _counted(node)
    return (
        Outcome("the loop is entered", head, reasons[0]),
        Outcome("the loop is not entered", head, reasons[1]),
    )


def _counted(node: For) -> tuple[str, str]:
    """Why a FOR with constant bounds cannot be entered, or passed by."""
    first, last, step = node.first, node.last, node.step
    if not (
        isinstance(first, Constant) and isinstance(last, Constant) and isinstance(step, Constant)
    ):
        return "", ""
    passes = range(int(first.value), int(last.value) + (1 if int(step.value) > 0 else -1))
    if int(step.value) < 0:
        passes = range(int(last.value), int(first.value) + 1)
    return ("", _BOUNDS) if passes else (_BOUNDS, "")


# --- decisions ----------------------------------------------------------------------------------


def _decision(node: Expression, found: Decision) -> DecisionPlace:
    never = never_deciding(found)
    conditions = tuple(
        ConditionPlace(
            _text(condition), _place(condition.span), _NEVER_DECIDES if number in never else ""
        )
        for number, condition in enumerate(found.conditions)
    )
    return DecisionPlace(_text(node), _place(node.span), found.tree, conditions)


def _text(node: Expression) -> str:
    """The text of an expression in one line."""
    return " ".join(node.span.text.split())
