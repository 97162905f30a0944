"""Rules of the CPU families for TIA Portal sources.

Source: TIA Portal help, "Overview of the valid data types" and the attributes of blocks: optimized
access is one of S7-1200 and S7-1500.
"""

import re
from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.emit.lint.emitted import EmittedText
from fbgen.lang import ast
from fbgen.lang.families import MISSING_TYPES, Cpu
from fbgen.plant.families import PlcFamily

_OLD_CPUS: tuple[PlcFamily, ...] = ("s7-300", "s7-400")
_CPUS = {cpu.value: cpu for cpu in Cpu}
_OPTIMIZED = re.compile(r"S7_Optimized_Access\s*:=\s*'TRUE'", re.IGNORECASE)


def types_of_the_cpu(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5049: every elementary type is one that the CPU has."""
    missing = MISSING_TYPES[_CPUS[emitted.plc]] if emitted.plc in _CPUS else frozenset()
    for item in emitted.of(ast.NamedType):
        if item.name.upper() in missing:
            yield Diagnostic(
                "FB5049",
                f"{emitted.plc} has no type {item.name.upper()}",
                item.span,
                "choose a type that all families have, such as INT, DINT, WORD, DWORD or REAL",
            )


def optimized_access_of_the_cpu(emitted: EmittedText) -> Iterator[Diagnostic]:
    """FB5053: blocks of S7-300 and S7-400 have no optimized access."""
    if emitted.plc not in _OLD_CPUS:
        return
    for unit in emitted.file.units:
        if isinstance(unit, ast.Block | ast.DataBlock):
            for item in unit.header:
                if _OPTIMIZED.search(item.text):
                    yield Diagnostic(
                        "FB5053",
                        f"'{unit.name.name}' asks for optimized access, "
                        f"which {emitted.plc} has not",
                        item.span,
                        "write S7_Optimized_Access := 'FALSE'",
                    )


RULES = (types_of_the_cpu, optimized_access_of_the_cpu)
