"""What the chosen CPU family lacks: types, constructs, instructions.

Errors, as its compiler refuses them.
"""

from collections.abc import Iterable, Iterator
from typing import Any

from fbgen.diagnostics import Diagnostic
from fbgen.lang import ast
from fbgen.lang.families import MISSING_CONSTRUCTS, MISSING_TYPES, Construct, Cpu
from fbgen.lang.instruction_families import instead_of
from fbgen.lang.walk import walk
from fbgen.source import Span

_COMPOUND = ("+=", "-=", "*=", "/=")
_HELP = {
    Construct.REGIONS: "write the title as a comment",
    Construct.SLICES: "lay another variable over it with AT, or shift and mask",
    Construct.COMPOUND: "write the variable again: x := x + 1;",
    Construct.OPEN_ARRAYS: "declare the bounds, or hand the area over as ANY",
    Construct.REFERENCES: "use an in-out, or VARIANT where the family has it",
}


def missing_on(cpu: Cpu, files: Iterable[ast.File]) -> Iterator[Diagnostic]:
    """FB4301 to FB4303: what the family does not have, each place."""
    types, constructs = MISSING_TYPES[cpu], MISSING_CONSTRUCTS[cpu]
    files = tuple(files)
    own = {
        unit.name.name.casefold()
        for file in files
        for unit in file.units
        if isinstance(unit, ast.TypeDeclaration | ast.Block)
    }
    for file in files:
        item: Any
        for item in walk(file):
            for name, span in _types_of(item):
                if name.upper() in types and name.casefold() not in own:
                    yield _missing_type(cpu, name.upper(), span)
            used = _instruction_of(item)
            if used is not None and used.name.casefold() not in own:
                instead = instead_of(used.name, cpu)
                if instead is not None:
                    yield _missing_instruction(cpu, used, instead)
            construct = _construct_of(item)
            if construct is not None and construct in constructs:
                yield _missing_construct(cpu, construct, item.span)


def _types_of(item: object) -> Iterator[tuple[str, Span]]:
    """The type names in a node: of declarations, literals and conversion functions."""
    if isinstance(item, ast.NamedType):
        if not item.quoted:
            yield item.name, item.span
    elif isinstance(item, ast.StringSpec):
        yield ("WSTRING" if item.wide else "STRING"), item.span
    elif isinstance(item, ast.Literal):
        yield item.type_name, item.span
    elif isinstance(item, ast.Call) and isinstance(item.callee, ast.Name):
        source, to, target = item.callee.name.partition("_TO_")
        if to and not item.callee.quoted:
            yield source, item.callee.span
            yield target, item.callee.span


def _instruction_of(item: object) -> ast.Name | ast.NamedType | None:
    """The name of what may be an instruction: the callee, or the type of an instance."""
    if isinstance(item, ast.Call) and isinstance(item.callee, ast.Name):
        callee = item.callee
        return None if callee.quoted or callee.local else callee
    return item if isinstance(item, ast.NamedType) and not item.quoted else None


def _construct_of(item: object) -> Construct | None:
    if isinstance(item, ast.Region):
        return Construct.REGIONS
    if isinstance(item, ast.Slice):
        return Construct.SLICES
    if isinstance(item, ast.Assignment) and item.operator in _COMPOUND:
        return Construct.COMPOUND
    if isinstance(item, ast.Bounds) and item.first is None:
        return Construct.OPEN_ARRAYS
    if isinstance(item, ast.ReferenceSpec) and item.keyword == "REF_TO":
        return Construct.REFERENCES
    return None


def _missing_type(cpu: Cpu, name: str, span: Span) -> Diagnostic:
    return Diagnostic(
        "FB4301",
        f"{cpu.value} has no type {name}",
        span,
        "choose a type that the family has, such as INT, DINT, WORD, DWORD, REAL or TIME",
    )


def _missing_construct(cpu: Cpu, construct: Construct, span: Span) -> Diagnostic:
    return Diagnostic("FB4302", f"{cpu.value} has no {construct.value}", span, _HELP[construct])


def _missing_instruction(cpu: Cpu, used: ast.Name | ast.NamedType, instead: str) -> Diagnostic:
    return Diagnostic("FB4303", f"{cpu.value} has no {used.name.upper()}", used.span, instead)
