"""All mutants of a block, in the order of its text, each with its id."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence

from fbgen.lang.checked import Block, Statement
from harness.engine.compiled.generation import room_for_generation
from harness.verify.mutation import constants, operations, statements
from harness.verify.mutation.mutant import Change, Mutant, Operator
from harness.verify.mutation.places import every_seat, every_statement

ALL = frozenset(Operator)


def mutants_of(
    block: Block, body: Sequence[Statement], operators: Collection[Operator] = ALL
) -> tuple[Mutant, ...]:
    """Every mutant of a block. Two that give the same text are one."""
    with room_for_generation():
        changes = sorted(_changes(body), key=_order)
    found: list[Mutant] = []
    texts: set[tuple[tuple[int, int, str], ...]] = set()
    numbers: Counter[tuple[int, Operator]] = Counter()
    for change in changes:
        text = tuple((edit.span.start, edit.span.end, edit.text) for edit in change.edits)
        if text in texts:
            continue
        texts.add(text)
        line = change.edits[0].span.line
        numbers[line, change.operator] += 1
        number = numbers[line, change.operator]
        name = f"{block.name}:{line}:{change.operator.value}:{number}"
        if change.operator in operators:
            found.append(Mutant(name, block, change))
    return tuple(found)


_RANK = {operator: rank for rank, operator in enumerate(Operator)}


def _order(change: Change) -> tuple[int, int]:
    return change.edits[0].span.start, _RANK[change.operator]


def _changes(body: Sequence[Statement]) -> Iterator[Change]:
    memories = operations.edge_memories(body)
    for statement in every_statement(body):
        yield from statements.left_out(statement)
        yield from statements.negated(statement)
        yield from statements.exchanged_labels(statement)
        yield from constants.byte_order(statement)
        yield from constants.preset_times(statement)
    for seat in every_seat(body):
        yield from operations.edges(seat, memories)
        yield from operations.comparisons(seat)
        yield from operations.logic(seat)
        yield from operations.calculations(seat)
        yield from constants.values(seat)
        yield from constants.assembled(seat)
