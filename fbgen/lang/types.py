"""The types of the PLC languages, with their width, and how values of them look at run time.

At run time a value is a plain Python object: BOOL a `bool`; bit strings, integers, TIME and dates
an `int`; REAL and LREAL a `float` (REAL already rounded to 32 bit); CHAR and STRING a `str` of
characters below 256, WCHAR and WSTRING a `str`. TIME counts milliseconds in 32 bit, LTIME
nanoseconds in 64 bit (both signed), TIME_OF_DAY milliseconds since midnight. What DATE,
DATE_AND_TIME, LDT and LDATE count, and from when on, stands in `fbgen.lang.dates`.
Sources: IEC 61131-3 third edition, table 10; TIA Portal help, "Overview of the valid data types".
"""

from collections.abc import Callable
from enum import Enum
from functools import cached_property
from typing import Any, TypeAlias

from fbgen.dataclass import dataclass


class Family(Enum):
    """What kind of value an elementary type holds."""

    BOOL = "bool"
    BITS = "bit string"
    SIGNED = "signed integer"
    UNSIGNED = "unsigned integer"
    REAL = "floating point"
    DURATION = "duration"
    DATE = "date"
    CHAR = "character"
    VOID = "no value"


@dataclass(frozen=True, slots=True)
class Elementary:
    """A type without parts. `bits` is its width; 0 for no value at all."""

    name: str
    family: Family
    bits: int

    def __reduce__(self) -> str | tuple[Any, ...]:
        """One type is one object, also in what was kept or copied: only its name goes along."""
        return _NAMES.get(self) or object.__reduce_ex__(self, 4)

    @property
    def minimum(self) -> int:
        """The smallest value of a type that counts in whole numbers."""
        return -(1 << (self.bits - 1)) if self.is_signed else 0

    @property
    def maximum(self) -> int:
        """The largest value of a type that counts in whole numbers."""
        return (1 << (self.bits - 1)) - 1 if self.is_signed else (1 << self.bits) - 1

    @property
    def is_signed(self) -> bool:
        """True where the top bit is a sign."""
        return self.family in (Family.SIGNED, Family.DURATION)

    @property
    def is_integer(self) -> bool:
        """True for the types that calculate with whole numbers."""
        return self.family in (Family.SIGNED, Family.UNSIGNED)

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, slots=True, eq=False)
class Enumeration(Elementary):
    """Named values of an integer type. Two are the same type only if they are the same object.

    `members` has the names as declared with their values, in their order. `qualified` ones are
    reached by the type's name only (`Colour.red`), `strict` ones never mix with numbers.
    """

    members: tuple[tuple[str, int], ...]
    base: Elementary
    qualified: bool = False
    strict: bool = False

    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def value_of(self, name: str) -> int | None:
        """The value of an enumerator, whatever the case of its name."""
        key = name.casefold()
        return next((value for known, value in self.members if known.casefold() == key), None)

    def name_of(self, value: int) -> str | None:
        """The first enumerator that has a value."""
        return next((name for name, known in self.members if known == value), None)


@dataclass(frozen=True, slots=True, eq=False)
class Subrange(Elementary):
    """An integer type whose values go from `lowest` to `highest` only.

    `minimum` and `maximum` remain those of the base: that is how wide a calculation is.
    """

    base: Elementary
    lowest: int
    highest: int

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Subrange) and (self.base, self.lowest, self.highest) == (
            other.base,
            other.lowest,
            other.highest,
        )

    def __hash__(self) -> int:
        return hash((self.base, self.lowest, self.highest))


def counting_type(kind: Elementary) -> Elementary:
    """The integer type behind an enumeration or subrange; any other type as it is."""
    while isinstance(kind, Enumeration | Subrange):
        kind = kind.base
    return kind


