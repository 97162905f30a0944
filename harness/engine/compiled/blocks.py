"""Whole blocks and structures as Python source: classes with slots, and functions."""

from collections.abc import Sequence
from functools import partial

from fbgen.lang.checked import Block, Statement, Variable, VariableKind, VariableRef
from fbgen.lang.layout import holds_blocks
from fbgen.lang.start_information import start_places
from fbgen.lang.types import ArrayType, StructInitial, StructType, Type
from harness.engine.compiled.code import Listing
from harness.engine.compiled.data.initials import Initializer
from harness.engine.compiled.data.model import Model, Part, Record, has_memory, is_scalar
from harness.engine.compiled.data.placement import Bytes
from harness.engine.compiled.data.shapes import Shapes
from harness.engine.compiled.evaluation import enter
from harness.engine.compiled.expressions import (
    attempts,
    operators,
    places,
    references,
    standard_functions,
)
from harness.engine.compiled.outside.calls import input_types
from harness.engine.compiled.outside.signatures import signature
from harness.engine.compiled.procedure import BlockContext, FrameNeededError, Procedure
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.shortening.temporaries import read_unfilled
from harness.engine.compiled.statements import calls, local_errors, routine_calls
from harness.engine.compiled.statements.jumps import has_jumps
from harness.engine.compiled.statements.kinds import write_long
from harness.engine.compiled.watching.probes import Probe
from harness.engine.compiled.watching.write_notes import writers_of
from harness.engine.compiled.watching.writers import Writers
from harness.engine.compiled.written import Written
from harness.engine.interface import Value
from harness.engine.layout import S7
from harness.engine.leftovers import left_over, values_left

for module in (
    *(places, references, operators, standard_functions, calls, attempts, local_errors),
    routine_calls,
):
    enter(module.EXPRESSIONS)


def write_block(
    block: Block,
    facts: Facts,
    shapes: Shapes,
    *,
    probe: Probe | None = None,
    body: Sequence[Statement] | None = None,
) -> Written:
    """A block as Python source, with another body if one is given; FB6050 if nested too deep."""
    if body is None:
        body = shapes.model.program.bodies[block]
    for framed in (False, True):
        context = BlockContext(block, facts, shapes, probe=probe, framed=framed)
        try:
            listing = _class(context, body) if has_memory(block) else _function(context, body)
        except FrameNeededError:
            continue
        for part in context.parts:
            listing.add("")
            listing.append(part)
        return Written(listing, context.tables, context.links)
    raise AssertionError("a block with a frame needs no other one")


_MEMORY = "_memory"
"""The local with the bytes of a call."""

# --- functions ----------------------------------------------------------------------------------


def _own(context: BlockContext) -> list[Variable]:
    """The variables of a block that start anew with each call."""
    kinds: tuple[VariableKind, ...] = (VariableKind.TEMP, VariableKind.RESULT)
    if not has_memory(context.block):
        kinds = (*kinds, VariableKind.OUTPUT)
    declared = [variable for variable in context.block.variables if variable.kind in kinds]
    return [*declared, *context.model.program.temporaries.get(context.block, ())]


def _filled_first(procedure: Procedure, body: Sequence[Statement]) -> set[Variable]:
    """The temporary variables that need no value at the start: the statements give them one."""
    context = procedure.context
    if context.framed or has_jumps(body):
        return set()
    read = read_unfilled(body)
    return {
        variable
        for variable in context.block.variables
        if variable.kind is VariableKind.TEMP
        and is_scalar(variable.type)
        and variable.address is None
        and variable not in read
        and not procedure.has_cell(variable)
    }


