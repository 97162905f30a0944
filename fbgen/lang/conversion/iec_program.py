"""What an IEC program has and S7 has not: global variables, enumerations, PROGRAMs and tasks.

Global variables become one data block, PROGRAMs function blocks with an instance each that OB1
calls. Enumerations become INT, and their names the numbers that they stand for; the other types
that are no structures are written out where they are used.
"""

from collections.abc import Iterator, Sequence

from fbgen.lang.ast import (
    ArraySpec,
    Block,
    BlockKind,
    Call,
    CallStatement,
    Configuration,
    DataBlock,
    Declaration,
    DirectAddress,
    EnumSpec,
    Expression,
    File,
    Globals,
    Literal,
    LiteralKind,
    Name,
    NamedType,
    StructSpec,
    SubrangeSpec,
    Task,
    TypeDeclaration,
    TypeSpec,
    Unary,
    UnionSpec,
    VarSection,
)
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.walk import walk
from fbgen.source import Span

_OWN_TYPES = (StructSpec, UnionSpec)
"""Types of the user that TIA has, too, or that are refused."""

GLOBALS = "Globals"
"""The data block that takes the global variables."""


class IecProgram:
    """The declarations of all files that concern more than one unit."""

    def __init__(self, files: Sequence[File], findings: Findings) -> None:
        self.files = files
        self.dialect = files[0].dialect
        self.sections: list[VarSection] = []
        self.addresses: dict[str, DirectAddress] = {}
        self.variables: dict[str, str] = {}
        self.enumerations: dict[str, dict[str, int]] = {}
        self.aliases: dict[str, TypeDeclaration] = {}
        self.programs: list[Block] = []
        self.lists: dict[str, set[str]] = {}
        self.called: set[str] = set()
        """What is called by its name, casefolded; a PROGRAM among it is not called by OB1."""
        self._named: set[EnumSpec] = set()
        self._findings = findings
        for file in files:
            for unit in file.units:
                self._collect(unit)
            for node in walk(file):
                if isinstance(node, EnumSpec) and node not in self._named:
                    place = f"{node.span.source.name}:{node.span.start}"
                    self.enumerations[place] = dict(self._values(node))
                elif isinstance(node, Call) and isinstance(node.callee, Name):
                    self.called.add(node.callee.name.casefold())
        for section in self.sections:
            for declaration in section.declarations:
                self._declare(declaration)

    def _collect(self, unit: object) -> None:
        if isinstance(unit, Globals):
            self.sections.append(unit.section)
            if unit.name:
                self._enlist(unit)
        elif isinstance(unit, Configuration):
            self.sections += unit.sections
            tasks: list[Task] = []
            for resource in unit.resources:
                self.sections += resource.sections
                tasks += resource.tasks
            for task in tasks[1:]:
                self._findings.refuse(
                    f"the second task {task.name}",
                    task.span,
                    "call its programs from a cyclic interrupt OB by hand",
                )
        elif isinstance(unit, TypeDeclaration) and not isinstance(unit.type, _OWN_TYPES):
            self.aliases[unit.name.name.casefold()] = unit
            if isinstance(unit.type, EnumSpec):
                self._named.add(unit.type)
                self.enumerations[unit.name.name.casefold()] = dict(self._values(unit.type))
        elif isinstance(unit, Block) and unit.kind is BlockKind.PROGRAM:
            self.programs.append(unit)

    def _enlist(self, unit: Globals) -> None:
        """One data block takes all lists, so no two of them may have the same name."""
        members = self.lists.setdefault(unit.name.casefold(), set())
        for declaration in unit.section.declarations:
            for name in declaration.names:
                key = name.name.casefold()
                if any(key in one for one in self.lists.values()):
                    self._findings.refuse(
                        f"the variable {name.name} of several lists",
                        name.span,
                        "give it a name that no other list of global variables has",
                    )
                members.add(key)

    def in_list(self, list_name: str, name: str) -> bool:
        """Whether a list of global variables has a variable."""
        return name.casefold() in self.lists.get(list_name.casefold(), ())

    def instance_of(self, name: str) -> str:
        """The data block that a PROGRAM becomes; "" for any other name."""
        found = (one.name.name for one in self.programs if one.name.name.casefold() == name)
        return next((f"{one}_DB" for one in found), "")

    def _declare(self, declaration: Declaration) -> None:
        for name in declaration.names:
            key = name.name.casefold()
            if isinstance(declaration.at, DirectAddress):
                self.addresses[key] = declaration.at
            else:
                self.variables[key] = name.name

    def _values(self, spec: EnumSpec) -> Iterator[tuple[str, int]]:
        """The numbers of an enumeration: as given, or one more than the one before."""
        number = -1
        for item in spec.enumerators:
            given = _whole(item.value)
            if item.value is not None and given is None:
                self._findings.refuse(
                    f"the value of {item.name}", item.span, "write it as a number"
                )
            number = number + 1 if given is None else given
            yield item.name.casefold(), number

    def enumerator(self, type_name: str, name: str) -> int | None:
        """The number of `Colour.red` or `Colour#red`; of `red` with an empty type name.

        None if there is no such name, or there are several that stand for different numbers.
        """
        key = name.casefold()
        if type_name:
            return self.enumerations.get(type_name.casefold(), {}).get(key)
        found = {values[key] for values in self.enumerations.values() if key in values}
        return found.pop() if len(found) == 1 else None

    def is_ambiguous(self, name: str) -> bool:
        """Whether a name stands for different numbers in different enumerations."""
        key = name.casefold()
        return len({values[key] for values in self.enumerations.values() if key in values}) > 1

    def default(self, spec: TypeSpec) -> Expression | None:
        """What a variable of the type begins with, if that is not what TIA gives to it."""
        if isinstance(spec, EnumSpec):
            first = next(iter(dict(self._values(spec)).values()), 0)
            return number(spec.span, first) if first else None
        if isinstance(spec, SubrangeSpec):
            return None if _whole(spec.first) == 0 else spec.first
        if isinstance(spec, NamedType) and spec.name.casefold() in self.aliases:
            alias = self.aliases[spec.name.casefold()]
            return alias.initial if alias.initial is not None else self.default(alias.type)
        if isinstance(spec, ArraySpec) and self.default(spec.element) is not None:
            self._findings.refuse(
                "the default value of the elements",
                spec.span,
                "give the array its values where it is declared",
            )
        return None

    # --- new units ----------------------------------------------------------------------------

    def new_units(self, declarations: Sequence[Declaration]) -> list[Block | DataBlock]:
        """The data block with `declarations`, the instances of the programs and OB1."""
        units: list[Block | DataBlock] = []
        if declarations:
            place = declarations[0].span
            name = Name(place, GLOBALS, True)
            struct = StructSpec(place, tuple(declarations))
            units.append(DataBlock(place, name, (), None, struct, (), ()))
        calls: list[CallStatement] = []
        for program in self.programs:
            place = program.span._replace(end=program.span.start)
            instance = Name(place, f"{program.name.name}_DB", True)
            kind = NamedType(place, program.name.name, True)
            units.append(DataBlock(place, instance, (), kind, None, (), ()))
            if program.name.name.casefold() not in self.called:
                calls.append(CallStatement(place, Call(place, instance, ())))
        if calls:
            place = calls[0].span
            units.append(
                Block(
                    place,
                    BlockKind.ORGANIZATION_BLOCK,
                    Name(place, "OB1", True),
                    None,
                    (),
                    (),
                    tuple(calls),
                )
            )
        return units


def number(place: Span, value: int) -> Expression:
    """A whole number as an expression."""
    literal = Literal(place, LiteralKind.INTEGER, abs(value), str(abs(value)))
    return literal if value >= 0 else Unary(place, "-", literal)


def _whole(value: Expression | None) -> int | None:
    if isinstance(value, Unary) and value.operator == "-":
        inner = _whole(value.operand)
        return None if inner is None else -inner
    if isinstance(value, Literal) and value.kind is LiteralKind.INTEGER:
        return int(value.value)
    return None
