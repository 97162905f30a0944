"""Names and absolute addresses: the places that values are read from and written to.

`MW4` and `M0.1` are addresses where the dialect has them without `%`, unless the block declares
something of that name. Source: TIA Portal help, "Indirect addressing in SCL" and "Addressing of
DB_ANY"; published S7-SCL sources.
"""

import re
from abc import ABC, abstractmethod

from fbgen.lang.ast import (
    Argument,
    ArgumentKind,
    Call,
    DirectAddress,
    Expression,
    Index,
    IndexedAddress,
    Literal,
    LiteralKind,
    Member,
    Name,
    Peripheral,
    Slice,
)
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.parser.addresses import (
    data_block_number,
    read_address,
    read_area,
    read_data_area,
    read_marked_member,
    read_member_address,
    read_plain_address,
    read_slice,
)
from fbgen.lang.parser.cursor import Cursor
from fbgen.source import Source, Span

NAMES = frozenset({"name", "#", '"', '#"'})
"""Kinds of tokens that are names."""


_MARKED_BLOCK = re.compile(r"(%(?:DB|FB|FC|SFB|SFC)[0-9]+)((?:\.[^\W\d]\w*)*)", re.IGNORECASE)
_ADDRESSED = re.compile(r"DB[XBWD][0-9]+", re.IGNORECASE).fullmatch
_NUMBERED = frozenset({"FB", "FC", "OB", "DB", "UDT", "SFB", "SFC"})
_MOST_DIMENSIONS = 2
_LONGEST_AREA = 3