def _head(procedure: Procedure, parameters: Sequence[Variable], body: Sequence[Statement]) -> None:
    """Write what comes before the statements of the block: its variables."""
    context = procedure.context
    initializer = context.initializer
    if context.framed:
        names = [context.names.of(variable.name) for variable in (*parameters, *_own(context))]
        procedure.line(f"frame = _{context.python_name}_frame()")
        context.tables[f"_{context.python_name}_frame"] = type(
            f"{context.python_name}_frame", (), {"__slots__": tuple(names)}
        )
    placement = context.shapes.frame(context.block)
    if placement.size:
        first = context.table("first", context.shapes.first_bytes(placement))
        procedure.line(f"{_MEMORY} = bytearray({first})")
    for variable in parameters:
        bit = placement.bits.get(variable)
        if bit is not None:
            name, target = context.names.of(variable.name), procedure.storage(variable)
            make = context.link("at", Bytes.maker, variable.type)
            procedure.line(f"{target} = _placed_parameter({make}({_MEMORY}, {bit}), {name})")
            continue
        name, target = context.names.of(variable.name), procedure.storage(variable)
        if procedure.has_cell(variable) and variable.kind is not VariableKind.IN_OUT:
            procedure.line(f"{target} = _ValueCell({name})")
        elif context.framed:
            procedure.line(f"{target} = {name}")
    filled_first = _filled_first(procedure, body)
    for variable in _own(context):
        target = procedure.storage(variable)
        if variable in filled_first and variable not in placement.bits:
            continue
        if variable in placement.bits:
            make = context.link("at", Bytes.maker, variable.type)
            procedure.line(f"{target} = {make}({_MEMORY}, {placement.bits[variable]})")
            continue
        for text in initializer.statements(target, variable.type, variable.initial):
            if procedure.has_cell(variable):
                text = f"{target} = _ValueCell({text.removeprefix(f'{target} = ')})"
            procedure.line(text)
    if context.shapes.leaves:
        left = [
            variable
            for variable in left_over(context.block, context.model.program.dialect)
            if variable not in filled_first or variable in placement.bits
        ]
        if left:
            _leftovers(procedure, left)
    used = [
        (variable, bit)
        for variable, bit in start_places(context.block)
        if variable not in filled_first or variable in placement.bits
    ]
    if used:
        _start_information(procedure, used)


def _leftovers(procedure: Procedure, variables: Sequence[Variable]) -> None:
    """Write what gives temporary variables the values that were left in their places."""
    context = procedure.context
    draw = context.table("left", partial(values_left, context.block, tuple(variables)))
    values = procedure.temporary()
    procedure.line(f"{values} = {draw}(_environment)")
    for number, variable in enumerate(variables):
        _fill(procedure, variable, f"{values}[{number}]")


def _fill(procedure: Procedure, variable: Variable, value: str, indent: str = "") -> None:
    """Write what gives a variable a whole value that was made outside of the program."""
    if is_scalar(variable.type):
        procedure.line(f"{indent}{procedure.text_of(variable)} = {value}")
        return
    node = procedure.context.table("filled", VariableRef(variable.span, variable, variable.type))
    procedure.line(f"{indent}_fill({node}, {procedure.storage(variable)}, {value})")


def _start_information(procedure: Procedure, places: Sequence[tuple[Variable, int]]) -> None:
    """Write what fills the temporary variables that the operating system fills."""
    context = procedure.context
    read = partial(_start_values, tuple((bit, variable.type) for variable, bit in places))
    values = procedure.temporary()
    procedure.line("if _cpu.start:")
    procedure.line(f"    {values} = {context.table('start', read)}(_cpu.start)")
    for number, (variable, _) in enumerate(places):
        _fill(procedure, variable, f"{values}[{number}]", "    ")


def _start_values(kinds: Sequence[tuple[int, Type]], start: bytes) -> tuple[Value, ...]:
    """What stands in the start information at these bits. No closure: programs are kept."""
    return tuple(S7.read(start, bit, kind) for bit, kind in kinds)


def _function(context: BlockContext, body: Sequence[Statement]) -> Listing:
    block = context.block
    facts = context.facts
    shape = signature(block, facts)
    parameters = (*shape.inputs, *shape.in_outs)
    names = ", ".join(context.names.of(variable.name) for variable in parameters)
    counted = facts.counts_depth(block)
    name = f"_{context.python_name}_uncounted" if counted else context.python_name
    procedure = Procedure(context, name, 0, split=False)
    procedure.line(f"def {name}({names}):")
    procedure.listing.indent = 4
    _head(procedure, parameters, body)
    returned = ", ".join(procedure.text_of(variable) for variable in shape.returned)
    procedure.return_line = f"return {returned}" if returned else "return"
    write_long(procedure, body)
    procedure.listing.span = None
    procedure.line(procedure.return_line)
    procedure.listing.indent = 0
    if counted:
        procedure.line(f"def {context.python_name}({names}):")
        procedure.line(f"    _enter({block.name!r})")
        procedure.line(f"    result = {name}({names})")
        procedure.line("    _leave()")
        procedure.line("    return result")
    return procedure.listing


# --- classes ------------------------------------------------------------------------------------


def _slots(record: Record, writers: Writers | None) -> str:
    slots = [repr(part.slot) for part in record.parts if not _is_property(part)]
    if writers is not None:
        slots += [repr(name) for name in writers.room_in(record)]
    if record.size:
        slots += ["'_memory'", "'_at'"]
    return f"({', '.join(slots)}{',' if len(slots) == 1 else ''})"


def _is_property(part: Part) -> bool:
    """True for single values that lie in bytes."""
    return part.bit is not None and is_scalar(part.type)


