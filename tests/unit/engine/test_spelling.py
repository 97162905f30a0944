"""Values as PLC text writes them, both ways."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.types import (
    DATE_AND_TIME,
    ELEMENTARY,
    LDATE,
    LDT,
    PC_DATE,
    PC_DATE_AND_TIME,
    ArrayType,
    Elementary,
    Family,
    Field,
    StringType,
    StructType,
    Type,
)
from harness.engine.interface import Value
from harness.engine.spelling import WrongSpellingError, read_value, spell
from harness.engine.values import accept_scalar

_E = ELEMENTARY


@pytest.mark.parametrize(
    ("kind", "value", "text"),
    [
        (_E["BOOL"], True, "TRUE"),
        (_E["WORD"], 0xC400, "16#C400"),
        (_E["BYTE"], 5, "16#05"),
        (_E["INT"], -7, "-7"),
        (_E["REAL"], accept_scalar("", _E["REAL"], 0.1), "0.1"),
        (_E["LREAL"], 0.1 + 0.2, "0.30000000000000004"),
        (_E["TIME"], 93_784_005, "T#1d2h3m4s5ms"),
        (_E["TIME"], -1500, "T#-1s500ms"),
        (_E["TIME"], 0, "T#0ms"),
        (_E["LTIME"], 1_000_001, "LT#1ms1ns"),
        (_E["DATE"], 0, "D#1990-01-01"),
        (_E["TIME_OF_DAY"], 86_399_250, "TOD#23:59:59.25"),
        (_E["DATE_AND_TIME"], 1_709_164_800_000_000_000, "DT#2024-02-29-00:00:00"),
        (StringType(20), "it's 5$", "'it$'s 5$$'"),
        (_E["CHAR"], "x", "'x'"),
    ],
)
def test_values_are_spelled_as_in_plc_text_and_read_back(
    kind: Type, value: Value, text: str
) -> None:
    assert spell(kind, value) == text
    assert read_value(kind, text) == value


def test_parts_are_spelled_with_their_types() -> None:
    point = StructType("point", (Field("x", _E["WORD"]), Field("t", _E["TIME"])))
    assert spell(point, {"x": 1, "t": 1000}) == "(x := 16#0001, t := T#1s)"
    assert spell(ArrayType(((0, 1),), _E["BYTE"]), [1, 255]) == "[16#01, 16#FF]"


@pytest.mark.parametrize(
    ("kind", "text", "advice"),
    [
        (_E["TIME"], "5", "write it as the PLC does, such as T#2s or T#1m30s"),
        (_E["TIME"], "D#2024-02-29", "write it as the PLC does, such as T#2s or T#1m30s"),
        (_E["BOOL"], "yes", "write TRUE or FALSE"),
        (_E["INT"], "1.5", "write a whole number, such as 16#FF"),
        (_E["REAL"], "T#5s", "write a number"),
        (StructType("point", ()), "1", "point has parts: name one of them"),
    ],
)
def test_a_text_that_is_no_value_of_the_type_comes_with_advice(
    kind: Type, text: str, advice: str
) -> None:
    with pytest.raises(WrongSpellingError) as wrong:
        read_value(kind, text)
    assert wrong.value.help == advice


def test_a_value_that_does_not_fit_is_refused() -> None:
    with pytest.raises(DiagnosticError) as refused:
        read_value(_E["BYTE"], "16#100")
    assert refused.value.diagnostics[0].code == "FB6021"


def test_bool_is_also_1_and_0_and_texts_need_no_quotes() -> None:
    assert read_value(_E["BOOL"], "1") is True
    assert read_value(_E["BOOL"], "false") is False
    assert read_value(StringType(10), "pump 1") == "pump 1"


_TIMED = (Family.DURATION, Family.DATE)
_SPELLED = [
    *(kind for kind in ELEMENTARY.values() if kind.family in _TIMED),
    *(PC_DATE, PC_DATE_AND_TIME),
]


@given(st.sampled_from(_SPELLED), st.data())
def test_every_time_and_date_is_read_back(kind: Elementary, data: st.DataObject) -> None:
    day_ns = 86_400 * 10**9
    most = {
        "TIME_OF_DAY": day_ns // 10**6 - 1,
        "LTIME_OF_DAY": day_ns - 1,
    }.get(kind.name, kind.maximum)
    if kind in (DATE_AND_TIME, LDT, LDATE):
        most = 40_000 * day_ns
    value = data.draw(st.integers(max(kind.minimum, -kind.maximum), most))
    if kind in (PC_DATE, LDATE):  # of a date only the day is shown
        day = day_ns // 10**9 if kind == PC_DATE else day_ns
        value -= value % day
    assert read_value(kind, spell(kind, value)) == value


@given(st.floats(allow_nan=False, allow_infinity=False, width=32))
def test_every_real_is_read_back(value: float) -> None:
    assert read_value(_E["REAL"], spell(_E["REAL"], value)) == value
