"""Lines that note who has written a variable or an output, behind each write of generated code.

Nothing is written without a probe that wants to know. Notes read nothing but attributes and what
the write itself has read, so they change nothing. What is written through a pointer that is worked
out at run time (POKE, ANY) is not noted.
"""

from fbgen.lang.checked import (
    Assignment,
    Branch,
    Case,
    CaseArm,
    Constant,
    Expression,
    FieldRef,
    For,
    If,
    IndexRef,
    Place,
    Repeat,
    SliceRef,
    Try,
    Variable,
    VariableKind,
    VariableRef,
    While,
)
from fbgen.lang.types import ArrayType, BlockType, Elementary, StructType, Type
from fbgen.source import Span
from harness.engine.compiled.data.model import Model, has_memory, is_scalar
from harness.engine.compiled.evaluation import value
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.walk import children, every_node
from harness.engine.compiled.watching.writers import Elements, Shape, Writers

_DEEPEST_ORIGIN = 5
_FORKS = (If, Branch, Case, CaseArm, For, While, Repeat, Try)


def writers_of(procedure: Procedure) -> Writers | None:
    """Where notes go; None if nobody wants them."""
    probe = procedure.context.probe
    return probe.writers if probe is not None else None


def note_write(procedure: Procedure, text: str, kind: Type, entry: str = "") -> None:
    """Behind the write of what this Python text names; `entry` if somebody else is the writer."""
    writers = writers_of(procedure)
    if writers is None:
        return
    entry = entry or entry_text(procedure, writers)
    if is_scalar(kind):
        line = _note(procedure, writers, text, entry)
    else:
        line = _note_whole(procedure, writers, text, kind, entry)
    if line:
        procedure.forget_sites()
        procedure.line(line)


def note_elements(procedure: Procedure, text: str, count: str, kind: Type) -> None:
    """Behind an instruction that writes so many elements, from the one with this text on."""
    writers = writers_of(procedure)
    if writers is None:
        return
    base, index = _split_index(text)
    shape = procedure.context.table("shape", shape_of(kind, procedure.context.model))
    entry = entry_text(procedure, writers)
    procedure.forget_sites()
    procedure.line(f"_wrote_elements({base}, {index}, {count}, {shape}, {entry})")


def note_outputs(procedure: Procedure, byte: int, count: int) -> None:
    """Behind a write of outputs: the writer is who wrote the variable that went there."""
    writers = writers_of(procedure)
    if writers is None:
        return
    entry = entry_text(procedure, writers)
    if procedure.assigned is not None:
        place = origin(procedure, procedure.assigned)
        if place is not None:
            procedure.forget_sites()
            text = value(procedure, place).text
            entry = _known_entry(procedure, writers, text, entry)
    procedure.forget_sites()
    procedure.line(f"_wrote_outputs({byte}, {count}, {entry})")


def note_record(procedure: Procedure, laddr: str, area: Place) -> None:
    """Behind an instruction that writes an area to a module."""
    writers = writers_of(procedure)
    if writers is None or is_scalar(area.type):
        return
    procedure.forget_sites()
    shape = procedure.context.table("shape", shape_of(area.type, procedure.context.model))
    text = value(procedure, area).text
    procedure.forget_sites()
    procedure.line(f"_wrote_record({laddr}, {text}, {shape}, {entry_text(procedure, writers)})")


def entry_text(procedure: Procedure, writers: Writers, part: Span | None = None) -> str:
    """The entry of the present statement, or of a part of it, such as an argument of a call."""
    block = procedure.context.block
    span = part or procedure.listing.span
    assert span is not None, "statements have places"
    this = "self" if has_memory(block) else "None"
    return f"({writers.number(span, block)}, {this})"


def argument_entry(procedure: Procedure, argument: Expression) -> str:
    """The entry of an argument of the present call; "" for no notes."""
    writers = writers_of(procedure)
    return "" if writers is None else entry_text(procedure, writers, argument.span)


def passed_entry(procedure: Procedure, text: str) -> str:
    """The entry of what a block has done with an in-out, else that of the call; "" for no notes."""
    writers = writers_of(procedure)
    if writers is None:
        return ""
    owner, _, slot = text.rpartition(".")
    return f"(_taken_from({owner}, {slot!r}) or {entry_text(procedure, writers)})"


def _note_whole(procedure: Procedure, writers: Writers, text: str, kind: Type, entry: str) -> str:
    shape = shape_of(kind, procedure.context.model)
    if not isinstance(shape, Elements | int) and _is_flat(shape):
        name = procedure.temporary()
        procedure.line(f"{name} = {text}")
        places = (_place_of_entry(procedure, writers, name, slot) for slot, _ in shape)
        return " = ".join((*places, entry))
    return f"_wrote_whole({text}, {procedure.context.table('shape', shape)}, {entry})"


def _is_flat(shape: tuple[tuple[str, Shape], ...]) -> bool:
    """True for single values only."""
    return all(isinstance(inner, int) for _, inner in shape)


