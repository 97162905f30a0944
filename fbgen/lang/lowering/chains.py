"""Assignments in assignments, taken apart: `a := b := c` is `b := c; a := b;`.

Source: TIA Portal help, "Value assignments": a chain is worked out from right to left.
"""

from fbgen.lang.ast import Assignment, Chained, Expression


def links(node: Assignment) -> tuple[Assignment, ...]:
    """One assignment for each link of a chain; a plain assignment is its own only link.

    The comments in front stay with the first one, the one behind with the last.
    """
    if not isinstance(node.value, Chained):
        return (node,)
    targets: list[tuple[Expression, str]] = [(node.target, node.operator)]
    source: Expression = node.value
    while isinstance(source, Chained):
        targets.append((source.target, source.operator))
        source = source.value
    single: list[Assignment] = []
    for target, operator in reversed(targets):
        leading = () if single else node.leading
        single.append(Assignment(node.span, target, operator, source, leading))
        source = target
    last = single[-1]
    single[-1] = Assignment(
        last.span, last.target, last.operator, last.value, last.leading, node.trailing
    )
    return tuple(single)