BOOL = Elementary("BOOL", Family.BOOL, 1)
BYTE = Elementary("BYTE", Family.BITS, 8)
WORD = Elementary("WORD", Family.BITS, 16)
DWORD = Elementary("DWORD", Family.BITS, 32)
LWORD = Elementary("LWORD", Family.BITS, 64)
SINT = Elementary("SINT", Family.SIGNED, 8)
INT = Elementary("INT", Family.SIGNED, 16)
DINT = Elementary("DINT", Family.SIGNED, 32)
LINT = Elementary("LINT", Family.SIGNED, 64)
USINT = Elementary("USINT", Family.UNSIGNED, 8)
UINT = Elementary("UINT", Family.UNSIGNED, 16)
UDINT = Elementary("UDINT", Family.UNSIGNED, 32)
ULINT = Elementary("ULINT", Family.UNSIGNED, 64)
REAL = Elementary("REAL", Family.REAL, 32)
LREAL = Elementary("LREAL", Family.REAL, 64)
TIME = Elementary("TIME", Family.DURATION, 32)
LTIME = Elementary("LTIME", Family.DURATION, 64)
S5TIME = Elementary("S5TIME", Family.BITS, 16)
DATE = Elementary("DATE", Family.DATE, 16)
TIME_OF_DAY = Elementary("TIME_OF_DAY", Family.DATE, 32)
LTIME_OF_DAY = Elementary("LTIME_OF_DAY", Family.DATE, 64)
DATE_AND_TIME = Elementary("DATE_AND_TIME", Family.DATE, 64)
LDT = Elementary("LDT", Family.DATE, 64)
LDATE = Elementary("LDATE", Family.DATE, 64)
PC_DATE = Elementary("DATE", Family.DATE, 32)
PC_DATE_AND_TIME = Elementary("DATE_AND_TIME", Family.DATE, 32)
CHAR = Elementary("CHAR", Family.CHAR, 8)
WCHAR = Elementary("WCHAR", Family.CHAR, 16)
VOID = Elementary("VOID", Family.VOID, 0)
TIMER = Elementary("TIMER", Family.UNSIGNED, 16)
COUNTER = Elementary("COUNTER", Family.UNSIGNED, 16)
BLOCK_DB = Elementary("BLOCK_DB", Family.UNSIGNED, 16)
DB_ANY = Elementary("DB_ANY", Family.UNSIGNED, 16)

_NAMES = {kind: name for name, kind in globals().items() if isinstance(kind, Elementary)}

NUMBER_TYPES = {kind.name: kind for kind in (TIMER, COUNTER, BLOCK_DB, DB_ANY)}
"""Types of parameters on S7: the number of a timer, a counter or a data block."""

ELEMENTARY: dict[str, Elementary] = {
    kind.name: kind
    for kind in (
        *(BOOL, BYTE, WORD, DWORD, LWORD, SINT, INT, DINT, LINT, USINT, UINT, UDINT, ULINT),
        *(REAL, LREAL, TIME, LTIME, S5TIME, DATE, TIME_OF_DAY, LTIME_OF_DAY),
        *(DATE_AND_TIME, LDT, LDATE, CHAR, WCHAR, VOID),
    )
}
"""By canonical name; `ALIASES` has the other spellings. DATE and DATE_AND_TIME are those of S7."""

ALIASES: dict[str, str] = {
    "TOD": "TIME_OF_DAY",
    "LTOD": "LTIME_OF_DAY",
    "DT": "DATE_AND_TIME",
    "LDATE_AND_TIME": "LDT",
}

S7_STRING_LENGTH = 254
"""Length of a STRING without a length on S7; IEC leaves it to the implementation."""


@dataclass(frozen=True, slots=True)
class StringType:
    """STRING or WSTRING with room for `length` characters."""

    length: int = S7_STRING_LENGTH
    wide: bool = False

    @property
    def name(self) -> str:
        """The name with the length."""
        return f"{'WSTRING' if self.wide else 'STRING'}[{self.length}]"

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, slots=True)
class ArrayType:
    """An array; `bounds` has the first and the last index of each dimension."""

    bounds: tuple[tuple[int, int], ...]
    element: "Type"

    @property
    def count(self) -> int:
        """How many elements there are over all dimensions."""
        count = 1
        for first, last in self.bounds:
            count *= last - first + 1
        return count

    @property
    def name(self) -> str:
        """The type as it is declared."""
        bounds = ", ".join(f"{first}..{last}" for first, last in self.bounds)
        return f"ARRAY[{bounds}] OF {self.element.name}"

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, slots=True)
class OpenArrayType:
    """ARRAY[*]: a parameter that takes arrays of any bounds, which come with the argument."""

    dimensions: int
    element: "Type"

    @property
    def name(self) -> str:
        """The type as it is declared."""
        return f"ARRAY[{', '.join('*' * self.dimensions)}] OF {self.element.name}"

    def takes(self, kind: "Type") -> bool:
        """True for arrays that can be an argument."""
        if isinstance(kind, OpenArrayType):
            return kind == self
        return (
            isinstance(kind, ArrayType)
            and len(kind.bounds) == self.dimensions
            and kind.element == self.element
        )

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, slots=True)
class Field:
    """One part of a structure. `initial` is None for the default of the type."""

    name: str
    type: "Type"
    initial: "Initial | None" = None


