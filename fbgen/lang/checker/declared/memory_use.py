"""What is reached besides its name, and therefore lies in bytes; the numbers of data blocks.

A data block has the number that the project gives it (`numbers`), or the one in its name (`DB100`).
One that the text itself needs a number for gets one that nobody else has, from the top down.
Absolute addresses reach blocks with standard access only; a source that says nothing about
`S7_Optimized_Access` counts as standard.
"""

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING

from fbgen.lang import ast
from fbgen.lang.checked import Block, Variable, VariableKind
from fbgen.lang.checker.findings import Findings
from fbgen.lang.layout import holds_values
from fbgen.lang.types import ArrayType, BlockType, StructType, Type
from fbgen.nearest import nearest

if TYPE_CHECKING:
    from fbgen.lang.checker.library import Library

_NUMBERED = re.compile(r"db([0-9]{1,5})")
_OPTIMIZED = re.compile(r"S7_Optimized_Access\s*:=\s*'TRUE'", re.IGNORECASE)
_HIGHEST = 65535


def is_optimized(header: tuple[ast.HeaderItem, ...]) -> bool:
    """True if the header says that the block has no byte layout."""
    return any(item.keyword == "{}" and _OPTIMIZED.search(item.text) for item in header)


class MemoryUse:
    """Collects what the text does with memory while it is checked."""

    __slots__ = (
        *("_addressed", "_any_block", "_declared", "_given", "_names", "_numbers", "_overlaid"),
        "optimized",
    )

    def __init__(self, numbers: Mapping[str, int]) -> None:
        self._names = tuple(numbers)
        self._given = {name.casefold(): number for name, number in numbers.items()}
        self._declared: dict[str, str] = {}
        self._numbers: dict[int, Variable] = {}
        self._addressed: set[Variable] = set()
        self._overlaid: set[Variable] = set()
        self._any_block = False
        self.optimized: set[Variable] = set()

    def declare(self, variable: Variable, optimized: bool) -> None:
        """A data block; it has a number if somebody gives it one."""
        key = variable.name.casefold()
        self._declared[key] = variable.name
        match = _NUMBERED.fullmatch(key)
        number = self._given.get(key, int(match.group(1)) if match else None)
        if number is not None:
            self._numbers.setdefault(number, variable)
        if optimized:
            self.optimized.add(variable)

    def report_strangers(self, findings: Findings) -> None:
        """FB4062: a number is given to a data block that is in none of the files."""
        for name in self._names:
            if name.casefold() not in self._declared:
                findings.error(
                    "FB4062",
                    f"a number is given to '{name}', which is no data block",
                    None,
                    nearest(name, self._declared.values()),
                )

    def overlay(self, variable: Variable, root: Variable) -> None:
        """A variable lies over another one."""
        self._overlaid |= {variable, root}

    def block_with(self, number: int) -> Variable | None:
        """The data block of a number."""
        return self._numbers.get(number)

    def number_of(self, variable: Variable) -> int:
        """The number of a data block that is used by its bytes."""
        self._addressed.add(variable)
        for number, known in self._numbers.items():
            if known is variable:
                return number
        number = next(n for n in range(_HIGHEST, 0, -1) if n not in self._numbers)
        self._numbers[number] = variable
        return number

    def address(self, number: int) -> None:
        """The bytes of the data block with that number are used."""
        variable = self._numbers.get(number)
        if variable is not None:
            self._addressed.add(variable)

    def address_any(self) -> None:
        """Which data block is used shows only when the program runs."""
        self._any_block = True

    @property
    def numbers(self) -> Mapping[int, Variable]:
        """The data blocks that have a number."""
        return self._numbers

    def byte_memory(self, library: "Library") -> frozenset[Variable]:
        """All variables that lie in bytes."""
        found = set(self._overlaid)
        found |= self._addressed - self.optimized
        if self._any_block:
            found |= set(self._numbers.values()) - self.optimized
        whole: set[Block] = set()
        for variable in list(found):
            if variable.kind is VariableKind.GLOBAL:
                _lay_out(library, variable.type, whole)
        for block in whole:
            found |= {v for v in block.variables if _lives(v) and holds_values(v.type)}
        return frozenset(found)


def _lives(variable: Variable) -> bool:
    return variable.address is None and variable.kind not in (
        VariableKind.TEMP,
        VariableKind.RESULT,
    )


def _lay_out(library: "Library", kind: Type, whole: set[Block]) -> None:
    """Add the function blocks whose instances a variable of the type is or holds."""
    if isinstance(kind, ArrayType):
        _lay_out(library, kind.element, whole)
    elif isinstance(kind, StructType):
        for field in kind.fields:
            _lay_out(library, field.type, whole)
    elif isinstance(kind, BlockType):
        block = library.user_block(kind.name)
        if block is not None and block not in whole:
            whole.add(block)
            for variable in block.variables:
                if _lives(variable):
                    _lay_out(library, variable.type, whole)
