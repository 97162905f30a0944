"""Warnings about names that nobody uses and results that nobody sets."""

from collections.abc import Mapping

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Block, Variable, VariableKind
from fbgen.lang.checker.library import Library
from fbgen.lang.checker.symbols import NamedConstant

_INNER = (VariableKind.STATIC, VariableKind.TEMP)


def report_unused(library: Library, blocks: Mapping[str, Block]) -> None:
    """Warn about inner variables and constants that the text never mentions."""
    for block in blocks.values():
        ctx = library.context_of(block)
        for entry in ctx.scope.entries.values():
            inner = isinstance(entry, NamedConstant) or (
                isinstance(entry, Variable) and entry.kind in _INNER and entry.address is None
            )
            if inner and entry not in ctx.used:
                what = "constant" if isinstance(entry, NamedConstant) else "variable"
                library.findings.warning(
                    "FB4101",
                    f"{what} '{entry.name}' of {block.name} is never used",
                    entry.span,
                    "remove it",
                )
        result = block.result
        if block.kind is BlockKind.FUNCTION and result is not None and result not in ctx.written:
            library.findings.warning(
                "FB4102",
                f"{block.name} never sets its result",
                result.span,
                f"assign it: {block.name} := ...;",
            )
