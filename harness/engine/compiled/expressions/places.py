"""Places: reading and writing variables, fields, elements, slices and absolute addresses.

An index is checked unless its interval lies inside the bounds. Python itself refuses an index that
is too large, but not one that is negative, so mostly only that side is tested.
"""

from fbgen.lang.checked import (
    AddressRef,
    BoundOf,
    Constant,
    Dereference,
    Expression,
    FieldRef,
    IndexRef,
    MemoryRef,
    Place,
    SliceRef,
    Variable,
    VariableKind,
    VariableRef,
)
from fbgen.lang.types import (
    BOOL,
    VARIANT_VALUE,
    ArrayType,
    BlockType,
    Elementary,
    OpenArrayType,
    StringType,
    StructType,
    Type,
    refers_to_anything,
)
from harness.engine.compiled.code import Code, Level
from harness.engine.compiled.data.model import is_scalar, may_be_unconnected
from harness.engine.compiled.evaluation import Write, named, stored, value
from harness.engine.compiled.expressions.addresses import as_memory_ref, read_address, write_address
from harness.engine.compiled.expressions.conversions import cut
from harness.engine.compiled.expressions.memory_access import spot
from harness.engine.compiled.procedure import Procedure
from harness.engine.compiled.shortening.paths import path_of
from harness.engine.compiled.shortening.ranges import limits, wrapped
from harness.engine.compiled.watching.write_notes import is_steady, note_write, writers_of


def _variable(procedure: Procedure, node: VariableRef) -> Code:
    variable = node.variable
    if variable.address is not None:
        assert isinstance(node.type, Elementary)
        return read_address(procedure, node, variable.address, node.type)
    low, high = procedure.known.get(variable) or limits(node.type)
    alias = procedure.aliases.get(variable)
    text = alias or procedure.text_of(variable)
    simple = alias is not None or "." not in text
    if may_be_unconnected(variable, procedure.context.block):
        procedure.site(text, node)
        return Code(text, Level.ATOM, low, high, safe=False)
    return Code(text, Level.ATOM, low, high, simple=simple)


def _field(procedure: Procedure, node: FieldRef) -> Code:
    if procedure.paths and isinstance(node.type, StructType):
        path = path_of(node)
        if path is not None and path in procedure.paths:
            return Code(procedure.paths[path], simple=True)
    base = place(procedure, node.base)
    assert isinstance(node.base.type, StructType | BlockType)
    record = procedure.context.model.record_of(node.base.type)
    part = record.part(node.name)
    assert part is not None
    was_called = isinstance(node.base, VariableRef) and node.base.variable is procedure.timer
    now = "._now()" if node.name.casefold() in record.following and not was_called else ""
    text = f"{base.text}{now}.{part.slot}"
    low, high = limits(node.type)
    if part.variable is None or part.kind is not VariableKind.IN_OUT:
        return base._replace(text=text, low=low, high=high, simple=False)
    if procedure.has_cell(part.variable):
        text += ".value"
    # An in-out that was never connected has no attribute yet.
    procedure.site(text, node)
    return base._replace(text=text, low=low, high=high, simple=False, safe=False)


def element_position(procedure: Procedure, node: IndexRef) -> tuple[Code, str]:
    """The position of an element in the flat list, and the text of an index to show on failure."""
    kind = node.base.type
    if isinstance(kind, OpenArrayType):
        return _open_position(procedure, node), ""
    assert isinstance(kind, ArrayType)
    if len(kind.bounds) == 1:
        return _single_position(procedure, node, kind.bounds[0])
    codes = [value(procedure, index) for index in node.indices]
    texts: list[str] = []
    constant = 0
    stride = kind.count
    safe = True
    for dimension, (code, (first, last)) in enumerate(zip(codes, kind.bounds, strict=True), 1):
        stride //= last - first + 1
        if code.low == code.high and first <= code.low <= last:
            constant += (code.low - first) * stride
            continue
        if not (first <= code.low and code.high <= last):
            text = f"_checked_index({code.text}, {first}, {last}, {dimension})"
            procedure.site(text, node)
            code = code._replace(text=text, level=Level.ATOM)
            safe = False
        constant -= first * stride
        factor = code.at(Level.PRODUCT)
        texts.append(factor if stride == 1 else f"{factor} * {stride}")
    if constant or not texts:
        texts.append(str(constant))
    return (
        Code(
            " + ".join(texts).replace("+ -", "- "),
            Level.SUM,
            depth=max(code.depth for code in codes) + 2,
            safe=safe and all(code.safe for code in codes),
            pure=all(code.pure for code in codes),
        ),
        "",
    )


