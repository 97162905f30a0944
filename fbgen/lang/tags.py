"""What a project has besides its sources: PLC tags and user constants, as global variables.

TIA Portal and STEP 7 keep both in tables. Here they become VAR_GLOBAL sections, so that whatever
works on sources works on them.
"""

import re
from collections.abc import Mapping, Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import error
from fbgen.lang import ast
from fbgen.lang.literals import BadLiteralError, read_literal
from fbgen.lang.parser.addresses import read_address
from fbgen.lang.types import StringType
from fbgen.source import Source, Span

ConstantValue = bool | int | float | str
"""A constant from outside: a Python value, or a text as in PLC text: `T#5s`, `16#FF`, `'on'`."""

_TYPES_OF_KINDS = {
    ast.LiteralKind.BOOL: "BOOL",
    ast.LiteralKind.REAL: "REAL",
    ast.LiteralKind.DURATION: "TIME",
    ast.LiteralKind.DATE: "DATE",
    ast.LiteralKind.TIME_OF_DAY: "TIME_OF_DAY",
    ast.LiteralKind.DATE_AND_TIME: "DATE_AND_TIME",
}
_NUMBERED = re.compile(r"%?([TCZ]) *([0-9]+)", re.IGNORECASE)
"""The address of a timer or counter."""
_INTEGERS = (("INT", 15), ("DINT", 31), ("LINT", 63))


@dataclass(frozen=True, slots=True)
class Tag:
    """A variable of the tag table. `address` as in `%I0.3`; "" for none. `span` is its place."""

    name: str
    type: str
    address: str = ""
    span: Span | None = None


@dataclass(frozen=True, slots=True)
class TagConstant:
    """A user constant of the tag table; `type` "" takes that of the value."""

    name: str
    value: str
    type: str = ""
    span: Span | None = None


def as_file(
    tags: Sequence[Tag], constants: Sequence[TagConstant], dialect: str, name: str = "tags"
) -> ast.File:
    """The tags and constants as sections of global variables.

    Raises DiagnosticError FB3060 for an address or a value that is none.
    """
    source = Source(name, "")
    nowhere = Span(source, 0, 0)
    units: list[ast.Unit] = []
    numbers = [_NUMBERED.fullmatch(one.address) for one in tags]
    numbered = tuple(
        _number(tag, match, nowhere) for tag, match in zip(tags, numbers, strict=True) if match
    )
    for qualifiers, declarations in (
        (("CONSTANT",), (*(_constant(one, nowhere) for one in constants), *numbered)),
        (
            (),
            tuple(
                _variable(tag, nowhere)
                for tag, match in zip(tags, numbers, strict=True)
                if match is None
            ),
        ),
    ):
        if declarations:
            section = ast.VarSection(nowhere, "VAR_GLOBAL", qualifiers, declarations)
            units.append(ast.Globals(nowhere, section))
    return ast.File(source, dialect, tuple(units))


def constants_of(values: Mapping[str, ConstantValue]) -> list[TagConstant]:
    """Constants given as Python values."""
    found = []
    for name, value in values.items():
        if isinstance(value, bool):
            text = "TRUE" if value else "FALSE"
        else:
            text = repr(value) if isinstance(value, int | float) else value
        source = Source(f"constant {name}", text)
        found.append(TagConstant(name, text, span=Span(source, 0, len(text))))
    return found


def _number(tag: Tag, match: re.Match[str], nowhere: Span) -> ast.Declaration:
    """A timer or counter is its number, which is all that a program does with it."""
    span = tag.span or nowhere
    kind = "TIMER" if match[1].upper() == "T" else "COUNTER"
    number = ast.Literal(span, ast.LiteralKind.INTEGER, int(match[2]), match[2])
    return _declaration(tag.name, kind, number, None, span)


def _variable(tag: Tag, nowhere: Span) -> ast.Declaration:
    span = tag.span or nowhere
    at = None
    if tag.address:
        text = tag.address if tag.address.startswith("%") else f"%{tag.address}"
        at = read_address(text.replace(" ", ""), span)
        if at is None:
            raise error(
                "FB3060",
                f"tag '{tag.name}' has the address '{tag.address}', which is none",
                span,
                "addresses look like %I0.3, %QW4 or %MD20",
            )
    return _declaration(tag.name, tag.type, None, at, span)


def _constant(constant: TagConstant, nowhere: Span) -> ast.Declaration:
    span = constant.span or nowhere
    text = constant.value.strip()
    negative = text.startswith("-")
    try:
        meaning = read_literal(text.removeprefix("-") or "?")
    except (BadLiteralError, ValueError) as problem:
        raise error(
            "FB3060",
            f"constant '{constant.name}' has the value '{text}', which is none",
            span,
            getattr(problem, "help", "") or "write it as in PLC text: 8, 16#FF, T#5s, 'text'",
        ) from None
    literal: ast.Expression = ast.Literal(
        span, meaning.kind, meaning.value, text, meaning.type_name, meaning.base
    )
    if negative:
        literal = ast.Unary(span, "-", literal)
    kind = constant.type or meaning.type_name or _TYPES_OF_KINDS.get(meaning.kind, "")
    if not kind and isinstance(meaning.value, str):
        wide = meaning.kind is ast.LiteralKind.WSTRING
        kind = StringType(wide=wide).name.partition("[")[0]
    if not kind:
        bits = int(meaning.value).bit_length()
        kind = next((name for name, most in _INTEGERS if bits <= most), "ULINT")
    return _declaration(constant.name, kind, literal, None, span)


def _declaration(
    name: str,
    kind: str,
    initial: ast.Expression | None,
    at: ast.DirectAddress | None,
    span: Span,
) -> ast.Declaration:
    plain = kind.strip()
    quoted = len(plain) > 1 and plain[0] == plain[-1] == '"'
    named: ast.TypeSpec = ast.NamedType(span, plain.strip('"'), quoted)
    if plain.upper() in ("STRING", "WSTRING"):
        named = ast.StringSpec(span, plain.upper() == "WSTRING", None)
    return ast.Declaration(span, (ast.DeclaredName(span, name, quoted=True),), named, initial, at)
