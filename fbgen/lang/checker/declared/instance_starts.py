"""FB_init: what runs once when an instance is made, with the arguments of its declaration.

For each block that has instances with an FB_init inside, a FUNCTION is written that calls them all,
inner instances before outer ones, in the order of their declarations. FB_init of a base block runs
before that of the block that extends it. `bInitRetains` is TRUE but for a warm start,
`bInCopyCode` FALSE, because no program is changed while it runs.
Sources: CODESYS online help and Beckhoff Infosys, "Methods FB_init, FB_reinit and FB_exit".
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from typing import TYPE_CHECKING, TypeAlias

from fbgen.lang import ast
from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    Block,
    Constant,
    Evaluate,
    Expression,
    FieldRef,
    For,
    FunctionCall,
    IndexRef,
    Place,
    Statement,
    Stop,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.checked.variables import IN_GLOBALS, RECEIVER
from fbgen.lang.checker.calls.binding import bind_variables, report_missing
from fbgen.lang.checker.context import Context
from fbgen.lang.checker.symbols import Scope
from fbgen.lang.checker.types.literals import ERRONEOUS
from fbgen.lang.types import (
    BOOL,
    DINT,
    VOID,
    ArrayType,
    BlockType,
    Elementary,
    StringType,
    StructType,
    Type,
)
from fbgen.source import Source, Span

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

FB_INIT = "fb_init"
_RETAINS, _COPIES = "binitretains", "bincopycode"
_OWNERS = (BlockKind.FUNCTION_BLOCK, BlockKind.PROGRAM)
_NOWHERE = Span(Source("arguments of FB_init", ""), 0, 0)
_Given: TypeAlias = tuple[ast.Argument, ...]
_ARGUMENT_PLACES = (VariableKind.STATIC, VariableKind.GLOBAL)


class InstanceStarts:
    """Writes the functions that start the instances inside of blocks."""

    def __init__(self, library: "Library") -> None:
        self._library = library
        self._arguments: dict[Variable, tuple[Span, tuple[ast.Argument, ...]]] = {}
        self._each: dict[Variable, list[_Given]] = {}
        self._needed: dict[str, bool] = {}
        self.bodies: dict[Block, tuple[Statement, ...]] = {}
        self.functions: dict[str, Block] = {}
        """By the casefolded name of the block whose instances they start; see IN_GLOBALS."""

    def declare(self, variable: Variable, declaration: ast.Declaration) -> None:
        """Keep the arguments that a declaration has for FB_init."""
        if not declaration.arguments:
            return
        first = declaration.arguments[0]
        if isinstance(first.value, ast.ArrayLiteral):
            self._each[variable] = list(element_arguments(first.value))
        self._arguments[variable] = (first.span, declaration.arguments)

    def chain(self, block: Block) -> tuple[Block, ...]:
        """The FB_init of a block and its bases, in the order in which they run."""
        found: list[Block] = []
        step: Block | None = block
        while step is not None:
            method = self._library.objects.members_of(step).methods.get(FB_INIT)
            if method is not None and method.owner is step:
                found.insert(0, method.block)
            step = self._library.objects.base_of(step)
        return tuple(found)

    def write(self) -> None:
        """Write all functions that are needed, and report arguments that nobody takes."""
        library = self._library
        if not library.has_members and not self._arguments:
            return
        for block in library.own_blocks():
            if block.kind in _OWNERS:
                self._function(block)
        self._of_globals()
        for variable, (place, _) in self._arguments.items():
            kind = _element(variable.type)
            if kind == ERRONEOUS:
                continue
            known = library.user_block(kind.name) if isinstance(kind, BlockType) else None
            if known is None or not self.chain(known) or variable.kind not in _ARGUMENT_PLACES:
                library.findings.error(
                    "FB4042",
                    f"{kind.name} has no FB_init that could take arguments here",
                    place,
                    "remove them, or write METHOD FB_init in the function block",
                )

    def needs(self, kind: Type) -> bool:
        """True for an instance that has something to run, and for what has such a one inside."""
        if isinstance(kind, ArrayType):
            return self.needs(kind.element)
        if isinstance(kind, StructType):
            return any(self.needs(part.type) for part in kind.fields)
        if not isinstance(kind, BlockType):
            return False
        key = kind.name.casefold()
        if key not in self._needed:
            self._needed[key] = False  # what contains itself has been reported
            block = self._library.user_block(kind.name)
            self._needed[key] = block is not None and (
                bool(self.chain(block)) or self._has_inside(block)
            )
        return self._needed[key]

    def _has_inside(self, block: Block) -> bool:
        return any(
            one.kind is VariableKind.STATIC and self.needs(one.type) for one in block.variables
        )

    def _function(self, owner: Block) -> None:
        if not self._has_inside(owner):
            return
        if owner.name.casefold() in self.functions:
            return
        kind = self._library.instance_type(owner)
        this = Variable(owner.span, RECEIVER, VariableKind.IN_OUT, kind)
        place = VariableRef(owner.span, this, kind)
        start = _Start(self, self._library, owner, this, owner.span)
        for variable in owner.variables:
            if variable.kind is VariableKind.STATIC and self.needs(variable.type):
                inner = FieldRef(variable.span, place, variable.name, variable.type)
                start.add(inner, variable)
        self._enter(owner.name, start, (this,))

    def _of_globals(self) -> None:
        entries = [
            one
            for one in self._library.globals.entries.values()
            if isinstance(one, Variable) and self.needs(one.type)
        ]
        if not entries:
            return
        start = _Start(self, self._library, None, None, entries[0].span)
        for entry in entries:
            start.add(VariableRef(entry.span, entry, entry.type), entry)
        self._enter(IN_GLOBALS, start, ())

    def _enter(self, name: str, start: "_Start", parameters: tuple[Variable, ...]) -> None:
        span = start.retains.span
        written = ast.Name(span, f"{name}.start")
        syntax = ast.Block(span, BlockKind.FUNCTION, written, None, (), (), ())
        variables = (*parameters, start.retains, *start.counters)
        block = Block(span, written.name, BlockKind.FUNCTION, variables, None, syntax)
        self.bodies[block] = tuple(start.statements)
        self.functions[name.casefold()] = block

    def each_of(self, variable: Variable) -> Sequence[_Given]:
        """The arguments for each element of an array; none if all have the same."""
        return self._each.get(variable, ())

    def arguments_of(self, variable: Variable) -> _Given:
        """The arguments in the declaration of a variable."""
        return self._arguments.get(variable, (variable.span, ()))[1]

    def function(self, block: Block) -> Block | None:
        """What starts the instances inside of a block; None if there is nothing to start."""
        if not self._has_inside(block):
            return None
        self._function(block)
        return self.functions[block.name.casefold()]


class _Start:
    """The statements of one function while they are written."""

    def __init__(
        self,
        starts: InstanceStarts,
        library: "Library",
        owner: Block | None,
        this: Variable | None,
        span: Span,
    ) -> None:
        self._starts = starts
        self._library = library
        self._ctx = Context(library, Scope())
        self._ctx.owner, self._ctx.this = owner, this
        self._ctx.method = FB_INIT
        self.retains = Variable(span, "retains", VariableKind.INPUT, BOOL)
        self.counters: list[Variable] = []
        self.statements: list[Statement] = []

    def add(self, place: Place, variable: Variable) -> None:
        """Start everything at a place; `variable` has the arguments for it."""
        each = self._starts.each_of(variable)
        if each and isinstance(place.type, ArrayType):
            self.statements += self._each(place, place.type, variable, each)
        else:
            given = self._starts.arguments_of(variable)
            self.statements += self._started(place, variable, given)

    def _each(
        self, place: Place, kind: ArrayType, variable: Variable, each: Sequence[_Given]
    ) -> list[Statement]:
        """Each element with its own arguments, those of the first row."""
        found: list[Statement] = []
        for position, index in enumerate(_indices(kind)):
            given = each[position] if position < len(each) else ()
            element = IndexRef(place.span, place, index, kind.element)
            found += self._started(element, variable, given)
        return found

    def _started(self, place: Place, variable: Variable, given: _Given) -> list[Statement]:
        kind = place.type
        if isinstance(kind, ArrayType):
            return self._elements(place, kind, variable, given)
        if isinstance(kind, StructType):
            found: list[Statement] = []
            for part in kind.fields:
                if self._starts.needs(part.type):
                    inner = FieldRef(place.span, place, part.name, part.type)
                    found += self._started(inner, variable, ())
            return found
        assert isinstance(kind, BlockType)
        block = self._library.user_block(kind.name)
        assert block is not None
        found = []
        inside = self._starts.function(block)
        span = variable.span
        if inside is not None:
            this, retains = inside.variables[:2]
            found.append(self._call(span, inside, this, place, ((retains, self._retains(span)),)))
        for number, method in enumerate(chain := self._starts.chain(block)):
            self._ctx.not_run = []
            inputs = self._inputs(variable, given, method, number == len(chain) - 1)
            if self._ctx.not_run:
                found.append(Stop(span, self._ctx.not_run[0]))
            elif inputs is not None:
                found.append(self._call(span, method, method.variables[0], place, inputs))
        return found

    def _elements(
        self, place: Place, kind: ArrayType, variable: Variable, given: _Given
    ) -> list[Statement]:
        span = variable.span
        own = [
            Variable(span, f"index{len(self.counters) + one}", VariableKind.TEMP, DINT)
            for one in range(len(kind.bounds))
        ]
        self.counters += own
        indices = tuple(VariableRef(span, one, DINT) for one in own)
        body = self._started(IndexRef(span, place, indices, kind.element), variable, given)
        for counter, (first, last) in reversed(list(zip(own, kind.bounds, strict=True))):
            ends = (Constant(span, first, DINT), Constant(span, last, DINT))
            step = Constant(span, 1, DINT)
            body = [For(span, VariableRef(span, counter, DINT), *ends, step, tuple(body))]
        return body

    def _retains(self, span: Span) -> Expression:
        return VariableRef(span, self.retains, BOOL)

    def _call(
        self,
        span: Span,
        function: Block,
        this: Variable,
        place: Place,
        inputs: tuple[tuple[Variable, Expression], ...],
    ) -> Statement:
        kind = VOID if function.result is None else function.result.type
        return Evaluate(span, FunctionCall(span, function, inputs, ((this, place),), (), kind))

    def _inputs(
        self, variable: Variable, given: _Given, method: Block, is_last: bool
    ) -> tuple[tuple[Variable, Expression], ...] | None:
        """All inputs of FB_init; None after reporting errors."""
        own = tuple(
            one for one in method.variables if one.name.casefold() not in (_RETAINS, _COPIES)
        )
        names = {one.name.casefold() for one in own}
        places = sum(one.kind is VariableKind.INPUT for one in own)
        if not is_last:
            # A base gets what it knows; the derived FB_init looks at all of them.
            given = tuple(
                one
                for number, one in enumerate(given)
                if one.name.casefold() in names or (not one.name and number < places)
            )
        span = given[0].span if given else variable.span
        call = ast.Call(span, ast.Name(span, "FB_init"), given)
        trimmed = replace(method, variables=own)
        bound = bind_variables(self._ctx, call, method.name, trimmed, by_assignment=True)
        if bound is None:
            return None
        values = dict(bound.inputs)
        found: list[tuple[Variable, Expression]] = []
        missing = []
        for parameter in method.variables:
            if parameter.kind is not VariableKind.INPUT:
                continue
            key = parameter.name.casefold()
            if key == _RETAINS:
                found.append((parameter, self._retains(span)))
            elif key == _COPIES:
                found.append((parameter, Constant(span, False, BOOL)))
            elif parameter in values:
                found.append((parameter, values[parameter]))
            elif parameter.initial is None or not isinstance(
                parameter.type, Elementary | StringType
            ):
                missing.append(parameter.name)
            else:
                value = parameter.initial
                assert isinstance(value, bool | int | float | str)
                found.append((parameter, Constant(span, value, parameter.type)))
        if missing:
            report_missing(self._ctx, call, method.name, missing)
            return None
        return tuple(found)


def _indices(kind: ArrayType) -> Iterator[tuple[Expression, ...]]:
    """The indices of all elements, in flat order."""
    ranges = (range(first, last + 1) for first, last in kind.bounds)
    for numbers in product(*ranges):
        yield tuple(Constant(_NOWHERE, number, DINT) for number in numbers)


def element_arguments(node: ast.ArrayLiteral) -> Iterator[_Given]:
    """The arguments in `[(1), (n := 2), 3(4)]`, one after the other."""
    for item in node.items:
        if isinstance(item, ast.Repeated):
            count = item.count.value if isinstance(item.count, ast.Literal) else 1
            yield from (_as_arguments(item.value),) * int(count)
        else:
            yield _as_arguments(item)


def _as_arguments(node: ast.Expression | None) -> _Given:
    if isinstance(node, ast.StructLiteral):
        return node.fields
    values: Sequence[ast.Expression | ast.Repeated | None] = (node,)
    if isinstance(node, ast.ArrayLiteral):
        values = node.items
    return tuple(
        ast.Argument(one.span, ast.ArgumentKind.POSITIONAL, "", one)
        for one in values
        if one is not None and not isinstance(one, ast.Repeated)
    )


def _element(kind: Type) -> Type:
    while isinstance(kind, ArrayType):
        kind = kind.element
    return kind
