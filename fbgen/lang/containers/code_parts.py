"""Blocks in parts, as containers keep them: the declaration apart from the statements.

Nothing is indented that stands on its own.
"""

from collections.abc import Callable

from fbgen.lang.ast import (
    Accessor,
    Action,
    Block,
    File,
    Interface,
    Method,
    Property,
    Statement,
    TriviaList,
    Unit,
)
from fbgen.lang.depth import room_for_depth
from fbgen.lang.dialects import dialect_named
from fbgen.lang.printer.members import first_of, without_last_blanks
from fbgen.lang.printer.units import UnitPrinter
from fbgen.lang.rewriting import replaced


def declaration(node: Block | Method | Property | Interface, dialect: str) -> str:
    """The first line and the VAR sections; comments above the block come with it."""
    return _written(dialect, lambda printer: _declaration(printer, node))


def _declaration(printer: UnitPrinter, node: Block | Method | Property | Interface) -> None:
    printer.lines.trivia(node.leading)
    if isinstance(node, Block):
        printer.lines.trivia(node.header_comments)
        printer.lines.level -= 1
        behind = printer.heading(node)
        printer.lines.level += 1
        printer.header_items(node.header)
        _sections(printer, replaced(node, sections=behind))
    elif isinstance(node, Method):
        printer.lines.add(printer.head_of_method(node), first_of(node.span))
        _sections(printer, node)
    elif isinstance(node, Property):
        printer.lines.add(printer.head_of_property(node), first_of(node.span))
        printer.lines.trivia(without_last_blanks(node.closing))
    else:
        printer.lines.add(printer.head_of_interface(node), first_of(node.span))
        printer.lines.trivia(without_last_blanks(node.closing))


def accessor_declaration(node: Accessor, dialect: str) -> str:
    """The VAR sections of a GET or SET."""
    return _written(dialect, lambda printer: _accessor(printer, node))


def _accessor(printer: UnitPrinter, node: Accessor) -> None:
    printer.lines.trivia(node.leading)
    if node.modifiers:
        printer.lines.add(" ".join(node.modifiers), first_of(node.span))
    _sections(printer, node)


def _sections(printer: UnitPrinter, node: Block | Method | Accessor) -> None:
    printer.lines.level -= 1
    printer.sections(node.sections)
    printer.lines.level += 1


def body(node: Block | Method | Action | Accessor, dialect: str) -> str:
    """The statements, without an end of line behind the last one."""
    comments: TriviaList = ()
    if isinstance(node, Block):
        comments = without_last_blanks(node.body_comments)
    text = _written(
        dialect, lambda printer: _statements(printer, comments, node.body, node.closing)
    )
    return text.strip("\n")


def _statements(
    printer: UnitPrinter, above: TriviaList, body: tuple[Statement, ...], closing: TriviaList
) -> None:
    printer.lines.trivia(above)
    printer.lines.level -= 1
    printer.statements(body, without_last_blanks(closing))
    printer.lines.level += 1


def units(nodes: tuple[Unit, ...], dialect: str, closing: TriviaList = ()) -> str:
    """Whole units."""

    def write(printer: UnitPrinter) -> None:
        source = nodes[0].span.source if nodes else None
        if source is not None:
            printer.file(File(source, dialect, nodes, closing))

    return _written(dialect, write)


def _written(dialect: str, write: Callable[[UnitPrinter], None]) -> str:
    printer = UnitPrinter(dialect_named(dialect))
    with room_for_depth():
        write(printer)
    return printer.lines.text()
