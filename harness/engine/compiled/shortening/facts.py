"""What is known about a whole program before it is written as Python.

An in-out of a single value could always be a reference, but copying it in and out is much faster
and cannot be told apart unless somebody else reaches the same variable during the call. `cells`
holds the variables where that is possible, and those that references to them need.
"""

from collections.abc import Iterable, Mapping
from copy import copy
from dataclasses import field

from fbgen.dataclass import dataclass
from fbgen.lang.checked import (
    LIVING,
    AddressRef,
    Attempt,
    Block,
    FieldRef,
    For,
    FunctionCall,
    Goto,
    Guarded,
    IndexRef,
    InstanceCall,
    MemoryRef,
    Place,
    Program,
    ReferenceTo,
    Repeat,
    RoutineCall,
    SliceRef,
    StandardBlock,
    Statement,
    Substituted,
    SystemCall,
    TakenError,
    Variable,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import (
    ArrayType,
    BlockType,
    OpenArrayType,
    StructType,
    Type,
    refers_to_anything,
)
from harness.engine.compiled.data.model import has_memory, is_scalar
from harness.engine.compiled.statements.instructions import areas
from harness.engine.compiled.walk import (
    WRITING,
    Node,
    every_node,
    nodes_of,
    root_of,
    written_places,
)

_CALLS = frozenset((FunctionCall, InstanceCall))
_WRITERS = _CALLS | {RoutineCall, Attempt, Substituted, TakenError, Guarded, SystemCall}
"""What may write variables beside assignments and loops."""


_TOLD = WRITING | {VariableRef, While, Repeat, Goto, ReferenceTo}
"""What says something about the whole program."""


@dataclass(slots=True)
class _Found:
    """What one block does itself, and after `_spread` also what the blocks do that it calls."""

    callees: set[Block] = field(default_factory=set)
    globals: set[Variable] = field(default_factory=set)
    loops: bool = False
    written: set[Variable] = field(default_factory=set)


def _kind(name: str) -> str:
    """A standard block without the type behind its name: TON of TON_LTIME."""
    return name.partition("_")[0]


@dataclass(frozen=True, slots=True, eq=False)
class _Site:
    """One in-out of one call."""

    caller: Block
    callee: Block | None
    parameter: Variable
    place: Place
    other_roots: frozenset[Variable | None]


class Facts:
    """The facts of one program."""

    __slots__ = (
        "_found",
        "_in_bytes",
        "_program",
        "_too_deep",
        "cells",
        "counts_loops",
        "instances_referenced",
        "referenced",
        "turned",
    )

    def __init__(self, program: Program, call_depth: int) -> None:
        self._program = program
        self._found = {block: _Found() for block in program.bodies}
        self._in_bytes = program.byte_memory
        self.cells: set[Variable] = set()
        self.referenced: set[Variable] = set()
        """Variables that a reference may refer to, wholly or in part."""
        self.turned: set[str] = set()
        """The types of timers, casefolded, whose instances are called as other timers, too."""
        self.counts_loops = True
        sites: list[_Site] = []
        for block, body in program.bodies.items():
            sites += self._look(block, body)
        self.instances_referenced = any(_has_blocks(one.type) for one in self.referenced)
        """True if a call may reach any instance by a reference, also the one it stands in."""
        self._too_deep = _nests_deeper({b: f.callees for b, f in self._found.items()}, call_depth)
        self._spread()
        self._find_cells(sites)

    def counting_loops(self) -> "Facts":
        """The same facts where any loop may run too long: of other statements than the block's."""
        same = copy(self)
        same.counts_loops = True
        return same

    def counts_passes(self, block: Block) -> bool:
        """True if a call of the block can run a loop anywhere, and loops are counted."""
        return self.counts_loops and self._found[block].loops

    def counts_depth(self, block: Block) -> bool:
        """True if calls of the block have to be counted."""
        return self._too_deep and block in self._found

    def touches(self, block: Block) -> set[Variable]:
        """The global variables that a call of the block can read or write anywhere."""
        return self._found[block].globals

    def written(self, block: Block) -> set[Variable]:
        """The variables that the block itself writes, wholly or in part."""
        return self._found[block].written

    def only_reads(self, block: Block, parameter: Variable) -> bool:
        """True if an input can be handed over uncopied: nobody changes it during the call."""
        found = self._found[block]
        if self.referenced:
            return False
        return (
            parameter not in found.written
            and not found.globals
            and all(variable.kind is not VariableKind.IN_OUT for variable in block.variables)
        )

    def keeps(self, variable: Variable, body: Iterable[Statement]) -> bool:
        """True if nothing in `body` can change the variable, a single value of the own block."""
        if variable in self.cells or variable in self._in_bytes or variable.address is not None:
            return False
        if variable in self.referenced:
            return False
        foreign = False
        for node in every_node(body):
            foreign = foreign or _hands_on_this(node)
            if self.instances_referenced and _callees(node):
                foreign = True
            if any(root_of(place) is variable for place in written_places(node)):
                return False
            if any(self._found[callee].globals for callee in _callees(node)):
                foreign = True
        return variable.kind in (VariableKind.TEMP, VariableKind.RESULT) or not foreign

    def private(
        self, variables: set[Variable], block: Block, body: Iterable[Statement]
    ) -> set[Variable]:
        """Those single values of the own block that only `body` itself writes while it runs."""
        if any(self._refers(variable) for variable in block.variables):
            return set()
        if self.instances_referenced:
            return set()
        private = variables - self.cells - self.referenced - self._in_bytes
        if not private:
            return private
        for node in nodes_of(_WRITERS, body):
            if _hands_on_this(node):
                return set()
            touched = [one for callee in _callees(node) for one in self._found[callee].globals]
            if any(_has_blocks(one.type) for one in touched):
                return set()
            if isinstance(node, FunctionCall | RoutineCall):
                # A call inside of an expression may write in a function of its own.
                private -= {
                    one.variable for one in written_places(node) if isinstance(one, VariableRef)
                }
            elif isinstance(node, InstanceCall):
                private -= {
                    place.variable
                    for parameter, place in node.in_outs
                    if parameter in self.cells and isinstance(place, VariableRef)
                }
            elif isinstance(node, Attempt):
                private.discard(node.flag.variable)
            elif isinstance(node, Substituted | TakenError | Guarded):
                private.discard(node.memory.variable)
            elif isinstance(node, SystemCall):
                private -= {
                    place.variable
                    for place in areas(node).values()
                    if isinstance(place, VariableRef)
                }
        return private

    def _refers(self, variable: Variable) -> bool:
        """True for an in-out through which a block could reach its own variables."""
        if variable.kind is not VariableKind.IN_OUT:
            return False
        return variable in self.cells or _has_blocks(variable.type)

    def _look(self, block: Block, body: tuple[Statement, ...]) -> list[_Site]:
        found = self._found[block]
        sites: list[_Site] = []
        for node in nodes_of(_TOLD, body):
            for place in written_places(node):
                root = root_of(place)
                if root is not None:
                    found.written.add(root)
            match node:
                case VariableRef():
                    if node.variable.kind is VariableKind.GLOBAL:
                        found.globals.add(node.variable)
                case For() | While() | Repeat() | Goto():
                    found.loops = True
                case FunctionCall():
                    found.callees.add(node.function)
                    sites += _sites(block, node.function, node.in_outs, [])
                    if node.overrides:
                        self.cells |= _single_in_outs(node.function)
                    for _, override in node.overrides:
                        found.callees.add(override)
                        self.cells |= _single_in_outs(override)
                case InstanceCall():
                    if isinstance(node.block, StandardBlock):
                        if _kind(node.block.name) != _kind(node.instance.type.name):
                            self.turned.add(node.instance.type.name.casefold())
                    else:
                        found.callees.add(node.block)
                        sites += _sites(block, node.block, node.in_outs, [root_of(node.instance)])
                case ReferenceTo() if node.place is not None:
                    root = root_of(node.place)
                    if root is not None:
                        self.referenced.add(root)
                        found.written.add(root)
                        if root.kind is VariableKind.IN_OUT and is_scalar(root.type):
                            self.cells.add(root)
                    if refers_to_anything(node.type):
                        self._box([node.place])
                case SystemCall():
                    self._box(areas(node).values())
                case Attempt():
                    self._box([node.flag])
                case Substituted() | TakenError() | Guarded():
                    self._box([node.memory])
                case _:
                    pass
        return sites

    def _box(self, places: Iterable[Place]) -> None:
        for place in places:
            if isinstance(place, VariableRef) and is_scalar(place.type):
                self.cells.add(place.variable)

    def _spread(self) -> None:
        changed = True
        while changed:
            changed = False
            for found in self._found.values():
                before = (len(found.globals), found.loops)
                for callee in found.callees:
                    other = self._found[callee]
                    found.globals |= other.globals
                    found.loops = found.loops or other.loops
                changed = changed or before != (len(found.globals), found.loops)

    def _find_cells(self, sites: list[_Site]) -> None:
        # A boxed variable of a block with memory is reached by its attribute: it needs no cell.
        memory = {
            variable
            for block in self._found
            if has_memory(block)
            for variable in block.variables
            if variable.kind in LIVING
        }
        self.cells -= memory
        self.cells = {cell for cell in self.cells if cell.kind is not VariableKind.GLOBAL}
        self.cells |= {
            variable
            for block in self._found
            for variable in block.variables
            if variable in self._in_bytes and variable not in memory and is_scalar(variable.type)
        }
        self.cells |= {site.parameter for site in sites if self._may_alias(site)}
        changed = True
        while changed:
            before = len(self.cells)
            for site in sites:
                place = site.place
                if not isinstance(place, VariableRef) or place.variable in memory:
                    continue
                if site.parameter in self.cells and place.variable.kind is not VariableKind.GLOBAL:
                    self.cells.add(place.variable)
                elif place.variable in self.cells:
                    self.cells.add(site.parameter)
            changed = len(self.cells) != before

    def _may_alias(self, site: _Site) -> bool:
        root = root_of(site.place)
        if root in self.referenced or (self.referenced and root is None):
            return True
        if root is None:
            return _is_in_bytes(site.place)
        assert site.callee is not None
        if root in site.other_roots or root in self._in_bytes:
            return True
        if any(one is not None and one.kind is VariableKind.THIS for one in site.other_roots):
            return True
        touched = self._found[site.callee].globals
        if root.kind is VariableKind.GLOBAL:
            return root in touched
        if root.kind is VariableKind.IN_OUT:
            return not is_scalar(root.type)
        if root.kind in (VariableKind.TEMP, VariableKind.RESULT) or not has_memory(site.caller):
            return False
        return any(_has_blocks(variable.type) for variable in touched)


def _is_in_bytes(place: Place) -> bool:
    """True for absolute addresses that a variable may lie at as well."""
    while isinstance(place, FieldRef | IndexRef | SliceRef):
        place = place.base
    return isinstance(place, MemoryRef) or (
        isinstance(place, AddressRef) and place.address.area == "DB"
    )


def _hands_on_this(node: Node) -> bool:
    """True for a call that can write every variable of the instance it stands in."""
    return isinstance(node, FunctionCall | InstanceCall) and any(
        root is not None and root.kind is VariableKind.THIS
        for root in map(root_of, written_places(node))
    )


def _has_blocks(kind: Type) -> bool:
    """True for types with an instance of a block inside."""
    if isinstance(kind, ArrayType | OpenArrayType):
        return _has_blocks(kind.element)
    if isinstance(kind, StructType):
        return any(_has_blocks(part.type) for part in kind.fields)
    return isinstance(kind, BlockType)


def _sites(
    caller: Block,
    callee: Block,
    in_outs: tuple[tuple[Variable, Place], ...],
    roots: list[Variable | None],
) -> list[_Site]:
    sites = []
    for parameter, place in in_outs:
        if not is_scalar(parameter.type) or parameter.kind is VariableKind.KEPT:
            continue
        others = [root_of(other) for variable, other in in_outs if variable is not parameter]
        sites.append(_Site(caller, callee, parameter, place, frozenset((*others, *roots))))
    return sites


def _callees(node: Node) -> list[Block]:
    """The blocks of the user that a node itself may call."""
    if isinstance(node, FunctionCall):
        return [node.function, *(override for _, override in node.overrides)]
    if isinstance(node, InstanceCall) and isinstance(node.block, Block):
        return [node.block]
    return []


def _single_in_outs(block: Block) -> set[Variable]:
    """The in-outs that are single values: with several callees all of them are references."""
    return {
        variable
        for variable in block.variables
        if variable.kind is VariableKind.IN_OUT and is_scalar(variable.type)
    }


def _nests_deeper(calls: Mapping[Block, set[Block]], limit: int) -> bool:
    """True if some chain of calls has more than `limit` blocks, or none is the longest."""
    waiting = {block: len(callees) for block, callees in calls.items()}
    callers: dict[Block, list[Block]] = {block: [] for block in calls}
    for block, callees in calls.items():
        for callee in callees:
            callers[callee].append(block)
    depth = dict.fromkeys(calls, 1)
    ready = [block for block, count in waiting.items() if count == 0]
    done = 0
    while ready:
        block = ready.pop()
        done += 1
        if depth[block] > limit:
            return True
        for caller in callers[block]:
            depth[caller] = max(depth[caller], depth[block] + 1)
            waiting[caller] -= 1
            if waiting[caller] == 0:
                ready.append(caller)
    return done < len(calls)
