"""Binary coded decimal numbers.

S7 codes signed numbers of three or seven digits with a sign in the first digit; IEC 61131-3 codes
unsigned ones with a digit in each four bits. Sources: TIA Portal help, "BCD16" and "BCD32"; IEC
61131-3 third edition, table 22.
"""

from fbgen.lang.checker.supplied.function_signatures import COMMON, EXPECTED, Common, Function
from fbgen.lang.types import BOOL, BYTE, DINT, DWORD, INT, LWORD, UDINT, UINT, ULINT, USINT, WORD

_BITS = (BYTE, WORD, DWORD, LWORD)
_UNSIGNED = (USINT, UINT, UDINT, ULINT)

BCD_FUNCTIONS = (
    Function("BCD16_TO_INT", (("IN", WORD),), INT),
    Function("INT_TO_BCD16", (("IN", INT),), WORD),
    Function("BCD32_TO_DINT", (("IN", DWORD),), DINT),
    Function("DINT_TO_BCD32", (("IN", DINT),), DWORD),
    Function("IS_VALID_BCD", (("IN", COMMON),), BOOL, Common.SHIFTED),
    Function("FROM_BCD", (("IN", COMMON),), EXPECTED, Common.SHIFTED, results=_UNSIGNED),
    Function("TO_BCD", (("IN", COMMON),), EXPECTED, Common.UNSIGNED, results=_BITS),
)

BCD_ALIASES = {
    "WORD_BCD_TO_INT": "BCD16_TO_INT",
    "INT_TO_BCD_WORD": "INT_TO_BCD16",
    "DWORD_BCD_TO_DINT": "BCD32_TO_DINT",
    "DINT_TO_BCD_DWORD": "DINT_TO_BCD32",
    "BCD_TO_INT": "BCD16_TO_INT",
    "INT_TO_BCD": "INT_TO_BCD16",
    "BCD_TO_DINT": "BCD32_TO_DINT",
    "DINT_TO_BCD": "DINT_TO_BCD32",
}

UNSIGNED_BCD: dict[str, Function] = {
    **{
        f"{bits.name}_BCD_TO_{number.name}": Function("FROM_BCD", (("IN", bits),), number)
        for bits in _BITS
        for number in _UNSIGNED
    },
    **{
        f"{number.name}_TO_BCD_{bits.name}": Function("TO_BCD", (("IN", number),), bits)
        for bits in _BITS
        for number in _UNSIGNED
    },
    **{
        f"BCD_TO_{number.name}": Function("FROM_BCD", (("IN", COMMON),), number, Common.SHIFTED)
        for number in _UNSIGNED
    },
    **{
        f"TO_BCD_{bits.name}": Function("TO_BCD", (("IN", COMMON),), bits, Common.UNSIGNED)
        for bits in _BITS
    },
}
"""The spellings of the standard; all are StandardCalls FROM_BCD or TO_BCD."""