class AddressParser(Cursor, ABC):
    """Reads names, addresses, and what follows them if it makes an address of them."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        super().__init__(source, dialect)
        self.has_addresses = dialect.has(Feature.DB_ADDRESSES)
        self._has_plain = dialect.has(Feature.PLAIN_ADDRESSES)
        self.declared_addresses: set[str] = set()
        """Casefolded names that the block declares though they look like addresses."""

    @abstractmethod
    def expression(self) -> Expression:
        """One expression."""

    def name(self) -> Name:
        """A name in any spelling: x, #x, "x", #"x"."""
        at = self.at
        kind, text = self.kinds[at], self.texts[at]
        place = self.token_span(at)
        if kind == "#":
            name = Name(place, text[1:], False, True)
        elif kind == '"':
            name = Name(place, text[1:-1], True, False)
        elif kind == '#"':
            name = Name(place, text[2:-1], True, True)
        elif self.word(at):
            name = Name(place, text)
        else:
            raise self.failed("a name")
        self.at = at + 1
        if name.quoted:
            self.need(Feature.QUOTED_NAMES, at)
            if not name.name.strip():
                self.report("FB3004", "an empty name", place, "write a name between the quotes")
        if name.local:
            self.need(Feature.LOCAL_MARKS, at)
        return name

    def block_name(self) -> Name:
        """The name of a block or type, or an absolute one with a blank in it: `FB 10` is FB10."""
        first = self.at
        name = self.name()
        if name.name.upper() not in _NUMBERED or name.quoted or not self._has_plain:
            return name
        number = self.texts[self.at]
        if self.kinds[self.at] != "literal" or not number.isdecimal():
            return name
        self.at += 1
        return Name(self.span(first), f"{name.name}{number}")

    def address(self) -> DirectAddress:
        """An absolute address such as %IB256:P, %DB100.DBW4, MW4 or M0.1."""
        at = self.at
        text = self.texts[at]
        bit = self._bit_behind(at)
        is_plain = text[:1] != "%"
        address = read_plain_address(text, bit, self._to(at + 2)) if is_plain and bit else None
        if address:
            self.at = at + 3
        else:
            address = read_address(text, self.token_span(at))
            if address is None:
                raise self.failed(
                    "an absolute address", "addresses look like %I0.0, %QW4, %MD10, %DB1.DBW2"
                )
            self.at = at + 1
        self.need(Feature.PLAIN_ADDRESSES if is_plain else Feature.MARKED_ADDRESSES, at)
        if address.peripheral and not is_plain:
            self.need(Feature.PERIPHERAL, at)
        if address.area == "DB":
            self.need(Feature.DB_ADDRESSES, at)
        return address

    def address_or_name(self) -> Expression:
        """An address; or what looks like one and is a name, or an address with an index."""
        at = self.at
        text = self.texts[at]
        if text[:1] == "%":
            if self.kinds[at + 1] == "(" and (indexed := self._marked_with_index()):
                return indexed
            return self._marked_block() or self.address()
        is_bit = self._bit_behind(at) is not None
        if text.casefold() in self.declared_addresses or (
            read_plain_address(text, None, self.token_span(at)) is None and not is_bit
        ):
            self.at = at + 1
            return Name(self.token_span(at), text)
        return self.address()

    def _marked_block(self) -> Expression | None:
        """`%DB5`, `%FC12`, `%DB5.a.b`: an absolute block and members of it."""
        at = self.at
        match = _MARKED_BLOCK.fullmatch(self.texts[at])
        if match is None or read_marked_member(match[2][1:].partition(".")[0] + ".0"):
            return None
        if read_address(self.texts[at], self.token_span(at)) is not None:
            return None
        self.at = at + 1
        self.need(Feature.MARKED_ADDRESSES, at)
        start = self.starts[at]
        end = start + len(match[1])
        base: Expression = Name(Span(self.source, start, end), match[1])
        for name in match[2].split(".")[1:]:
            end += 1 + len(name)
            base = Member(Span(self.source, start, end), base, name)
        return base

    def _bit_behind(self, at: int) -> str | None:
        """The 1 of `M0.1`, where the token is `M0`."""
        text = self.texts[at + 2] if self.kinds[at + 1] == "." else ""
        return text if text.isdecimal() and text.isascii() and len(text) == 1 else None

    def _to(self, last: int) -> Span:
        return Span(self.source, self.starts[self.at], self.ends[last])

    # --- addresses with an index --------------------------------------------------------------

    def _marked_with_index(self) -> IndexedAddress | None:
        """`%MW(i)`, `%DB100.DW(i)`."""
        first = self.at
        block, _, member = self.texts[first].partition(".")
        size = read_data_area(member) if data_block_number(block) is not None else None
        area = read_area(block) if not member else None
        if size is None and area is None:
            return None
        self.at += 2
        indices = self._indices(")")
        place = self.span(first)
        self.need(Feature.MARKED_ADDRESSES, first)
        if area:
            return IndexedAddress(place, None, area[0], area[1], indices, area[2], area[3])
        start = self.starts[first]
        base = Name(Span(self.source, start, start + len(block)), block[1:])
        return IndexedAddress(place, base, "DB", size or "X", indices)

    def _indices(self, end: str) -> tuple[Expression, ...]:
        self.deeper()
        indices = [self.expression()]
        while self.accept(","):
            indices.append(self.expression())
        self.expect(end, f"'{end}' or ','", f"an index ends with '{end}'")
        self.depth -= 1
        return tuple(indices)

    def bracketed(
        self, base: Expression, indices: tuple[Expression, ...], place: Span
    ) -> Expression:
        """`base[indices]`: an element, or an address with an index as `MW[i]`, `DB10.DW[i]`."""
        if self._has_plain and len(indices) <= _MOST_DIMENSIONS:
            return self._indexed_address(base, indices, place) or Index(place, base, indices)
        return Index(place, base, indices)

    def called(
        self, callee: Expression, arguments: tuple[Argument, ...], place: Span
    ) -> Expression:
        """`callee(arguments)`: a call, or an address with an index as `EB(1):P`, `"d".DW(i)`."""
        if (
            self.has_addresses
            and not self._has_plain
            and 1 <= len(arguments) <= _MOST_DIMENSIONS
            and isinstance(callee, (Name, Member))
            and len(callee.name) <= _LONGEST_AREA
        ):
            indices = tuple(
                item.value
                for item in arguments
                if item.kind is ArgumentKind.POSITIONAL and item.value is not None
            )
            if len(indices) == len(arguments) and (
                address := self._indexed_address(callee, indices, place)
            ):
                self.put_back(arguments)
                return address
        return Call(place, callee, arguments)

    def _indexed_address(
        self, base: Expression, indices: tuple[Expression, ...], place: Span
    ) -> IndexedAddress | None:
        if isinstance(base, Name) and not base.quoted and not base.local:
            area = read_area(base.name)
            if area is None or base.name.casefold() in self.declared_addresses:
                return None
            if not self._has_plain and (not area[1] or len(base.name) == 1):
                return None
            return IndexedAddress(place, None, area[0], area[1], indices, area[2], area[3])
        if isinstance(base, Member) and not base.quoted and (size := read_data_area(base.name)):
            return IndexedAddress(place, base.base, "DB", size, indices)
        return None

    # --- members and marks --------------------------------------------------------------------

    def member_address(self, base: Expression, text: str) -> Expression | None:
        """The address that `.DBW4` or `.DBX0.1` behind `DB10` makes; the member has been read."""
        if isinstance(base, Call):
            return self._member_of_block(base, text)
        if not isinstance(base, Name) or base.quoted or base.local or text[:1] not in "dD":
            return None
        bit = self._bit_behind(self.at - 1)
        place = Span(self.source, base.span.start, self.ends[self.at + 1 if bit else self.at - 1])
        address = read_member_address(base.name, text, bit, place)
        if address is None and data_block_number(base.name) is not None and _ADDRESSED(text):
            self.at -= 1
            raise self.failed("an absolute address", "they look like DB1.DBX0.7 and DB1.DBW2")
        if address is None:
            return None
        self.at += 2 if bit else 0
        self.need(Feature.PLAIN_ADDRESSES, self.at - 1)
        return address

    def _member_of_block(self, base: Call, text: str) -> Expression | None:
        """`WORD_TO_BLOCK_DB(w).DW10`."""
        callee = base.callee
        if not isinstance(callee, Name) or callee.name.upper() != "WORD_TO_BLOCK_DB":
            return None
        bit = self._bit_behind(self.at - 1)
        found = read_marked_member(f"{text}.{bit}" if bit else text)
        if found is None:
            return None
        token = self.at - 1
        self.at += 2 if bit else 0
        return self._marked(base, token, *found)

    def _marked(
        self, base: Expression, token: int, size: str, numbers: tuple[int, ...]
    ) -> IndexedAddress:
        place = self.token_span(token)
        indices = tuple(
            Literal(place, LiteralKind.INTEGER, number, str(number)) for number in numbers
        )
        whole = Span(self.source, base.span.start, self.ends[self.at - 1])
        return IndexedAddress(whole, base, "DB", size, indices, marked=True)

    def marked_member(self, base: Expression, text: str, at: int) -> Expression | None:
        """A slice `.%X3`, or the address `.%DBW4` in the data block that `base` names."""
        place = Span(self.source, base.span.start, self.ends[at])
        if part := read_slice(text):
            self.need(Feature.SLICES, at)
            return Slice(place, base, *part)
        if found := read_marked_member(text):
            self.need(Feature.MARKED_ADDRESSES, at)
            if isinstance(base, Name) and not base.quoted and not base.local:
                address = read_member_address(base.name, text, None, place)
                if address is not None:
                    return address
            return self._marked(base, at, *found)
        return None

    def at_peripheral_mark(self, at: int) -> bool:
        """Whether `:P` is at a token, without blanks: with them it is a label before a name P."""
        return (
            self.texts[at + 1] in ("P", "p")
            and self.ends[at - 1] == self.starts[at]
            and self.ends[at] == self.starts[at + 1]
        )

    def peripheral(self, base: Expression, place: Span) -> Expression:
        """`base:P`."""
        if isinstance(base, IndexedAddress):
            return IndexedAddress(
                place, base.base, base.area, base.size, base.indices, True, base.german
            )
        if isinstance(base, DirectAddress):
            return DirectAddress(
                place, base.area, base.size, base.byte, base.bit, base.db, True, base.german
            )
        return Peripheral(place, base)