def elements(procedure: Procedure, node: Place) -> Code:
    """The flat list with the elements of an array."""
    base = place(procedure, node)
    if isinstance(node.type, OpenArrayType):
        return base._replace(text=f"{base.text}.elements", simple=False)
    return base


def _open_position(procedure: Procedure, node: IndexRef) -> Code:
    """ARRAY[*] knows its bounds itself."""
    base = place(procedure, node.base)
    codes = [value(procedure, index) for index in node.indices]
    method = "at" if len(codes) == 1 else "at_all"
    text = f"{base.text}.{method}({', '.join(code.text for code in codes)})"
    procedure.site(text, node)
    return Code(
        text,
        depth=max(base.depth, *(code.depth for code in codes)) + 1,
        safe=False,
        pure=all(code.pure for code in codes),
    )


def _bound(procedure: Procedure, node: BoundOf) -> Code:
    base = place(procedure, node.base)
    low, high = limits(node.type)
    text = f"{base.text}.bounds[{node.dimension}][{int(node.upper)}]"
    return base._replace(text=text, low=low, high=high, simple=False)


def _single_position(
    procedure: Procedure, node: IndexRef, bounds: tuple[int, int]
) -> tuple[Code, str]:
    first, last = bounds
    index = node.indices[0]
    code = value(procedure, index)
    if isinstance(index, Constant):
        return Code(str(code.low - first), simple=True), ""
    inside = first <= code.low and code.high <= last
    minus = f" - {first}" if first > 0 else f" + {-first}" if first < 0 else ""
    if inside:
        text = f"{code.at(Level.SUM)}{minus}" if minus else code.text
        return code._replace(text=text, level=Level.SUM, depth=code.depth + 1), ""
    if not code.pure:
        call = f"_checked_index({code.text}, {first}, {last})"
        procedure.site(call, node)
        return code._replace(text=call + minus, depth=code.depth + 1, safe=False), ""
    if code.low >= first:
        text = f"{code.at(Level.SUM)}{minus}" if minus else code.text
        return code._replace(text=text, depth=code.depth + 1, safe=False), code.text
    start, again = named(procedure, code)
    bad = f"_bad_index({again})"
    procedure.site(bad, node)
    text = f"{again}{minus} if {start} >= {first} else {bad}"
    return code._replace(text=text, depth=code.depth + 2, safe=False), code.text


def _element(procedure: Procedure, node: IndexRef) -> Code:
    base = elements(procedure, node.base)
    position, shown = element_position(procedure, node)
    text = f"{base.text}[{position.text}]"
    if shown:
        procedure.site(text, node, shown)
    low, high = limits(node.type)
    return Code(
        text,
        Level.ATOM,
        low,
        high,
        max(base.depth, position.depth) + 1,
        base.safe and position.safe,
        base.pure and position.pure,
    )


def _slice(procedure: Procedure, node: SliceRef) -> Code:
    base = value(procedure, node.base)
    bits = node.type.bits
    shift = node.index * bits
    if node.type == BOOL:
        text = f"{base.at(Level.BIT_AND)} & {hex(1 << shift)} != 0"
        return base._replace(
            text=text, level=Level.COMPARISON, low=0, high=0, depth=base.depth + 1, simple=False
        )
    text = f"{base.at(Level.SHIFT)} >> {shift}" if shift else base.at(Level.BIT_AND)
    return base._replace(
        text=f"{text} & {hex((1 << bits) - 1)}",
        level=Level.BIT_AND,
        low=0,
        high=(1 << bits) - 1,
        depth=base.depth + 2,
        simple=False,
    )


def _address(procedure: Procedure, node: AddressRef) -> Code:
    return read_address(procedure, node, node.address, node.type)


def memory_cell(procedure: Procedure, node: MemoryRef) -> Code:
    """The place at an address that is worked out at run time, as a cell."""
    context = procedure.context
    texts = [context.table("spot", spot(node, context.shapes)), *_whereabouts(procedure, node)]
    return Code(f"_memory_at({', '.join(texts)})", depth=5, safe=False)


def _whereabouts(procedure: Procedure, node: MemoryRef) -> list[str]:
    parts = [node.area, node.db, node.byte, *([] if node.bit is None else [node.bit])]
    return ["0" if one is None else value(procedure, one).text for one in parts]


def _memory(procedure: Procedure, node: MemoryRef) -> Code:
    cell = memory_cell(procedure, node)
    if not is_scalar(node.type):
        return cell
    low, high = limits(node.type)
    return cell._replace(text=f"{cell.text}.value", low=low, high=high)


