"""The symbol table of a classic program: which number each block and data type has.

STEP 7 V5 compiles a source only when all names in it are known. The table is imported first; it is
written in the System Data Format, one line for each symbol: name, address, data type, comment, each
filled up with blanks. Source: "Programming with STEP 7", 8.6 "File formats for importing/exporting
a symbol table"; exported tables of published projects for the widths and the line ends.
"""

from collections import Counter
from collections.abc import Sequence

from fbgen.diagnostics import error
from fbgen.lang import ast
from fbgen.plant import BlockNumbers, Plant, buffer_numbers, with_prefix

LINE_END = "\r\n"
_KINDS = {ast.BlockKind.FUNCTION: "FC", ast.BlockKind.FUNCTION_BLOCK: "FB"}
_COMMENT = 80

Unit = ast.Block | ast.DataBlock | ast.TypeDeclaration


def symbol_table(units: Sequence[ast.Unit], plant: Plant) -> str:
    """The table for these units, with numbers of the plant's range; lines end with LF.

    Raises DiagnosticError FB5011 where the range is too small.
    """
    named = [unit for unit in units if isinstance(unit, Unit) and not _has_its_number(unit)]
    addresses = {
        name: f"{kind}{number:>{9 - len(kind)}}"
        for name, (kind, number) in numbers_of(units, plant).items()
    }
    return "".join(
        f'"{unit.name.name:<24}","{addresses[unit.name.name]}   ",'
        f'"{_data_type(unit, addresses)} ","{_title(unit):<{_COMMENT}}"\n'
        for unit in named
    )


def numbers_of(units: Sequence[ast.Unit], plant: Plant) -> dict[str, tuple[str, int]]:
    """Kind and number of each unit: each kind counts from the first number.

    Raises DiagnosticError FB5011 where the range is too small.
    """
    numbers = plant.block_numbers
    counts: Counter[str] = Counter()
    found: dict[str, tuple[str, int]] = {}
    fixed = {
        with_prefix(name, plant.prefix): number for name, number in buffer_numbers(plant).items()
    }
    for unit in units:
        if isinstance(unit, Unit) and not _has_its_number(unit):
            kind = _kind(unit)
            if unit.name.name in fixed:
                found[unit.name.name] = kind, fixed[unit.name.name]
                continue
            found[unit.name.name] = kind, numbers.first + counts[kind]
            counts[kind] += 1
    for kind, count in counts.items():
        taken = len(fixed) if kind == "DB" else 0
        if count + taken > _room(numbers):
            needed = count + taken
            raise error(
                "FB5011",
                f"the plant needs {needed} {kind}s, and {_room(numbers)} numbers are free for them",
                numbers.span_of("last"),
                f"let block_numbers end at {numbers.first + needed - 1} or later",
            )
    return found


def _room(numbers: BlockNumbers) -> int:
    return numbers.last - numbers.first + 1


def _has_its_number(unit: Unit) -> bool:
    """Organization blocks are called by their numbers."""
    return isinstance(unit, ast.Block) and unit.kind is ast.BlockKind.ORGANIZATION_BLOCK


def _kind(unit: Unit) -> str:
    if isinstance(unit, ast.Block):
        return _KINDS[unit.kind]
    return "DB" if isinstance(unit, ast.DataBlock) else "UDT"


def _data_type(unit: Unit, addresses: dict[str, str]) -> str:
    """What the symbol is: for a data block of a function block or a data type that one."""
    if isinstance(unit, ast.DataBlock) and unit.type is not None:
        return addresses[unit.type.name]
    return addresses[unit.name.name]


def _title(unit: Unit) -> str:
    title = next((item.text.strip("'") for item in unit.header if item.keyword == "TITLE"), "")
    return title.replace('"', "'")[:_COMMENT]
