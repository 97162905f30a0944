"""`text[i]`: one character of a text.

On S7 and in the standard it is a CHAR and counted from 1, and writing behind the end does nothing:
the length of a text changes only as a whole. CODESYS and TwinCAT count from 0 and take a byte of
memory (of a WSTRING a word): 0 ends the text there, and a byte in the place of the end makes the
text longer.
Reading is MID, behind the end it gives character 0.
Sources: TIA Portal help, "Addressing individual characters of a STRING or WSTRING"; IEC 61131-3
third edition, "single characters of strings"; CODESYS online help, "STRING".
"""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import Expression, Statement
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import StringType, Type


def has_characters(kind: Type, node: ast.Index) -> bool:
    """Whether the index selects a character."""
    return isinstance(kind, StringType) and len(node.indices) == 1


def character(ctx: Context, node: ast.Index, kind: StringType) -> Expression:
    """The value of `text[i]`."""
    if ctx.rules.dialect == "twincat":
        single, memory = _names(kind)[1], "WORD" if kind.wide else "BYTE"
        part = _call(node, "MID", node.base, _number(node, 1), _sum(_place(node), 1))
        byte = _call(
            node, f"{single}_TO_{memory}", _call(node, f"{_names(kind)[0]}_TO_{single}", part)
        )
        return check_expression(ctx, byte)
    part = _call(node, "MID", node.base, _number(node, 1), node.indices[0])
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
    if not isinstance(kind, StringType) or not has_characters(kind, target):
        return None
    if ctx.rules.dialect == "twincat":
        return _written_byte(node, target, kind)
    text, single = _names(kind)
    index = target.indices[0]
    value = _call(target, f"{single}_TO_{text}", node.value)
    replaced = _call(target, "REPLACE", target.base, value, _number(target, 1), index)
    inside = ast.Binary(
        index.span,
        "AND",
        ast.Binary(index.span, ">=", index, _number(target, 1)),
        ast.Binary(index.span, "<=", index, _call(target, "LEN", target.base)),
    )
    write = ast.Assignment(node.span, target.base, ":=", replaced)
    return ast.If(node.span, (ast.Branch(node.span, inside, (write,)),), None)


def _written_byte(node: ast.Assignment, target: ast.Index, kind: StringType) -> ast.If:
    """`text[i] := b` of CODESYS: 0 ends the text, and a byte behind its end makes it longer."""
    text, single = _names(kind)
    span, base = node.span, target.base
    place = _place(target)
    length = _call(target, "LEN", base)
    memory = _call(target, "TO_WORD" if kind.wide else "TO_BYTE", node.value)
    value = _call(
        target,
        f"{single}_TO_{text}",
        _call(target, f"{'WORD' if kind.wide else 'BYTE'}_TO_{single}", memory),
    )
    inside = ast.Binary(
        span,
        "AND",
        ast.Binary(span, ">=", place, _number(target, 0)),
        ast.Binary(span, "<", place, length),
    )
    is_end = ast.Binary(span, "=", memory, _number(target, 0))
    behind = ast.Binary(
        span,
        "AND",
        ast.Binary(span, "=", place, length),
        ast.Binary(span, "<>", memory, _number(target, 0)),
    )
    replaced = _call(target, "REPLACE", base, value, _number(target, 1), _sum(place, 1))

    def branch(condition: ast.Expression, result: ast.Expression) -> ast.Branch:
        return ast.Branch(span, condition, (ast.Assignment(span, base, ":=", result),))

    return ast.If(
        span,
        (
            branch(ast.Binary(span, "AND", inside, is_end), _call(target, "LEFT", base, place)),
            branch(inside, replaced),
            branch(behind, _call(target, "CONCAT", base, value)),
        ),
        None,
    )


def _place(node: ast.Index) -> ast.Expression:
    """The index as the INT that text functions take."""
    return _call(node, "TO_INT", node.indices[0])


def _sum(left: ast.Expression, number: int) -> ast.Binary:
    literal = ast.Literal(left.span, ast.LiteralKind.INTEGER, number, str(number))
    return ast.Binary(left.span, "+", left, literal)


def _names(kind: StringType) -> tuple[str, str]:
    return ("WSTRING", "WCHAR") if kind.wide else ("STRING", "CHAR")


def _number(node: ast.Index, value: int) -> ast.Literal:
    return ast.Literal(node.span, ast.LiteralKind.INTEGER, value, str(value))


def _call(node: ast.Index, function: str, *arguments: ast.Expression) -> ast.Call:
    return ast.Call(
        node.span,
        ast.Name(node.span, function),
        tuple(ast.Argument(one.span, ast.ArgumentKind.POSITIONAL, "", one) for one in arguments),
    )
