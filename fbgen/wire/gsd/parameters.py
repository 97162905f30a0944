"""User parameters in a GSD file: the bytes behind the seven that every Set_Prm has, preset.

They come as bytes (User_Prm_Data, Ext_User_Prm_Data_Const) and as named values with a type, a
preset and a range (ExtUserPrmData), which Ext_User_Prm_Data_Ref puts into a byte. Words are
big-endian.
"""

from collections.abc import Mapping

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.wire.gsd.lines import Kind
from fbgen.wire.gsd.statements import Block, Statement, number_of
from fbgen.wire.gsd.values import not_a, numbers_of, octets_of

_LENGTHS = {"unsigned8": 1, "unsigned16": 2, "unsigned32": 4}
_LENGTHS |= {"signed8": 1, "signed16": 2, "signed32": 4}
_LONGEST = 244
"""Set_Prm has up to 244 bytes, seven of them the standard ones."""


@dataclass(frozen=True, slots=True)
class NamedParameter:
    """A parameter with a name: its type in small letters, its bits, what it is preset to."""

    name: str
    type: str
    bits: tuple[int, ...]
    preset: int

    def put_into(self, data: bytearray, offset: int) -> None:
        """Write the preset at a place; bits leave their neighbours alone."""
        if self.type in ("bit", "bitarea"):
            low, high = (self.bits[0], self.bits[-1]) if self.bits else (0, 0)
            mask = ((1 << (high - low + 1)) - 1) << low & 0xFF if low <= high else 0
            _reach(data, offset + 1)
            data[offset] = data[offset] & ~mask | self.preset << low & mask
            return
        length = _LENGTHS.get(self.type, 0)
        _reach(data, offset + length)
        whole = self.preset % (1 << 8 * length) if length else 0
        data[offset : offset + length] = whole.to_bytes(length, "big")


def named_parameter(block: Block, findings: list[Diagnostic]) -> tuple[int, NamedParameter] | None:
    """The number and the parameter of an ExtUserPrmData block; None and FB1303 for what is none."""
    number, name = _number_and_text(block.head)
    if number is None:
        findings.append(not_a("a number and a text in quotes", block.head))
        return None
    for line in block.statements:
        if line.key in (*_LENGTHS, "bit", "bitarea"):
            values = numbers_of(line.value)
            bits = tuple(bit & 7 for bit in line.index)
            return number, NamedParameter(name, line.key, bits, values[0] if values else 0)
    return None


def preset_parameters(
    statements: tuple[Statement, ...],
    named: Mapping[int, NamedParameter],
    length: int | None,
    findings: list[Diagnostic],
) -> bytes:
    """The preset bytes of a station or module, `length` many where the file says how many."""
    data = bytearray()
    for line in statements:
        if line.key == "user_prm_data" and not line.index:
            data[:] = octets_of(line.value, line, findings) or b""
    for line in statements:
        if line.key == "ext_user_prm_data_const":
            offset = line.index[0] if line.index else 0
            octets = octets_of(line.value, line, findings) or b""
            if _fits(line, offset, len(octets), findings):
                _reach(data, offset + len(octets))
                data[offset : offset + len(octets)] = octets
    for line in statements:
        if line.key == "ext_user_prm_data_ref":
            _put(line, named, data, findings)
    if length is not None:
        _reach(data, min(length, _LONGEST))
    return bytes(data)


def _number_and_text(head: Statement) -> tuple[int | None, str]:
    """`= 3 "name"`: the number, None where there is none, and the text."""
    words = [token for token in head.value if token.kind is Kind.WORD]
    texts = [token.text for token in head.value if token.kind is Kind.TEXT]
    return (number_of(words[0].text) if words else None), (texts[0].strip() if texts else "")


def _put(
    line: Statement,
    named: Mapping[int, NamedParameter],
    data: bytearray,
    findings: list[Diagnostic],
) -> None:
    offset = line.index[0] if line.index else 0
    numbers = numbers_of(line.value)
    if not numbers:
        findings.append(not_a("the number of an ExtUserPrmData", line))
    elif numbers[0] not in named:
        findings.append(
            Diagnostic(
                "FB1309",
                f"there is no ExtUserPrmData {numbers[0]}",
                line.value_span,
                "the parameter is left out",
                severity=Severity.WARNING,
            )
        )
    elif _fits(line, offset, 1, findings):
        named[numbers[0]].put_into(data, offset)


def _fits(line: Statement, offset: int, length: int, findings: list[Diagnostic]) -> bool:
    if offset + length <= _LONGEST:
        return True
    findings.append(
        Diagnostic(
            "FB1309",
            f"byte {offset} lies behind the {_LONGEST} bytes of Set_Prm",
            line.span,
            "the line is left out",
            severity=Severity.WARNING,
        )
    )
    return False


def _reach(data: bytearray, length: int) -> None:
    data.extend(bytes(max(0, length - len(data))))
