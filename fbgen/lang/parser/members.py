"""Methods, properties and actions of blocks, interfaces, and what the head of a block adds.

Source: IEC 61131-3 third edition, classes, interfaces and methods of function blocks; CODESYS and
TwinCAT help, "Object METHOD", "Object PROPERTY", "Object ACTION". CODESYS writes actions behind
their block, the standard writes methods in front of the statements: both are read.
"""

from abc import ABC, abstractmethod

from fbgen.lang.ast import (
    Accessor,
    Action,
    BlockMember,
    Interface,
    Method,
    NamedType,
    Property,
    Statement,
    TypeSpec,
    Using,
    VarSection,
)
from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.configurations import ConfigurationParser
from fbgen.lang.parser.declarations import MEMBERS

_MODIFIERS = words("ABSTRACT FINAL PUBLIC PRIVATE PROTECTED INTERNAL OVERRIDE")


class MemberParser(ConfigurationParser, ABC):
    """Reads what is inside a block besides sections and statements."""

    @abstractmethod
    def sections_here(self) -> tuple[VarSection, ...]:
        """All VAR sections at the cursor."""

    @abstractmethod
    def usings(self) -> tuple[Using, ...]:
        """All USING at the cursor."""

    def modifiers(self) -> tuple[str, ...]:
        """ABSTRACT, PUBLIC and the like in front of a name."""
        found: list[str] = []
        while self.kinds[self.at] == "name" and self.texts[self.at].upper() in _MODIFIERS:
            if self.kinds[self.at + 1] not in ("name", '"'):
                break
            if self.texts[self.at + 1].upper() in ("EXTENDS", "IMPLEMENTS"):
                break
            found.append(self.texts[self.at].upper())
            self.at += 1
        if found:
            self.need(Feature.OBJECTS, self.at - 1)
        return tuple(found)

    def base_types(self, word: str) -> tuple[NamedType, ...]:
        """`EXTENDS a, b` or `IMPLEMENTS a, b`; nothing if the word is not here."""
        at = self.at
        if not self.accept_word(word):
            return ()
        self.need(Feature.OBJECTS, at)
        found = [self.named_type()]
        while self.accept(","):
            found.append(self.named_type())
        return tuple(found)

    def end_head(self) -> None:
        """Step over the semicolon that some write behind the first line of a block."""
        if self.kinds[self.at] == ";" and not self.starts_line(self.at):
            self.at += 1

    def members(self) -> list[BlockMember]:
        """All methods, properties and actions at the cursor."""
        found: list[BlockMember] = []
        while (kind := self.kinds[self.at]) in MEMBERS:
            if kind == "METHOD":
                found.append(self._method())
            elif kind == "PROPERTY":
                found.append(self._property())
            else:
                found.append(self._action())
        return found

    def statements_and_members(
        self, end: str
    ) -> tuple[tuple[Statement, ...], tuple[BlockMember, ...]]:
        """What a block has behind its sections, in either order."""
        members = self.members()
        statements = self.body(end)
        while self.kinds[self.at] in MEMBERS:
            members += self.members()
            if more := self.body(end):
                if statements:
                    self.report(
                        "FB3015",
                        "statements in front of a member and behind it",
                        more[0].span,
                        "write all statements of the block together, in front or behind",
                    )
                statements += more
        return statements, tuple(members)

    # --- members ------------------------------------------------------------------------------

    def _method(self) -> Method:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.OBJECTS, first)
        modifiers = self.modifiers()
        name = self.name()
        result: TypeSpec | None = self.type_spec() if self.accept(":") else None
        self.end_head()
        sections = self.sections_here()
        body = self.body("END_METHOD")
        closing = self.take_leading()
        self._end_member("END_METHOD", first)
        return Method(
            self.span(first),
            name,
            modifiers,
            result,
            sections,
            body,
            leading,
            closing,
        )

    def _property(self) -> Property:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.OBJECTS, first)
        modifiers = self.modifiers()
        name = self.name()
        self.expect(":", "':' and the type of the property", "write PROPERTY name : TYPE")
        spec = self.type_spec()
        self.end_head()
        accessors: list[Accessor] = []
        while self.kinds[self.at] == "name":
            accessors.append(self._accessor())
        closing = self.take_leading()
        self._end_member("END_PROPERTY", first)
        return Property(self.span(first), name, modifiers, spec, tuple(accessors), leading, closing)

    def _accessor(self) -> Accessor:
        leading = self.take_leading()
        modifiers: tuple[str, ...] = ()
        first = self.at
        if self.texts[first].upper() in _MODIFIERS:
            modifiers = (self.texts[first].upper(),)
            self.at += 1
        keyword = self.texts[self.at].upper()
        if keyword not in ("GET", "SET"):
            raise self.failed("GET, SET or END_PROPERTY", "write GET ... END_GET")
        self.at += 1
        if not modifiers and self.texts[self.at].upper() in _MODIFIERS:
            modifiers = (self.texts[self.at].upper(),)
            self.at += 1
        following = self.kinds[self.at]
        sections: tuple[VarSection, ...] = ()
        body: tuple[Statement, ...] = ()
        is_bare = following == "END_PROPERTY" or self.texts[self.at].upper() == "SET"
        if not (is_bare and self.kinds[self.at + 1] not in (":=", ".", "(")):
            sections = self.sections_here()
            body = self.body(f"END_{keyword}")
            closing = self.take_leading()
            self._end_member(f"END_{keyword}", first)
        else:
            closing = ()
        return Accessor(self.span(first), keyword, modifiers, sections, body, leading, closing)

    def _action(self) -> Action:
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.OBJECTS, first)
        name = self.name()
        self.accept(":")
        body = self.body("END_ACTION")
        closing = self.take_leading()
        self._end_member("END_ACTION", first)
        return Action(self.span(first), name, body, leading, closing)

    def _end_member(self, end: str, first: int) -> None:
        if self.accept(end):
            self.accept(";")
        else:
            self.missing_end(end, first)

    # --- interfaces ---------------------------------------------------------------------------

    def interface(self) -> Interface:
        """INTERFACE ... END_INTERFACE."""
        leading = self.take_leading()
        first = self.at
        self.at += 1
        self.need(Feature.OBJECTS, first)
        modifiers = self.modifiers()
        name = self.name()
        usings = self.usings()
        extends = self.base_types("EXTENDS")
        members: list[Method | Property] = []
        for member in self.members():
            if isinstance(member, Action):
                self.report(
                    "FB3015",
                    "an action in an interface",
                    member.name.span,
                    "an interface has methods and properties",
                )
            else:
                members.append(member)
        closing = self.take_leading()
        if self.kinds[self.at] not in ("END_INTERFACE", "end"):
            self.unexpected("METHOD, PROPERTY or END_INTERFACE")
        self._end_member("END_INTERFACE", first)
        return Interface(
            self.span(first), name, modifiers, extends, tuple(members), leading, closing, usings
        )
