"""The kinds of single values that catalogue entries and plant files are made of.

They are strict: plain `int`, `float` and `bool` fields of a model would also take the texts "017",
"1_0" and "no".
"""

import re
from typing import Annotated, Any, NamedTuple

from pydantic import (
    AllowInfNan,
    BeforeValidator,
    Field,
    GetCoreSchemaHandler,
    Strict,
    StrictBool,
    StrictInt,
)
from pydantic.json_schema import WithJsonSchema
from pydantic_core import CoreSchema, core_schema

from fbgen.catalog.yaml_nodes import YamlInt

_HEX_WORD = re.compile(r"[0-9A-Fa-f]{1,4}")


def _hexadecimal(value: object) -> object:
    """`FA00`, `0009` and `1388` as written; a Python int is taken as the number itself."""
    if isinstance(value, YamlInt):
        value = value.text
    if isinstance(value, int) and not isinstance(value, bool):
        return value
    if isinstance(value, str):
        digits = value[2:] if value[:2] in ("0x", "0X") else value
        if _HEX_WORD.fullmatch(digits):
            return int(digits, 16)
    raise ValueError(f"'{value}' is no hexadecimal number of one to four digits such as FA00")


def _octets(value: object) -> object:
    """`30 30 20` as bytes."""
    if isinstance(value, YamlInt):
        value = value.text
    if isinstance(value, bytes):
        return value
    if isinstance(value, str):
        try:
            return bytes.fromhex(value)
        except ValueError:
            pass
    raise ValueError(f"'{value}' is no row of bytes in hexadecimal such as 30 30 20")


def _number(value: object) -> object:
    """A key or value that may be written decimal or with 0x."""
    if isinstance(value, str) and re.fullmatch(r"0x[0-9A-Fa-f]{1,8}|[0-9]{1,9}", value):
        return int(value, 16) if value.startswith("0x") else int(value)
    return value


HexWord = Annotated[
    int,
    BeforeValidator(_hexadecimal),
    Field(ge=0, le=0xFFFF),
    WithJsonSchema({"type": ["string", "integer"], "pattern": "^(0x)?[0-9A-Fa-f]{1,4}$"}),
]
"""A 16-bit number that is always written in hexadecimal: a communication number, a word."""

HexByte = Annotated[
    int,
    BeforeValidator(_hexadecimal),
    Field(ge=0, le=0xFF),
    WithJsonSchema({"type": ["string", "integer"], "pattern": "^(0x)?[0-9A-Fa-f]{1,2}$"}),
]
"""An 8-bit number that is always written in hexadecimal: a start code, a command."""

Octets = Annotated[
    bytes,
    BeforeValidator(_octets),
    WithJsonSchema({"type": ["string", "integer"], "pattern": "^([0-9A-Fa-f]{2} ?)*$"}),
]
"""Bytes in hexadecimal, separated by blanks."""

Number = Annotated[int, BeforeValidator(_number)]
"""A whole number, decimal or with 0x."""

Flag = StrictBool
"""true or false."""

Whole = StrictInt
"""A whole number."""

Real = Annotated[float, Strict(), AllowInfNan(False), Field(ge=-1e9, le=1e9)]
"""A finite number, with or without a decimal point."""

Count = Annotated[StrictInt, Field(ge=0)]
"""A whole number from 0."""

SnakeName = Annotated[str, Field(pattern=r"^[a-z][a-z0-9]*(_[a-z0-9]+)*$", max_length=60)]
"""A name in snake_case."""

EntryId = Annotated[str, Field(pattern=r"^[a-z0-9]+([-_][a-z0-9]+)*$", max_length=60)]
"""The id of a catalogue entry, which is also the name of its file."""

Text = Annotated[str, Field(min_length=1, max_length=4000)]
"""A text for people."""


class BitRange(NamedTuple):
    """Bits `high` down to `low` of a 16-bit word, both included."""

    high: int
    low: int

    @property
    def mask(self) -> int:
        """The bits as ones in a word."""
        return ((1 << (self.high - self.low + 1)) - 1) << self.low

    def __str__(self) -> str:
        return str(self.high) if self.high == self.low else f"{self.high}..{self.low}"

    @classmethod
    def parse(cls, value: object) -> "BitRange":
        """`9` or `12..8`. Raises ValueError for anything else."""
        if isinstance(value, BitRange):
            return value
        if isinstance(value, int) and not isinstance(value, bool):
            value = str(int(value))
        match = re.fullmatch(r"([0-9]{1,2})(?:\.\.([0-9]{1,2}))?", str(value))
        if match is None:
            raise ValueError(f"'{value}' is no bit: write 9, or 12..8 for several")
        high = int(match[1])
        low = int(match[2]) if match[2] is not None else high
        if not 15 >= high >= low:
            raise ValueError(f"'{value}' is no bit range of a word: the highest bit is 15, first")
        return cls(high, low)

    @classmethod
    def __get_pydantic_core_schema__(cls, source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(
            cls.parse,
            json_schema_input_schema=core_schema.union_schema(
                [
                    core_schema.int_schema(ge=0, le=15),
                    core_schema.str_schema(pattern=r"^[0-9]{1,2}(\.\.[0-9]{1,2})?$"),
                ]
            ),
        )
