"""Standard functions on dates, times of day and durations, and what + and - on them become.

Sources: IEC 61131-3 third edition, tables 35 and 36; STEP 7 help for the S5TIME.
"""

from dataclasses import replace

from fbgen.lang.checker.supplied.function_signatures import COMMON, WHOLE_NUMBER, Common, Function
from fbgen.lang.dates import of_dialect
from fbgen.lang.types import (
    DATE,
    DATE_AND_TIME,
    LDATE,
    LDT,
    LTIME,
    LTIME_OF_DAY,
    S5TIME,
    TIME,
    TIME_OF_DAY,
    USINT,
    Elementary,
)

_DAY = (("YEAR", WHOLE_NUMBER), ("MONTH", WHOLE_NUMBER), ("DAY", WHOLE_NUMBER))
_TIME = (
    *(("HOUR", WHOLE_NUMBER), ("MINUTE", WHOLE_NUMBER), ("SECOND", WHOLE_NUMBER)),
    ("MILLISECOND", WHOLE_NUMBER),
)

CALENDAR_FUNCTIONS = (
    Function("CONCAT_DATE_TOD", (("IN1", DATE), ("IN2", TIME_OF_DAY)), DATE_AND_TIME),
    Function("CONCAT_DATE_LTOD", (("IN1", DATE), ("IN2", LTIME_OF_DAY)), LDT),
    Function("CONCAT_DATE", _DAY, DATE),
    Function("CONCAT_TOD", _TIME, TIME_OF_DAY),
    Function("CONCAT_LTOD", _TIME, LTIME_OF_DAY),
    Function("CONCAT_DT", (*_DAY, *_TIME), DATE_AND_TIME),
    Function("CONCAT_LDT", (*_DAY, *_TIME), LDT),
    Function("DAY_OF_WEEK", (("IN", COMMON),), USINT, Common.DAYS),
    Function("S5TIME_TO_TIME", (("IN", S5TIME),), TIME),
    Function("TIME_TO_S5TIME", (("IN", TIME),), S5TIME),
)

_ON_S7: dict[tuple[str, Elementary, Elementary], tuple[str, Elementary]] = {
    ("+", TIME_OF_DAY, TIME): ("ADD_TOD_TIME", TIME_OF_DAY),
    ("+", LTIME_OF_DAY, LTIME): ("ADD_LTOD_LTIME", LTIME_OF_DAY),
    ("+", DATE_AND_TIME, TIME): ("ADD_DT_TIME", DATE_AND_TIME),
    ("+", LDT, LTIME): ("ADD_LDT_LTIME", LDT),
    ("-", TIME_OF_DAY, TIME): ("SUB_TOD_TIME", TIME_OF_DAY),
    ("-", LTIME_OF_DAY, LTIME): ("SUB_LTOD_LTIME", LTIME_OF_DAY),
    ("-", DATE_AND_TIME, TIME): ("SUB_DT_TIME", DATE_AND_TIME),
    ("-", LDT, LTIME): ("SUB_LDT_LTIME", LDT),
    ("-", TIME_OF_DAY, TIME_OF_DAY): ("SUB_TOD_TOD", TIME),
    ("-", LTIME_OF_DAY, LTIME_OF_DAY): ("SUB_LTOD_LTOD", LTIME),
    ("-", DATE, DATE): ("SUB_DATE_DATE", TIME),
    ("-", DATE_AND_TIME, DATE_AND_TIME): ("SUB_DT_DT", TIME),
    ("-", LDT, LDT): ("SUB_LDT_LDT", LTIME),
}

DATE_ARITHMETIC: dict[tuple[str, Elementary, Elementary], tuple[str, Elementary]] = {
    **_ON_S7,
    **{
        (symbol, of_dialect(left, "iec"), of_dialect(right, "iec")): (name, of_dialect(kind, "iec"))
        for (symbol, left, right), (name, kind) in _ON_S7.items()
    },
    ("-", LDATE, LDATE): ("SUB_LDT_LDT", LTIME),
}
"""Dates and times of different types: the standard function that calculates, and its result."""

DATE_FUNCTIONS: dict[str, Function] = {
    name: Function(name, (("IN1", left), ("IN2", right)), result)
    for (_, left, right), (name, result) in _ON_S7.items()
}
"""Dates and times of day with durations: by name, and what + and - on these types become."""


def function_of_dialect(function: Function, dialect: str) -> Function:
    """The function with the dates that the dialect has."""
    parameters = tuple((name, of_dialect(kind, dialect)) for name, kind in function.parameters)
    return replace(function, parameters=parameters, result=of_dialect(function.result, dialect))
