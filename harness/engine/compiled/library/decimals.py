"""Numbers in BCD, and S5TIME, which is one with a time base.

Source: STEP 7 System Software reference, "Format of the data type S5TIME"; TIA Portal help,
"BCD16" and "S5TIME".
"""

from harness.engine.compiled.library.stops import NoDecimal, NoFit

_BASES_MS = (10, 100, 1_000, 10_000)


def _digits(word: int) -> int:
    high, middle, low = word >> 8 & 15, word >> 4 & 15, word & 15
    if max(high, middle, low) > 9:
        raise NoDecimal(word)
    return high * 100 + middle * 10 + low


def _word(number: int) -> int:
    return number // 100 << 8 | number // 10 % 10 << 4 | number % 10


def bcd_to_int(word: int) -> int:
    """BCD16_TO_INT: three digits, bit 15 is the sign."""
    number = _digits(word)
    return -number if word & 0x8000 else number


def int_to_bcd(number: int) -> int:
    """INT_TO_BCD16."""
    if not -999 <= number <= 999:
        raise NoFit(number)
    return 0xF000 | _word(-number) if number < 0 else _word(number)


def s5time_to_time(word: int) -> int:
    """S5TIME_TO_TIME, in milliseconds."""
    return _digits(word) * _BASES_MS[word >> 12 & 3]


def time_to_s5time(milliseconds: int) -> int:
    """TIME_TO_S5TIME: the finest time base that holds the value; what is finer is cut."""
    if milliseconds >= 0:
        for code, base_ms in enumerate(_BASES_MS):
            if milliseconds // base_ms <= 999:
                return code << 12 | _word(milliseconds // base_ms)
    raise NoFit(milliseconds)
