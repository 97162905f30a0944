"""Absolute addresses: the process image, bit memory, the peripheral and bytes of data blocks.

Bytes are big endian. Whether an address lies inside its area is known when the program is loaded;
one outside stops the program only when it gets there.
"""

from fbgen.lang.checked import Address, AddressRef, VariableRef
from fbgen.lang.types import (
    BOOL,
    DWORD,
    LWORD,
    REAL,
    Elementary,
    Family,
)
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.ranges import limits, masked, wrapped

_AREAS = {"I": "_environment.inputs", "Q": "_environment.outputs", "M": "_environment.markers"}
_SIZES = {1: "X", 8: "B", 16: "W", 32: "D", 64: "L"}


def spelled(address: Address) -> str:
    """The address as it is written."""
    size = _SIZES[address.bits]
    place = f"{address.byte}.{address.bit}" if address.bits == 1 else f"{address.byte}"
    if address.area == "DB":
        return f"%DB{address.db}.DB{size}{place}"
    return f"%{address.area}{size}{place}"


def _bytes(address: Address) -> int:
    return max(1, address.bits // 8)


def _inside(procedure: Procedure, address: Address) -> bool:
    return address.byte + _bytes(address) <= procedure.context.image_sizes[address.area]


def read_address(
    procedure: Procedure, node: AddressRef | VariableRef, address: Address, kind: Elementary
) -> Code:
    """The value at an address, as a value of the type."""
    count = _bytes(address)
    bits = 8 * count
    safe = not address.peripheral
    if address.area == "DB":
        table = procedure.context.table("address", node)
        code = Code(f"_read_block({table})", depth=2, safe=False)
        procedure.site(code.text, node)
    elif address.peripheral:
        code = Code(f"_environment.read_peripheral({address.byte}, {count})", depth=2, safe=False)
    elif not _inside(procedure, address):
        code = Code(f"_outside({spelled(address)!r})", depth=2, safe=False)
        procedure.site(code.text, node)
    else:
        code = _image(address, count)
    pure = not address.peripheral
    code = code._replace(low=0, high=(1 << bits) - 1, safe=code.safe and safe, pure=pure)
    if address.bits == 1:
        mask = hex(1 << address.bit)
        text = f"{code.at(Level.BIT_AND)} & {mask} != 0"
        return code._replace(text=text, level=Level.COMPARISON, low=0, high=0, depth=3)
    return _typed(procedure, code, kind)


def _image(address: Address, count: int) -> Code:
    area, byte = _AREAS[address.area], address.byte
    if count == 1:
        return Code(f"{area}[{byte}]", depth=2)
    if count == 2:
        return Code(f"{area}[{byte}] << 8 | {area}[{byte + 1}]", Level.BIT_OR, depth=3)
    return Code(f'int.from_bytes({area}[{byte}:{byte + count}], "big")', depth=3)


def _typed(procedure: Procedure, code: Code, kind: Elementary) -> Code:
    low, high = limits(kind)
    if kind.family is Family.REAL:
        function = "_real_of_bits" if kind == REAL else "_long_real_of_bits"
        return code._replace(text=f"{function}({code.text})", level=Level.ATOM, low=0, high=0)
    if kind.family is Family.CHAR:
        return code._replace(text=f"chr({code.text})", level=Level.ATOM, low=0, high=0)
    if kind == BOOL:
        text = f"{code.at(Level.BIT_AND)} & 1 == 1"
        return code._replace(text=text, level=Level.COMPARISON, low=0, high=0)
    code = wrapped(code, kind, procedure.temporary)
    return code._replace(low=max(low, code.low), high=min(high, code.high))


def write_address(
    procedure: Procedure,
    node: AddressRef | VariableRef,
    address: Address,
    kind: Elementary,
    code: Code,
) -> None:
    """Write statements that put a value of the type at an address."""
    count = _bytes(address)
    if address.bits > 1:
        code = _as_bits(code, kind)
    if address.area == "DB":
        table = procedure.context.table("address", node)
        text = f"_write_block({table}, {code.text})"
        procedure.site(text, node)
        procedure.line(text)
    elif not address.peripheral and not _inside(procedure, address):
        text = f"_outside({spelled(address)!r})"
        procedure.site(text, node)
        procedure.line(text)
    elif address.peripheral:
        _write_peripheral(procedure, address, code)
    elif address.bits == 1:
        area, byte = _AREAS[address.area], address.byte
        procedure.line(_bit(f"{area}[{byte}]", address.bit, code))
    elif count == 1:
        procedure.line(f"{_AREAS[address.area]}[{address.byte}] = {code.text}")
    else:
        area, byte = _AREAS[address.area], address.byte
        number = code.at(Level.ATOM) if not code.text.isdigit() else f"({code.text})"
        procedure.line(f'{area}[{byte}:{byte + count}] = {number}.to_bytes({count}, "big")')


def _bit(place: str, bit: int, code: Code) -> str:
    kept = 0xFF & ~(1 << bit)
    return f"{place} = {place} | {1 << bit} if {code.text} else {place} & {kept}"


def _write_peripheral(procedure: Procedure, address: Address, code: Code) -> None:
    if address.bits > 1:
        count = _bytes(address)
        procedure.line(f"_environment.write_peripheral({address.byte}, {count}, {code.text})")
        return
    # A single bit goes out with the other bits of its byte as they stand in the image.
    name = procedure.temporary()
    procedure.line(f"{name} = _environment.outputs[{address.byte}]")
    procedure.line(_bit(name, address.bit, code))
    procedure.line(f"_environment.write_peripheral({address.byte}, 1, {name})")


def _as_bits(code: Code, kind: Elementary) -> Code:
    if kind.family is Family.REAL:
        function = "_bits_of_real" if kind == REAL else "_bits_of_long_real"
        unsigned = DWORD if kind == REAL else LWORD
        return Code(f"{function}({code.text})", high=unsigned.maximum, depth=code.depth + 1)
    if kind.family is Family.CHAR:
        return Code(f"ord({code.text})", high=(1 << kind.bits) - 1, depth=code.depth + 1)
    if kind == BOOL:
        return Code(f"+{code.at(Level.SIGN)}", Level.SIGN, 0, 1, code.depth + 1)
    return masked(code, kind.bits)