def _assign_memory(procedure: Procedure, node: MemoryRef, code: Code) -> None:
    context = procedure.context
    texts = [context.table("spot", spot(node, context.shapes)), *_whereabouts(procedure, node)]
    procedure.line(f"_write_memory({stored(code).text}, {', '.join(texts)})")


def place(procedure: Procedure, node: Place) -> Code:
    """The Python text that a place is read by, and, but for slices and addresses, written."""
    return value(procedure, node)


def assign(procedure: Procedure, target: Place, code: Code, source: Type, writer: str = "") -> None:
    """Write statements that give a place a value; `source` is the type of the value.

    `writer` is the text of an entry of `Writers`, if another one than the statement writes it.
    """
    if writers_of(procedure) is not None and not is_steady(target):
        target, code = _steady(procedure, target, code)
    if isinstance(target, SliceRef):
        _assign_slice(procedure, target, code)
    elif isinstance(target, MemoryRef):
        _assign_memory(procedure, target, code)
    elif isinstance(target, AddressRef):
        write_address(procedure, target, target.address, target.type, code)
    elif isinstance(target, VariableRef) and target.variable.address is not None:
        assert isinstance(target.type, Elementary)
        write_address(procedure, target, target.variable.address, target.type, code)
    elif is_scalar(target.type):
        if isinstance(target.type, StringType) and isinstance(source, StringType):
            code = cut(code, source.length, target.type)
        text = place(procedure, target).text
        code = stored(code)
        held = text
        if isinstance(target, VariableRef) and target.variable in procedure.aliases:
            attribute = held = procedure.text_of(target.variable)
            if procedure.unwritten is None:
                text = f"{attribute} = {text}"
            else:
                procedure.unwritten[attribute] = text
        if code.text.startswith("_rounded(") and _closes_at_end(code.text):
            # Storing into the cell directly saves a call.
            procedure.line(f"_cell[0] = {code.text[len('_rounded(') : -1]}")
            procedure.line(f"{text} = _cell[0]")
        else:
            procedure.line(f"{text} = {code.text}")
        note_write(procedure, held, target.type, writer)
    else:
        text = place(procedure, target).text
        copy_into(procedure, text, target.type, code.text)
        note_write(procedure, text, target.type, writer)


def _steady(procedure: Procedure, target: Place, code: Code) -> tuple[Place, Code]:
    """The place with its indices worked out, behind the value if that does more than to read."""
    if not code.pure:
        name = procedure.temporary()
        procedure.line(f"{name} = {code.text}")
        code = code._replace(
            text=name, level=Level.ATOM, depth=1, safe=True, pure=True, simple=True
        )
    return pinned(procedure, target), code


def _closes_at_end(text: str) -> bool:
    """True if the first bracket is closed by the last character."""
    depth = 0
    for position, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if character in "\"'":
            return False
        if depth == 0 and character == ")":
            return position == len(text) - 1
    return False


def copy_into(procedure: Procedure, target: str, kind: Type, source: str) -> None:
    """Write statements that copy a structure or an array into another one."""
    if isinstance(kind, ArrayType):
        if is_scalar(kind.element):
            procedure.line(f"{target}[:] = {source}")
            return
        one, two = procedure.temporary(), procedure.temporary()
        procedure.line(f"for {one}, {two} in zip({target}, {source}):")
        procedure.listing.indent += 4
        copy_into(procedure, one, kind.element, two)
        procedure.listing.indent -= 4
    else:
        procedure.line(f"{target}._assign({source})")


def _assign_slice(procedure: Procedure, target: SliceRef, code: Code) -> None:
    if not code.simple:
        name = procedure.temporary()
        procedure.line(f"{name} = {code.text}")
        code = code._replace(text=name, level=Level.ATOM, simple=True)
    base = pinned(procedure, target.base)
    kind = base.type
    assert isinstance(kind, Elementary)
    whole = place(procedure, base)
    bits = target.type.bits
    shift = target.index * bits
    kept = (1 << kind.bits) - 1 & ~(((1 << bits) - 1) << shift)
    old = f"{whole.at(Level.BIT_AND)} & {hex(kept)}"
    if target.type == BOOL:
        bit = hex(1 << shift)
        text = f"{whole.at(Level.BIT_OR)} | {bit} if {code.text} else {old}"
        result = Code(text, Level.CONDITIONAL)
    else:
        part = f"{code.text} << {shift}" if shift else code.text
        result = Code(f"{old} | {part}", Level.BIT_OR)
    result = result._replace(low=0, high=(1 << kind.bits) - 1, depth=whole.depth + 3)
    if kind.is_signed:
        # The sign bit may have been set or cleared: look at the low bits anew.
        result = result._replace(low=-(1 << kind.bits), high=2 << kind.bits)
    assign(procedure, base, wrapped(result, kind, procedure.temporary), kind)


