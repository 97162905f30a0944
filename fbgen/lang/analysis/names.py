"""Names that hide others, are too long for the tools, or are words of another dialect."""

from functools import cache
from typing import TYPE_CHECKING

from fbgen.lang.analysis.flow import Flow
from fbgen.lang.checked import Variable
from fbgen.lang.dialects import DIALECTS

if TYPE_CHECKING:
    from fbgen.lang.checker.context import Context

_MARKED = ("tia",)
"""Dialects that tell local names from global ones by how they are written."""


def check_names(flow: Flow, ctx: "Context") -> None:
    """FB4240, FB4241, FB4243 for what a block declares, FB4242 for what it mentions."""
    for symbol, span in ctx.respelled.items():
        flow.report.hint(
            "FB4242",
            f"'{span.text}' is declared as '{symbol.name}'",
            span,
            "write it as it is declared: some tools tell upper from lower case",
        )
    dialect = DIALECTS.get(flow.program.dialect)
    hidden = flow.program.globals if flow.program.dialect not in _MARKED else {}
    reserved = _words_of_others(flow.program.dialect)
    for key, entry in ctx.scope.entries.items():
        if entry.name.casefold() == flow.block.name.casefold():
            continue
        other = hidden.get(key)
        if other is not None and other is not entry and isinstance(entry, Variable):
            flow.report.hint(
                "FB4240",
                f"'{entry.name}' of {flow.block.name} hides the global variable of that name",
                entry.span,
                "give one of them another name",
            )
        if dialect is not None and len(entry.name) > dialect.identifier_length:
            flow.report.warning(
                "FB4241",
                f"'{entry.name}' has {len(entry.name)} characters; {dialect.title} takes"
                f" {dialect.identifier_length}",
                entry.span,
                "choose a shorter name",
            )
        owner = reserved.get(key)
        if owner is not None:
            flow.report.hint(
                "FB4243",
                f"'{entry.name}' is a word of {owner} and cannot be a name there",
                entry.span,
                "choose another name if this text may go there",
            )


@cache
def _words_of_others(own: str) -> dict[str, str]:
    """Casefolded word -> the dialect that reserves it, of the words that `own` does not."""
    mine = DIALECTS[own].reserved if own in DIALECTS else frozenset()
    return {
        word.casefold(): dialect.title
        for dialect in DIALECTS.values()
        if dialect.name != own
        for word in dialect.reserved - mine
    }
