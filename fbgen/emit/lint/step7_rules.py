"""Rules of STEP 7 V5 for classic SCL sources.

The parser already refuses what the dialect has not (REGION, slices, `+=`, VAR CONSTANT); here
stands what is only wrong for the compiler of S7-SCL, or for STEP 7's symbol table. Sources: S7-SCL
V5.3 manual, 9.1.3 "Notation for Constants"; "Programming with STEP 7", 13.2.3 "Rules for Block
Order"; published classic sources for headers, calls of instances and the order of sections.
"""

import re
from collections.abc import Iterator, Mapping

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang import ast
from fbgen.lang.dialects import dialect_named
from fbgen.lang.walk import walk

_Named = ast.Block | ast.DataBlock | ast.TypeDeclaration
_LONGEST_NAME = dialect_named("step7").identifier_length
_LONGEST_HEADER = 8
_SHORT = ("AUTHOR", "FAMILY", "NAME")
_QUOTED = ("TITLE", "VERSION")
_SECTIONS = ("CONST", "LABEL", "VAR_INPUT", "VAR_OUTPUT", "VAR_IN_OUT", "VAR", "VAR_TEMP")
_BEGIN = re.compile(r"^\s*BEGIN\b", re.MULTILINE | re.IGNORECASE)
_EDGES = frozenset({"R_TRIG", "F_TRIG"})
_TIA_ATTRIBUTES = re.compile(r"S7_Optimized_Access|InstructionName", re.IGNORECASE)


def names_not_too_long(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5054: a symbol or variable has at most 24 characters."""
    for item in emitted.names_longer_than(_LONGEST_NAME):
        yield Diagnostic(
            "FB5054",
            f"the name '{item.name}' has {len(item.name)} characters",
            item.span,
            f"STEP 7 takes {_LONGEST_NAME}; shorten the names in the plant file",
        )


def header_as_step7_reads_it(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5055: AUTHOR, FAMILY, NAME of eight characters, TITLE, VERSION in quotes, none at a UDT."""
    for unit in emitted.file.units:
        if isinstance(unit, ast.TypeDeclaration):
            for item in unit.header:
                message = f"the data type '{unit.name.name}' has a header"
                yield Diagnostic("FB5055", message, item.span, "write a comment above it")
        if not isinstance(unit, ast.Block | ast.DataBlock):
            continue
        for item in unit.header:
            text = item.text.strip("'")
            if item.keyword in _SHORT and len(text) > _LONGEST_HEADER:
                message = f"{item.keyword} of '{unit.name.name}' has {len(text)} characters"
                yield Diagnostic("FB5055", message, item.span, f"at most {_LONGEST_HEADER}")
            elif item.keyword in _QUOTED and not (
                item.text.startswith("'") and item.text.endswith("'")
            ):
                message = f"{item.keyword} of '{unit.name.name}' stands without quotes"
                yield Diagnostic("FB5055", message, item.span, f"{item.keyword} = '{text}'")


def sections_in_order(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5056: each section once and in the usual order, BEGIN behind the last one."""
    for unit in emitted.file.units:
        if not isinstance(unit, ast.Block):
            continue
        before = -1
        for section in unit.sections:
            keyword = "CONST" if "CONSTANT" in section.qualifiers else section.keyword
            place = _SECTIONS.index(keyword) if keyword in _SECTIONS else before
            if place <= before:
                yield Diagnostic(
                    "FB5056",
                    f"{keyword} stands twice or too late in '{unit.name.name}'",
                    section.span,
                    f"the order is {', '.join(_SECTIONS)}",
                )
            before = max(before, place)
        if not _BEGIN.search(unit.span.text):
            yield Diagnostic(
                "FB5056",
                f"'{unit.name.name}' has no BEGIN",
                unit.name.span,
                "write BEGIN in front of the first statement",
            )


def declared_before_use(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5057: blocks, data blocks and types stand in front of what uses them."""
    units = [unit for unit in emitted.file.units if isinstance(unit, _Named)]
    waiting = {unit.name.name.casefold(): unit for unit in units}
    for unit in units:
        for item in walk(unit):
            if not isinstance(item, ast.Name | ast.NamedType) or not item.quoted:
                continue
            used = waiting.get(item.name.casefold())
            if used is not None and used is not unit:
                yield Diagnostic(
                    "FB5057",
                    f"'{item.name}' is used before it is declared",
                    item.span,
                    "STEP 7 compiles a source from its beginning: put it further up",
                )
        waiting.pop(unit.name.name.casefold(), None)


def calls_of_instances(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5058: a global instance behind its block, no outputs in the call of an instance."""
    instances = {
        unit.name.name.casefold(): unit.type.name
        for unit in emitted.file.units
        if isinstance(unit, ast.DataBlock) and unit.type is not None
    }
    for item in emitted.of(ast.CallStatement):
        callee = item.call.callee
        if isinstance(callee, ast.Name) and callee.quoted:
            yield from _called_alone(callee, instances)
        for argument in item.call.arguments:
            if argument.kind is ast.ArgumentKind.OUTPUT:
                yield Diagnostic(
                    "FB5058",
                    f"the output {argument.name} stands in the call",
                    argument.span,
                    f"read it behind the call: {callee.span.text}.{argument.name}",
                )


def _called_alone(callee: ast.Name, instances: Mapping[str, str]) -> Iterator[Diagnostic]:
    block = instances.get(callee.name.casefold())
    if block is not None:
        yield Diagnostic(
            "FB5058",
            f"the data block '{callee.name}' is called without its block",
            callee.span,
            f'write "{block}"."{callee.name}"(...)',
        )


def numbers_with_their_type(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5059: `16#7001` is an integer to S7-SCL, which no bit string takes, but CASE does."""
    labels = [item.labels for item in emitted.of(ast.CaseArm)]
    integers = {id(item) for item in walk(tuple(labels))}
    for item in emitted.of(ast.Literal):
        if (
            id(item) not in integers
            and item.kind is ast.LiteralKind.INTEGER
            and "#" in item.text
            and not item.type_name
        ):
            yield Diagnostic(
                "FB5059",
                f"{item.text} has no type",
                item.span,
                f"write B#{item.text}, W#{item.text} or DW#{item.text}",
            )


def nothing_of_tia_portal(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5060: blocks and attributes that only TIA Portal knows."""
    for header in emitted.of(ast.HeaderItem):
        if _TIA_ATTRIBUTES.search(header.text):
            message = "an attribute of TIA Portal stands in the header"
            yield Diagnostic("FB5060", message, header.span, "leave it out")
    for item in emitted.of(ast.NamedType):
        if item.name.upper() in _EDGES and not item.quoted:
            yield Diagnostic(
                "FB5060",
                f"STEP 7 has no block {item.name}",
                item.span,
                "keep the last value in a variable and compare with it",
            )


RULES = (
    names_not_too_long,
    header_as_step7_reads_it,
    sections_in_order,
    declared_before_use,
    calls_of_instances,
    numbers_with_their_type,
    nothing_of_tia_portal,
)
