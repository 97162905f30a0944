"""Blocks, data blocks, types, configurations, and the file that holds them."""

from enum import Enum
from typing import TypeAlias

from fbgen.lang.ast.declarations import (
    LabelSection,
    NamedType,
    StructSpec,
    TypeSpec,
    VarSection,
)
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
    CLASS = "CLASS"


@node
class Method:
    """METHOD inside a block or an interface; `modifiers` upper case: PUBLIC, ABSTRACT, FINAL, ...

    The body of a method of an interface is empty.
    """

    span: Span
    name: Name
    modifiers: tuple[str, ...]
    return_type: TypeSpec | None
    sections: tuple[VarSection, ...]
    body: tuple[Statement, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Accessor:
    """GET or SET of a property: local variables and code; `keyword` is "GET" or "SET"."""

    span: Span
    keyword: str
    modifiers: tuple[str, ...]
    sections: tuple[VarSection, ...]
    body: tuple[Statement, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Property:
    """PROPERTY name : type with its accessors."""

    span: Span
    name: Name
    modifiers: tuple[str, ...]
    type: TypeSpec
    accessors: tuple[Accessor, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


@node
class Action:
    """ACTION name: ... END_ACTION: statements that share the variables of their block."""

    span: Span
    name: Name
    body: tuple[Statement, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


BlockMember: TypeAlias = Method | Property | Action


@node
class Block:
    """A block with code. `return_type` only for a FUNCTION; NamedType "Void" without result.

    `members` are its methods, properties and actions, also those that a file has behind the block.
    `modifiers` upper case: ABSTRACT, FINAL, PUBLIC, INTERNAL. `usings` are the namespaces that this
    block opens for itself.
    """

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
    modifiers: tuple[str, ...] = ()
    extends: NamedType | None = None
    implements: tuple[NamedType, ...] = ()
    members: tuple[BlockMember, ...] = ()
    labels: tuple[LabelSection, ...] = ()
    usings: tuple["Using", ...] = ()


@node
class Interface:
    """INTERFACE name EXTENDS a, b ... END_INTERFACE."""

    span: Span
    name: Name
    modifiers: tuple[str, ...]
    extends: tuple[NamedType, ...]
    members: tuple[Method | Property, ...]
    leading: TriviaList = ()
    closing: TriviaList = ()
    usings: tuple["Using", ...] = ()


@node
class DataBlock:
    """DATA_BLOCK: either its own structure (`struct` or `sections`) or of a type (`type`).

    `is_array`: an ARRAY data block of TIA, which is written as the type of its only variable, THIS.
    """

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
    is_array: bool = False


@node
class TypeDeclaration:
    """TYPE name : spec; END_TYPE, one per type. `initial` as in `TYPE t : INT := 5; END_TYPE`.

    `extends` as in `TYPE b EXTENDS a : STRUCT ...` of CODESYS.
    """

    span: Span
    name: Name
    header: tuple[HeaderItem, ...]
    type: TypeSpec
    initial: Expression | None = None
    leading: TriviaList = ()
    header_comments: TriviaList = ()
    closing: TriviaList = ()
    modifiers: tuple[str, ...] = ()
    extends: NamedType | None = None


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
    """PROGRAM name WITH task : type(a := x, q => y);  `task` "" without WITH."""

    span: Span
    name: str
    task: str
    type: NamedType
    leading: TriviaList = ()
    trailing: Trivia | None = None
    arguments: tuple[Argument, ...] = ()
    qualifiers: tuple[str, ...] = ()


@node
class Resource:
    """RESOURCE name ON type ... END_RESOURCE.

    Tasks and programs of a configuration without RESOURCE are in one with the name "".
    """

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
    """A VAR_GLOBAL section outside of a configuration.

    `name` is that of the list it stands in (TwinCAT), "" in plain texts: `list.x` means its x too.
    A VAR_CONFIG section of CODESYS stands here, too.
    """

    span: Span
    section: VarSection
    name: str = ""


@node
class LoneMember:
    """A METHOD, PROPERTY or ACTION that stands in a file of its own, without its block."""

    span: Span
    member: BlockMember


@node
class Using:
    """USING Motors, Plant.Lines;"""

    span: Span
    names: tuple[str, ...]
    leading: TriviaList = ()
    trailing: Trivia | None = None


@node
class Namespace:
    """NAMESPACE Plant.Lines ... END_NAMESPACE; `name` with its dots."""

    span: Span
    name: str
    modifiers: tuple[str, ...]
    units: tuple["Unit", ...]
    leading: TriviaList = ()
    closing: TriviaList = ()


Unit: TypeAlias = (
    Block
    | Interface
    | DataBlock
    | TypeDeclaration
    | Configuration
    | Globals
    | Using
    | Namespace
    | LoneMember
)


@node
class File:
    """Everything that one source holds, in its order."""

    source: Source
    dialect: str
    units: tuple[Unit, ...]
    closing: TriviaList = ()
