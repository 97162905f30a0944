"""What a path gives that can be read, and how names are looked up."""

from collections.abc import Callable, Iterable
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.engine.compiled.watching.last_writes import LastWrite
from harness.scenario.kinds import Found, ValueKind

Writer: TypeAlias = Callable[[], LastWrite | None]
"""Gives the last write of a variable; None where nobody takes notes."""


@dataclass(frozen=True, slots=True)
class Readable:
    """What a path gives: `get` the value now, `kind` what sort of value.

    `writer` tells which line of the PLC wrote it last; None for what no PLC writes.
    """

    kind: ValueKind
    get: Callable[[], Found]
    writer: Writer | None = None


def one_of(name: str, known: Iterable[str], what: str, span: Span | None) -> None:
    """Raises DiagnosticError FB8003 for a name that is none of these."""
    if name not in known:
        raise unknown(name, tuple(known), what, span)


def unknown(name: str, known: tuple[str, ...], what: str, span: Span | None) -> DiagnosticError:
    """FB8003 with the nearest names."""
    message = f"there is no {what} '{name}'" if name else f"a {what} must be named"
    return error("FB8003", message, span, nearest(name, known))
