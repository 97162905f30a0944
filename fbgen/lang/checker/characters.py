"""`text[i]`: one character of a text, counted from 1.

Reading is MID, behind the end character 0. Writing is REPLACE, and behind the end nothing happens:
the length of a text changes only as a whole.
Sources: TIA Portal help, "Addressing individual characters of a STRING or WSTRING"; IEC 61131-3
third edition, "single characters of strings".
"""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import Expression, Statement
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.literals import ERRONEOUS
from fbgen.lang.types import StringType, Type

_DIALECTS = ("tia", "step7", "iec")


def has_characters(ctx: Context, kind: Type, node: ast.Index) -> bool:
    """Whether the index selects a character; CODESYS counts bytes from 0, which is refused."""
    is_text = isinstance(kind, StringType) and len(node.indices) == 1
    return is_text and ctx.rules.dialect in _DIALECTS


def character(ctx: Context, node: ast.Index, kind: StringType) -> Expression:
    """The value of `text[i]`."""
    part = _call(node, "MID", node.base, _one(node), node.indices[0])
    return check_expression(ctx, _call(node, f"{_names(kind)[0]}_TO_{_names(kind)[1]}", part))


def written_character(ctx: Context, node: ast.Assignment) -> ast.If | Sequence[Statement] | None:
    """The statement that `text[i] := c` means; nothing if it is another target, or wrong."""
    target = node.target
    if not isinstance(target, ast.Index) or len(target.indices) != 1 or node.operator != ":=":
        return None
    kind = check_expression(ctx, target.base).type
    if kind == ERRONEOUS:
        check_expression(ctx, node.value)
        return ()
    if not isinstance(kind, StringType) or not has_characters(ctx, kind, target):
        return None
    text, single = _names(kind)
    index = target.indices[0]
    value = _call(target, f"{single}_TO_{text}", node.value)
    replaced = _call(target, "REPLACE", target.base, value, _one(target), index)
    inside = ast.Binary(
        index.span,
        "AND",
        ast.Binary(index.span, ">=", index, _one(target)),
        ast.Binary(index.span, "<=", index, _call(target, "LEN", target.base)),
    )
    write = ast.Assignment(node.span, target.base, ":=", replaced)
    return ast.If(node.span, (ast.Branch(node.span, inside, (write,)),), None)


def _names(kind: StringType) -> tuple[str, str]:
    return ("WSTRING", "WCHAR") if kind.wide else ("STRING", "CHAR")


def _one(node: ast.Index) -> ast.Literal:
    return ast.Literal(node.span, ast.LiteralKind.INTEGER, 1, "1")


def _call(node: ast.Index, function: str, *arguments: ast.Expression) -> ast.Call:
    return ast.Call(
        node.span,
        ast.Name(node.span, function),
        tuple(ast.Argument(one.span, ast.ArgumentKind.POSITIONAL, "", one) for one in arguments),
    )
