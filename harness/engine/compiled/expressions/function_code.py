"""Calls of functions of the library as pieces of Python."""

from collections.abc import Callable

from fbgen.lang.checked import StandardCall
from harness.engine.compiled.code import Code, Level, deepest
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits

Writer = Callable[[Procedure, StandardCall, list[Code]], Code]
"""Writes a call whose arguments have been written."""


def all_of(codes: list[Code], text: str, level: Level = Level.ATOM, more_depth: int = 1) -> Code:
    """A piece made of others, all of which are evaluated."""
    return Code(
        text,
        level,
        depth=deepest(codes) + more_depth,
        safe=all(code.safe for code in codes),
        pure=all(code.pure for code in codes),
    )


def called(function: str, node: StandardCall, codes: list[Code], *more: object) -> Code:
    """A call of a function of the library with these arguments and further constants."""
    low, high = limits(node.type)
    texts = ", ".join((*(code.text for code in codes), *(str(one) for one in more)))
    return all_of(codes, f"{function}({texts})").within(low, high)


def failing(procedure: Procedure, node: StandardCall, code: Code) -> Code:
    """A piece that may stop the program."""
    procedure.site(code.text, node)
    return code._replace(safe=False)