@dataclass(frozen=True, eq=False)
class StructType:
    """A structure or UDT. Two structures are the same type only if they are the same object.

    The parts of a union (`is_union`) all begin at the same byte.
    """

    name: str
    fields: tuple[Field, ...]
    is_union: bool = False

    def field(self, name: str) -> Field | None:
        """The part with this name, whatever its case."""
        return self._by_name.get(name.casefold())

    @cached_property
    def _by_name(self) -> dict[str, Field]:
        return {field.name.casefold(): field for field in reversed(self.fields)}

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, eq=False)
class BlockType:
    """The type of an instance of a function block, the user's or a standard one.

    What the block looks like inside stands in `fbgen.lang.checked` under the same name.
    """

    name: str

    def __str__(self) -> str:
        return self.name


INTERFACE = "INTERFACE"
"""The keyword of the reference type that variables of an interface have."""


@dataclass(frozen=True, slots=True, eq=False)
class ReferenceType:
    """REF_TO, POINTER TO (both followed by `^`), REFERENCE TO (followed by itself), INTERFACE.

    `target_name` is what the target is called, and makes two reference types the same. What it is
    comes from `find`, because a structure may refer to its own kind.
    """

    keyword: str
    target_name: str
    find: "Callable[[], Type]"

    @property
    def target(self) -> "Type":
        """The type of the variables that can be referred to."""
        return self.find()

    @property
    def name(self) -> str:
        """The type as it is declared."""
        written = f"{self.keyword} {self.target_name}".strip()
        return self.target_name if self.is_interface else written

    @property
    def is_interface(self) -> bool:
        """True for a variable that refers to any instance that implements an interface."""
        return self.keyword == INTERFACE

    @property
    def is_implicit(self) -> bool:
        """True where the name of the reference means what it refers to."""
        return self.keyword == "REFERENCE TO"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ReferenceType) and (
            self.keyword,
            self.target_name.casefold(),
        ) == (other.keyword, other.target_name.casefold())

    def __hash__(self) -> int:
        return hash((self.keyword, self.target_name.casefold()))

    def __str__(self) -> str:
        return self.name


@dataclass(frozen=True, eq=False)
class AnyType:
    """VARIANT or ANY: a parameter of a system instruction that takes a whole area."""

    name: str

    def __str__(self) -> str:
        return self.name


VARIANT = AnyType("VARIANT")
ANY = AnyType("ANY")

VARIANT_VALUE = ReferenceType("VARIANT", "", lambda: VOID)
"""VARIANT in a block of the user: it refers to a variable of a type that the program asks for."""

ANY_VALUE = ReferenceType("ANY", "", lambda: VOID)
POINTER_VALUE = ReferenceType("POINTER", "", lambda: VOID)
"""ANY and POINTER in a block of the user: where an overlay shows them they are 10 and 6 bytes."""


def refers_to_anything(kind: "Type") -> bool:
    """True for VARIANT, ANY and POINTER."""
    return isinstance(kind, ReferenceType) and kind.keyword in ("VARIANT", "ANY", "POINTER")


def is_area_pointer(kind: "Type") -> bool:
    """True for ANY and POINTER, which can lie in memory as bytes."""
    return isinstance(kind, ReferenceType) and kind.keyword in ("ANY", "POINTER")


Type: TypeAlias = (
    Elementary
    | StringType
    | ArrayType
    | OpenArrayType
    | StructType
    | BlockType
    | ReferenceType
    | AnyType
)


def is_of_type(kind: Type, wanted: Type) -> bool:
    """True for a type and itself; a text without room stands for texts of any length."""
    if isinstance(wanted, StringType) and not wanted.length:
        return isinstance(kind, StringType) and kind.wide == wanted.wide
    return kind == wanted


Scalar: TypeAlias = bool | int | float | str
"""A value of an elementary type or a string."""


@dataclass(frozen=True, slots=True)
class ArrayInitial:
    """Initial values of an array, flat, last index fastest; None is the default of the element."""

    items: tuple["Initial | None", ...]


@dataclass(frozen=True, slots=True)
class StructInitial:
    """Initial values of the named parts of a structure or an instance; the others have defaults."""

    fields: tuple[tuple[str, "Initial"], ...]


Initial: TypeAlias = Scalar | ArrayInitial | StructInitial

DTL = StructType(
    "DTL",
    (
        Field("YEAR", UINT, 1970),
        Field("MONTH", USINT, 1),
        Field("DAY", USINT, 1),
        Field("WEEKDAY", USINT, 5),
        Field("HOUR", USINT),
        Field("MINUTE", USINT),
        Field("SECOND", USINT),
        Field("NANOSECOND", UDINT),
    ),
)
"""Date and time in parts, of S7-1200 and S7-1500: WEEKDAY counts from 1, Sunday.

It starts as 1970-01-01, a Thursday (TIA Portal help, "DTL"). A `Convert` to and from LDT exists.
"""
