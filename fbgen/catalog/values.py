"""Word values as people write them: 9F00, 16#9F00, 0x9F00, 9F00h, 2#1001..., 0b1001, 40704."""

import re

from fbgen.diagnostics import error

_HEX = re.compile(r"(?:16#|0x|\$)([0-9a-f]{1,4})|([0-9a-f]{1,4})h|([0-9a-f]{1,4})")
_BINARY = re.compile(r"(?:2#|0b)([01]{1,16})")
_DECIMAL = re.compile(r"10#([0-9]{1,5})|([0-9]{5})")


def parse_word(text: str) -> int:
    """The 16-bit number that a text stands for.

    Up to four digits without a mark are hexadecimal, as in all manuals of these devices (so 0B10 is
    no binary number); five digits without a mark are decimal. Decimal is marked by `10#`, binary by
    `2#`, or by `0b` with three digits and more. Underscores and blanks between the digits do not
    count. Raises DiagnosticError FB1204 for anything else.
    """
    plain = re.sub(r"[_\s]", "", text).lower()
    value = -1
    if match := _HEX.fullmatch(plain):
        value = int(match[1] or match[2] or match[3], 16)
    elif match := _BINARY.fullmatch(plain):
        value = int(match[1], 2)
    elif match := _DECIMAL.fullmatch(plain):
        value = int(match[1] or match[2])
    if not 0 <= value <= 0xFFFF:
        raise error(
            "FB1204",
            f"'{text}' is no 16-bit number",
            help="write 9F00, 16#9F00, 0x9F00, 9F00h, 2#1001_1111_0000_0000 or 10#40704",
        )
    return value
