"""Absolute addresses: the process image, bit memory, the peripheral and bytes of data blocks.

Bytes are big endian. Whether an address lies inside its area is known when the program is loaded;
one outside stops the program only when it gets there.
"""

from fbgen.lang.checked import Address, AddressRef, Constant, MemoryRef, VariableRef
from fbgen.lang.types import (
    BOOL,
    DINT,
    DWORD,
    LWORD,
    REAL,
    Elementary,
    Family,
)
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.ranges import limits, masked, wrapped
from harness.engine.compiled.watching.write_notes import note_outputs

_AREAS = {"I": "_environment.inputs", "Q": "_environment.outputs", "M": "_environment.markers"}
_CODES = {"I": 0x81, "Q": 0x82, "M": 0x83, "DB": 0x84}


def _bytes(address: Address) -> int:
    return max(1, address.bits // 8)


def as_memory_ref(node: AddressRef | VariableRef, address: Address) -> MemoryRef:
    """The same place, as one that is worked out at run time."""

    def number(value: int) -> Constant:
        return Constant(node.span, value, DINT)

    code = _CODES[address.area]
    if address.peripheral:
        code = 1 if address.area == "I" else 2
    bit = number(address.bit) if address.bits == 1 else None
    db, byte = number(address.db), number(address.byte)
    return MemoryRef(node.span, number(code), db, byte, bit, node.type)


def _size(procedure: Procedure, address: Address) -> int | None:
    """The bytes of the area; None for a data block that has none."""
    data = procedure.context.shapes
    return data.block_size(address.db) if address.area == "DB" else data.image_sizes[address.area]


def _area(procedure: Procedure, address: Address) -> str:
    """The Python text for the bytes of the area, which is there."""
    if address.area != "DB":
        return _AREAS[address.area]
    model = procedure.context.model
    return f"{model.global_name(model.program.data_blocks[address.db])}._memory"


def _outside(procedure: Procedure, node: AddressRef | VariableRef, address: Address) -> str:
    """The Python text that stops at an address which is nowhere; "" for one that is somewhere."""
    size = _size(procedure, address)
    if size is not None and address.byte + _bytes(address) <= size:
        return ""
    text = f"_no_block({address.db})" if size is None else f"_outside({size})"
    procedure.site(text, node)
    return text


def read_address(
    procedure: Procedure, node: AddressRef | VariableRef, address: Address, kind: Elementary
) -> Code:
    """The value at an address, as a value of the type."""
    count = _bytes(address)
    bits = 8 * count
    safe = not address.peripheral
    if id(node) in procedure.at_hand:
        code, safe = Code(procedure.at_hand[id(node)], simple=True), True
    elif address.peripheral:
        code = Code(f"_environment.read_peripheral({address.byte}, {count})", depth=2, safe=False)
    elif outside := _outside(procedure, node, address):
        code = Code(outside, depth=2, safe=False)
    else:
        code = _image(_area(procedure, address), address.byte, count)
    pure = safe
    code = code._replace(low=0, high=(1 << bits) - 1, safe=code.safe and safe, pure=pure)
    if address.bits == 1:
        mask = hex(1 << address.bit)
        text = f"{code.at(Level.BIT_AND)} & {mask} != 0"
        return code._replace(text=text, level=Level.COMPARISON, low=0, high=0, depth=3)
    return _typed(procedure, code, kind)


def _image(area: str, byte: int, count: int) -> Code:
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
    outside = "" if address.peripheral else _outside(procedure, node, address)
    if outside:
        procedure.line(outside)
    elif address.peripheral:
        _write_peripheral(procedure, address, code)
    elif address.bits == 1:
        area, byte = _area(procedure, address), address.byte
        procedure.line(_bit(f"{area}[{byte}]", address.bit, code))
    elif count == 1:
        procedure.line(f"{_area(procedure, address)}[{address.byte}] = {code.text}")
    else:
        area, byte = _area(procedure, address), address.byte
        number = code.at(Level.ATOM) if not code.text.isdigit() else f"({code.text})"
        procedure.line(f'{area}[{byte}:{byte + count}] = {number}.to_bytes({count}, "big")')
    if address.area == "Q" and not outside:
        note_outputs(procedure, address.byte, count)


def _bit(place: str, bit: int, code: Code) -> str:
    kept = 0xFF & ~(1 << bit)
    return f"{place} = {place} | {1 << bit} if {code.text} else {place} & {kept}"


def _write_peripheral(procedure: Procedure, address: Address, code: Code) -> None:
    if address.bits > 1:
        if procedure.gathered is not None:
            procedure.gathered.append(code.text)
            return
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