def _note(procedure: Procedure, writers: Writers, text: str, entry: str) -> str:
    if text.endswith("]"):
        base, index = _split_index(text)
        table = procedure.context.shared_table("_writer_of_elements", writers.elements)
        return f"{table}[id({base}), {index}] = {entry}"
    owner, _, slot = text.rpartition(".")
    if not owner:
        return ""  # a local of Python's
    if slot == "value":
        return f"_wrote_cell({owner}, {entry})"
    return f"{_place_of_entry(procedure, writers, owner, slot)} = {entry}"


def _place_of_entry(procedure: Procedure, writers: Writers, owner: str, slot: str) -> str:
    """Where the entry of an attribute stands. A frame holds what nobody asks for from outside."""
    beside = None if owner == "frame" else writers.beside(slot)
    if beside is not None:
        return f"{owner}.{beside}"
    return f"{_table(procedure, writers, slot)}[id({owner})]"


def _known_entry(procedure: Procedure, writers: Writers, text: str, other: str) -> str:
    if text.endswith("]"):
        base, index = _split_index(text)
        table = procedure.context.shared_table("_writer_of_elements", writers.elements)
        return f"{table}.get((id({base}), {index}), {other})"
    owner, _, slot = text.rpartition(".")
    if not owner or slot == "value":
        return other
    if (beside := writers.beside(slot)) is not None and owner != "frame":
        return f"(getattr({owner}, {beside!r}, None) or {other})"
    return f"{_table(procedure, writers, slot)}.get(id({owner}), {other})"


def _table(procedure: Procedure, writers: Writers, slot: str) -> str:
    return procedure.context.shared_table(f"_writer_of_{slot}", writers.table(slot))


def _split_index(text: str) -> tuple[str, str]:
    """The list and the position of `list[position]`."""
    depth = 0
    for at in range(len(text) - 1, -1, -1):
        depth += (text[at] == "]") - (text[at] == "[")
        if not depth:
            return text[:at], text[at + 1 : -1]
    raise AssertionError(text)


def shape_of(kind: Type, model: Model) -> Shape:
    """What there is in data of a type."""
    if isinstance(kind, ArrayType):
        return Elements(shape_of(kind.element, model))
    if isinstance(kind, StructType | BlockType):
        record = model.record_of(kind)
        return tuple((part.slot, shape_of(part.type, model)) for part in record.parts)
    return max(1, kind.bits // 8) if isinstance(kind, Elementary) else 1


def is_simple(node: Expression) -> bool:
    """True for constants and variables that Python reads without doing anything else."""
    if isinstance(node, VariableRef):
        return node.variable.address is None
    return isinstance(node, Constant)


def is_steady(target: Place) -> bool:
    """True if the Python text of a place may be evaluated once more behind a write to it."""
    return all(
        is_simple(index)
        for node in every_node((target,))
        if isinstance(node, IndexRef)
        for index in node.indices
    )


# --- where a value comes from -------------------------------------------------------------------


def origin(procedure: Procedure, node: Expression, depth: int = 0) -> Place | None:
    """The one variable from which a value is made; None for none or for several.

    A temporary variable stands for what the statements just before have filled it with.
    """
    places = _outermost(node)
    if len(places) != 1 or depth == _DEEPEST_ORIGIN:
        return None
    [place] = places
    if isinstance(place, SliceRef):
        return origin(procedure, place.base, depth + 1)
    if not is_plain(place):
        return None
    if isinstance(place, VariableRef) and _is_temporary(place.variable):
        filled = _filling(procedure, place.variable)
        return None if filled is None else origin(procedure, filled.value, depth + 1)
    return place


def _outermost(node: Expression) -> list[Place]:
    if isinstance(node, Place):
        return [node]
    return [
        place
        for inner in children(node)
        if isinstance(inner, Expression)
        for place in _outermost(inner)
    ]


def is_plain(place: Place) -> bool:
    """True for variables, fields and elements that Python reads without doing anything else."""
    node: Expression = place
    while not isinstance(node, VariableRef):
        if isinstance(node, IndexRef):
            if not is_steady(node):
                return False
            node = node.base
        elif isinstance(node, FieldRef) and isinstance(node.base.type, StructType):
            node = node.base
        else:
            return False
    return node.variable.address is None


def _is_temporary(variable: Variable) -> bool:
    return variable.kind is VariableKind.TEMP and is_scalar(variable.type)


def _filling(procedure: Procedure, variable: Variable) -> Assignment | None:
    """What has filled a variable before the present statement; None if that depends on the way."""
    here = procedure.listing.span
    body = list(every_node(procedure.context.model.program.bodies[procedure.context.block]))
    before = [
        node
        for node in body
        if isinstance(node, Assignment)
        and isinstance(node.target, VariableRef)
        and node.target.variable is variable
        and here is not None
        and node.span.start < here.start
    ]
    if not before or here is None:
        return None
    filling = max(before, key=lambda node: node.span.start)
    forks = (node.span for node in body if isinstance(node, _FORKS))
    together = all(_inside(here, fork) == _inside(filling.span, fork) for fork in forks)
    return filling if together else None


def _inside(inner: Span, outer: Span) -> bool:
    return outer.start <= inner.start and inner.end <= outer.end
