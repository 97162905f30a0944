"""Standard functions on texts.

Sources: IEC 61131-3 third edition, table 34; TIA Portal help, "String + Char".
"""

from fbgen.lang.checker.supplied.function_signatures import COMMON, WHOLE_NUMBER, Common, Function
from fbgen.lang.types import CHAR, INT, WCHAR, StringType

_TWO_TEXTS = (("IN1", COMMON), ("IN2", COMMON))
_PART = (("IN", COMMON), ("L", WHOLE_NUMBER), ("P", WHOLE_NUMBER))

TEXT_FUNCTIONS = (
    Function("LEN", (("IN", COMMON),), INT, Common.TEXT),
    Function("LEFT", (("IN", COMMON), ("L", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function("RIGHT", (("IN", COMMON), ("L", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function("MID", _PART, COMMON, Common.TEXT),
    Function("CONCAT", _TWO_TEXTS, COMMON, Common.TEXT, repeats=True),
    Function("INSERT", (*_TWO_TEXTS, ("P", WHOLE_NUMBER)), COMMON, Common.TEXT),
    Function("DELETE", _PART, COMMON, Common.TEXT),
    Function(
        "REPLACE",
        (*_TWO_TEXTS, ("L", WHOLE_NUMBER), ("P", WHOLE_NUMBER)),
        COMMON,
        Common.TEXT,
    ),
    Function("FIND", _TWO_TEXTS, INT, Common.TEXT),
    Function("STRING_TO_CHAR", (("IN", StringType()),), CHAR),
    Function("WSTRING_TO_WCHAR", (("IN", StringType(wide=True)),), WCHAR),
)

_NUMBERS = (
    *("SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT", "ULINT"),
    *("REAL", "LREAL", "BOOL", "BYTE", "WORD", "DWORD", "LWORD"),
)
_TIMES = (
    *("TIME", "LTIME", "DATE", "TIME_OF_DAY", "LTIME_OF_DAY", "DATE_AND_TIME", "LDT", "LDATE"),
)
TEXT_CONVERSIONS: dict[str, tuple[str, str]] = {
    **{
        f"{source}_TO_{target}": (source, target)
        for number in _NUMBERS
        for text in ("STRING", "WSTRING")
        for source, target in ((number, text), (text, number))
    },
    **{f"{time}_TO_{text}": (time, text) for time in _TIMES for text in ("STRING", "WSTRING")},
}
"""Numbers to text and back, times to text: StandardCalls with one argument and a result of these
types."""
