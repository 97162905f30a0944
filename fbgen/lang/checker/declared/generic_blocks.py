"""VAR_GENERIC CONSTANT: a block for each set of values that instances are declared with.

`Buffer<6>` becomes a block of that name in which the constants have these values; `Buffer` itself
has the values of its declaration. A value may name a constant of the block around.
Source: TwinCAT 3 help and CODESYS online help, "Generic constant variables - VAR_GENERIC CONSTANT".
"""

import re
from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang import ast
from fbgen.lang.checker.findings import Findings
from fbgen.lang.parser import parse_recovering
from fbgen.lang.rewriting import Rewriter, Rule, replaced
from fbgen.source import Source, Span

_GENERIC = "VAR_GENERIC"
_WORD = re.compile(r"[^\W\d]\w*")
_MOST = 1000
"""Blocks that are made of generic ones; more means that they make each other."""


def with_values(files: Sequence[ast.File], findings: Findings) -> Sequence[ast.File]:
    """The program without VAR_GENERIC, with a block for each set of values."""
    generic = {
        unit.name.name.casefold(): unit
        for file in files
        for unit in file.units
        if isinstance(unit, ast.Block) and any(one.keyword == _GENERIC for one in unit.sections)
    }
    if not generic:
        return files
    making = _Making(generic, files[0].dialect, findings)
    result = [
        ast.File(file.source, file.dialect, tuple(map(making.unit, file.units)), file.closing)
        for file in files
    ]
    first = result[0]
    made = tuple(making.made())
    result[0] = ast.File(first.source, first.dialect, (*first.units, *made), first.closing)
    return result


class _Making(Rewriter):
    def __init__(self, generic: Mapping[str, ast.Block], dialect: str, findings: Findings) -> None:
        self._generic = generic
        self._dialect = dialect
        self._findings = findings
        self._wanted: dict[str, ast.Block] = {}
        self._constants: dict[str, str] = {}

    def unit(self, unit: ast.Unit) -> ast.Unit:
        """A unit that names blocks with their values; a generic one with its own values."""
        self._constants = {}
        if isinstance(unit, ast.Block):
            self._constants = _constants(unit)
            unit = replaced(unit, sections=tuple(map(_plain, unit.sections)))
        written: ast.Unit = self.rewrite(unit)
        return written

    def made(self) -> list[ast.Unit]:
        """The blocks that were named; those that these name in their turn, too."""
        done: dict[str, ast.Unit] = {}
        while waiting := [key for key in self._wanted if key not in done]:
            for key in waiting[: _MOST - len(done)]:
                done[key] = self.unit(self._wanted[key])
            if len(done) >= _MOST:
                break
        return list(done.values())

    def _type(self, node: ast.NamedType) -> ast.NamedType:
        name, bracket, values = node.name.partition("<")
        block = self._generic.get(name.casefold())
        if not bracket or block is None:
            return node
        given = [_WORD.sub(self._value, one.strip()) for one in values.removesuffix(">").split(",")]
        names = [
            declared
            for section in block.sections
            if section.keyword == _GENERIC
            for declaration in section.declarations
            for declared in declaration.names
        ]
        if len(given) != len(names):
            self._findings.error(
                "FB4042",
                f"{block.name.name} has {len(names)} generic constants, {len(given)} are given",
                node.span,
                "give a value for each: " + ", ".join(one.name for one in names),
            )
            return replaced(node, name=block.name.name)
        whole = f"{block.name.name}<{', '.join(given)}>"
        self._wanted.setdefault(whole.casefold(), self._with(block, whole, given, node.span))
        return replaced(node, name=whole)

    def _value(self, word: re.Match[str]) -> str:
        return self._constants.get(word[0].casefold(), word[0])

    def _with(self, block: ast.Block, name: str, given: list[str], span: Span) -> ast.Block:
        values = iter(given)

        def declaration(node: ast.Declaration) -> list[ast.Declaration]:
            return [
                replaced(node, names=(one,), initial=_expression(next(values), self._dialect, span))
                for one in node.names
            ]

        sections = tuple(
            replaced(
                section,
                declarations=tuple(new for one in section.declarations for new in declaration(one)),
            )
            if section.keyword == _GENERIC
            else section
            for section in block.sections
        )
        return replaced(block, name=replaced(block.name, name=name), sections=sections)

    rules: ClassVar[Mapping[type, Rule]] = {ast.NamedType: _type}


def _plain(section: ast.VarSection) -> ast.VarSection:
    if section.keyword != _GENERIC:
        return section
    return replaced(section, keyword="VAR", qualifiers=("CONSTANT",))


def _constants(block: ast.Block) -> dict[str, str]:
    """The constants of a block whose values can stand in the name of another one."""
    return {
        declared.name.casefold(): declaration.initial.text
        for section in block.sections
        if section.keyword == _GENERIC or "CONSTANT" in section.qualifiers
        for declaration in section.declarations
        if isinstance(declaration.initial, ast.Literal)
        for declared in declaration.names
    }


def _expression(text: str, dialect: str, span: Span) -> ast.Expression:
    """A value as an expression; its places are in a text of their own."""
    source = Source(span.source.name, f"VAR_GLOBAL CONSTANT a : INT := {text}; END_VAR")
    file, _ = parse_recovering(source, dialect)
    unit = file.units[0] if file.units else None
    initial = None
    if isinstance(unit, ast.Globals) and unit.section.declarations:
        initial = unit.section.declarations[0].initial
    return _Moved(span).rewrite(initial) if initial is not None else ast.Name(span, text)


class _Moved(Rewriter):
    """The same expression at another place."""

    def __init__(self, span: Span) -> None:
        self._span = span

    def _here(self, node: ast.Literal | ast.Name) -> ast.Expression:
        return replaced(node, span=self._span)

    rules: ClassVar[Mapping[type, Rule]] = {ast.Literal: _here, ast.Name: _here}
