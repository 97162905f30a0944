"""Errors that a block handles itself, because GET_ERROR or GET_ERR_ID stands in it.

In such a block a place that cannot be reached stops nothing: read, it is zero or empty; written,
the write is left out; handed to a call, the call is left out. The first of them since the last
question is kept in a variable of the block, `reaction * 16#1_0000 + ERROR_ID`, which starts empty
with each call. That is written out here, so that an engine meets three simple nodes. Blocks that
this one calls are not meant.
Source: TIA Portal help, "GET_ERROR: Get error locally", "GET_ERR_ID: Get error ID locally".
"""

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import TypeVar

from fbgen.lang.ast import BlockKind
from fbgen.lang.checked import (
    WORKS,
    AddressRef,
    Assignment,
    Attempt,
    Binary,
    Block,
    Branch,
    Case,
    Constant,
    Convert,
    Dereference,
    Evaluate,
    Expression,
    FieldRef,
    For,
    FunctionCall,
    Guarded,
    If,
    IndexRef,
    InstanceCall,
    MemoryRef,
    Place,
    Program,
    Repeat,
    RoutineCall,
    SliceRef,
    StandardCall,
    Statement,
    Substituted,
    SystemCall,
    TakenError,
    Try,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import (
    BOOL,
    BYTE,
    DWORD,
    WORD,
    Elementary,
    OpenArrayType,
    StringType,
    StructType,
    Type,
)
from fbgen.source import Span

_MENTION = re.compile(r"GET_?ERR(?:OR)?_?(?:ID)?", re.IGNORECASE)
_WHOLE, _NUMBER = "GETERROR", "GETERRORID"
_BLOCK_TYPES = {BlockKind.ORGANIZATION_BLOCK: 1, BlockKind.FUNCTION: 2}
_FUNCTION_BLOCK = 3
_PLACES = (FieldRef, IndexRef, SliceRef, AddressRef, MemoryRef, Dereference)
_T = TypeVar("_T", FunctionCall, InstanceCall)


def with_local_errors(program: Program) -> Program:
    """The program with what its blocks do about their own errors."""
    bodies = dict(program.bodies)
    temporaries = dict(program.temporaries)
    for block, body in program.bodies.items():
        span = block.syntax.span
        if not _MENTION.search(span.source.text, span.start, span.end):
            continue
        writer = _LocalErrors(block)
        written = writer.body(body)
        if writer.asks:
            temporaries[block] = (*temporaries.get(block, ()), writer.memory.variable)
            bodies[block] = (writer.empty(span), *written)
    return replace(program, bodies=bodies, temporaries=temporaries)


class _LocalErrors:
    """Writes the statements of one block anew; `asks` if it asks for its errors."""

    def __init__(self, block: Block) -> None:
        span = block.syntax.name.span
        variable = Variable(span, "first error", VariableKind.TEMP, DWORD)
        self.memory = VariableRef(span, variable, DWORD)
        self.asks = False
        self._kind = _BLOCK_TYPES.get(block.kind, _FUNCTION_BLOCK)

    def empty(self, span: Span) -> Statement:
        """There is no error."""
        return Assignment(span, self.memory, Constant(span, 0, DWORD))

    def body(self, statements: tuple[Statement, ...]) -> tuple[Statement, ...]:
        """A list of statements."""
        return tuple(new for one in statements for new in self._statement(one))

    def _statement(self, node: Statement) -> tuple[Statement, ...]:
        match node:
            case Assignment():
                return self._assignment(node)
            case Evaluate(call=RoutineCall(name=name) as call) if name in (_WHOLE, _NUMBER):
                return self._question(call)
            case Evaluate() | InstanceCall():
                return (self._call(node),)
            case If():
                branches = tuple(
                    Branch(one.span, self._read(one.condition), self.body(one.body))
                    for one in node.branches
                )
                return (replace(node, branches=branches, otherwise=self.body(node.otherwise)),)
            case Case():
                arms = tuple(replace(arm, body=self.body(arm.body)) for arm in node.arms)
                selector, otherwise = self._read(node.selector), self.body(node.otherwise)
                return (replace(node, selector=selector, arms=arms, otherwise=otherwise),)
            case For():
                first, last, step = map(self._read, (node.first, node.last, node.step))
                body = self.body(node.body)
                return (replace(node, first=first, last=last, step=step, body=body),)
            case While() | Repeat():
                condition, body = self._read(node.condition), self.body(node.body)
                return (replace(node, condition=condition, body=body),)
            case Try():
                body, catch, final = map(self.body, (node.body, node.catch, node.final))
                return (replace(node, body=body, catch=catch, final=final),)
            case _:
                return (node,)

    # --- the questions ------------------------------------------------------------------------

    def _assignment(self, node: Assignment) -> tuple[Statement, ...]:
        asked = _under_conversions(node.value)
        value = self._read(node.value)
        assignment = Assignment(node.span, self._way(node.target), value)
        statement = self._guarded(assignment, assignment.target, value)
        if isinstance(asked, RoutineCall) and asked.name == _NUMBER:
            return (self._where_there_is_one(node.span, statement),)
        return (statement,)

    def _question(self, call: RoutineCall) -> tuple[Statement, ...]:
        self.asks = True
        span = call.span
        statements: list[Statement] = []
        number: Expression = TakenError(span, self.memory, WORD)
        for name, place in call.outputs:
            if name == WORKS:
                statements.append(Assignment(span, place, Constant(span, True, BOOL)))
            elif call.name == _NUMBER:
                statements.append(Assignment(span, place, number))
                number = place
            else:
                statements += self._described(place)
                statements.append(self.empty(span))
        return (self._where_there_is_one(span, *statements),)

    def _where_there_is_one(self, span: Span, *statements: Statement) -> Statement:
        """What is done only if there was an error."""
        some = Binary(span, "<>", self.memory, Constant(span, 0, DWORD), BOOL)
        return If(span, (Branch(span, some, statements),), ())

    def _described(self, place: Place) -> Iterator[Statement]:
        """The parts of an ErrorStruct; what is about the machine code is 0."""
        assert isinstance(place.type, StructType)
        for field in place.type.fields:
            part = FieldRef(place.span, place, field.name, field.type)
            if isinstance(field.type, StructType):
                yield from self._described(part)
            else:
                assert isinstance(field.type, Elementary)
                value = self._part(place.span, field.name.upper(), field.type)
                yield Assignment(place.span, part, value)

    def _part(self, span: Span, name: str, kind: Elementary) -> Expression:
        if name == "ERROR_ID":
            return Convert(span, self.memory, WORD)
        if name == "REACTION":
            high = StandardCall(span, "SHR", (self.memory, Constant(span, 16, WORD)), DWORD)
            return Convert(span, high, BYTE)
        return Constant(span, self._kind if name == "BLOCK_TYPE" else 0, kind)

    # --- what may fail ------------------------------------------------------------------------

    def _call(self, node: Evaluate | InstanceCall) -> Statement:
        if isinstance(node, InstanceCall):
            called = replace(self._with_arguments(node), instance=self._way(node.instance))
            handed_on = [place for _, place in (*called.in_outs, *called.outputs)]
            return self._guarded(called, called.instance, *handed_on)
        if isinstance(node.call, FunctionCall):
            function = self._with_arguments(node.call)
            handed_on = [place for _, place in (*function.in_outs, *function.outputs)]
            return self._guarded(Evaluate(node.span, function), *handed_on)
        if isinstance(node.call, SystemCall):
            call = self._system(node.call)
            return self._guarded(Evaluate(node.span, call), *_parts(call))
        routine = self._routine(node.call)
        return self._guarded(Evaluate(node.span, routine), *_parts(routine))

    def _system(self, call: SystemCall) -> SystemCall:
        """The same call; the places in it may be areas and stay as they are."""
        return replace(call, arguments=tuple(map(self._given, call.arguments)))

    def _routine(self, call: RoutineCall) -> RoutineCall:
        """As `_system`."""
        return replace(call, inputs=tuple(map(self._given, call.inputs)))

    def _given(self, argument: tuple[str, Expression]) -> tuple[str, Expression]:
        name, value = argument
        return argument if isinstance(value, (VariableRef, *_PLACES)) else (name, self._read(value))

    def _with_arguments(self, call: _T) -> _T:
        return replace(
            call,
            inputs=tuple((one, self._read(value)) for one, value in call.inputs),
            in_outs=tuple((one, self._way(place)) for one, place in call.in_outs),
            outputs=tuple((one, self._way(place)) for one, place in call.outputs),
        )

    def _guarded(
        self, statement: Assignment | Evaluate | InstanceCall, *parts: Expression
    ) -> Statement:
        if any(_may_fail(part) for part in parts):
            return Guarded(statement.span, statement, self.memory)
        return statement

    def _read(self, node: Expression) -> Expression:
        links: list[Binary | Convert] = []
        while isinstance(node, Binary | Convert):
            links.append(node)
            node = node.left if isinstance(node, Binary) else node.operand
        result = self._operand(node)
        for link in reversed(links):
            if isinstance(link, Convert):
                result = replace(link, operand=result)
            else:
                result = replace(link, left=result, right=self._read(link.right))
        return result

    def _operand(self, node: Expression) -> Expression:
        match node:
            case FieldRef() | IndexRef() | SliceRef() | AddressRef() | MemoryRef() | Dereference():
                place = self._way(node)
                if _is_single(node.type) and _may_fail(place):
                    return Substituted(node.span, place, self.memory, node.type)
                return place
            case Unary():
                return replace(node, operand=self._read(node.operand))
            case StandardCall():
                return replace(node, arguments=tuple(map(self._read, node.arguments)))
            case FunctionCall():
                return self._with_arguments(node)
            case Attempt():
                operand = self._read(node.operand)
                assert isinstance(operand, Unary | Binary | Convert | StandardCall)
                return replace(node, operand=operand)
            case RoutineCall() if node.name == _NUMBER:
                self.asks = True
                return TakenError(node.span, self.memory, WORD)
            case SystemCall():
                return self._system(node)
            case RoutineCall():
                return self._routine(node)
            case _:
                return node

    def _way(self, place: Place) -> Place:
        """The place with the indices on the way to it."""
        match place:
            case IndexRef():
                indices = tuple(map(self._read, place.indices))
                return replace(place, base=self._way(place.base), indices=indices)
            case FieldRef() | SliceRef():
                return replace(place, base=self._way(place.base))
            case MemoryRef():
                return replace(place, byte=self._read(place.byte))
            case _:
                return place


def _parts(call: SystemCall | RoutineCall) -> list[Expression]:
    if isinstance(call, SystemCall):
        return [part for _, part in call.arguments]
    return [part for _, part in (*call.inputs, *call.outputs)]


def _under_conversions(value: Expression) -> Expression:
    while isinstance(value, Convert):
        value = value.operand
    return value


def _is_single(kind: Type) -> bool:
    return isinstance(kind, Elementary | StringType)


def _may_fail(part: Expression) -> bool:
    """True for a place that may turn out not to be there."""
    while isinstance(part, _PLACES):
        match part:
            case IndexRef():
                is_open = isinstance(part.base.type, OpenArrayType)
                if is_open or not all(isinstance(index, Constant) for index in part.indices):
                    return True
                part = part.base
            case FieldRef() | SliceRef():
                part = part.base
            case AddressRef():
                return part.address.area == "DB"
            case _:
                return True
    return False
