"""A type as PLC text writes it: `INT`, `STRING[20]`, `ARRAY[0..3] OF BYTE`, the name of a UDT."""

from fbgen.diagnostics import DiagnosticError
from fbgen.lang import ast
from fbgen.lang.checked import Program
from fbgen.lang.checker.declared.type_names import elementary_type
from fbgen.lang.parser import parse
from fbgen.lang.types import DTL, S7_STRING_LENGTH, ArrayType, StringType, Type
from fbgen.source import Source
from harness.engine.faults import unknown_name, wrong_path


def type_written(program: Program, text: str) -> Type:
    """The type of a program that a text names. Raises FB6020 and FB6024."""
    declared = f"FUNCTION_BLOCK x VAR x : {text}; END_VAR END_FUNCTION_BLOCK"
    try:
        file = parse(Source("type", declared), program.dialect)
    except DiagnosticError:
        raise wrong_path(text, "write a type as in VAR: INT, ARRAY[0..3] OF BYTE") from None
    (unit,) = file.units
    assert isinstance(unit, ast.Block)
    return _type(program, unit.sections[0].declarations[0].type, text)


def _type(program: Program, spec: ast.TypeSpec, text: str) -> Type:
    if isinstance(spec, ast.NamedType):
        return _named(program, spec)
    if isinstance(spec, ast.StringSpec):
        length = S7_STRING_LENGTH if spec.length is None else _number(spec.length, text)
        return StringType(length, spec.wide)
    if isinstance(spec, ast.ArraySpec):
        bounds = tuple((_bound(one.first, text), _bound(one.last, text)) for one in spec.bounds)
        return ArrayType(bounds, _type(program, spec.element, text))
    raise wrong_path(text, "a structure needs a name: declare it with TYPE")


def _named(program: Program, spec: ast.NamedType) -> Type:
    key = spec.name.casefold()
    found = program.structures.get(key) or elementary_type(spec.name, program.dialect)
    if found is None and spec.name.upper() == "DTL":
        found = DTL
    if found is None:
        known = [kind.name for kind in program.structures.values()]
        raise unknown_name("type", spec.name, [*known, "INT", "REAL", "BYTE", "STRING"])
    return found


def _bound(node: ast.Expression | None, text: str) -> int:
    if node is None:
        raise wrong_path(text, "it has no bounds")
    return _number(node, text)


def _number(node: ast.Expression, text: str) -> int:
    if isinstance(node, ast.Unary) and node.operator == "-":
        return -_number(node.operand, text)
    if isinstance(node, ast.Literal) and isinstance(node.value, int):
        return node.value
    raise wrong_path(text, "its bounds have to be numbers")
