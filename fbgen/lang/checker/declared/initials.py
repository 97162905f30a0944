"""Initial values: scalars, lists with repetition, structures, and start values of data blocks.

An initial value is complete where it is given: what a structure leaves out has the default of its
type, and where a declaration overlays the initial value of its type, both are merged here.
Sources: IEC 61131-3 third edition, tables 11, 13 and 14; TIA Portal help, "Default values".
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.lang import ast
from fbgen.lang.checked import Constant, Convert, ReferenceTo
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.declared.start_values import OpenArray, OpenStruct, Started, closed
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.not_run import cannot_run
from fbgen.lang.checker.operands.pointers import has_addresses
from fbgen.lang.checker.types.coercion import coerce, spelled
from fbgen.lang.checker.types.constants import constant_of, whole_number
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.checker.types.stamps import stamp_initial
from fbgen.lang.types import (
    DTL,
    ArrayInitial,
    ArrayType,
    BlockType,
    Elementary,
    Initial,
    ReferenceType,
    StringType,
    StructInitial,
    StructType,
    Type,
)
from fbgen.nearest import nearest
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library


class Initials:
    """Checks initial values against the types they are for."""

    def __init__(self, library: "Library") -> None:
        self._library = library

    def check(
        self, ctx: Context, node: ast.Expression, kind: Type, base: Initial | None
    ) -> Initial | None:
        """The value of an initializer over `base`; `base` itself after reporting errors."""
        if isinstance(kind, StructType | BlockType) and kind != DTL:
            node = self._one_part(node, kind)
        else:
            node = _bare(node)
        if kind == ERRONEOUS or (isinstance(node, ast.StructLiteral) and not node.fields):
            return base  # `()` leaves what is there, as TIA writes it: (1, (), 3)
        if isinstance(kind, ArrayType):
            if isinstance(node, ast.ArrayLiteral):
                return self._array(ctx, node, kind, base)
            return self._shape(ctx, node.span, kind, base, "[value, value, ...]")
        if kind == DTL and not isinstance(node, ast.StructLiteral):
            return self._stamp(ctx, node, base)
        if isinstance(kind, StructType | BlockType):
            if isinstance(node, ast.StructLiteral):
                return self._structure(ctx, node, kind, base)
            return self._shape(ctx, node.span, kind, base, "(name := value, ...)")
        if isinstance(node, ast.ArrayLiteral | ast.StructLiteral):
            return self._shape(ctx, node.span, kind, base, "one value")
        if isinstance(kind, ReferenceType):
            found = coerce(ctx, check_expression(ctx, node, kind), kind, "this initial value")
            if isinstance(found, ReferenceTo) and found.place is not None and has_addresses(ctx):
                cannot_run(ctx, node.span, "an initial value that is no constant")
            elif isinstance(found, ReferenceTo) and found.place is not None:
                return self._shape(ctx, node.span, kind, base, "NULL, and bind it in the block")
            return base
        if not isinstance(kind, Elementary | StringType):
            return base
        if not has_addresses(ctx):
            value = constant_of(ctx, node, kind, "this initial value")
            return base if value is None else value
        found = coerce(ctx, check_expression(ctx, node, kind), kind, "this initial value")
        if isinstance(found, Constant) and found.type != ERRONEOUS:
            return found.value
        if found.type != ERRONEOUS:
            cannot_run(ctx, node.span, "an initial value that is no constant")
        return base

    def _stamp(self, ctx: Context, node: ast.Expression, base: Initial | None) -> Initial | None:
        """A DTL is written as one literal, too."""
        where = "this initial value"
        found = coerce(ctx, check_expression(ctx, node, DTL), DTL, where)
        if isinstance(found, Convert) and isinstance(found.operand, Constant):
            return stamp_initial(int(found.operand.value))
        if found.type != ERRONEOUS:
            return self._shape(ctx, node.span, DTL, base, "DTL#2024-02-29-23:59:59")
        return base

    def _shape(
        self, ctx: Context, span: Span, kind: Type, base: Initial | None, form: str
    ) -> Initial | None:
        ctx.findings.error(
            "FB4057",
            f"this is no initial value for {spelled(kind)}",
            span,
            f"write {form}",
        )
        return base

    def _array(
        self, ctx: Context, node: ast.ArrayLiteral, kind: ArrayType, base: Initial | None
    ) -> Initial | None:
        items: list[Initial | None] = []
        self._items(ctx, node.items, kind, items)
        if len(items) > kind.count:
            ctx.findings.error(
                "FB4057",
                f"{len(items)} values for an array of {kind.count}",
                node.span,
                "remove some values, or declare the array larger",
            )
            return None
        if isinstance(base, ArrayInitial):
            items += base.items[len(items) :]
        else:
            items += [None] * (kind.count - len(items))
        return ArrayInitial(tuple(items))

    def _items(
        self,
        ctx: Context,
        nodes: Sequence["ast.Repeated | ast.Expression"],
        kind: ArrayType,
        items: list[Initial | None],
    ) -> None:
        for node in nodes:
            if isinstance(node, ast.ArrayLiteral) and not isinstance(kind.element, ArrayType):
                self._items(ctx, node.items, kind, items)
            elif not isinstance(node, ast.Repeated):
                items.append(self.check(ctx, node, kind.element, None))
            else:
                self._repeated(ctx, node, kind, items)

    def _repeated(
        self, ctx: Context, node: ast.Repeated, kind: ArrayType, items: list[Initial | None]
    ) -> None:
        count = whole_number(ctx, node.count, "a repetition count")
        if count is None:
            return
        values: list[Initial | None] = [None]
        if node.value is not None:
            values = []
            value = node.value
            inner = value.items if isinstance(value, ast.ArrayLiteral) and value.bare else (value,)
            self._items(ctx, inner, kind, values)
        if not 0 <= count * len(values) <= kind.count:
            ctx.findings.error(
                "FB4057",
                f"{count * len(values)} values for an array of {kind.count}",
                node.span,
                "repeat as often as the array has elements left",
            )
            return
        items += values * count

    def _structure(
        self, ctx: Context, node: ast.StructLiteral, kind: Type, base: Initial | None
    ) -> Initial | None:
        parts = self._library.parts_of(kind)
        known = {name.casefold(): (name, part, initial) for name, part, initial in parts}
        named: dict[str, Initial] = dict(base.fields) if isinstance(base, StructInitial) else {}
        for position, field in enumerate(node.fields):
            if field.value is None:
                continue
            if field.kind is ast.ArgumentKind.POSITIONAL:
                if position >= len(parts):
                    ctx.findings.error(
                        "FB4057",
                        f"{spelled(kind)} has {len(parts)} parts only",
                        field.span,
                        "remove the values behind them",
                    )
                    break
                name, part, initial = parts[position]
            elif field.name.casefold() in known:
                name, part, initial = known[field.name.casefold()]
            elif self._library.is_incomplete(kind):
                continue
            else:
                ctx.findings.error(
                    "FB4005",
                    f"{kind.name} has no member '{field.name}'",
                    field.span,
                    nearest(field.name, (name for name, _, _ in parts)),
                )
                continue
            value = self.check(ctx, field.value, part, named.get(name, initial))
            if value is not None:
                named[name] = value
        return StructInitial(tuple(named.items()))

    def _one_part(self, node: ast.Expression, kind: Type) -> ast.Expression:
        """`(7)` is a structure with a value for its first part, `((1, 2))` too if that is one."""
        if not isinstance(node, ast.Parenthesized):
            return node
        parts = self._library.parts_of(kind)
        nested = bool(parts) and isinstance(parts[0][1], StructType | BlockType)
        if isinstance(_bare(node), ast.StructLiteral) and not nested:
            return _bare(node)
        part = ast.Argument(node.inner.span, ast.ArgumentKind.POSITIONAL, "", node.inner)
        return ast.StructLiteral(node.span, (part,))

    # --- start values of data blocks: one assignment for each part ---------------------------

    def assign(
        self, ctx: Context, nodes: Sequence[ast.Assignment], kind: Type, base: Initial | None
    ) -> Initial | None:
        """The initial value `base` of a data block with all start values set."""
        value: Started = base
        for node in nodes:
            path = _path(node.target)
            if path is None or node.operator != ":=":
                ctx.findings.error(
                    "FB4057",
                    "a data block's BEGIN part takes start values only",
                    node.span,
                    "write member := value;",
                )
            else:
                value = self._set(ctx, path, kind, value, node.value)
        return closed(value)

    def _part_of(self, kind: Type, name: str) -> tuple[str, Type, Initial | None] | None:
        """The part with this name, whatever its case, of what a structure or instance holds."""
        if isinstance(kind, StructType):
            field = kind.field(name)
            return None if field is None else (field.name, field.type, field.initial)
        key = name.casefold()
        return next(
            (part for part in self._library.parts_of(kind) if part[0].casefold() == key), None
        )

    def _set(
        self,
        ctx: Context,
        path: Sequence[ast.Name | ast.Member | ast.Index],
        kind: Type,
        base: Started,
        value: ast.Expression,
    ) -> Started:
        if not path:
            return self.check(ctx, value, kind, closed(base))
        if kind == ERRONEOUS:
            return base
        step = path[0]
        if isinstance(step, ast.Index):
            return self._set_element(ctx, path, kind, base, value)
        found = self._part_of(kind, step.name)
        if found is not None:
            name, part, initial = found
            changed = base if isinstance(base, OpenStruct) else OpenStruct(base)
            inner = self._set(ctx, path[1:], part, changed.named.get(name, initial), value)
            if inner is not None:
                changed.named[name] = inner
            return changed
        if self._library.is_incomplete(kind):
            return base
        ctx.findings.error(
            "FB4005",
            f"{spelled(kind)} has no member '{step.name}'",
            step.span,
            nearest(step.name, (name for name, _, _ in self._library.parts_of(kind))),
        )
        return base

    def _set_element(
        self,
        ctx: Context,
        path: Sequence[ast.Name | ast.Member | ast.Index],
        kind: Type,
        base: Started,
        value: ast.Expression,
    ) -> Started:
        step = path[0]
        assert isinstance(step, ast.Index)
        if not isinstance(kind, ArrayType) or len(step.indices) != len(kind.bounds):
            ctx.findings.error(
                "FB4019",
                f"{spelled(kind)} cannot be indexed like this",
                step.span,
                "give one index for each dimension of an array",
            )
            return base
        flat = 0
        for node, (first, last) in zip(step.indices, kind.bounds, strict=True):
            index = whole_number(ctx, node, "the index of a start value")
            if index is None:
                return base
            if not first <= index <= last:
                ctx.findings.error(
                    "FB4015",
                    f"index {index} is outside of the array's {first}..{last}",
                    node.span,
                    f"use an index from {first} to {last}, or declare the array larger",
                )
                return base
            flat = flat * (last - first + 1) + index - first
        changed = base if isinstance(base, OpenArray) else OpenArray(base, kind.count)
        inner = changed.items[flat]
        changed.items[flat] = self._set(ctx, path[1:], kind.element, inner, value)
        return changed


def _bare(node: ast.Expression) -> ast.Expression:
    """The value itself where parentheses stand around it."""
    while isinstance(node, ast.Parenthesized):
        node = node.inner
    return node


def _path(node: ast.Expression) -> list[ast.Name | ast.Member | ast.Index] | None:
    """The steps from the data block to the part that a start value names."""
    steps: list[ast.Name | ast.Member | ast.Index] = []
    while isinstance(node, ast.Member | ast.Index):
        steps.append(node)
        node = node.base
    if not isinstance(node, ast.Name):
        return None
    steps.append(node)
    steps.reverse()
    return steps
