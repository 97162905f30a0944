"""Calls from outside as Python source: they check the inputs, store them, and run the block.

Every block has a method that takes a mapping. A function that takes the inputs as keywords is
faster still, because Python then builds no mapping; it is made for those who ask for it.
"""

from collections.abc import Sequence

from fbgen.lang.checked import Block, VariableKind
from fbgen.lang.types import BOOL, Type
from harness.engine.compiled.code import Listing
from harness.engine.compiled.facts import Facts
from harness.engine.compiled.model import Part, Record, is_scalar
from harness.engine.compiled.ranges import is_counted, limits


def _inputs(record: Record) -> Sequence[Part]:
    """The inputs that are single values; the others are set one by one."""
    return [
        part for part in record.parts if part.kind is VariableKind.INPUT and is_scalar(part.type)
    ]


def _type_name(record: Record, part: Part) -> str:
    return f"_{record.class_name}_{part.slot}_type"


def input_types(record: Record) -> dict[str, Type]:
    """The types that the checks name, by their module-level names."""
    return {_type_name(record, part): part.type for part in _inputs(record)}


def _is_plain(part: Part, value: str) -> str:
    """The condition under which a value is one of the type as it is; "" if that is not so easy."""
    if part.type == BOOL:
        return f"{value} is True or {value} is False"
    if is_counted(part.type):
        low, high = limits(part.type)
        return f"_type({value}) is int and {low} <= {value} <= {high}"
    return ""


def _accepted(record: Record, part: Part, value: str) -> str:
    """What the library makes of a value, or says against it."""
    return f"_accept({part.name!r}, {_type_name(record, part)}, {value})"


def _write_start(listing: Listing, facts: Facts, block: Block) -> None:
    if facts.counts_passes(block):
        listing.add("_cpu.passes = _cpu.most_passes")
    if facts.counts_depth(block):
        listing.add("_cpu.depth = 0")


def write_call(listing: Listing, record: Record, facts: Facts, block: Block) -> None:
    """The method of a block that takes its inputs as a mapping."""
    listing.add("")
    listing.add("def _call(self, inputs):")
    listing.indent += 4
    _write_start(listing, facts, block)
    listing.add("others = len(inputs)")
    for part in _inputs(record):
        listing.add(f"if {part.name!r} in inputs:")
        listing.add(f"    value = inputs[{part.name!r}]")
        listing.add("    others -= 1")
        plain, accepted = _is_plain(part, "value"), _accepted(record, part, "value")
        text = f"value if {plain} else {accepted}" if plain else accepted
        listing.add(f"    self.{part.slot} = {text}")
    listing.add("if others: _set_others(self, inputs)")
    if any(part.kind is VariableKind.IN_OUT for part in record.parts):
        listing.add("_connect(self)")
    listing.add("self._run()")
    listing.indent -= 4


def write_keyword_call(record: Record, facts: Facts, block: Block) -> Listing:
    """A function `make(data)` that gives a function with the inputs of `data` as keywords."""
    listing = Listing()
    keywords = "".join(f"{part.slot}=_keep, " for part in _inputs(record))
    listing.add("def make(data):")
    listing.indent = 4
    listing.add("run = data._run")
    listing.add(f"def call({keywords.removesuffix(', ')}):")
    listing.indent = 8
    listing.add("try:")
    listing.indent = 12
    _write_start(listing, facts, block)
    for part in _inputs(record):
        keyword = "if"
        if plain := _is_plain(part, part.slot):
            listing.add(f"if {plain}: data.{part.slot} = {part.slot}")
            keyword = "elif"
        listing.add(f"{keyword} {part.slot} is not _keep:")
        listing.add(f"    data.{part.slot} = {_accepted(record, part, part.slot)}")
    listing.add("run()")
    listing.indent = 8
    listing.add("except Exception as exception: raise _stopped(exception) from None")
    listing.indent = 4
    listing.add("return call")
    return listing
