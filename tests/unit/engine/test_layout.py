"""How variables lie in memory on S7; bytes written by hand from the format descriptions."""

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.types import (
    BOOL,
    BYTE,
    CHAR,
    DATE,
    DATE_AND_TIME,
    DINT,
    INT,
    LREAL,
    REAL,
    S5TIME,
    SINT,
    TIME,
    WCHAR,
    WORD,
    ArrayType,
    BlockType,
    Field,
    StringType,
    StructType,
    Type,
)
from harness.engine.interface import Value
from harness.engine.layout import decode, encode, size_bits, size_bytes

NESTED = StructType("nested", (Field("a", BYTE), Field("b", BOOL)))
MIXED = StructType(
    "mixed",
    (
        Field("first", BOOL),
        Field("second", BOOL),
        Field("byte", BYTE),
        Field("third", BOOL),
        Field("word", WORD),
        Field("last", BYTE),
        Field("inner", NESTED),
    ),
)
# 1990-12-24 13:58:59.123 is a Monday
CHRISTMAS_NS = 662_047_139_123_000_000

CASES: list[tuple[Type, Value, bytes]] = [
    (BOOL, True, b"\x01"),
    (WORD, 0x1234, b"\x12\x34"),
    (SINT, -2, b"\xfe"),
    (INT, -2, b"\xff\xfe"),
    (DINT, 1, b"\x00\x00\x00\x01"),
    (REAL, -1.5, b"\xbf\xc0\x00\x00"),
    (LREAL, 1.0, b"\x3f\xf0\x00\x00\x00\x00\x00\x00"),
    (TIME, -1, b"\xff\xff\xff\xff"),
    (S5TIME, 0x2127, b"\x21\x27"),
    (DATE, 1, b"\x00\x01"),
    (CHAR, "A", b"A"),
    (WCHAR, "Ω", b"\x03\xa9"),
    (DATE_AND_TIME, CHRISTMAS_NS, bytes.fromhex("9012241358591232")),
    (StringType(3), "AB", b"\x03\x02AB\x00\x00"),
    (StringType(2, wide=True), "é", b"\x00\x02\x00\x01\x00\xe9\x00\x00"),
    (ArrayType(((1, 3),), BYTE), [1, 2, 3], b"\x01\x02\x03\x00"),
    (ArrayType(((0, 8),), BOOL), [True] + [False] * 7 + [True], b"\x01\x01"),
    (ArrayType(((0, 1), (0, 2)), BYTE), [1, 2, 3, 4, 5, 6], b"\x01\x02\x03\x00\x04\x05\x06\x00"),
    (
        ArrayType(((1, 2),), NESTED),
        [{"a": 1, "b": True}, {"a": 2, "b": False}],
        b"\x01\x01\x02\x00",
    ),
    (
        MIXED,
        {
            "first": False,
            "second": True,
            "byte": 0xAA,
            "third": True,
            "word": 0x1122,
            "last": 0x55,
            "inner": {"a": 7, "b": True},
        },
        b"\x02\xaa\x01\x00\x11\x22\x55\x00\x07\x01",
    ),
]


@pytest.mark.parametrize(("kind", "value", "data"), CASES, ids=lambda case: str(case)[:40])
def test_a_value_has_its_bytes_and_comes_back(kind: Type, value: Value, data: bytes) -> None:
    assert encode(kind, value) == data
    assert decode(kind, data) == value
    assert size_bytes(kind) == len(data)


def test_a_bool_is_one_bit() -> None:
    assert size_bits(BOOL) == 1


def test_a_string_that_claims_to_be_longer_than_its_room_is_cut() -> None:
    assert decode(StringType(2), b"\x02\xffAB") == "AB"


def test_a_date_that_is_none_is_the_first_one() -> None:
    assert decode(DATE_AND_TIME, b"\x90\x13\x01\x00\x00\x00\x00\x00") == 631_152_000_000_000_000


def test_an_instance_has_no_layout() -> None:
    with pytest.raises(DiagnosticError, match="FB6013"):
        encode(BlockType("TON"), {})
