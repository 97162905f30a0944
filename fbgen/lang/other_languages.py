"""Bodies in ladder, function block diagrams, charts and lists: known to be there, and no more.

Such a body stands in the tree as one call, `__BODY_IN_FBD();`, which checks as a statement that
cannot run. It is not written back: what a file has there stays as it is.
"""

from collections.abc import Iterator, Sequence

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang.ast import Block, CallStatement, File, Interface, Name, Property, Statement
from fbgen.source import Span

_PREFIX = "__BODY_IN_"


def foreign_body(language: str) -> str:
    """The statement that stands for a body in a language."""
    return f"{_PREFIX}{language}();"


def other_language(name: str, language: str, place: Span) -> Diagnostic:
    """A body that is not structured text."""
    return Diagnostic(
        "FB3017",
        f"the body of {name} is written in {language}",
        place,
        "only structured text is read; its variables are known all the same",
        severity=Severity.WARNING,
    )


def language_of(name: str) -> str:
    """The language in the name of such a call; empty for any other name."""
    return name.removeprefix(_PREFIX) if name.startswith(_PREFIX) else ""


def is_foreign(body: Sequence[Statement]) -> bool:
    """True for a body in another language."""
    return any(map(_language, body))


def bodies(block: Block | Interface) -> Iterator[Sequence[Statement]]:
    """The statements of a block, its methods, accessors and actions."""
    if isinstance(block, Block):
        yield block.body
    for member in block.members:
        if isinstance(member, Property):
            yield from (accessor.body for accessor in member.accessors)
        else:
            yield member.body


def foreign_bodies(files: Sequence[File]) -> Iterator[tuple[Span, str]]:
    """Where bodies in other languages are, and in which."""
    for file in files:
        for unit in file.units:
            if isinstance(unit, Block | Interface):
                for body in bodies(unit):
                    yield from ((one.span, found) for one in body if (found := _language(one)))


def _language(statement: Statement) -> str:
    if isinstance(statement, CallStatement) and isinstance(statement.call.callee, Name):
        return language_of(statement.call.callee.name)
    return ""
