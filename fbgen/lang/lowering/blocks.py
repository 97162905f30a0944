"""Blocks in IEC: functions, function blocks, and programs for what S7 calls from an OB."""

from fbgen.lang.ast import (
    Assignment,
    Block,
    BlockKind,
    Declaration,
    DeclaredName,
    HeaderItem,
    Literal,
    LiteralKind,
    Name,
    NamedType,
    Statement,
    Trivia,
    TriviaKind,
    TriviaList,
    TypeSpec,
    VarSection,
)
from fbgen.lang.lowering.build import comment
from fbgen.lang.lowering.context import Context
from fbgen.lang.lowering.plant import BlockScope
from fbgen.lang.lowering.statements import StatementLowering
from fbgen.lang.lowering.types import TypeLowering
from fbgen.source import Span

_KEPT_QUALIFIERS = frozenset({"CONSTANT", "RETAIN", "NON_RETAIN"})


def lower_block(context: Context, block: Block) -> Block:
    """One block with code."""
    scope = BlockScope(context.plant, block)
    types = TypeLowering(context, block.name.name, scope)
    body = StatementLowering(types)
    name = context.names.check(block.name.name, block.name.span)
    is_program = context.is_program(block)
    is_function = block.kind is BlockKind.FUNCTION and not is_program
    if is_program:
        _check_program(context, block)
    sections = [_section(types, section, is_function) for section in block.sections]
    statements, closing = body.body(block.body, block.closing)
    sections += _unused(body, block, is_function)
    sections += _externals(context, body, block)
    result: TypeSpec | None = None
    if is_function and block.return_type is not None:
        result, statements = _result(types, block, name, statements)
    if is_function and body.used_globals and not context.target.has_free_globals:
        _refuse_global_data(context, block)
    leading, comments = _comments(block)
    kind = BlockKind.PROGRAM if is_program else block.kind
    return Block(
        block.span,
        kind,
        Name(block.name.span, name),
        result,
        (),
        tuple(sections),
        statements,
        leading,
        (),
        comments,
        closing,
    )


def header_comments(header: tuple[HeaderItem, ...]) -> TriviaList:
    """Header lines as comments; attributes mean nothing outside of S7 and are left out."""
    comments: list[Trivia] = []
    for item in header:
        if item.keyword != "{}":
            text = f"{item.keyword}: {item.text}" if item.text else item.keyword
            comments.append(comment(item.span, text))
    return tuple(comments)


def _comments(block: Block) -> tuple[TriviaList, TriviaList]:
    """What stands above the block, and in front of its first statement."""
    leading = (*block.leading, *header_comments(block.header), *block.header_comments)
    blank = tuple(one for one in block.body_comments if one.kind is not TriviaKind.BLANK_LINE)
    return leading, blank


def _section(types: TypeLowering, section: VarSection, is_function: bool) -> VarSection:
    keyword = section.keyword
    if is_function and keyword == "VAR_TEMP":
        keyword = "VAR"
    qualifiers = tuple(one for one in section.qualifiers if one in _KEPT_QUALIFIERS)
    return VarSection(
        section.span,
        keyword,
        qualifiers,
        tuple(types.declaration(one) for one in section.declarations),
        section.leading,
        section.trailing,
        section.closing,
        section.opening,
    )


def _unused(body: StatementLowering, block: Block, is_function: bool) -> list[VarSection]:
    """Variables for results of functions that the text drops."""
    if not body.unused_results:
        return []
    place = block.span
    declarations = tuple(
        _variable(place, name, NamedType(place, type_name))
        for type_name, name in sorted(body.unused_results.items())
    )
    return [VarSection(place, "VAR" if is_function else "VAR_TEMP", (), declarations)]


def _externals(context: Context, body: StatementLowering, block: Block) -> list[VarSection]:
    """The global variables that the block uses."""
    if not body.used_globals or context.target.has_free_globals:
        return []
    place = block.span
    declarations = tuple(
        _variable(place, name, context.types_of_globals[key])
        for key, name in sorted(body.used_globals.items())
    )
    return [VarSection(place, "VAR_EXTERNAL", (), declarations)]


def _variable(place: Span, name: str, spec: TypeSpec) -> Declaration:
    return Declaration(place, (DeclaredName(place, name),), spec, None)


def _result(
    types: TypeLowering, block: Block, name: str, statements: tuple[Statement, ...]
) -> tuple[TypeSpec, tuple[Statement, ...]]:
    """The type of the result; a function without one gets BOOL and is always TRUE."""
    spec = block.return_type
    if isinstance(spec, NamedType) and spec.name.upper() == "VOID":
        place = spec.span
        true = Literal(place, LiteralKind.BOOL, True, "TRUE")
        done = Assignment(place, Name(place, name), ":=", true)
        return NamedType(place, "BOOL"), (done, *statements)
    if spec is None:
        raise ValueError("a function without a type of its result")
    return types.type_spec(spec, "result"), statements


def _check_program(context: Context, block: Block) -> None:
    """A program has no parameters and no result that somebody could use."""
    has_result = (
        isinstance(block.return_type, NamedType) and block.return_type.name.upper() != "VOID"
    )
    parameters = [one for one in block.sections if one.keyword.startswith(("VAR_IN", "VAR_OUT"))]
    is_function = block.kind is BlockKind.FUNCTION
    if is_function and (has_result or any(section.declarations for section in parameters)):
        _refuse_global_data(context, block)


def _refuse_global_data(context: Context, block: Block) -> None:
    context.findings.report(
        "FB3053",
        f"the function {block.name.name} uses global data, which IEC forbids",
        block.name.span,
        "hand the data over as VAR_IN_OUT, or make it a FUNCTION_BLOCK",
    )
