"""Absolute addresses and slices from their tokens.

Source: IEC 61131-3, directly represented variables; TIA Portal help, "Addressing operands" and
"Indirect addressing in SCL"; published S7-SCL sources for the spellings without `%` and the German
mnemonics E, A, PE, PA, Z.
"""

import re

from fbgen.lang.ast import DirectAddress
from fbgen.lang.lexer import PLAIN_ADDRESS
from fbgen.source import Span

_ADDRESS = re.compile(
    r"%(?:(?P<area>P?[IEQA]|M)(?P<size>[XBWDL]?)(?P<byte>\*|[0-9]{1,9})(?:\.(?P<bit>[0-9]{1,9}))?"
    r"|DB(?P<db>[0-9]{1,9})\.DB?(?P<db_size>[XBWD])(?P<db_byte>[0-9]{1,9})"
    r"(?:\.(?P<db_bit>[0-9]{1,9}))?"
    r"|(?P<count>[TCZ])(?P<number>[0-9]{1,9}))(?P<peripheral>:P)?"
)
_MEMBER = re.compile(r"%?D(?:B?(?P<size>[XBWD]))?(?P<byte>[0-9]{1,9})(?:\.(?P<bit>[0-9]{1,9}))?")
_DATA_BLOCK = re.compile(r"%?DB([0-9]{1,9})")
_AREA = re.compile(r"%?(?:(P?[IEQA]|M)([XBWD]?)|([TCZ]))")
_DATA_AREA = re.compile(r"DB?([XBWD])|D")
_SLICE = re.compile(r"%([XBWD])([0-9]{1,2})", re.IGNORECASE)

_ENGLISH = {"E": "I", "A": "Q", "Z": "C"}
_LAST_BIT = 7


def read_address(text: str, place: Span) -> DirectAddress | None:
    """The address of a token such as `%IB256:P` or `MW4`; None if it is none.

    A bit has two numbers (`%I0.3`), anything wider one. `%I0` of IEC is a bit with one number,
    which is bit 0 of nothing in particular, so it is no address here.
    """
    if text[:1] != "%":
        return read_plain_address(text, None, place)
    match = _ADDRESS.fullmatch(text.upper())
    if match is None:
        return None
    peripheral = match["peripheral"] is not None
    if match["count"]:
        area, german = _english(match["count"])
        return None if peripheral else _counted(area, match["number"], german, place)
    if match["db"]:
        size, byte, bit = match["db_size"], match["db_byte"], match["db_bit"]
        return _in_data_block(_sized("DB", size, byte, bit, place), int(match["db"]), peripheral)
    area, german = _english(match["area"].removeprefix("P"))
    peripheral = peripheral or match["area"].startswith("P")
    if match["byte"] == "*":
        size = match["size"]
        return None if match["bit"] else DirectAddress(place, area, size, -1, 0, 0, False, german)
    address = _sized(area, match["size"], match["byte"], match["bit"], place)
    return _spelled(address, peripheral, german)


def read_plain_address(text: str, bit: str | None, place: Span) -> DirectAddress | None:
    """The address of a word such as `MW4`, or of `M0` with its bit."""
    match = PLAIN_ADDRESS.match(text.upper())
    if match is None:
        return None
    if match["count"]:
        area, german = _english(match["count"])
        return None if bit else _counted(area, match["number"], german, place)
    area, german = _english(match["area"].removeprefix("P"))
    address = _sized(area, match["size"], match["number"], bit, place)
    return _spelled(address, match["area"].startswith("P"), german)


def read_member_address(
    block: str, text: str, bit: str | None, place: Span
) -> DirectAddress | None:
    """`DB100` with `DBW4` or `DW4`, or with `DBX0` or `D0` and a bit."""
    number = data_block_number(block)
    match = _MEMBER.fullmatch(text.upper())
    if number is None or match is None:
        return None
    address = _sized("DB", match["size"] or "X", match["byte"], bit or match["bit"], place)
    return _in_data_block(address, number)


def read_marked_member(text: str) -> tuple[str, tuple[int, ...]] | None:
    """Size and numbers of the `%DBX4.1` of `#block.%DBX4.1`."""
    match = _MEMBER.fullmatch(text.upper())
    if match is None or (match["size"] in (None, "X")) != (match["bit"] is not None):
        return None
    size = match["size"] or "X"
    if match["bit"] is None:
        return size, (int(match["byte"]),)
    return (size, (int(match["byte"]), int(match["bit"]))) if int(match["bit"]) <= 7 else None


def data_block_number(text: str) -> int | None:
    """The 100 of `DB100` or `%DB100`."""
    match = _DATA_BLOCK.fullmatch(text.upper())
    return int(match[1]) if match else None


def is_data_block(text: str) -> bool:
    """Whether a name is the absolute name of a data block, such as `DB100`."""
    return data_block_number(text) is not None


def read_area(text: str) -> tuple[str, str, bool, bool] | None:
    """Area, size, whether peripheral, whether German, of `PEB`, `%MW`, `T` in front of an index."""
    match = _AREA.fullmatch(text.upper())
    if match is None:
        return None
    if match[3]:
        area, german = _english(match[3])
        return area, "", False, german
    area, german = _english(match[1].removeprefix("P"))
    return area, match[2] or "X", match[1].startswith("P"), german


def read_data_area(text: str) -> str | None:
    """The size of `DW`, `DBW`, `D` in front of an index."""
    match = _DATA_AREA.fullmatch(text.upper())
    return (match[1] or "X") if match else None


def read_slice(text: str) -> tuple[str, int] | None:
    """Size and number of a slice such as `%X3`."""
    match = _SLICE.fullmatch(text)
    return (match[1].upper(), int(match[2])) if match else None


def _english(area: str) -> tuple[str, bool]:
    return _ENGLISH.get(area, area), area in _ENGLISH


def _counted(area: str, number: str, german: bool, place: Span) -> DirectAddress:
    return DirectAddress(place, area, "", int(number), 0, 0, False, german)


def _sized(area: str, size: str, byte: str, bit: str | None, place: Span) -> DirectAddress | None:
    size = size or "X"
    if (size == "X") != (bit is not None) or (bit is not None and int(bit) > _LAST_BIT):
        return None
    return DirectAddress(place, area, size, int(byte), int(bit or 0))


def _spelled(address: DirectAddress | None, peripheral: bool, german: bool) -> DirectAddress | None:
    if address is None or not (peripheral or german):
        return address
    return DirectAddress(
        address.span, address.area, address.size, address.byte, address.bit, 0, peripheral, german
    )


def _in_data_block(
    address: DirectAddress | None, number: int, peripheral: bool = False
) -> DirectAddress | None:
    if address is None:
        return None
    return DirectAddress(
        address.span, "DB", address.size, address.byte, address.bit, number, peripheral
    )
