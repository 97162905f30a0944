"""PUBLIC, PROTECTED, INTERNAL and PRIVATE: who may use a member or a variable of a block.

Source: IEC 61131-3 third edition, sections 6.6.5.9 and 6.6.5.10: PRIVATE is for the block alone,
PROTECTED also for the blocks that extend it, INTERNAL for all of its namespace. VAR without a word
is PROTECTED there; CODESYS and TwinCAT show it to everybody and write it from inside.
"""

from collections.abc import Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Note
from fbgen.lang import ast
from fbgen.lang.checked import Block, Variable
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.namespaces import is_inside
from fbgen.source import Span

_ACCESS = ("PRIVATE", "PROTECTED", "INTERNAL", "PUBLIC")


@dataclass(frozen=True, slots=True)
class Guarded:
    """Something of the block `owner` that only some may use; `word` as in `access_word`."""

    name: str
    word: str
    owner: Block
    span: Span


class VariableAccess:
    """The variables of a program whose section says who may use them."""

    def __init__(self) -> None:
        self._said: dict[Variable, Guarded] = {}

    def enter(
        self, block: Block, sections: Sequence[ast.VarSection], variables: Sequence[Variable]
    ) -> None:
        """Take note of what the sections of a block say."""
        by_name = {one.name.casefold(): one for one in variables}
        for section in sections:
            word = access_word(section.qualifiers)
            if not word:
                continue
            for declaration in section.declarations:
                for declared in declaration.names:
                    variable = by_name.get(declared.name.casefold())
                    if variable is not None:
                        self._said[variable] = Guarded(variable.name, word, block, variable.span)

    def word(self, variable: Variable) -> str:
        """PUBLIC and the like; "" for a variable whose section says nothing."""
        said = self._said.get(variable)
        return "" if said is None else said.word

    def check(self, ctx: Context, span: Span, variable: object) -> bool:
        """Report the use of a variable where it must not be used."""
        if not self._said or not isinstance(variable, Variable):
            return True
        said = self._said.get(variable)
        return said is None or check_who(ctx, span, said)


def access_word(modifiers: Sequence[str]) -> str:
    """The narrowest of PRIVATE, PROTECTED, INTERNAL and PUBLIC among some words; "" without."""
    return next((word for word in _ACCESS if word in modifiers), "")


def check_who(ctx: Context, span: Span, used: Guarded) -> bool:
    """Report the use of something where it must not be used."""
    word, owner = used.word, used.owner
    user = ctx.owner or ctx.block
    if word == "PRIVATE":
        allowed, who = user is owner, f"{owner.name} itself"
    elif word == "PROTECTED":
        objects = ctx.library.objects
        allowed = user is not None and objects.is_kind_of(user, owner)
        who = f"{owner.name} and the blocks that extend it"
    elif word == "INTERNAL":
        home = owner.name.rpartition(".")[0]
        allowed = user is not None and is_inside(user.name.rpartition(".")[0], home)
        who = f"the namespace {home}"
    else:
        return True
    if not allowed:
        ctx.findings.error(
            "FB4085",
            f"'{used.name}' of {owner.name} is {word}",
            span,
            f"only {who} can use it: use something PUBLIC, or change the modifier",
            (Note("it is declared here", used.span),),
        )
    return allowed
