"""__POUNAME() and __POSITION(): the texts that they stand for.

The name is that of the program, function or block around, with a method behind it as `FB.Do` and
an accessor of a property as `FB.Speed.Get`; in a list of globals or a structure it is that one's.
The position is the line, and in statements the column, of the text as it was read.
Sources: CODESYS online help, "Operator: __POUNAME", "Operator: __POSITION"; TwinCAT 3 help, the
same.
"""

from collections.abc import Sequence
from typing import ClassVar

from fbgen.lang import ast
from fbgen.lang.rewriting import Rewriter, Rule

_NAME = "__POUNAME"
_POSITION = "__POSITION"


def with_own_names(files: Sequence[ast.File]) -> Sequence[ast.File]:
    """The program with texts in the place of the two operators."""
    return [_written(file) if _names_itself(file) else file for file in files]


def _names_itself(file: ast.File) -> bool:
    if file.dialect != "twincat":
        return False
    text = file.source.text.upper()
    return _NAME in text or _POSITION in text


def _written(file: ast.File) -> ast.File:
    units = tuple(_Writing(_name(unit)).rewrite(unit) for unit in file.units)
    return ast.File(file.source, file.dialect, units, file.closing)


def _name(unit: ast.Unit) -> str:
    name = getattr(unit, "name", "")
    return name.name if isinstance(name, ast.Name) else str(name)


class _Writing(Rewriter):
    def __init__(self, name: str) -> None:
        self._path = [name]
        self._declares = False

    def _inside(self, node: ast.Method | ast.Property) -> ast.Method | ast.Property:
        self._path.append(node.name.name)
        written = self.inside(node)
        self._path.pop()
        return written

    def _accessor(self, node: ast.Accessor) -> ast.Accessor:
        self._path.append(node.keyword.capitalize())
        written = self.inside(node)
        self._path.pop()
        return written

    def _declaration(self, node: ast.Declaration) -> ast.Declaration:
        self._declares = True
        written = self.inside(node)
        self._declares = False
        return written

    def _call(self, node: ast.Call) -> ast.Expression:
        callee = node.callee
        if not isinstance(callee, ast.Name) or node.arguments:
            return self.inside(node)
        word = callee.name.upper()
        if word not in (_NAME, _POSITION):
            return node
        text = ".".join(self._path)
        if word == _POSITION:
            place = "(Decl)" if self._declares else f"Column {node.span.column} (Impl)"
            text = f"Line {node.span.line}{' ' if self._declares else ', '}{place}"
        return ast.Literal(node.span, ast.LiteralKind.STRING, text, f"'{text}'")

    rules: ClassVar[dict[type, Rule]] = {
        ast.Method: _inside,
        ast.Property: _inside,
        ast.Accessor: _accessor,
        ast.Declaration: _declaration,
        ast.Call: _call,
    }
