"""Expressions and places of a block, read into terms; what they do on the way is noted."""

from collections.abc import Callable
from typing import TypeAlias

import z3

from fbgen.lang.checked import (
    AddressRef,
    Binary,
    Block,
    Constant,
    Convert,
    Expression,
    FieldRef,
    FunctionCall,
    IndexRef,
    Place,
    Program,
    StandardBlock,
    StandardCall,
    Unary,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.types import ArrayType, BlockType, Elementary
from harness.engine.compiled.walk import every_node
from harness.verify.mutation.proof import terms
from harness.verify.mutation.proof.memory import INDEX_BITS, Key, Memory, leaves, steps
from harness.verify.mutation.proof.terms import Sort, Term, UnknownError, is_single, sort_of

_PLACES = (VariableRef, FieldRef, IndexRef)


Part: TypeAlias = tuple[Key, tuple[Term, ...], Term]
"""One value inside of a place: its key, the indices to it, the value itself."""


class Reader:
    """Reads and writes places, and evaluates expressions, in one memory after the other."""

    def __init__(self, program: Program, memory: Memory, *, exact: bool) -> None:
        """Without `exact` a calculation with REAL is only known to give the same for the same.

        That is enough for most proofs, and the solver is much faster with it.
        """
        self.program = program
        self.memory = memory
        self._exact = exact

    # --- effects ----------------------------------------------------------------------------

    def stop(self, condition: Term) -> None:
        """The program stops here if a condition holds."""
        memory = self.memory
        memory.stopped = z3.Or(memory.stopped, z3.And(memory.runs, condition))

    def change_world(self, what: str, *values: Term) -> None:
        """Something happens outside."""
        memory = self.memory
        world = apply(f"{what}: world", memory.world.sort(), memory.world, *values)
        memory.world = z3.If(memory.runs, world, memory.world)

    def put(self, key: Key, value: Term) -> None:
        """A value as a whole."""
        memory = self.memory
        memory.values[key] = z3.If(memory.runs, value, memory.values[key])

    # --- places -----------------------------------------------------------------------------

    def find(self, place: Place) -> tuple[Key, tuple[Term, ...]]:
        """The variable and names of a place, and its indices, which are evaluated."""
        variable, names, elements = steps(place)
        self.check(variable)
        indices: list[Term] = []
        for element in elements:
            indices += self._indices(element)
        return (variable, names), tuple(indices)

    def check(self, variable: Variable) -> None:
        """Raises UnknownError for a variable that is more than its own value."""
        if variable.address is not None or variable.overlay is not None:
            raise UnknownError(f"{variable.name} has an address")
        if variable in self.program.byte_memory:
            raise UnknownError(f"{variable.name} lies in bytes")
        if variable.kind is VariableKind.THIS:
            raise UnknownError("THIS")

    def _indices(self, element: IndexRef) -> list[Term]:
        kind = element.base.type
        if not isinstance(kind, ArrayType):
            raise UnknownError(f"elements of {kind}")
        found: list[Term] = []
        for index, (first, last) in zip(element.indices, kind.bounds, strict=True):
            term = self.value(index)
            if not z3.is_bv(term) or term.size() > INDEX_BITS:
                raise UnknownError("an index of 64 bits")
            more = INDEX_BITS - term.size()
            signed = terms.is_signed(index.type)
            wide = z3.SignExt(more, term) if signed else z3.ZeroExt(more, term)
            if not signed and term.size() == INDEX_BITS:
                raise UnknownError("an index of 32 bits without a sign")
            self.stop(z3.Or(wide < first, wide > last))
            found.append(wide)
        return found

    def read(self, place: Place) -> Term:
        """The single value at a place."""
        if isinstance(place, AddressRef):
            return self._hardware(place)
        key, indices = self.find(place)
        if isinstance(place, FieldRef) and isinstance(place.base.type, BlockType):
            self._look_at_instance(place.base, place.name)
        return self._value(key, indices)

    def _value(self, key: Key, indices: tuple[Term, ...]) -> Term:
        whole = self.memory.values.get(key)
        if whole is None:
            raise UnknownError(f"{key[0].name} is no variable of the block")
        return z3.Select(whole, _index(indices)) if indices else whole

    def _look_at_instance(self, instance: Place, name: str) -> None:
        """A timer may go on when it is looked at, so looking is something that happens to it."""
        assert isinstance(instance.type, BlockType)
        block = self.program.block_of(instance.type.name)
        if isinstance(block, StandardBlock):
            self.happen(f"look at {block.name}.{name}", instance, ())

    def write(self, place: Place, value: Term) -> None:
        """A single value goes to a place; its indices are evaluated behind the value."""
        if isinstance(place, AddressRef):
            self.change_world(f"write {_address(place)}", value)
            return
        key, indices = self.find(place)
        self.write_at(key, indices, value)

    def write_at(self, key: Key, indices: tuple[Term, ...], value: Term) -> None:
        """A value goes where `find` has found it."""
        whole = self.memory.values.get(key)
        if whole is None:
            raise UnknownError(f"{key[0].name} is no variable of the block")
        self.put(key, z3.Store(whole, _index(indices), value) if indices else value)

    def parts(self, place: Place) -> list[Part]:
        """All values at a place: where each is, and the value itself."""
        (variable, names), indices = self.find(place)
        found = []
        for leaf in leaves(self.program, place.type):
            if leaf.indices and indices:
                raise UnknownError("an array inside of an element of an array")
            key = (variable, (*names, *leaf.path))
            found.append((key, indices, self._value(key, indices)))
        return found

    def _hardware(self, place: AddressRef) -> Term:
        memory = self.memory
        value = apply(f"read {_address(place)}", sort_of(place.type), memory.world)
        self.change_world(f"after reading {_address(place)}")
        return value

    # --- calls ------------------------------------------------------------------------------

    def happen(self, what: str, instance: Place, values: tuple[Term, ...]) -> None:
        """A standard block does something: all of its instance may be another one then."""
        parts = self.parts(instance)
        called = event(what, *(value for _, _, value in parts), *values, self.memory.world)
        for number, (key, indices, value) in enumerate(parts):
            self.write_at(key, indices, apply(f"{what}: part {number}", value.sort(), called))

    def function(self, node: FunctionCall) -> Term | None:
        """A call of a FUNCTION; None for one without a result."""
        if node.overrides:
            raise UnknownError("a method")
        name = f"FUNCTION {node.function.name}"
        values = [value for _, one in node.inputs for value in self.given(one)]
        places = [part for _, place in node.in_outs for part in self.parts(place)]
        values += [value for _, _, value in places]
        results = [
            (f"{name}: {key[0].name}.{key[1]} {number}", key, indices, value)
            for number, (key, indices, value) in enumerate(places)
        ]
        called = self.call(name, node.function, values)
        for label, key, indices, value in results:
            self.write_at(key, indices, apply(label, value.sort(), called))
        for variable, place in node.outputs:
            self.write(place, apply(f"{name}: => {variable.name}", sort_of(place.type), called))
        if node.function.result is None:
            return None
        return apply(f"{name}: result", sort_of(node.type), called)

    def call(self, name: str, block: Block, values: list[Term]) -> Term:
        """A block of the user does something with these values; what it reaches besides changes."""
        if is_pure(self.program, block):
            called = event(name, *values)
            self.stop(apply(f"{name}: stops", z3.BoolSort(), called))
            return called
        memory = self.memory
        reached = [key for key in memory.values if key[0].kind is VariableKind.GLOBAL]
        called = event(name, *values, memory.world, *(memory.values[key] for key in reached))
        self.stop(apply(f"{name}: stops", z3.BoolSort(), called))
        for key in reached:
            label = f"{name}: {key[0].name}.{'.'.join(key[1])}"
            self.put(key, apply(label, memory.values[key].sort(), called))
        self.change_world(name, called)
        return called

    def given(self, value: Expression) -> list[Term]:
        """What is handed over: one value, or all of a structure."""
        if is_single(value.type):
            return [self.value(value)]
        if isinstance(value, _PLACES):
            return [term for _, _, term in self.parts(value)]
        raise UnknownError(f"a value of type {value.type}")

    # --- values -----------------------------------------------------------------------------

    def value(self, node: Expression) -> Term:
        """A single value."""
        match node:
            case Constant():
                return terms.constant(node.value, node.type)
            case VariableRef() | FieldRef() | IndexRef() | AddressRef():
                return self.read(node)
            case Unary():
                return terms.unary(node.operator, self.value(node.operand), node.type)
            case Binary():
                return self._binary(node)
            case Convert():
                return self._convert(node)
            case StandardCall():
                return self._standard(node)
            case FunctionCall():
                result = self.function(node)
                if result is not None:
                    return result
            case _:
                pass
        raise UnknownError(f"an expression such as {node.span.text}")

    def _binary(self, node: Binary) -> Term:
        operator, kind = node.operator, node.left.type
        if operator in ("AND_THEN", "OR_ELSE"):
            return self._short(node)
        left, right = self.value(node.left), self.value(node.right)
        if operator in ("=", "<>", "<", "<=", ">", ">="):
            if left.sort() != right.sort():
                raise UnknownError("values of different types compared")
            return terms.compare(operator, left, right, kind)
        if operator in ("AND", "OR", "XOR"):
            return terms.logical(operator, left, right, kind)
        if kind != node.right.type or not isinstance(kind, Elementary) or operator == "**":
            raise UnknownError(f"{operator} on {kind} and {node.right.type}")
        if z3.is_bv(left) and operator in ("/", "MOD"):
            self.stop(right == 0)
            return terms.divide(operator, left, right, kind)
        if not z3.is_bv(left) and not terms.is_real(kind):
            raise UnknownError(f"{operator} on {kind}")
        if terms.is_real(kind) and not self._exact:
            return apply(f"REAL {operator}", left.sort(), left, right)
        return terms.calculate(operator, left, right, kind)

    def _convert(self, node: Convert) -> Term:
        source, target = node.operand.type, node.type
        operand = self.value(node.operand)
        value, fits_not = terms.convert(operand, source, target, node.rounding)
        if not self._exact and (terms.is_real(source) or terms.is_real(target)):
            name = f"{source} to {target}, {node.rounding}"
            value = apply(name, value.sort(), operand)
            fits_not = apply(f"{name}: does not fit", z3.BoolSort(), operand)
        self.stop(fits_not)
        return value

    def _short(self, node: Binary) -> Term:
        """The right side is evaluated only where the left one does not decide."""
        left = self.value(node.left)
        needed = left if node.operator == "AND_THEN" else z3.Not(left)
        before, evaluated = self.memory, self.memory.copy()
        self.memory = evaluated
        right = self.value(node.right)
        self.memory = before
        before.become(needed, evaluated, before.copy())
        return terms.logical(node.operator, left, right, node.type)

    def _standard(self, node: StandardCall) -> Term:
        values = [self.value(one) for one in node.arguments]
        if node.name == "ABS" and terms.is_real(node.type):
            return z3.fpAbs(values[0])
        make = _STANDARD.get(node.name)
        if make is None or not all(z3.is_bv(one) for one in values):
            raise UnknownError(f"{node.name} on {node.type}")
        return make(node, values)


def _shift(node: StandardCall, values: list[Term]) -> Term:
    """SHL, SHR: a count of the width and more gives 0, as a negative one does."""
    value, count = values
    if terms.is_signed(node.arguments[0].type):
        raise UnknownError("a shift of a signed number")
    wide, bits = max(value.size(), count.size()), value.size()
    signed = terms.is_signed(node.arguments[1].type)
    more = wide - count.size()
    by = z3.SignExt(more, count) if signed else z3.ZeroExt(more, count)
    long = z3.ZeroExt(wide - bits, value)
    moved = long << by if node.name == "SHL" else z3.LShR(long, by)
    nothing = z3.BitVecVal(0, bits)
    return z3.If(z3.UGE(by, bits), nothing, z3.Extract(bits - 1, 0, moved))


def _rotate(node: StandardCall, values: list[Term]) -> Term:
    count = node.arguments[1]
    if not isinstance(count, Constant) or not isinstance(count.value, int):
        raise UnknownError(f"{node.name} by a variable")
    turn = z3.RotateLeft if node.name == "ROL" else z3.RotateRight
    return turn(values[0], count.value % values[0].size())


_STANDARD: dict[str, Callable[[StandardCall, list[Term]], Term]] = {
    "SHL": _shift,
    "SHR": _shift,
    "ROL": _rotate,
    "ROR": _rotate,
}


def _index(indices: tuple[Term, ...]) -> Term:
    return indices[0] if len(indices) == 1 else z3.Concat(*indices)


def _address(place: AddressRef) -> str:
    one = place.address
    return f"{one.area}{one.bits} {one.byte}.{one.bit} {one.db} {one.peripheral}"


def apply(name: str, sort: Sort, *values: Term) -> Term:
    """What some function of these values gives; the same name and values give the same."""
    sorts = [value.sort() for value in values]
    label = f"{name} ({', '.join(map(str, sorts))})"
    return z3.Function(label, *sorts, sort)(*values)


def event(name: str, *values: Term) -> Term:
    """Something that happens with these values, as one value for all that comes of it."""
    sort = z3.DeclareSort("Event")
    return apply(name, sort, *values) if values else z3.Const(name, sort)


def is_pure(program: Program, block: Block) -> bool:
    """True for a FUNCTION that only calculates with what it is given."""
    body = program.bodies.get(block)
    if body is None or block.kind.name != "FUNCTION":
        return False
    for node in every_node(body):
        if isinstance(node, VariableRef) and node.variable.kind is VariableKind.GLOBAL:
            return False
        if isinstance(node, FunctionCall):
            if node.function is block or not is_pure(program, node.function):
                return False
        elif type(node).__name__ not in CALCULATING:
            return False
    return True


CALCULATING = (
    *("Assignment", "If", "Branch", "Case", "CaseArm", "For", "Return", "Exit", "Continue"),
    *("Evaluate", "Constant", "VariableRef", "FieldRef", "IndexRef", "Unary", "Binary"),
    *("Convert", "StandardCall"),
)
"""The kinds of nodes that only calculate."""
