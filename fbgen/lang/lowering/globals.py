"""Data blocks as global variables of a configuration."""

from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    DataBlock,
    Declaration,
    DeclaredName,
    Expression,
    Member,
    Name,
    NamedType,
    StructLiteral,
    StructSpec,
    Trivia,
    TypeSpec,
)
from fbgen.lang.lowering.blocks import header_comments
from fbgen.lang.lowering.context import Context
from fbgen.lang.lowering.expressions import ExpressionLowering
from fbgen.lang.lowering.types import TypeLowering
from fbgen.source import Span


def lower_data_block(context: Context, block: DataBlock) -> Declaration:
    """One data block as a declaration; its own structure becomes a type `NAME_TYPE`."""
    name = context.names.check(block.name.name, block.name.span)
    types = TypeLowering(context, name, None)
    spec = types.type_spec(_own_type(block), "TYPE")
    context.types_of_globals[name.casefold()] = spec
    comments: tuple[Trivia, ...] = (
        *block.leading,
        *header_comments(block.header),
        *block.header_comments,
        *block.closing,
    )
    return Declaration(
        block.span,
        (DeclaredName(block.name.span, name),),
        spec,
        _start_values(context, block),
        None,
        "",
        comments,
    )


def _own_type(block: DataBlock) -> TypeSpec:
    if block.type is not None:
        return NamedType(block.type.span, block.type.name, block.type.quoted)
    if block.struct is not None:
        return block.struct
    fields = tuple(one for section in block.sections for one in section.declarations)
    return StructSpec(block.span, fields)


@dataclass(slots=True)
class _Level:
    """Start values of one structure: of its plain members and of the structures in it."""

    values: dict[str, Expression] = field(default_factory=dict)
    inner: dict[str, "_Level"] = field(default_factory=dict)

    def literal(self, place: Span) -> StructLiteral:
        members: dict[str, Expression] = dict(self.values)
        members |= {name: level.literal(place) for name, level in self.inner.items()}
        return StructLiteral(
            place,
            tuple(
                Argument(place, ArgumentKind.INPUT, name, value) for name, value in members.items()
            ),
        )


def _start_values(context: Context, block: DataBlock) -> Expression | None:
    """The assignments behind BEGIN as one value of the structure."""
    expressions = ExpressionLowering(context, None)
    top = _Level()
    for assignment in block.assignments:
        path = _path(assignment.target)
        if path is None:
            context.findings.refuse(
                f"the start value of {assignment.target.span.text}",
                assignment.span,
                "set the whole array where it is declared",
            )
            continue
        level = top
        for name in path[:-1]:
            level = level.inner.setdefault(name, _Level())
        level.values[path[-1]] = expressions.expression(assignment.value)
    return top.literal(block.span) if block.assignments else None


def _path(target: Expression) -> list[str] | None:
    """The names from the data block down to a member; None with an index on the way."""
    names: list[str] = []
    while isinstance(target, Member):
        names.append(target.name)
        target = target.base
    if not isinstance(target, Name):
        return None
    return [target.name, *reversed(names)]
