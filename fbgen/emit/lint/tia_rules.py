"""Rules of TIA Portal for external SCL sources.

Sources: TIA Portal help, "Using external source files" and "Overview of the valid data types";
headers, quoting and attributes as in published native exports.
"""

import re
from collections.abc import Iterator
from itertools import pairwise

from fbgen.blocks.plan import ERROR_BLOCKS
from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang import ast
from fbgen.lang.walk import walk

_LONGEST_NAME = 125
_HEADER_ORDER = ("TITLE", "{}", "AUTHOR", "FAMILY", "NAME", "VERSION")
_NAMES_OF_THE_USER = frozenset({"main", "ob1", "startup", "ob100"})
_TIMERS = frozenset({"TON_TIME", "TOF_TIME", "TP_TIME", "TONR_TIME"})
_OPTIMIZED = re.compile(r"S7_Optimized_Access\s*:=\s*'TRUE'", re.IGNORECASE)


def no_comment_in_header(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5041: between the line of a block and its first section no comment may stand."""
    for unit in emitted.file.units:
        if isinstance(unit, ast.Block | ast.DataBlock):
            behind = unit.sections[0].leading if unit.sections else ()
            trivia = (*unit.header_comments, *behind)
            comments = [item for item in trivia if item.kind is not ast.TriviaKind.BLANK_LINE]
            allowed = 1 if isinstance(unit, ast.Block) and _is_function(unit) else 0
            for comment in comments[allowed:]:
                yield Diagnostic(
                    "FB5041",
                    f"a comment stands in the header of '{unit.name.name}'",
                    comment.span,
                    "TIA Portal wants it before the block or behind the first section",
                )


def header_in_order(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5042: header lines stand in the order in which TIA Portal exports them."""
    for unit in emitted.file.units:
        if not isinstance(unit, ast.Block | ast.DataBlock | ast.TypeDeclaration):
            continue
        places = [
            (_HEADER_ORDER.index(item.keyword), item)
            for item in unit.header
            if item.keyword in _HEADER_ORDER
        ]
        for (before, _), (place, item) in pairwise(places):
            if place < before:
                yield Diagnostic(
                    "FB5042",
                    f"{item.keyword} stands too late in the header of '{unit.name.name}'",
                    item.span,
                    "the order is TITLE, attributes, AUTHOR, FAMILY, NAME, VERSION",
                )


def names_not_too_long(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5043: a name has at most 125 characters."""
    for item in emitted.names_longer_than(_LONGEST_NAME):
        yield Diagnostic(
            "FB5043",
            f"the name '{item.name[:20]}...' has {len(item.name)} characters",
            item.span,
            f"TIA Portal takes {_LONGEST_NAME}; shorten the names in the plant file",
        )


def no_block_of_the_user(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5044: no organization block and no Main: importing it would overwrite the user's own.

    The error blocks are excepted, which the plant file leaves out where there are others.
    """
    for unit in emitted.file.units:
        if not isinstance(unit, ast.Block):
            continue
        is_ob = unit.kind is ast.BlockKind.ORGANIZATION_BLOCK
        if unit.name.name in ERROR_BLOCKS:
            continue
        if is_ob or unit.name.name.casefold() in _NAMES_OF_THE_USER:
            yield Diagnostic(
                "FB5044",
                f"'{unit.name.name}' would overwrite a block of the user's project",
                unit.name.span,
                "generate a FUNCTION that the user's OB calls",
            )


def locals_and_globals_marked(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5045: in code, locals carry # and globals stand in quotes, as TIA Portal exports them."""
    instructions = {id(item.callee) for item in emitted.of(ast.Call)}
    plain = [
        item
        for item in emitted.of(ast.Name)
        if not item.local and not item.quoted and id(item) not in instructions
    ]
    if not plain:
        return
    in_code = {
        id(item)
        for unit in emitted.file.units
        if isinstance(unit, ast.Block)
        for item in walk(unit.body)
    }
    for item in plain:
        if id(item) in in_code:
            yield Diagnostic(
                "FB5045",
                f"'{item.name}' has neither # nor quotes",
                item.span,
                f'write #{item.name} for a local, "{item.name}" for a global',
            )


def overlays_only_without_optimization(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5046: AT stands only in blocks without optimized access, and without initial value."""
    if all(item.at is None for item in emitted.of(ast.Declaration)):
        return
    for unit in emitted.file.units:
        if not isinstance(unit, ast.Block):
            continue
        optimized = any(_OPTIMIZED.search(item.text) for item in unit.header)
        for item in walk(unit.sections):
            if isinstance(item, ast.Declaration) and item.at is not None:
                if optimized:
                    message = "AT stands in a block with optimized access"
                    yield Diagnostic("FB5046", message, item.span, "S7_Optimized_Access := 'FALSE'")
                if item.initial is not None:
                    yield Diagnostic("FB5046", "an AT overlay has an initial value", item.span)


def timers_with_their_instruction(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5047: an instance of an IEC timer names its instruction and library version."""
    for item in emitted.of(ast.Declaration):
        if not isinstance(item.type, ast.NamedType):
            continue
        attributes = item.type_attributes + "".join(name.attributes for name in item.names)
        if item.type.name.upper() in _TIMERS and "InstructionName" not in attributes:
            yield Diagnostic(
                "FB5047",
                f"the instance of {item.type.name} names no instruction",
                item.span,
                f"{{InstructionName := '{item.type.name.upper()}'; LibVersion := '1.0'}}",
            )


def powers_in_parentheses(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5048: Siemens contradicts itself on ** against the unary minus: parentheses decide."""
    for unary in emitted.of(ast.Unary):
        if _is_power(unary.operand):
            yield Diagnostic("FB5048", "a sign stands before a power", unary.span, "-(a ** b)")
    for binary in emitted.of(ast.Binary):
        if _is_power(binary) and isinstance(binary.left, ast.Unary):
            yield Diagnostic("FB5048", "a sign stands before a power", binary.span, "(-a) ** b")


def _is_power(item: object) -> bool:
    return isinstance(item, ast.Binary) and item.operator == "**"


def _is_function(unit: ast.Block) -> bool:
    return unit.kind is ast.BlockKind.FUNCTION


RULES = (
    no_comment_in_header,
    header_in_order,
    names_not_too_long,
    no_block_of_the_user,
    locals_and_globals_marked,
    overlays_only_without_optimization,
    timers_with_their_instruction,
    powers_in_parentheses,
)
