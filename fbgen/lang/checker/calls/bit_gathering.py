"""SCATTER, GATHER and their likes for blocks: bits of words as BOOLs of their own, and back.

They become assignments of slices, one for each bit; those for blocks a loop with these inside.
Source: TIA Portal help, "SCATTER", "SCATTER_BLK", "GATHER" and "GATHER_BLK".
"""

from collections.abc import Sequence

from fbgen.lang import ast
from fbgen.lang.checked import (
    Assignment,
    Binary,
    Constant,
    Convert,
    Expression,
    FieldRef,
    For,
    IndexRef,
    Place,
    SliceRef,
    Statement,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checker.calls.arguments import bind
from fbgen.lang.checker.calls.binding import report_missing
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.evaluation import check_expression
from fbgen.lang.checker.operands.memory_access import check_whole
from fbgen.lang.checker.statements.targets import check_target
from fbgen.lang.checker.types.coercion import as_typed, spelled
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import BOOL, DINT, ArrayType, Elementary, Family, StructType
from fbgen.source import Span

BIT_MOVES = {
    "SCATTER": ("IN", "OUT"),
    "GATHER": ("IN", "OUT"),
    "SCATTER_BLK": ("IN", "COUNT_IN", "OUT"),
    "GATHER_BLK": ("IN", "COUNT_OUT", "OUT"),
}
"""Their parameters."""


def is_bit_move(ctx: Context, name: str) -> bool:
    """True for the names of the four."""
    return ctx.rules.dialect == "tia" and name.upper() in BIT_MOVES


def bit_move(ctx: Context, node: ast.Call, name: str) -> Sequence[Statement]:
    """The call; nothing after reporting errors."""
    key = name.upper()
    given = _arguments(ctx, node, key)
    if given is None:
        return ()
    source = as_typed(check_expression(ctx, given["IN"]))
    target = check_target(ctx, given["OUT"], f"parameter OUT of {key}")
    if target is None or source.type == ERRONEOUS:
        return ()
    move = _Move(ctx, node.span, key)
    if not key.endswith("_BLK"):
        return move.single(source, target)
    count = check_whole(ctx, given[BIT_MOVES[key][1]], f"parameter {BIT_MOVES[key][1]} of {key}")
    return () if count.type == ERRONEOUS else move.block(source, count, target)


def _arguments(ctx: Context, node: ast.Call, key: str) -> dict[str, ast.Expression] | None:
    wanted = BIT_MOVES[key]
    bound = bind(ctx, node, key, [(one, one) for one in wanted])
    if bound is None:
        return None
    given: dict[str, ast.Expression] = {}
    for parameter, argument in bound:
        kind, is_output = argument.kind, parameter == "OUT"
        named = kind is not ast.ArgumentKind.POSITIONAL
        if named and is_output != (kind is ast.ArgumentKind.OUTPUT):
            ctx.findings.error(
                "FB4041",
                f"'{parameter}' of {key} is given by {kind.value}",
                argument.span,
                f"write {parameter} {'=>' if is_output else ':='} ...",
            )
            return None
        if argument.value is not None:
            given[parameter] = argument.value
    missing = [one for one in wanted if one not in given]
    if missing:
        report_missing(ctx, node, key, missing)
        return None
    return given


def _bits_of(place: Place) -> list[Place] | None:
    """The BOOLs of an array or a structure; None if it has anything else."""
    kind = place.type
    if isinstance(kind, ArrayType) and kind.element == BOOL and len(kind.bounds) == 1:
        first, last = kind.bounds[0]
        return [
            IndexRef(place.span, place, (Constant(place.span, index, DINT),), BOOL)
            for index in range(first, last + 1)
        ]
    if isinstance(kind, StructType) and all(field.type == BOOL for field in kind.fields):
        return [FieldRef(place.span, place, field.name, BOOL) for field in kind.fields]
    return None


class _Move:
    """Writes the statements of one call."""

    __slots__ = ("_ctx", "_key", "_scatters", "_span")

    def __init__(self, ctx: Context, span: Span, key: str) -> None:
        self._ctx = ctx
        self._span = span
        self._key = key
        self._scatters = key.startswith("SCATTER")

    # --- one word -------------------------------------------------------------------------------

    def single(self, source: Expression, target: Place) -> Sequence[Statement]:
        """SCATTER and GATHER."""
        word, bools = (source, target) if self._scatters else (target, source)
        kind = self._word(word)
        bits = _bits_of(bools) if isinstance(bools, Place) else None
        if kind is None:
            return ()
        if bits is None or len(bits) != kind.bits:
            self._refuse(
                bools,
                f"{'OUT' if self._scatters else 'IN'} of {self._key} takes {kind.bits} BOOLs,"
                f" not {spelled(bools.type)}",
                "give an array of BOOL with one dimension, or a structure of BOOLs, of that size",
            )
            return ()
        held = self._temporary(kind)
        parts = [SliceRef(self._span, held, number, BOOL) for number in range(kind.bits)]
        if self._scatters:
            shown = zip(bits, parts, strict=True)
            return [
                Assignment(self._span, held, source),
                *(Assignment(self._span, bit, part) for bit, part in shown),
            ]
        return [
            *(Assignment(self._span, part, bit) for bit, part in zip(bits, parts, strict=True)),
            Assignment(self._span, target, held),
        ]

    # --- several words --------------------------------------------------------------------------

    def block(self, source: Expression, count: Expression, target: Place) -> Sequence[Statement]:
        """SCATTER_BLK and GATHER_BLK, from one element on."""
        word, bools = (source, target) if self._scatters else (target, source)
        kind = self._word(word)
        if kind is None:
            return ()
        for place in (word, bools):
            if not isinstance(place, IndexRef) or len(place.indices) > 1:
                self._refuse(
                    place,
                    f"{self._key} works on elements of arrays, and this is none",
                    "give the first element that is meant: bits[0]",
                )
                return ()
        assert isinstance(word, IndexRef)
        assert isinstance(bools, IndexRef)
        if bools.type != BOOL:
            self._refuse(
                bools,
                f"{self._key} takes bits as an array of BOOL, not of {spelled(bools.type)}",
                "declare an ARRAY OF BOOL",
            )
            return ()
        passed, held = self._temporary(DINT), self._temporary(kind)
        first_word, first_bit = self._temporary(DINT), self._temporary(DINT)
        words = IndexRef(word.span, word.base, (self._sum(first_word, passed),), kind)
        begin = self._sum(first_bit, self._times(passed, kind.bits))
        bits = [
            IndexRef(bools.span, bools.base, (self._sum(begin, self._number(number)),), BOOL)
            for number in range(kind.bits)
        ]
        parts = [SliceRef(self._span, held, number, BOOL) for number in range(kind.bits)]
        body: list[Statement] = [
            Assignment(self._span, *((bit, part) if self._scatters else (part, bit)))
            for bit, part in zip(bits, parts, strict=True)
        ]
        if self._scatters:
            body.insert(0, Assignment(self._span, held, words))
        else:
            body.append(Assignment(self._span, words, held))
        last = Binary(self._span, "-", self._long(count), self._number(1), DINT)
        return [
            Assignment(self._span, first_word, self._long(word.indices[0])),
            Assignment(self._span, first_bit, self._long(bools.indices[0])),
            For(self._span, passed, self._number(0), last, self._number(1), tuple(body)),
        ]

    # --- pieces ---------------------------------------------------------------------------------

    def _word(self, word: Expression) -> Elementary | None:
        kind = word.type
        if isinstance(kind, Elementary) and kind.family is Family.BITS:
            return kind
        self._refuse(
            word,
            f"{'IN' if self._scatters else 'OUT'} of {self._key} takes BYTE, WORD, DWORD or LWORD,"
            f" not {spelled(kind)}",
            "use a variable of such a type",
        )
        return None

    def _refuse(self, node: Expression, message: str, help_text: str) -> None:
        self._ctx.findings.error("FB4075", message, node.span, help_text)

    def _temporary(self, kind: Elementary) -> VariableRef:
        name = f"bits{len(self._ctx.temporaries) + 1}"
        variable = Variable(self._span, name, VariableKind.TEMP, kind)
        self._ctx.temporaries.append(variable)
        return VariableRef(self._span, variable, kind)

    def _number(self, value: int) -> Constant:
        return Constant(self._span, value, DINT)

    def _sum(self, left: Expression, right: Expression) -> Expression:
        return Binary(self._span, "+", left, right, DINT)

    def _times(self, left: Expression, factor: int) -> Expression:
        return Binary(self._span, "*", left, self._number(factor), DINT)

    def _long(self, value: Expression) -> Expression:
        if isinstance(value, Constant):
            return Constant(value.span, value.value, DINT)
        return value if value.type == DINT else Convert(value.span, value, DINT, implicit=True)
