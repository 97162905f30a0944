"""Numbers in BCD, and S5TIME, which is one with a time base.

Source: STEP 7 System Software reference, "Format of the data type S5TIME"; TIA Portal help,
"BCD16" and "S5TIME".
"""

from harness.engine.compiled.library.stops import NoDecimal, NoFit

_BASES_MS = (10, 100, 1_000, 10_000)


def digits_of(word: int) -> int:
    """The number in the low three digits."""
    high, middle, low = word >> 8 & 15, word >> 4 & 15, word & 15
    if max(high, middle, low) > 9:
        raise NoDecimal(word)
    return high * 100 + middle * 10 + low


def word_of(number: int) -> int:
    """A number below 1000 as three digits."""
    return number // 100 << 8 | number // 10 % 10 << 4 | number % 10


def bcd_to_int(word: int) -> int:
    """BCD16_TO_INT: three digits, bit 15 is the sign."""
    number = digits_of(word)
    return -number if word & 0x8000 else number


def int_to_bcd(number: int) -> int:
    """INT_TO_BCD16."""
    if not -999 <= number <= 999:
        raise NoFit(number)
    return 0xF000 | word_of(-number) if number < 0 else word_of(number)


def s5time_to_time(word: int) -> int:
    """S5TIME_TO_TIME, in milliseconds."""
    return digits_of(word) * _BASES_MS[word >> 12 & 3]


def time_to_s5time(milliseconds: int) -> int:
    """TIME_TO_S5TIME: the finest time base that holds the value; what is finer is cut."""
    if milliseconds >= 0:
        for code, base_ms in enumerate(_BASES_MS):
            if milliseconds // base_ms <= 999:
                return code << 12 | word_of(milliseconds // base_ms)
    raise NoFit(milliseconds)


def long_bcd_to_int(word: int) -> int:
    """BCD32_TO_DINT: seven digits, bit 31 is the sign."""
    number = from_bcd(word & 0x0FFF_FFFF, 28, 9_999_999, word)
    return -number if word & 0x8000_0000 else number


def int_to_long_bcd(number: int) -> int:
    """DINT_TO_BCD32."""
    if not -9_999_999 <= number <= 9_999_999:
        raise NoFit(number)
    return (0xF000_0000 if number < 0 else 0) | to_bcd(abs(number), 28)


def from_bcd(word: int, bits: int, most: int, shown: int | None = None) -> int:
    """A digit in each four of `bits` bits; a number up to `most`."""
    number = 0
    for shift in range(bits - 4, -1, -4):
        digit = word >> shift & 15
        if digit > 9:
            raise NoDecimal(word if shown is None else shown)
        number = number * 10 + digit
    if number > most:
        raise NoFit(number)
    return number


def to_bcd(number: int, bits: int) -> int:
    """A digit in each four of `bits` bits."""
    word, rest = 0, number
    for shift in range(0, bits, 4):
        rest, digit = divmod(rest, 10)
        word |= digit << shift
    if rest:
        raise NoFit(number)
    return word


def is_bcd(word: int) -> bool:
    """IS_VALID_BCD."""
    while word:
        if word & 15 > 9:
            return False
        word >>= 4
    return True