def _class(context: BlockContext, body: Sequence[Statement]) -> Listing:
    record = context.model.block_record(context.block)
    counted = context.facts.counts_depth(context.block)
    procedure = Procedure(context, "_run", 0, split=False)
    listing = procedure.listing
    procedure.line(f"class {record.class_name}:")
    listing.indent = 4
    procedure.line(f"__slots__ = {_slots(record, writers_of(procedure))}")
    if record.size:
        _write_placed_init(context, record, listing)
    else:
        _write_init(procedure.listing, record.parts, context.initializer)
    listing.add("")
    procedure.line("def _uncounted(self):" if counted else "def _run(self):")
    listing.indent = 8
    before = len(listing.lines)
    _head(procedure, (), body)
    write_long(procedure, body)
    if len(listing.lines) == before:
        procedure.line("pass")
    listing.span = None
    listing.indent = 4
    if counted:
        procedure.line("def _run(self):")
        procedure.line(f"    _enter({context.block.name!r})")
        procedure.line("    self._uncounted()")
        procedure.line("    _leave()")
    context.tables.update(input_types(record))
    listing.indent = 0
    return listing


def _write_init(listing: Listing, parts: Sequence[Part], initializer: Initializer) -> None:
    listing.add("")
    listing.add("def __init__(self):")
    lines = [line for part in parts for line in initializer.part(f"self.{part.slot}", part)]
    for line in lines or ["pass"]:
        listing.add(f"    {line}")


def _write_placed_init(context: BlockContext, record: Record, listing: Listing) -> None:
    """The start of an instance with bytes, in a memory of its own or inside of another one's."""
    placement = context.shapes.layout.instance(context.block)
    first = context.table("first", context.shapes.first_bytes(placement))
    for part in record.parts:
        if _is_property(part):
            way = context.link("bytes", Bytes.codec, part.type)
            listing.add(f"{part.slot} = _attribute({way}, {part.bit})")
    listing.add("")
    listing.add("def __init__(self, memory=None, at=0):")
    listing.indent += 4
    listing.add(f"self._memory = bytearray({first}) if memory is None else memory")
    listing.add("self._at = at")
    listing.add("if memory is not None:")
    listing.add(f"    memory[at >> 3:(at >> 3) + {placement.size}] = {first}")
    for part in record.parts:
        if _is_property(part):
            continue
        if part.bit is None:
            lines = context.initializer.part(f"self.{part.slot}", part)
        else:
            make = context.link("at", Bytes.maker, part.type)
            lines = [f"self.{part.slot} = {make}(self._memory, at + {part.bit})"]
            if isinstance(part.initial, StructInitial) and holds_blocks(part.type):
                lines += context.initializer.changes(f"self.{part.slot}", part.type, part.initial)
        for line in lines:
            listing.add(line)
    listing.indent -= 4


def write_structures(model: Model, writers: Writers | None) -> Listing:
    """The classes of all structures; writing one may discover others."""
    listing = Listing()
    initializer = Initializer(model)
    written = 0
    while written < len(model.structures):
        _write_structure(listing, model.structures[written], initializer, writers)
        written += 1
    return listing


def _write_structure(
    listing: Listing, record: Record, initializer: Initializer, writers: Writers | None
) -> None:
    listing.add(f"class {record.class_name}:")
    listing.indent = 4
    listing.add(f"__slots__ = {_slots(record, writers)}")
    _write_init(listing, record.parts, initializer)
    listing.add("")
    listing.add("def _assign(self, other):")
    listing.indent = 8
    for part in record.parts:
        _write_copy(listing, f"self.{part.slot}", f"other.{part.slot}", part.type, 0)
    if not record.parts:
        listing.add("pass")
    listing.indent = 4
    listing.add("")
    listing.add("def _copy(self):")
    listing.add(f"    copy = {record.class_name}()")
    listing.add("    copy._assign(self)")
    listing.add("    return copy")
    listing.add("")
    listing.indent = 0


def _write_copy(listing: Listing, target: str, source: str, kind: object, depth: int) -> None:
    if isinstance(kind, StructType):
        listing.add(f"{target}._assign({source})")
    elif isinstance(kind, ArrayType):
        if is_scalar(kind.element):
            listing.add(f"{target}[:] = {source}")
            return
        one, two = f"one_{depth}", f"two_{depth}"
        listing.add(f"for {one}, {two} in zip({target}, {source}):")
        listing.indent += 4
        _write_copy(listing, one, two, kind.element, depth + 1)
        listing.indent -= 4
    else:
        listing.add(f"{target} = {source}")