def pinned(procedure: Procedure, node: Place) -> Place:
    """The same place with its indices calculated now, so that it may be written several times."""
    if isinstance(node, FieldRef):
        base = pinned(procedure, node.base)
        return node if base is node.base else FieldRef(node.span, base, node.name, node.type)
    if isinstance(node, SliceRef):
        base = pinned(procedure, node.base)
        return node if base is node.base else SliceRef(node.span, base, node.index, node.type)
    if isinstance(node, IndexRef):
        base = pinned(procedure, node.base)
        indices = tuple(_pinned_index(procedure, node, i) for i in range(len(node.indices)))
        return IndexRef(node.span, base, indices, node.type)
    if isinstance(node, MemoryRef):
        area, byte = _pinned_number(procedure, node.area), _pinned_number(procedure, node.byte)
        db = None if node.db is None else _pinned_number(procedure, node.db)
        bit = None if node.bit is None else _pinned_number(procedure, node.bit)
        return MemoryRef(node.span, area, db, byte, bit, node.type)
    if isinstance(node, Dereference):
        base = pinned(procedure, node.base)
        return node if base is node.base else Dereference(node.span, base, node.type)
    return node


def _pinned_number(procedure: Procedure, node: Expression) -> Expression:
    """A number, calculated now."""
    if isinstance(node, Constant):
        return node
    code = value(procedure, node)
    name = procedure.temporary()
    procedure.line(f"{name} = {code.text}")
    pin = Variable(node.span, name, VariableKind.TEMP, node.type)
    procedure.aliases = {**procedure.aliases, pin: name}
    return VariableRef(node.span, pin, node.type)


def _pinned_index(procedure: Procedure, node: IndexRef, number: int) -> Expression:
    index = node.indices[number]
    if isinstance(index, Constant):
        return index
    code = value(procedure, index)
    kind = node.base.type
    if isinstance(kind, OpenArrayType):
        # The access itself looks at its bounds, each time.
        first, last = limits(index.type)
    else:
        assert isinstance(kind, ArrayType)
        first, last = kind.bounds[number]
    name = procedure.temporary()
    if first <= code.low and code.high <= last:
        procedure.line(f"{name} = {code.text}")
    else:
        text = f"_checked_index({code.text}, {first}, {last}, {number + 1})"
        procedure.site(text, node)
        procedure.line(f"{name} = {text}")
    pin = Variable(index.span, name, VariableKind.TEMP, index.type)
    procedure.aliases = {**procedure.aliases, pin: name}
    procedure.known = {**procedure.known, pin: (first, last)}
    return VariableRef(index.span, pin, index.type)


def cell(procedure: Procedure, node: Place) -> Code:
    """A reference to the place of a single value."""
    if isinstance(node, VariableRef):
        if procedure.has_cell(node.variable):
            return Code(procedure.storage(node.variable))
        owner, name = procedure.owner(node.variable)
        return Code(f"_AttributeCell({owner}, {name!r})", depth=2)
    if isinstance(node, FieldRef):
        base, _, name = place(procedure, node).text.rpartition(".")
        if name == "value":
            return Code(base)
        return Code(f"_AttributeCell({base}, {name!r})", depth=3)
    if isinstance(node, AddressRef):
        node = as_memory_ref(node, node.address)
    if isinstance(node, MemoryRef):
        return memory_cell(procedure, node)
    if isinstance(node, Dereference):
        reference = place(procedure, node.base)
        text = f"_target({reference.text})"
        if refers_to_anything(node.base.type) and node.type != VARIANT_VALUE:
            text = f"{reference.text}.target"
        procedure.site(text, node)
        return Code(text, depth=reference.depth + 1, safe=False)
    assert isinstance(node, IndexRef)
    base_code = elements(procedure, node.base)
    kind = node.base.type
    position, shown = element_position(procedure, node)
    if shown:
        assert isinstance(kind, ArrayType)
        first, last = kind.bounds[0]
        text = f"_checked_index({shown}, {first}, {last})"
        procedure.site(text, node)
        position = Code(f"{text} - {first}" if first else text, depth=position.depth + 1)
    return Code(f"_ElementCell({base_code.text}, {position.text})", depth=position.depth + 2)


EXPRESSIONS: dict[type, Write] = {
    VariableRef: _variable,
    FieldRef: _field,
    IndexRef: _element,
    SliceRef: _slice,
    BoundOf: _bound,
    AddressRef: _address,
    MemoryRef: _memory,
}
"""Which function of this module writes which node."""
