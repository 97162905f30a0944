"""Taking dates and times of day apart.

Source: IEC 61131-3 third edition, table 36.
"""

_DAY = "YEAR => ANY_INT, MONTH => ANY_INT, DAY => ANY_INT"
_TIME = "HOUR => ANY_INT, MINUTE => ANY_INT, SECOND => ANY_INT, MILLISECOND => ANY_INT"

DATES = {
    "SPLIT_DATE": f"(IN DATE, {_DAY})",
    "SPLIT_TOD": f"(IN TOD, {_TIME})",
    "SPLIT_LTOD": f"(IN LTOD, {_TIME})",
    "SPLIT_DT": f"(IN DT, {_DAY}, {_TIME})",
    "SPLIT_LDT": f"(IN LDT, {_DAY}, {_TIME})",
}
