"""Lists of global variables: `GVL.x` is the x of the list GVL, and so is x where it means one.

Sources: TwinCAT 3 help, "Object GVL" and "Attribute 'qualified_only'"; CODESYS help, "Namespaces".
"""

from collections.abc import Mapping, Sequence
from pathlib import PurePath

from fbgen.lang import ast
from fbgen.lang.checked import Variable
from fbgen.source import Span

_QUALIFIED_ONLY = "qualified_only"


def named_by_their_files(files: Sequence[ast.File]) -> Sequence[ast.File]:
    """The program with names for the lists that stand in a text of their own, `GVL.st`."""
    return [_named(file) for file in files]


def _named(file: ast.File) -> ast.File:
    name, _, suffix = PurePath(file.source.name).name.rpartition(".")
    if file.dialect != "twincat" or suffix.casefold() != "st" or not name.isidentifier():
        return file
    units: list[ast.Unit] = []
    for unit in file.units:
        if not isinstance(unit, ast.Globals) or unit.section.keyword != "VAR_GLOBAL":
            return file
        units.append(unit if unit.name else ast.Globals(unit.span, unit.section, name))
    return ast.File(file.source, file.dialect, tuple(units), file.closing)


class GlobalLists:
    """The sections of global variables, and which name each variable has among all of them."""

    def __init__(self) -> None:
        self._sections: list[ast.VarSection] = []
        self._qualified: set[str] = set()
        self._names: dict[ast.VarSection, str] = {}
        self._in_configurations: set[Span] = set()
        self._members: dict[str, dict[str, str]] = {}

    def add(self, unit: ast.Globals) -> None:
        """Keep the section of a list, or one without a name."""
        if unit.name:
            self._names[unit.section] = unit.name
            self._members.setdefault(unit.name.casefold(), {})
        if any(_QUALIFIED_ONLY in one.text.casefold() for one in unit.section.leading):
            self._qualified.add(unit.name.casefold())
        self._sections.append(unit.section)

    def add_configuration(self, node: ast.Configuration) -> None:
        """Keep the sections of a configuration, which blocks name in VAR_EXTERNAL."""
        sections = [*node.sections, *(one for part in node.resources for one in part.sections)]
        self._sections += sections
        for section in sections:
            for declaration in section.declarations:
                self._in_configurations |= {one.span for one in declaration.names}

    @property
    def members(self) -> Mapping[str, Mapping[str, str]]:
        """The variables of each list and their keys among all globals, casefolded."""
        return self._members

    @property
    def sections(self) -> Sequence[ast.VarSection]:
        """All sections; where two lists have a name, the list comes first that needs none."""
        return sorted(
            self._sections, key=lambda one: self.list_of(one).casefold() in self._qualified
        )

    def is_of_configuration(self, variable: Variable) -> bool:
        """True for a variable of a CONFIGURATION or RESOURCE."""
        return variable.span in self._in_configurations

    def list_of(self, section: ast.VarSection) -> str:
        """The name of the list in which a section stands; "" if it has none."""
        return self._names.get(section, "")

    def place(self, list_name: str, name: str, is_taken: bool) -> str | None:
        """The name among all globals of a variable of a list; None if the list has it already.

        `is_taken`: another list has a variable of that name.
        """
        members = self._members[list_name.casefold()]
        key = name.casefold()
        if key in members:
            return None
        unique = f"{list_name}.{name}" if is_taken else name
        members[key] = unique.casefold()
        return unique

    def has(self, key: str) -> bool:
        """True if a list has the global variable of that key, so that its name can be added."""
        return any(key in members.values() for members in self._members.values())

    def is_list(self, name: str) -> bool:
        """True for the name of a list."""
        return name.casefold() in self._members

    def key_of(self, list_name: str, name: str) -> str | None:
        """The key among all globals of the variable of a list; None if it has no such."""
        return self._members[list_name.casefold()].get(name.casefold())

    def names_in(self, list_name: str) -> list[str]:
        """The casefolded names of the variables of a list."""
        return list(self._members[list_name.casefold()])
