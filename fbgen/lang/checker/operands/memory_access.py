"""PEEK, POKE and absolute addresses with an index: places whose address the program works out.

Sources: TIA Portal help, "PEEK: Read memory address", "POKE: Write memory address", "POKE_BOOL";
STEP 7 SCL manual, "Indexed access to memory areas of the CPU" and "... to data blocks".
"""

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.lang.checked import Assignment, Constant, Expression, MemoryRef, Variable, VariableKind
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.name_lookup import find_symbol
from fbgen.lang.checker.operands.places import report_no_value, report_optimized
from fbgen.lang.checker.types.coercion import as_typed, coerce, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS, erroneous, is_untyped
from fbgen.lang.types import (
    BOOL,
    BYTE,
    DINT,
    DWORD,
    INT,
    LWORD,
    WORD,
    BlockType,
    Elementary,
    Family,
    StructType,
)
from fbgen.source import Span

INPUTS, OUTPUTS, MARKERS, DATA_BLOCK = 0x81, 0x82, 0x83, 0x84
_AREAS = {"I": INPUTS, "Q": OUTPUTS, "M": MARKERS}
_HARDWARE = {"I": 1, "Q": 2}
_SIZES = {"X": BOOL, "B": BYTE, "W": WORD, "D": DWORD, "L": LWORD}
_NUMBER_OF_BLOCK = ("word_to_block_db", "word_to_db_any", "uint_to_db_any")
_PARAMETERS = (("area", BYTE), ("dbNumber", DINT), ("byteOffset", DINT))


@dataclass(frozen=True, slots=True)
class Access:
    """PEEK or one of its kin; `type` None: that of the value written."""

    name: str
    type: Elementary | None
    writes: bool


_ACCESSES = {
    access.name.casefold(): access
    for access in (
        Access("PEEK", BYTE, writes=False),
        Access("PEEK_WORD", WORD, writes=False),
        Access("PEEK_DWORD", DWORD, writes=False),
        Access("PEEK_LWORD", LWORD, writes=False),
        Access("PEEK_BOOL", BOOL, writes=False),
        Access("POKE", None, writes=True),
        Access("POKE_BOOL", BOOL, writes=True),
    )
}


def memory_access_named(name: str) -> Access | None:
    """PEEK, POKE and their kin, whatever the case."""
    return _ACCESSES.get(name.casefold())


def check_peek(ctx: Context, node: ast.Call, access: Access) -> Expression:
    """The place that PEEK reads."""
    if access.writes:
        ctx.findings.error(
            "FB4048",
            f"{access.name} has no result",
            node.span,
            "write it as a statement of its own; PEEK reads",
        )
        return erroneous(node.span)
    arguments = _arguments(ctx, node, access)
    if arguments is None or access.type is None:
        return erroneous(node.span)
    return _place(ctx, node.span, arguments, access.type)


def check_poke(ctx: Context, node: ast.Call, access: Access) -> Assignment | None:
    """POKE as the assignment that it is."""
    arguments = _arguments(ctx, node, access)
    if arguments is None:
        return None
    value = arguments["value"]
    kind = access.type or value.type
    assert isinstance(kind, Elementary)
    return Assignment(node.span, _place(ctx, node.span, arguments, kind), value)


def _place(
    ctx: Context, span: Span, arguments: dict[str, Expression], kind: Elementary
) -> MemoryRef:
    area, number = arguments["area"], arguments["dbNumber"]
    if not isinstance(area, Constant) or area.value == DATA_BLOCK:
        use_block(ctx, number)
    bit = arguments.get("bitOffset")
    return MemoryRef(span, area, number, arguments["byteOffset"], bit, kind)


def use_block(ctx: Context, number: Expression) -> None:
    """The bytes of the data block with that number are used."""
    if isinstance(number, Constant):
        ctx.library.memory.address(int(number.value))
    else:
        ctx.library.memory.address_any()


def _arguments(ctx: Context, node: ast.Call, access: Access) -> dict[str, Expression] | None:
    parameters: list[tuple[str, Elementary | None]] = list(_PARAMETERS)
    if access.type == BOOL:
        parameters.append(("bitOffset", INT))
    if access.writes:
        parameters.append(("value", access.type))
    named = [(name, (name, kind)) for name, kind in parameters]
    bound = bind(ctx, node, access.name, named)
    if bound is None:
        return None
    found: dict[str, Expression] = {}
    for (name, kind), argument in bound:
        if argument.value is None:
            continue
        where = f"parameter {name} of {access.name}"
        if name == "area":
            value = _area_code(ctx, argument.value, where)
        elif kind is None:
            value = _poked(ctx, argument.value, where)
        elif kind in (DINT, INT):
            value = check_whole(ctx, argument.value, where)
        else:
            value = coerce(ctx, check_expression(ctx, argument.value, kind), kind, where)
        found[name] = value
    missing = [name for name, _ in parameters if name not in found]
    if missing:
        ctx.findings.error(
            "FB4040",
            f"the call of {access.name} does not give '{missing[0]}'",
            node.span,
            f"add {', '.join(f'{name} := ...' for name in missing)}",
        )
        return None
    return None if any(value.type == ERRONEOUS for value in found.values()) else found


