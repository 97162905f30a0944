"""The variables of a block as terms: each value of a structure apart, arrays by their index."""

from collections.abc import Iterator
from dataclasses import fields
from typing import TypeAlias

import z3

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    LIVING,
    FieldRef,
    IndexRef,
    Place,
    Program,
    StandardBlock,
    Variable,
    VariableRef,
)
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from harness.verify.mutation.proof.terms import Sort, Term, UnknownError, is_single, sort_of

HIDDEN = "<hidden>"
"""What an instance of a standard block keeps beside its parameters."""

INDEX_BITS = 32

Key: TypeAlias = tuple[Variable, tuple[str, ...]]
"""A variable with the casefolded names of the parts that lead to one value."""


@dataclass(frozen=True, slots=True)
class Leaf:
    """One value inside of a type: the names that lead to it, and how many indices."""

    path: tuple[str, ...]
    indices: int
    sort: Sort

    @property
    def whole_sort(self) -> Sort:
        """The sort of the value, or of the array of all of them."""
        if not self.indices:
            return self.sort
        return z3.ArraySort(z3.BitVecSort(INDEX_BITS * self.indices), self.sort)


@dataclass(slots=True)
class Memory:
    """What all variables hold at one point of a call.

    `world` stands for everything outside: time, hardware, what other blocks do. The rest of the
    block is left out when it has `returned` or the program has `stopped`, the rest of a loop when
    it is `left`, of a pass when the `next` one begins; `held` is what an outer loop says of that.
    """

    values: dict[Key, Term]
    world: Term
    returned: Term
    stopped: Term
    left: Term
    next: Term
    held: Term

    @classmethod
    def begin(cls, values: dict[Key, Term]) -> "Memory":
        """At the first statement."""
        world = z3.Const("world", z3.DeclareSort("World"))
        return cls(values, world, *(z3.BoolVal(False) for _ in range(5)))

    def copy(self) -> "Memory":
        """The same, to be changed on its own."""
        rest = (self.returned, self.stopped, self.left, self.next, self.held)
        return Memory(dict(self.values), self.world, *rest)

    @property
    def runs(self) -> Term:
        """True while statements are carried out."""
        ends = (self.returned, self.stopped, self.left, self.next, self.held)
        return z3.simplify(z3.Not(z3.Or(*ends)))

    def become(self, condition: Term, yes: "Memory", no: "Memory") -> None:
        """What holds behind two branches, both with the variables of this."""
        self.values = {
            key: _either(condition, yes.values[key], no.values[key]) for key in self.values
        }
        for one in fields(self):
            if one.name != "values":
                term = _either(condition, getattr(yes, one.name), getattr(no, one.name))
                setattr(self, one.name, term)


def _either(condition: Term, one: Term, other: Term) -> Term:
    return one if one is other or one.eq(other) else z3.If(condition, one, other)


def leaves(program: Program, kind: Type) -> tuple[Leaf, ...]:
    """All values inside of a type; UnknownError for what has none, such as references."""
    return tuple(_leaves(program, kind, (), 0))


def _leaves(program: Program, kind: Type, path: tuple[str, ...], indices: int) -> Iterator[Leaf]:
    if is_single(kind):
        yield Leaf(path, indices, sort_of(kind))
    elif isinstance(kind, StructType) and not kind.is_union:
        for part in kind.fields:
            yield from _leaves(program, part.type, (*path, part.name.casefold()), indices)
    elif isinstance(kind, ArrayType):
        yield from _leaves(program, kind.element, path, indices + len(kind.bounds))
    elif isinstance(kind, BlockType):
        block = program.block_of(kind.name)
        own = isinstance(block, StandardBlock)
        for variable in block.variables:
            if own or variable.kind in LIVING:
                name = variable.name.casefold()
                yield from _leaves(program, variable.type, (*path, name), indices)
        if own:
            yield Leaf((*path, HIDDEN), indices, z3.DeclareSort("Hidden"))
    else:
        raise UnknownError(f"a variable of type {kind}")


def steps(place: Place) -> tuple[Variable, tuple[str, ...], tuple[IndexRef, ...]]:
    """The variable, the names and the elements of arrays on the way to a place."""
    names: list[str] = []
    elements: list[IndexRef] = []
    while not isinstance(place, VariableRef):
        if isinstance(place, FieldRef):
            names.insert(0, place.name.casefold())
        elif isinstance(place, IndexRef):
            elements.insert(0, place)
        else:
            raise UnknownError(f"a place such as {place.span.text}")
        place = place.base
    return place.variable, tuple(names), tuple(elements)


def any_values(program: Program, variables: set[Variable]) -> dict[Key, Term]:
    """Any values for some variables."""
    return {
        (variable, leaf.path): z3.Const(
            f"{variable.kind.value} {'.'.join((variable.name, *leaf.path))}", leaf.whole_sort
        )
        for variable in variables
        for leaf in leaves(program, variable.type)
    }
