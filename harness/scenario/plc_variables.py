"""Variables of the PLC in scenario files: which type a path has, and which values that takes.

Values are written as YAML has them: true and false for BOOL, numbers, texts for STRING and CHAR.
Bit strings and integers may also be written as the PLC languages write them (16#8401, 2#1010);
times and dates always are (T#2s, D#2024-02-29), because a bare number would hide its unit. A REAL
may also be .nan, .inf or -.inf.
"""

from collections.abc import Callable
from math import inf, nan

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.ast import LiteralKind
from fbgen.lang.checked import Program
from fbgen.lang.literals import BadLiteralError, LiteralValue, read_literal
from fbgen.lang.types import (
    LTIME,
    AnyType,
    ArrayType,
    BlockType,
    Elementary,
    Enumeration,
    Family,
    StringType,
    StructType,
    Subrange,
    Type,
)
from harness.engine.interface import Engine, Reader, Value
from harness.engine.path_types import stays, type_at
from harness.engine.spelling import LITERALS, counted
from harness.engine.values import accept_scalar
from harness.scenario.kinds import Found, ValueKind, WrongValueError, show
from harness.scenario.scalars import Scalar

_NOT_FINITE = {".nan": nan, ".inf": inf, "-.inf": -inf}
"""As YAML writes what a REAL can hold beside numbers."""
_NUMBERS = (Family.BITS, Family.SIGNED, Family.UNSIGNED, Family.REAL)


def variable_kind(program: Program, path: str) -> ValueKind:
    """What the global variable at a path can be set to and compared with."""
    return kind_of_type(program, path, type_at(program, path))


def reading(engine: Engine, path: str) -> Callable[[], Found]:
    """What reads the global variable at a path.

    Most conditions are asked again and again: from the second time on the place is known.
    """
    if not stays(engine.program, path):
        return lambda: engine.global_value(path)
    read: Reader | None = None
    asked = False

    def value() -> Found:
        nonlocal read, asked
        if read is not None:
            return read()[0]
        if asked:
            read = engine.reader((path,))
        asked = True
        return engine.global_value(path)

    return value


def kind_of_type(program: Program, path: str, kind: Type) -> ValueKind:
    """What a variable of a type can be set to and compared with; `path` is for messages."""

    def read(value: Scalar) -> Found:
        return _read(program, path, kind, value)

    number = isinstance(kind, Elementary) and kind.family in (*_NUMBERS, Family.DURATION)
    return ValueKind(f"of type {kind}", read, lambda found: _show(kind, found), number)


def _read(program: Program, path: str, kind: Type, value: Scalar) -> Value:
    if not isinstance(kind, Elementary | StringType):
        raise WrongValueError(_name_a_part(program, path, kind))
    try:
        return accept_scalar(path, kind, _as_python(kind, value))
    except DiagnosticError as refused:
        raise WrongValueError(_spelling(kind)) from refused


def _as_python(kind: Elementary | StringType, value: Scalar) -> Scalar:
    if isinstance(kind, StringType) or kind.family in (Family.BOOL, Family.CHAR):
        return value
    if isinstance(kind, Enumeration) and isinstance(value, str):
        return value
    if wanted := LITERALS.get(kind.name):
        literal = _literal(value)
        if literal is None or literal.kind is not wanted[0] or not isinstance(literal.value, int):
            raise WrongValueError(_spelling(kind))
        return counted(kind, literal.value)
    if kind.family is Family.REAL and isinstance(value, str) and value in _NOT_FINITE:
        return _NOT_FINITE[value]
    literal = _literal(value)
    if literal is not None and literal.kind in (LiteralKind.INTEGER, LiteralKind.REAL):
        return literal.value
    return value


def _literal(value: Scalar) -> LiteralValue | None:
    """A literal of the PLC languages with its prefix; None for anything else."""
    if not isinstance(value, str) or "#" not in value:
        return None
    try:
        return read_literal(value)
    except BadLiteralError as wrong:
        raise WrongValueError(wrong.help) from None


def _spelling(kind: Elementary | StringType) -> str:
    if isinstance(kind, StringType):
        return f"write a text of {kind.length} characters at most, in quotes if it looks a number"
    if isinstance(kind, Enumeration):
        return f"write one of {', '.join(name for name, _ in kind.members[:12])}"
    if kind.family is Family.BOOL:
        return "write true or false"
    if kind.family is Family.CHAR:
        return "write one character in quotes"
    if kind.family is Family.REAL:
        return "write a number, or .nan, .inf or -.inf"
    if wanted := LITERALS.get(kind.name):
        return f"write it as the PLC does, such as {wanted[1]}"
    based = f", also as 16#{kind.maximum:X}" if kind.family is Family.BITS else ""
    lowest, highest = kind.minimum, kind.maximum
    if isinstance(kind, Subrange):
        lowest, highest = kind.lowest, kind.highest
    return f"write a whole number from {lowest} to {highest}{based}"


def _name_a_part(program: Program, path: str, kind: Type) -> str:
    if isinstance(kind, ArrayType):
        indices = ", ".join(str(first) for first, _ in kind.bounds)
        return f"name one of its elements, such as {path}[{indices}]"
    if isinstance(kind, StructType):
        names = [field.name for field in kind.fields]
    elif isinstance(kind, AnyType):
        names = []
    else:
        assert isinstance(kind, BlockType)
        names = [variable.name for variable in program.block_of(kind.name).variables]
    return f"name one of its parts: {', '.join(names[:12])}{', ...' if len(names) > 12 else ''}"


def _show(kind: Type, found: Found) -> str:
    if isinstance(kind, Elementary) and isinstance(found, int) and not isinstance(found, bool):
        if isinstance(kind, Enumeration):
            name = kind.name_of(found)
            return f"{name} ({found})" if name else str(found)
        if kind.family is Family.BITS:
            return f"16#{found:0{kind.bits // 4}X} ({found})"
        if kind.family is Family.DURATION:
            return f"T#{found}ms" if kind is not LTIME else f"LT#{found}ns"
    return show(found)
