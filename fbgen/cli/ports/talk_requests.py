"""What a person asks an inverter, in words: `read 11 output_current`, `write 11 frequency 50`."""

import re
from collections.abc import Iterator, Sequence
from enum import Enum

from fbgen.catalog import ComNo, Drive, Word, parse_word
from fbgen.catalog.comno_names import named_comno
from fbgen.cli.frames.motor_start import STARTS
from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.wire import modbus, modbus_rtu, toshiba, toshiba_ascii, toshiba_binary

_INV_NO = re.compile(r"\d{1,3}(?:-\d{1,3})?")
_RAW = re.compile(r"(?:16#|0x|2#|0b).+|[0-9A-Fa-f]+h", re.IGNORECASE)
_NUMBER = re.compile(r"\d{4}|[0-9A-Fa-f]{4}|0[xX][0-9A-Fa-f]{1,4}")
_ALL = ("all", "broadcast")
SCAN = "scan"
_ALONE = ("names", "help", "quit")
FORWARD = "forward"
"""No bit of any word: it says that `reverse` is 0."""
HOW = {
    "read": "read [INV-NO] COMNO ...      read 11 output_current, read 1-5 FD01 FC90",
    "write": "write [INV-NO] COMNO VALUE   write 11 frequency 50, write 11 FA01 1388h, "
    "write 11 command run forward network_command [--eeprom] [--yes]",
}


class Form(Enum):
    """How frames of the Toshiba protocol are spelled."""

    BINARY = "binary"
    ASCII = "ascii"


@dataclass(frozen=True, slots=True)
class Talking:
    """In which language questions are put: protocol, form, series, INV-NO where none is said."""

    series: Drive
    protocol: str
    form: Form = Form.BINARY
    inv_no: int | None = None


@dataclass(frozen=True, slots=True)
class Question:
    """One telegram. `inv_no` is None for all inverters; `word` None to read; `warning` a remark."""

    inv_no: int | None
    com_no: int
    comno: ComNo | None
    frame: bytes
    word: int | None = None
    answered: bool = True
    starts: bool = False
    warning: str = ""


def questions(words: Sequence[str], talking: Talking) -> list[Question]:
    """The telegrams that a line asks for.

    Raises DiagnosticError FB9050 for what is no question, FB1105, FB1202, FB1203 and FB1204 for
    names and values.
    """
    plain = [word for word in words if word != "--eeprom"]
    verb = plain[0] if plain else ""
    if verb not in HOW:
        raise _no_question(verb)
    numbers, rest = _inverters(plain[1:], verb, talking)
    eeprom = len(plain) < len(words)
    if verb == "read":
        if eeprom:
            raise error("FB9050", "reading leaves the EEPROM alone", None, "leave out --eeprom")
        if not rest:
            raise _incomplete(verb)
        if None in numbers:
            message = "nobody answers what is read from all inverters"
            raise error("FB9050", message, None, "name one, or several: read 1-5 status")
        return [_read(number, key, talking) for number in numbers for key in rest]
    if len(rest) < 2:
        raise _incomplete(verb)
    return [_write(number, rest[0], rest[1:], talking, eeprom=eeprom) for number in numbers]


def _no_question(verb: str) -> DiagnosticError:
    if verb == SCAN:
        way = "leave this by quit, and write it on the command line: fbgen talk --port P scan"
        return error(
            "FB9050", "scan opens the port itself, with one speed after the other", None, way
        )
    if verb in _ALONE:
        return error("FB9050", f"'{verb}' takes no words", None, "write it alone")
    help_ = nearest(verb, (*HOW, SCAN, *_ALONE))
    return error("FB9050", f"'{verb}' is nothing that can be asked", None, help_)


def _incomplete(verb: str) -> DiagnosticError:
    return error("FB9050", f"this is not all of '{verb}'", None, f"write: {HOW[verb]}")


def _inverters(
    words: Sequence[str], verb: str, talking: Talking
) -> tuple[list[int | None], Sequence[str]]:
    """The INV-NOs that are meant, None for all, and what follows them."""
    first = words[0] if words else ""
    if first in _ALL:
        return [None], words[1:]
    if _INV_NO.fullmatch(first):
        low, _, high = first.partition("-")
        found = list(range(int(low), int(high or low) + 1))
        highest = _highest(talking)
        if not found or found[-1] > highest:
            message = f"'{first}' is no INV-NO"
            more = "; in ASCII (--ascii) to 99" if highest == toshiba.HIGHEST_BINARY_INV_NO else ""
            raise error("FB9050", message, None, f"they go from 0 to {highest}{more}")
        return [*found], words[1:]
    if talking.inv_no is None:
        raise error(
            "FB9050", "it is not said which inverter", None, f"write: {HOW[verb]}; or give --inv-no"
        )
    return [talking.inv_no], words


def _highest(talking: Talking) -> int:
    if talking.protocol == "modbus":
        return modbus.HIGHEST_ADDRESS
    return toshiba.HIGHEST_BINARY_INV_NO if talking.form is Form.BINARY else 99


