"""What all nodes share: how they are made, and what stands between the tokens."""

from collections.abc import Callable
from dataclasses import field
from enum import Enum
from typing import TYPE_CHECKING, TypeAlias, TypeVar, dataclass_transform

from fbgen.dataclass import dataclass
from fbgen.source import Span

_C = TypeVar("_C", bound=type)

if TYPE_CHECKING:

    @dataclass_transform(frozen_default=True, eq_default=False, field_specifiers=(field,))
    def node(cls: _C) -> _C: ...
else:
    node: Callable[[type], type] = dataclass(slots=True, eq=False)


class TriviaKind(Enum):
    """What stands between the tokens and is kept."""

    LINE_COMMENT = "// comment"
    BLOCK_COMMENT = "(* comment *)"
    PRAGMA = "{ pragma }"
    BLANK_LINE = "blank line"


@node
class Trivia:
    """A comment with its delimiters, a pragma with its braces, or one blank line (no text)."""

    span: Span
    kind: TriviaKind
    text: str


TriviaList: TypeAlias = tuple[Trivia, ...]
