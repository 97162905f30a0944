"""Calls from outside as Python source: they check the inputs, store them, and run the block.

A function that takes the inputs as keywords is the fastest way, because Python then builds no
mapping. It is written when somebody calls an instance of the block for the first time.
"""

from collections.abc import Sequence

from fbgen.lang.checked import Block, VariableKind
from fbgen.lang.types import BOOL, ReferenceType, Subrange, Type
from harness.engine.compiled.code import Listing
from harness.engine.compiled.data.model import Part, Record, is_scalar
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.shortening.ranges import is_counted, limits


def _inputs(record: Record) -> Sequence[Part]:
    """Inputs and kept in-outs that are single values; the others are set one by one."""
    kinds = (VariableKind.INPUT, VariableKind.KEPT)
    return [part for part in record.parts if part.kind in kinds and is_scalar(part.type)]


def _type_name(record: Record, part: Part) -> str:
    return f"_{record.class_name}_{part.slot}_type"


def input_types(record: Record) -> dict[str, Type]:
    """The types that the checks name, by their module-level names."""
    return {_type_name(record, part): part.type for part in _inputs(record)}


def _is_plain(part: Part, value: str) -> str:
    """The condition under which a value is one of the type as it is; "" if that is not so easy."""
    if part.type == BOOL:
        return f"{value} is True or {value} is False"
    if is_counted(part.type) and not isinstance(part.type, Subrange):
        low, high = limits(part.type)
        # Two comparisons, as Python keeps the value aside for one with both ends.
        return f"_type({value}) is int and {value} <= {high} and {value} >= {low}"
    return ""


def _accepted(record: Record, part: Part, value: str) -> str:
    """What the library makes of a value, or says against it; FALSE unbinds a reference."""
    accepted = f"_accept({part.name!r}, {_type_name(record, part)}, {value})"
    return f"{accepted} or None" if isinstance(part.type, ReferenceType) else accepted


def _write_start(listing: Listing, facts: Facts, block: Block) -> None:
    if facts.counts_passes(block):
        listing.add("_cpu.passes = _cpu.most_passes")
    if facts.counts_depth(block):
        listing.add("_cpu.depth = 0")


def write_keyword_call(record: Record, facts: Facts, block: Block) -> Listing:
    """A function `_make(_data, _convert)` that makes one with the inputs of `_data` as keywords.

    What is no single value, is named in another way than it was declared, or is no input at all,
    arrives in `_others`: `_set_others` sees to it.
    """
    inputs = [part for part in _inputs(record) if part.slot == part.name]
    names = "".join(f"{part.slot}=_keep, " for part in inputs)
    only = "*, " if inputs else ""
    listing = Listing()
    listing.add("def _make(_data, _convert):")
    listing.indent = 4
    listing.add("_run = _data._run")
    listing.add(f"def _call({only}{names}**_others):")
    listing.indent = 8
    listing.add("try:")
    listing.indent = 12
    _write_start(listing, facts, block)
    for part in inputs:
        slot, keyword = part.slot, "if"
        if part.type == BOOL:
            # Most of them are as they were, and then there is nothing to check or to store.
            listing.add(f"if {slot} is _data.{slot}: pass")
            keyword = "elif"
        if plain := _is_plain(part, slot):
            listing.add(f"{keyword} {plain}: _data.{slot} = {slot}")
            keyword = "elif"
        listing.add(f"{keyword} {slot} is not _keep:")
        listing.add(f"    _data.{slot} = {_accepted(record, part, slot)}")
    listing.add("if _others: _set_others(_data, _convert(_others))")
    listing.add("_run()")
    listing.indent = 8
    listing.add("except Exception as _exception:")
    listing.add("    _stopped = _stopped_by(_exception)")
    listing.add("    if _stopped is _exception: raise")
    listing.add("    raise _stopped from None")
    listing.indent = 4
    listing.add("return _call")
    return listing
