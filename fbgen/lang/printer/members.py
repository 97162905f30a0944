"""Methods, properties, actions, interfaces and namespaces as lines.

A block has its methods and properties in front of its statements, as the standard wants it.
"""

from fbgen.lang.ast import (
    Accessor,
    Action,
    Block,
    BlockMember,
    Interface,
    LoneMember,
    Method,
    NamedType,
    Property,
    TriviaKind,
    TriviaList,
    Using,
    VarSection,
)
from fbgen.lang.printer.declarations import DeclarationPrinter
from fbgen.source import Span


class MemberPrinter(DeclarationPrinter):
    """Writes what belongs to blocks and interfaces."""

    def sections(self, sections: tuple[VarSection, ...]) -> None:
        """VAR sections, one level deeper."""
        self.lines.level += 1
        for section in sections:
            self.section(section)
        self.lines.level -= 1

    def head_of_block(self, block: Block) -> str:
        """The first line of a block that opens no namespaces."""
        return self._first_words(block) + self._all_bases(block) + self._result(block)

    def heading(self, block: Block) -> tuple[VarSection, ...]:
        """The first line of a block, what has to stand before its bases, and these.

        Gives back the sections that come behind.
        """
        generic = [one for one in block.sections if one.keyword == "VAR_GENERIC"]
        bases = self._all_bases(block)
        if not block.usings and not (generic and bases):
            self.lines.add(self.head_of_block(block), first_of(block.span))
            return block.sections
        self.lines.add(self._first_words(block) + self._result(block), first_of(block.span))
        if block.usings:
            self._usings(block.usings, "" if generic else bases)
        if not (generic and bases):
            return block.sections
        self.sections(tuple(generic))
        self.lines.level += 1
        self.lines.add(bases.strip(), generic[-1].span)
        self.lines.level -= 1
        return tuple(one for one in block.sections if one.keyword != "VAR_GENERIC")

    def lone_member(self, node: LoneMember) -> None:
        """A member in a file of its own."""
        self.member(node.member)

    def _usings(self, usings: tuple[Using, ...], bases: str) -> None:
        """USING behind a name, and the bases that may be in what it opens."""
        self.lines.level += 1
        for using in usings:
            self.using(using)
        if bases:
            self.lines.add(bases.strip(), usings[-1].span)
        self.lines.level -= 1

    def _first_words(self, block: Block) -> str:
        return " ".join((block.kind.value, *block.modifiers, self.name(block.name)))

    def _result(self, block: Block) -> str:
        return f" : {self.type_text(block.return_type)}" if block.return_type else ""

    def _all_bases(self, block: Block) -> str:
        bases = (block.extends,) if block.extends else ()
        return self._bases("EXTENDS", bases) + self._bases("IMPLEMENTS", block.implements)

    def members(self, members: tuple[BlockMember, ...]) -> None:
        """All members one level deeper, with blank lines around them."""
        self.lines.level += 1
        for member in members:
            self.lines.blank()
            self.member(member)
        self.lines.level -= 1
        if members:
            self.lines.blank()

    def member(self, member: BlockMember) -> None:
        """One method, property or action."""
        self.lines.trivia(without_first_blanks(member.leading))
        if isinstance(member, Method):
            self._method(member)
        elif isinstance(member, Property):
            self._property(member)
        else:
            self._action(member)

    def head_of_method(self, method: Method) -> str:
        """The first line of a method."""
        result = f" : {self.type_text(method.return_type)}" if method.return_type else ""
        return " ".join(("METHOD", *method.modifiers, self.name(method.name))) + result

    def head_of_property(self, node: Property) -> str:
        """The first line of a property."""
        words = ("PROPERTY", *node.modifiers, self.name(node.name))
        return f"{' '.join(words)} : {self.type_text(node.type)}"

    def _method(self, method: Method) -> None:
        self.lines.add(self.head_of_method(method), first_of(method.span))
        self.sections(method.sections)
        self.statements(method.body, without_last_blanks(method.closing))
        self.lines.add("END_METHOD", last_of(method.span))

    def _property(self, node: Property) -> None:
        self.lines.add(self.head_of_property(node), first_of(node.span))
        self.lines.level += 1
        for accessor in node.accessors:
            self._accessor(accessor)
        self.lines.trivia(without_last_blanks(node.closing))
        self.lines.level -= 1
        self.lines.add("END_PROPERTY", last_of(node.span))

    def _accessor(self, accessor: Accessor) -> None:
        self.lines.trivia(accessor.leading)
        words = (*accessor.modifiers, accessor.keyword)
        self.lines.add(" ".join(words), first_of(accessor.span))
        self.sections(accessor.sections)
        self.statements(accessor.body, without_last_blanks(accessor.closing))
        self.lines.add(f"END_{accessor.keyword}", last_of(accessor.span))

    def _action(self, action: Action) -> None:
        self.lines.add(f"ACTION {self.name(action.name)}:", first_of(action.span))
        self.statements(action.body, without_last_blanks(action.closing))
        self.lines.add("END_ACTION", last_of(action.span))

    def interface(self, node: Interface) -> None:
        """INTERFACE ... END_INTERFACE."""
        self.lines.trivia(node.leading)
        if node.usings:
            words = ("INTERFACE", *node.modifiers, self.name(node.name))
            self.lines.add(" ".join(words), first_of(node.span))
            self._usings(node.usings, self._bases("EXTENDS", node.extends))
        else:
            self.lines.add(self.head_of_interface(node), first_of(node.span))
        self.members(node.members)
        self.lines.level += 1
        self.lines.trivia(without_last_blanks(node.closing))
        self.lines.level -= 1
        self.lines.add("END_INTERFACE", last_of(node.span))

    def head_of_interface(self, node: Interface) -> str:
        """The first line of an interface."""
        words = ("INTERFACE", *node.modifiers, self.name(node.name))
        return " ".join(words) + self._bases("EXTENDS", node.extends)

    def _bases(self, word: str, types: tuple[NamedType, ...]) -> str:
        return f" {word} {', '.join(map(self.type_text, types))}" if types else ""

    def using(self, node: Using) -> None:
        """USING a, b;"""
        self.lines.trivia(node.leading)
        self.lines.add(f"USING {', '.join(node.names)};", node.span, node.trailing)


def without_last_blanks(trivia: TriviaList) -> TriviaList:
    """Blank lines in front of an end are dropped."""
    while trivia and trivia[-1].kind is TriviaKind.BLANK_LINE:
        trivia = trivia[:-1]
    return trivia


def without_first_blanks(trivia: TriviaList) -> TriviaList:
    """Blank lines at the beginning are dropped, where the printer puts its own."""
    while trivia and trivia[0].kind is TriviaKind.BLANK_LINE:
        trivia = trivia[1:]
    return trivia


def first_of(place: Span) -> Span:
    """The place of a first line."""
    return place._replace(end=place.start)


def last_of(place: Span) -> Span:
    """The place of a last line."""
    return place._replace(start=max(place.start, place.end - 1))
