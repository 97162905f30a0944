"""What a name means as a value: variables, constants, lists of global variables, PROGRAMs."""

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import Variable, VariableKind
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.operands.foreign_names import is_library
from fbgen.lang.checker.symbols import Symbol
from fbgen.lang.types import ArrayType, BlockType, Elementary, StringType, StructType

_S7 = ("tia", "step7")
_DATA = (Elementary, StringType, ArrayType, StructType)


def find_symbol(ctx: Context, node: ast.Name) -> Symbol | None:
    """What a name means as a value; None if nothing has that name."""
    key = node.name.casefold()
    if node.local:
        return ctx.local(key)
    if node.outer:
        return ctx.of_program(key)
    if node.quoted:
        return ctx.of_program(key) or ctx.local(key)
    return (
        ctx.local(key)
        or ctx.of_owner(key)
        or ctx.of_program(key)
        or ctx.library.program_variable(node.name)
    )


def listed(ctx: Context, node: ast.Expression) -> Symbol | None:
    """The global variable or constant that `GVL.x` means; None if that can be something else."""
    if not isinstance(node, ast.Member) or not names_list(ctx, node.base):
        return None
    assert isinstance(node.base, ast.Name)
    key = ctx.library.lists.key_of(node.base.name, node.name)
    return None if key is None else ctx.of_program(key)


def names_list(ctx: Context, node: ast.Expression) -> bool:
    """True for the name of a list of global variables."""
    if not isinstance(node, ast.Name) or node.local or node.quoted:
        return False
    return ctx.library.lists.is_list(node.name) and find_symbol(ctx, node) is None


def without_library(ctx: Context, node: ast.Expression) -> ast.Expression:
    """`Tc2_Standard.x` as `x`: a name needs no library in front here."""
    if not isinstance(node, ast.Member) or not isinstance(node.base, ast.Name):
        return node
    if ctx.rules.dialect not in ("iec", "twincat") or not is_library(node.base.name):
        return node
    if ctx.library.lists.is_list(node.base.name) or find_symbol(ctx, node.base) is not None:
        return node
    return ast.Name(node.span, node.name)


def names_block(ctx: Context, node: ast.Name) -> bool:
    """True for a name in a call that means a block or an instruction, not a variable.

    The result variable of a FUNCTION has the name of the function; a name in quotes is global, also
    where a local variable has the same; on S7 data that cannot be called hides no block and no
    instruction: `TEST_DB.RESULT := TEST_DB(...)`.
    """
    if node.local:
        return False
    symbol = find_symbol(ctx, node)
    if symbol is None or (isinstance(symbol, Variable) and symbol.kind is VariableKind.RESULT):
        return True
    if ctx.rules.dialect in _S7 and not node.quoted and isinstance(symbol.type, _DATA):
        return True
    is_own = symbol is ctx.local(node.name.casefold())
    return node.quoted and is_own and ctx.library.user_block(node.name) is not None


def may_be_inherited(ctx: Context) -> bool:
    """True where an unknown name may be of a base that is in no file."""
    return ctx.library.objects.is_partial(ctx.owner or ctx.block)


def is_program(ctx: Context, kind: BlockType) -> bool:
    """True for the type of a PROGRAM: all of its variables can be seen from outside."""
    block = ctx.library.user_block(kind.name)
    return block is not None and block.kind is BlockKind.PROGRAM