def _read(inv_no: int | None, key: str, talking: Talking) -> Question:
    com_no, comno = _cell(key, talking.series)
    frame = _frame(inv_no, toshiba.Command.R, com_no, 0, talking)
    return Question(inv_no, com_no, comno, frame)


def _write(
    inv_no: int | None, key: str, values: Sequence[str], talking: Talking, *, eeprom: bool
) -> Question:
    com_no, comno = _cell(key, talking.series)
    bits = _bits_of(comno, talking.series)
    word = _word(comno, bits, values)
    command = toshiba.Command.W if eeprom else toshiba.Command.P
    if talking.protocol == "modbus":
        _check_eeprom(talking.series, eeprom)
    set_bits = [] if bits is None else [item for item in bits.decode(word) if item.value]
    names = {item.field.name for item in set_bits}
    warning = ""
    if bits is not None and bits.needs is not None and bits.needs not in names:
        acting = [item.field.name for item in set_bits if not item.field.always]
        if acting:
            warning = f"without {bits.needs} nothing comes of {', '.join(acting)}"
    return Question(
        *(inv_no, com_no, comno, _frame(inv_no, command, com_no, word, talking), word),
        answered=inv_no is not None and all(item.field.answered for item in set_bits),
        starts=not names.isdisjoint(STARTS),
        warning=warning,
    )


def _check_eeprom(series: Drive, eeprom: bool) -> None:
    """MODBUS does not say where a value stays: the series does. FB9050 if that is not wanted."""
    service = series.communication.modbus if series.communication is not None else None
    uses = service.accesses if service is not None else ()
    kept = next((use.keeps for use in uses if use.function == "write"), "ram")
    if (kept == "eeprom") is eeprom:
        return
    message = f"'{series.id}' keeps what MODBUS writes in its {kept.upper()}"
    help_ = "say --eeprom; a cell stands some 10,000 writes" if not eeprom else "leave out --eeprom"
    raise error("FB9050", message, None, help_)


def _cell(key: str, series: Drive) -> tuple[int, ComNo | None]:
    """The number of a ComNo, with what the catalogue says of it. FB1105 for a name of none."""
    try:
        comno = named_comno(series, key)
    except DiagnosticError:
        if _NUMBER.fullmatch(key) is None:
            raise
        return int(key, 16), None
    return comno.number, comno


def _bits_of(comno: ComNo | None, series: Drive) -> Word | None:
    return None if comno is None or comno.word is None else series.word(comno.word)


def _word(comno: ComNo | None, bits: Word | None, values: Sequence[str]) -> int:
    """The word that is meant: by bits, as it is, or as a value in its unit."""
    text = values[0]
    if bits is not None and not _is_word(text):
        return bits.encode(dict(_bit_values(bits, values)))
    if len(values) > 1:
        raise error(
            "FB9050", f"{len(values)} values for one ComNo", None, "only a word has bits by name"
        )
    if comno is None or bits is not None or _RAW.fullmatch(text):
        return parse_word(text)
    try:
        word = comno.to_word(float(text))
    except (ValueError, OverflowError):
        word = -1
    if not 0 <= word <= 0xFFFF:
        limit = f"{comno.to_value(0xFFFF):g} {comno.unit}".rstrip()
        message = f"'{text}' is no value of {comno.name} ({comno.hex})"
        raise error("FB9050", message, None, f"use 0 to {limit}, or a word such as 1388h")
    return word


def _is_word(text: str) -> bool:
    try:
        parse_word(text)
    except DiagnosticError:
        return False
    return True


def _bit_values(bits: Word, values: Sequence[str]) -> Iterator[tuple[str, int]]:
    for text in values:
        name, equals, number = text.partition("=")
        if name == FORWARD and not equals and all(field.name != FORWARD for field in bits.bits):
            if "reverse" in values:
                raise error("FB9050", "forward and reverse at once", None, "write one of them")
            continue
        try:
            yield name, int(number, 0) if equals else 1
        except ValueError:
            message = f"'{number}' is no number for '{name}'"
            raise error("FB9050", message, None, "write name=5 or name=0x1F") from None


def _frame(
    inv_no: int | None, command: toshiba.Command, com_no: int, word: int, talking: Talking
) -> bytes:
    if talking.protocol == "modbus":
        address = modbus.BROADCAST if inv_no is None else inv_no
        asked: modbus.Request = modbus.ReadRequest(address, com_no)
        if command is not toshiba.Command.R:
            asked = modbus.WriteRequest(address, com_no, word)
        return modbus_rtu.encode_request(asked)
    number = toshiba.BROADCAST if inv_no is None else inv_no
    form = toshiba.Form.BINARY if talking.form is Form.BINARY else toshiba.Form.ASCII
    request = toshiba.Request(number, command, com_no, word, form)
    if form is toshiba.Form.BINARY:
        return toshiba_binary.encode_request(request)
    return toshiba_ascii.encode_request(request)
