"""What a person can look at from outside: the variables of a data block, down to single values.

They are taken from the checked program, so that a list names exactly what is in the PLC. Comments
are those of the data types.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from typing import NamedTuple

from fbgen.dataclass import dataclass
from fbgen.lang import ast
from fbgen.lang.checked import Program
from fbgen.lang.layout import S7_SIZES
from fbgen.lang.types import Elementary, StringType, StructType, Type

_SPELLING = {
    "BOOL": "Bool",
    "BYTE": "Byte",
    "WORD": "Word",
    "DWORD": "DWord",
    "INT": "Int",
    "DINT": "DInt",
    "REAL": "Real",
    "TIME": "Time",
}
"""Elementary types as TIA Portal spells them."""


@dataclass(frozen=True, slots=True, eq=False)
class PlcVariable:
    """A single value in a data block; each is one object.

    `path` are the names below the data block. `bit` is its first bit from the beginning of the
    block where the block has the classic layout.
    """

    block: str
    path: tuple[str, ...]
    type: Type
    comment: str
    bit: int

    @property
    def name(self) -> str:
        """As in an HMI, a watch list, and in IEC text: `TOS_Plant.gw1.line.online`."""
        return ".".join((self.block, *self.path))

    @property
    def quoted(self) -> str:
        """As a watch table of TIA Portal or STEP 7 wants it: `"TOS_Plant".gw1.line.online`."""
        return ".".join((f'"{self.block}"', *self.path))

    @property
    def type_name(self) -> str:
        """The type without the length of a text: `Bool`, `Word`, `String`."""
        if isinstance(self.type, StringType):
            return "String"
        return _SPELLING[self.type.name]

    @property
    def size(self) -> int:
        """Bytes, for a text the number of its characters."""
        if isinstance(self.type, StringType):
            return self.type.length
        return S7_SIZES.size_bytes(self.type)

    def address(self, number: int) -> str:
        """The absolute address in data block `number` with the classic layout: `DB200.DBX4.1`."""
        byte, bit = divmod(self.bit, 8)
        if self.type_name == "Bool":
            return f"DB{number}.DBX{byte}.{bit}"
        width = {1: "B", 2: "W", 4: "D"}.get(self.size, "B") if self.is_number else "B"
        return f"DB{number}.DB{width}{byte}"

    @property
    def is_number(self) -> bool:
        """False for texts, which have no single address."""
        return isinstance(self.type, Elementary)


def variables(
    program: Program, units: Sequence[ast.File], block: str, left_out: Iterable[str] = ()
) -> tuple[PlcVariable, ...]:
    """Every single value in a data block that is a structure, in the order of declaration.

    Of structures of the types `left_out` there is nothing.
    """
    kind = program.globals[block.casefold()].type
    assert isinstance(kind, StructType), "only data blocks with a structure of their own"
    parts = _Parts(_comments(units), {name.casefold() for name in left_out})
    return tuple(
        PlcVariable(block, part.path, part.type, part.comment, part.bit)
        for part in parts.inside(kind)
    )


class _Part(NamedTuple):
    """A single value in a structure, counted from its beginning."""

    path: tuple[str, ...]
    type: Elementary | StringType
    comment: str
    bit: int


class _Parts:
    """The single values in structures. A plant has hundreds of drives and one type of drive."""

    def __init__(self, comments: Mapping[tuple[str, str], str], left_out: Set[str]) -> None:
        self._comments = comments
        self._left_out = left_out
        self._known: dict[int, list[_Part]] = {}

    def inside(self, kind: StructType) -> list[_Part]:
        """Those of a structure and of the structures in it, in the order of declaration."""
        if id(kind) not in self._known:
            self._known[id(kind)] = list(self._found(kind))
        return self._known[id(kind)]

    def _found(self, kind: StructType) -> Iterator[_Part]:
        for field, start in S7_SIZES.placed(kind):
            name = (field.name,)
            if isinstance(field.type, StructType):
                if field.type.name.casefold() in self._left_out:
                    continue
                for path, of_type, comment, bit in self.inside(field.type):
                    yield _Part(name + path, of_type, comment, start + bit)
            elif isinstance(field.type, Elementary | StringType):
                comment = self._comments.get((kind.name.casefold(), field.name.casefold()), "")
                yield _Part(name, field.type, comment, start)


def _comments(units: Sequence[ast.File]) -> dict[tuple[str, str], str]:
    """The comments behind the parts of all data types, by type and part."""
    found = {}
    for file in units:
        for unit in file.units:
            if isinstance(unit, ast.TypeDeclaration) and isinstance(unit.type, ast.StructSpec):
                for declaration in unit.type.fields:
                    text = _text(declaration.trailing)
                    for name in declaration.names:
                        found[unit.name.name.casefold(), name.name.casefold()] = text
    return found


def _text(comment: ast.Trivia | None) -> str:
    if comment is None:
        return ""
    return comment.text.removeprefix("//").removeprefix("(*").removesuffix("*)").strip()
