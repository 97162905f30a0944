"""IEC 61131-3 and CODESYS or TwinCAT, which are nearly the same language, objects included.

To `twincat`: namespaces become part of the names, a CLASS a FUNCTION_BLOCK, REF_TO a POINTER TO,
global variables of a CONFIGURATION reach every block, access words of variables go. To `iec`: lists
of global variables lose their names, variables that others read become VAR PUBLIC, and what CODESYS
converts by itself is written out.
Sources: TwinCAT 3 help and CODESYS online help, "Programming reference"; IEC 61131-3 third edition.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.ast import (
    Block,
    BlockKind,
    Call,
    Configuration,
    Expression,
    File,
    Globals,
    Interface,
    Literal,
    LiteralKind,
    Member,
    Name,
    NamedType,
    ProgramInstance,
    ReferenceSpec,
    Slice,
    TypeDeclaration,
    Unit,
    VarSection,
)
from fbgen.lang.checker.declared.global_lists import named_by_their_files
from fbgen.lang.checker.declared.namespaces import written_whole
from fbgen.lang.checker.findings import Findings as CheckFindings
from fbgen.lang.checker.operands.own_names import with_own_names
from fbgen.lang.conversion.list_names import without_list_names
from fbgen.lang.conversion.written_conversions import with_written_conversions
from fbgen.lang.lowering.build import integer
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.truth import same_truth
from fbgen.lang.rewriting import Rewriter, Rule, replaced
from fbgen.lang.walk import walk
from fbgen.source import Source, Span

_ACCESS = ("PUBLIC", "PRIVATE", "PROTECTED", "INTERNAL")


def iec_to_twincat(files: Sequence[File], findings: Findings) -> list[File]:
    """The program in the language of CODESYS and TwinCAT."""
    whole, known = written_whole(files, CheckFindings())
    names = frozenset(one for one in known.elements if "." in one)
    rewriter = _ToTwincat(findings, names)
    return [_file(file, "twincat", rewriter) for file in whole]


def twincat_to_iec(files: Sequence[File], findings: Findings) -> list[File]:
    """The program in the language of the standard."""
    named = frozenset(
        node.name.casefold() for node in walk(tuple(files)) if isinstance(node, Member)
    )
    rewriter = _ToIec(findings, named)
    named_out = with_own_names(named_by_their_files(files))
    plain = without_list_names(with_written_conversions(named_out, findings), findings)
    return [_file(file, "iec", rewriter) for file in plain]


def _file(file: File, dialect: str, rewriter: "_Between") -> File:
    units: list[Unit] = []
    for unit in file.units:
        units += rewriter.unit(unit)
    return File(file.source, dialect, tuple(units), file.closing)


class _Between(Rewriter):
    source: ClassVar[str]
    target: ClassVar[str]

    def __init__(self, findings: Findings) -> None:
        self._findings = findings

    def unit(self, unit: Unit) -> list[Unit]:
        """What stands in the place of a unit."""
        return [self.rewrite(unit)]

    def _call(self, node: Call) -> Expression:
        call: Call = self.inside(node)
        return same_truth(call, self.source, self.target, self._findings)

    rules: ClassVar[Mapping[type, Rule]] = {Call: _call}


class _ToIec(_Between):
    """`named` are the casefolded names that stand behind a dot somewhere: what others look at."""

    source, target = "twincat", "iec"

    def __init__(self, findings: Findings, named: frozenset[str]) -> None:
        super().__init__(findings)
        self._named = named

    def _block(self, node: Block) -> Block:
        block: Block = self.inside(node)
        if block.kind is not BlockKind.FUNCTION_BLOCK:
            return block
        return replaced(block, sections=tuple(map(self._shown, block.sections)))

    def _shown(self, section: VarSection) -> VarSection:
        """VAR with variables that are read from outside is VAR PUBLIC."""
        is_named = any(
            declared.name.casefold() in self._named
            for declaration in section.declarations
            for declared in declaration.names
        )
        if section.keyword != "VAR" or not is_named or "CONSTANT" in section.qualifiers:
            return section
        return replaced(section, qualifiers=("PUBLIC", *section.qualifiers))

    rules: ClassVar[Mapping[type, Rule]] = {**_Between.rules, Block: _block}


class _ToTwincat(_Between):
    source, target = "iec", "twincat"

    def __init__(self, findings: Findings, names: frozenset[str]) -> None:
        super().__init__(findings)
        self._names = names
        self._result = Name(Span(Source("", ""), 0, 0), "")

    def unit(self, unit: Unit) -> list[Unit]:
        """Global variables of a configuration stand on their own."""
        if not isinstance(unit, Configuration):
            return [self.rewrite(unit)]
        sections = [*unit.sections, *(one for part in unit.resources for one in part.sections)]
        lists: list[Unit] = [Globals(one.span, self.rewrite(one)) for one in sections]
        resources = tuple(replaced(part, sections=()) for part in unit.resources)
        return [*lists, self.rewrite(replaced(unit, sections=(), resources=resources))]

    def _program(self, node: ProgramInstance) -> ProgramInstance:
        if node.arguments:
            self._findings.refuse(
                "an argument of a PROGRAM", node.span, "assign it in a PROGRAM that comes before"
            )
        program: ProgramInstance = self.inside(node)
        return program

    def _block(self, node: Block) -> Block:
        self._result = node.name  # the result of a FUNCTION has the last part of its name
        block: Block = self.inside(node)
        kind = BlockKind.FUNCTION_BLOCK if block.kind is BlockKind.CLASS else block.kind
        sections = tuple(one for one in block.sections if one.keyword != "VAR_EXTERNAL")
        return replaced(block, name=self._plain(block.name), kind=kind, sections=sections)

    def _declared(self, node: Interface | TypeDeclaration) -> Interface | TypeDeclaration:
        declared: Interface | TypeDeclaration = self.inside(node)
        return replaced(declared, name=self._plain(declared.name))

    def _section(self, node: VarSection) -> VarSection:
        section: VarSection = self.inside(node)
        kept = tuple(one for one in section.qualifiers if one not in _ACCESS)
        return replaced(section, qualifiers=kept)

    def _type(self, node: NamedType) -> NamedType:
        return replaced(node, name=self._underscored(node.name))

    def _reference(self, node: ReferenceSpec) -> ReferenceSpec:
        spec: ReferenceSpec = self.inside(node)
        return replaced(spec, keyword="POINTER TO") if spec.keyword == "REF_TO" else spec

    def _name(self, node: Name) -> Expression:
        if node.name.upper() == "NULL":
            return integer(node.span, 0)
        if self._result.name.casefold().endswith(f".{node.name.casefold()}"):
            return replaced(node, name=self._underscored(self._result.name))
        return self._plain(node)

    def _pointer(self, node: Call) -> Expression:
        call = self._call(node)
        if not isinstance(call, Call) or not isinstance(call.callee, Name):
            return call
        is_reference = call.callee.name.upper() == "REF" and len(call.arguments) == 1
        return replaced(call, callee=Name(call.callee.span, "ADR")) if is_reference else call

    def _literal(self, node: Literal) -> Literal:
        name = self._underscored(node.type_name)
        if node.kind is not LiteralKind.ENUMERATOR or name == node.type_name:
            return node
        return replaced(node, type_name=name, text=f"{name}#{node.value}")

    def _slice(self, node: Slice) -> Slice:
        if node.size != "X":
            self._findings.refuse(
                node.span.text, node.span, "shift and mask, or lay a UNION over the variable"
            )
        part: Slice = self.inside(node)
        return part

    def _plain(self, name: Name) -> Name:
        return replaced(name, name=self._underscored(name.name)) if "." in name.name else name

    def _underscored(self, name: str) -> str:
        """The name of a unit of a namespace; those of libraries stay as they are."""
        return name.replace(".", "_") if name.casefold() in self._names else name

    rules: ClassVar[Mapping[type, Rule]] = {
        ProgramInstance: _program,
        Block: _block,
        Interface: _declared,
        TypeDeclaration: _declared,
        VarSection: _section,
        NamedType: _type,
        ReferenceSpec: _reference,
        Name: _name,
        Call: _pointer,
        Literal: _literal,
        Slice: _slice,
    }