def _area_code(ctx: Context, node: ast.Expression, where: str) -> Expression:
    value = coerce(ctx, check_expression(ctx, node, BYTE), BYTE, where)
    known = (1, 2, INPUTS, OUTPUTS, MARKERS, DATA_BLOCK)
    if isinstance(value, Constant) and value.type != ERRONEOUS and value.value not in known:
        ctx.findings.error(
            "FB4072",
            f"there is no memory area 16#{int(value.value):02X}",
            node.span,
            "16#81 inputs, 16#82 outputs, 16#83 bit memory, 16#84 data block, 1 and 2 hardware",
        )
        return erroneous(node.span)
    return value


def _poked(ctx: Context, node: ast.Expression, where: str) -> Expression:
    value = check_expression(ctx, node)
    if value.type == ERRONEOUS:
        return value
    if is_untyped(value.type) or not isinstance(value.type, Elementary) or value.type == BOOL:
        ctx.findings.error(
            "FB4010",
            f"{where} takes a BYTE, WORD, DWORD or LWORD, not {spelled(value.type)}",
            node.span,
            "say how wide the value is: WORD#16#1234; for a single bit use POKE_BOOL",
        )
        return erroneous(node.span)
    return value


def check_whole(ctx: Context, node: ast.Expression, where: str) -> Expression:
    """A whole number of any type, as it is."""
    value = as_typed(check_expression(ctx, node))
    kind = value.type
    if kind == ERRONEOUS:
        return value
    bits = isinstance(kind, Elementary) and kind.family is Family.BITS
    if not isinstance(kind, Elementary) or not (kind.is_integer or bits):
        ctx.findings.error(
            "FB4010",
            f"{where} is a whole number, not {spelled(kind)}",
            node.span,
            "use a variable of type INT or DINT, or convert it",
        )
        return erroneous(node.span)
    return value


# --- addresses with an index --------------------------------------------------------------------


def check_indexed_address(
    ctx: Context, node: ast.IndexedAddress, _expected: object = None
) -> Expression:
    """`MW[i]`, `DB100.DW[i]`, `"values".DX[i, j]`, `WORD_TO_BLOCK_DB(w).DW[i]`."""
    kind = _SIZES.get(node.size)
    if kind is None:
        report_no_value(ctx, node.span, node.area)
        return erroneous(node.span)
    wanted = 2 if kind == BOOL else 1
    indices = [check_whole(ctx, index, "an absolute address") for index in node.indices]
    if len(indices) != wanted:
        ctx.findings.error(
            "FB4019",
            f"this address takes {wanted} {'indices' if wanted > 1 else 'index'},"
            f" not {len(indices)}",
            node.span,
            "give byte and bit: MX[i, j]" if kind == BOOL else "give the byte: MW[i]",
        )
        return erroneous(node.span)
    number: Expression | None = None
    if node.base is not None:
        number = block_number(ctx, node.base)
        if number.type != ERRONEOUS:
            use_block(ctx, number)
        area = DATA_BLOCK
    else:
        area = _HARDWARE[node.area] if node.peripheral else _AREAS[node.area]
    if any(one.type == ERRONEOUS for one in (*indices, number) if one is not None):
        return erroneous(node.span)
    bit = indices[1] if kind == BOOL else None
    return MemoryRef(node.span, Constant(node.span, area, BYTE), number, indices[0], bit, kind)


def block_number(ctx: Context, base: ast.Expression) -> Expression:
    """The number of the data block in front of the dot."""
    if isinstance(base, ast.Call) and isinstance(base.callee, ast.Name):
        argument = base.arguments[0].value if len(base.arguments) == 1 else None
        if base.callee.name.casefold() in _NUMBER_OF_BLOCK and argument is not None:
            return check_whole(ctx, argument, "the number of a data block")
    if isinstance(base, ast.Name):
        symbol = find_symbol(ctx, base)
        if isinstance(symbol, Variable) and symbol.kind is VariableKind.GLOBAL:
            return _number_of(ctx, base, symbol)
        key = base.name.casefold()
        if symbol is None and key.startswith("db") and key[2:].isdecimal():
            return Constant(base.span, int(key[2:]), DINT)
    return check_whole(ctx, base, "the number of a data block")


def _number_of(ctx: Context, base: ast.Name, symbol: Variable) -> Expression:
    ctx.used.add(symbol)
    if not isinstance(symbol.type, StructType | BlockType):
        return check_whole(ctx, base, "the number of a data block")
    if symbol in ctx.library.memory.optimized:
        report_optimized(ctx, base.span, symbol)
        return erroneous(base.span)
    return Constant(base.span, ctx.library.memory.number_of(symbol), DINT)
