"""VAR_CONFIG: initial values and addresses that a configuration gives to variables of instances.

A path begins with a PROGRAM or its instance, behind the names of configuration and resource or
without them; CODESYS writes it without. An initial value goes into the declaration of the PROGRAM,
and so does the address of its own variable. What lies in an instance has no address here.
Source: IEC 61131-3 third edition, section 6.8.2; CODESYS online help, "Variable configuration".
"""

from collections.abc import Iterator, Sequence
from functools import partial
from typing import NamedTuple

from fbgen.diagnostics import Diagnostic, Severity
from fbgen.lang import ast
from fbgen.lang.checker.findings import Findings
from fbgen.lang.rewriting import replaced
from fbgen.nearest import nearest

_CONFIG = "VAR_CONFIG"


class _Given(NamedTuple):
    path: list[str]
    name: ast.DeclaredName
    declaration: ast.Declaration


def with_configured_variables(files: Sequence[ast.File], findings: Findings) -> Sequence[ast.File]:
    """The program without VAR_CONFIG, whose declarations say what it said."""
    given = [one for file in files for unit in file.units for one in _given(unit)]
    if not given:
        return files
    programs = {
        unit.name.name.casefold(): unit
        for file in files
        for unit in file.units
        if isinstance(unit, ast.Block) and unit.kind is ast.BlockKind.PROGRAM
    }
    names = {key: key for key in programs} | dict(_instances(files))
    for one in given:
        at = next((i for i, word in enumerate(one.path) if word.casefold() in names), None)
        key = "" if at is None else names[one.path[at].casefold()]
        program = programs.get(key)
        changed = None
        if program is not None and at is not None and len(one.path) > at + 1:
            changed = _with(program, one.path[at + 1 :], one, findings)
        if changed is None:
            known = [unit.name.name for unit in programs.values()]
            findings.unknown(
                "FB4001",
                f"VAR_CONFIG names '{one.name.name}', which no PROGRAM has",
                one.name.span,
                partial(nearest, one.path[0], known),
            )
        else:
            programs[key] = changed
    return [
        ast.File(
            file.source,
            file.dialect,
            tuple(_unit(unit, programs) for unit in file.units if not _is_config(unit)),
            file.closing,
        )
        for file in files
    ]


def _is_config(unit: ast.Unit) -> bool:
    return isinstance(unit, ast.Globals) and unit.section.keyword == _CONFIG


def _given(unit: ast.Unit) -> Iterator[_Given]:
    sections: Sequence[ast.VarSection] = ()
    if isinstance(unit, ast.Globals):
        sections = (unit.section,)
    elif isinstance(unit, ast.Configuration):
        sections = unit.sections
    for section in sections:
        if section.keyword == _CONFIG:
            for declaration in section.declarations:
                for name in declaration.names:
                    yield _Given(name.name.split("."), name, declaration)


def _instances(files: Sequence[ast.File]) -> Iterator[tuple[str, str]]:
    for file in files:
        for unit in file.units:
            for resource in unit.resources if isinstance(unit, ast.Configuration) else ():
                for program in resource.programs:
                    yield program.name.casefold(), program.type.name.casefold()


def _unit(unit: ast.Unit, programs: dict[str, ast.Block]) -> ast.Unit:
    if isinstance(unit, ast.Block):
        return programs.get(unit.name.name.casefold(), unit)
    if isinstance(unit, ast.Configuration):
        kept = tuple(one for one in unit.sections if one.keyword != _CONFIG)
        return replaced(unit, sections=kept)
    return unit


def _with(
    program: ast.Block, path: list[str], given: _Given, findings: Findings
) -> ast.Block | None:
    """The PROGRAM with another declaration; None if it has no such variable."""
    for number, section in enumerate(program.sections):
        for place, declaration in enumerate(section.declarations):
            found = [one for one in declaration.names if one.name.casefold() == path[0].casefold()]
            if not found:
                continue
            others = tuple(one for one in declaration.names if one is not found[0])
            mine = _changed(replaced(declaration, names=(found[0],)), path[1:], given, findings)
            new = (mine, replaced(declaration, names=others)) if others else (mine,)
            before, behind = section.declarations[:place], section.declarations[place + 1 :]
            changed = replaced(section, declarations=(*before, *new, *behind))
            sections = (*program.sections[:number], changed, *program.sections[number + 1 :])
            return replaced(program, sections=sections)
    return None


def _changed(
    declaration: ast.Declaration, path: list[str], given: _Given, findings: Findings
) -> ast.Declaration:
    said = given.declaration
    if said.initial is not None:
        initial = _merged(declaration.initial, path, said.initial)
        declaration = replaced(declaration, initial=initial)
    if said.at is not None and not path:
        declaration = replaced(declaration, at=said.at)
    elif said.at is not None:
        findings.add(
            Diagnostic(
                "FB4142",
                f"the address of {given.name.name} has no effect: it lies in an instance",
                said.at.span,
                "hand the address over as an input or output of the block",
                severity=Severity.INFO,
            )
        )
    return declaration


def _merged(
    initial: ast.Expression | None, path: list[str], value: ast.Expression
) -> ast.Expression:
    """An initial value in which the part at the path has another one."""
    if not path:
        return value
    fields = initial.fields if isinstance(initial, ast.StructLiteral) else ()
    kept = [one for one in fields if one.name.casefold() != path[0].casefold()]
    old = next((one.value for one in fields if one.name.casefold() == path[0].casefold()), None)
    inner = _merged(old, path[1:], value)
    new = ast.Argument(value.span, ast.ArgumentKind.INPUT, path[0], inner)
    return ast.StructLiteral(value.span, (*kept, new))
