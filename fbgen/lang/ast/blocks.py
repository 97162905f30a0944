"""Blocks, data blocks, types, configurations, and the file that holds them."""

from enum import Enum
from typing import TypeAlias

from fbgen.lang.ast.declarations import NamedType, StructSpec, TypeSpec, VarSection
from fbgen.lang.ast.expressions import Argument, Expression, Name
from fbgen.lang.ast.node import Trivia, TriviaList, node
from fbgen.lang.ast.statements import Assignment, Statement
from fbgen.source import Source, Span


@node
class HeaderItem:
    """A line of the block header: TITLE, AUTHOR, FAMILY, NAME, VERSION or attributes.

    `keyword` is upper case, "{}" for attributes; `text` is the raw text behind the keyword
    (without `=` or `:`), for attributes the text with its braces.
    """

    span: Span
    keyword: str
    text: str


class BlockKind(Enum):
    """What kind of block it is, by its keyword."""

    FUNCTION_BLOCK = "FUNCTION_BLOCK"
    FUNCTION = "FUNCTION"
    ORGANIZATION_BLOCK = "ORGANIZATION_BLOCK"
    PROGRAM = "PROGRAM"


@node
class Block:
    """A block with code. `return_type` only for a FUNCTION; NamedType "Void" without result."""

    span: Span
    kind: BlockKind
    name: Name
    return_type: TypeSpec | None
    header: tuple[HeaderItem, ...]
    sections: tuple[VarSection, ...]
    body: tuple[Statement, ...]
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    body_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class DataBlock:
    """DATA_BLOCK: either its own structure (`struct` or `sections`) or of a type (`type`)."""

    span: Span
    name: Name
    header: tuple[HeaderItem, ...]
    type: NamedType | None
    struct: StructSpec | None
    sections: tuple[VarSection, ...]
    assignments: tuple[Assignment, ...]
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class TypeDeclaration:
    """TYPE name : spec; END_TYPE, one per type. `initial` as in `TYPE t : INT := 5; END_TYPE`."""

    span: Span
    name: Name
    header: tuple[HeaderItem, ...]
    type: TypeSpec
    initial: Expression | None = None
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    closing: TriviaList = ()


@node
class Task:
    """TASK name(INTERVAL := T#10ms, PRIORITY := 0);"""

    span: Span
    name: str
    properties: tuple[Argument, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class ProgramInstance:
    """PROGRAM name WITH task : type;  `task` "" without WITH."""

    span: Span
    name: str
    task: str
    type: NamedType
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Resource:
    """RESOURCE name ON type ... END_RESOURCE."""

    span: Span
    name: str
    on: str
    sections: tuple[VarSection, ...]
    tasks: tuple[Task, ...]
    programs: tuple[ProgramInstance, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Configuration:
    """CONFIGURATION name ... END_CONFIGURATION."""

    span: Span
    name: str
    sections: tuple[VarSection, ...]
    resources: tuple[Resource, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Globals:
    """A VAR_GLOBAL section outside of a configuration."""

    span: Span
    section: VarSection


Unit: TypeAlias = Block | DataBlock | TypeDeclaration | Configuration | Globals


@node
class File:
    """Everything that one source holds, in its order."""

    source: Source
    dialect: str
    units: tuple[Unit, ...]
    closing: TriviaList = ()
