"""Printing and reading again gives the same expression, whatever tree it is."""

import sys
from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from fbgen.lang import ast
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.parser import parse
from fbgen.lang.printer.expressions import ExpressionPrinter
from fbgen.source import Source, Span

sys.path.insert(0, str(Path(__file__).parent.parent / "unit" / "lang"))
from trees import shape

_PLACE = Span(Source("built", ""), 0, 0)
_OPERATORS = ["OR", "XOR", "AND", "=", "<>", "<", ">=", "+", "-", "*", "/", "MOD", "**"]
_LEAVES = st.one_of(
    st.sampled_from(["a", "bc"]).map(lambda name: ast.Name(_PLACE, name)),
    st.integers(0, 99).map(
        lambda number: ast.Literal(_PLACE, ast.LiteralKind.INTEGER, number, str(number))
    ),
)


def _grow(inner: st.SearchStrategy[ast.Expression]) -> st.SearchStrategy[ast.Expression]:
    arguments = st.lists(
        inner.map(lambda value: ast.Argument(_PLACE, ast.ArgumentKind.POSITIONAL, "", value)),
        max_size=3,
    )
    return st.one_of(
        st.builds(
            lambda operator, left, right: ast.Binary(_PLACE, operator, left, right),
            st.sampled_from(_OPERATORS),
            inner,
            inner,
        ),
        st.builds(
            lambda operator, operand: ast.Unary(_PLACE, operator, operand),
            st.sampled_from(["NOT", "-"]),
            inner,
        ),
        inner.map(lambda value: ast.Index(_PLACE, ast.Name(_PLACE, "r"), (value,))),
        arguments.map(lambda found: ast.Call(_PLACE, ast.Name(_PLACE, "f"), tuple(found))),
    )


_TREES = st.recursive(_LEAVES, _grow, max_leaves=12)


def _bare(node: object) -> object:
    """A shape without parentheses, which printing may have added."""
    if isinstance(node, tuple):
        if node and node[0] == "Parenthesized":
            return _bare(dict(node[1:])["inner"])
        return tuple(_bare(item) for item in node)
    return node


@given(_TREES, st.sampled_from(sorted(DIALECTS)))
def test_a_printed_expression_reads_as_the_same_tree(tree: ast.Expression, dialect: str) -> None:
    text = ExpressionPrinter(DIALECTS[dialect]).expression(tree)
    kind = "FUNCTION_BLOCK"
    file = parse(Source("x", f"{kind} b\nx := {text};\nEND_{kind}\n"), dialect)
    (block,) = file.units
    assert isinstance(block, ast.Block)
    (statement,) = block.body
    assert isinstance(statement, ast.Assignment)
    assert _bare(shape(statement.value)) == _bare(shape(tree))
