"""TwinCAT objects from trees: `.TcPOU`, `.TcDUT`, `.TcGVL`, `.TcIO` and `.TcTTO`.

Ids come from the names, so that the same trees give the same files. Source: files that TwinCAT XAE
writes, in published projects: attributes, their order, and CRLF at the ends of lines.
"""

from collections.abc import Iterator, Sequence
from uuid import NAMESPACE_URL, uuid5

from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.lang.ast import (
    Accessor,
    Action,
    Block,
    BlockKind,
    BlockMember,
    Configuration,
    File,
    Globals,
    Interface,
    Property,
    TypeDeclaration,
    Unit,
)
from fbgen.lang.containers import code_parts
from fbgen.lang.containers.places import cdata
from fbgen.lang.containers.twincat_tasks import is_of_tasks, task_objects
from fbgen.source import Span

_KINDS = (BlockKind.FUNCTION_BLOCK, BlockKind.FUNCTION, BlockKind.PROGRAM)
_SUFFIXES = {"POU": ".TcPOU", "Itf": ".TcIO", "DUT": ".TcDUT", "GVL": ".TcGVL", "Task": ".TcTTO"}


def objects(files: Sequence[File], stem: str) -> Iterator[tuple[str, str]]:
    """Name and text of one file for each unit; lists of global variables without a name together.

    Raises `DiagnosticError` (FB3019) with everything that TwinCAT has no object for.
    """
    refused = [
        no_place("TwinCAT", unit.span) for file in files for unit in file.units if not _fits(unit)
    ]
    if refused:
        raise DiagnosticError(refused)
    lists: dict[str, list[Unit]] = {}
    for file in files:
        for unit in file.units:
            if isinstance(unit, Globals):
                lists.setdefault(unit.name or stem, []).append(unit)
            elif isinstance(unit, Configuration):
                for name, inside in task_objects(unit):
                    yield _file("Task", name, inside)
            else:
                yield _object(unit, file.dialect)
    dialect = files[0].dialect if files else "twincat"
    for name, sections in lists.items():
        yield _file("GVL", name, _declaration(code_parts.units(tuple(sections), dialect)))


def no_place(container: str, span: Span) -> Diagnostic:
    """Something that a container cannot hold."""
    word = " ".join(span.text.split()[:2]) or "this"
    return Diagnostic(
        "FB3019",
        f"{container} has no place for {word}",
        span._replace(end=min(span.end, span.start + len(word))),
        "leave it out, or write the files as plain text",
    )


def _fits(unit: Unit) -> bool:
    if isinstance(unit, Block):
        return unit.kind in _KINDS
    if isinstance(unit, Configuration):
        return is_of_tasks(unit)
    return isinstance(unit, Interface | TypeDeclaration | Globals)


def _object(unit: Unit, dialect: str) -> tuple[str, str]:
    if isinstance(unit, Block):
        name = unit.name.name
        inside = (
            _declaration(code_parts.declaration(unit, dialect))
            + _implementation(code_parts.body(unit, dialect))
            + "".join(_member(member, name, dialect) for member in unit.members)
        )
        return _file("POU", name, inside, ' SpecialFunc="None"')
    if isinstance(unit, Interface):
        name = unit.name.name
        inside = _declaration(code_parts.declaration(unit, dialect))
        inside += "".join(_member(member, name, dialect) for member in unit.members)
        return _file("Itf", name, inside)
    if isinstance(unit, TypeDeclaration):
        return _file("DUT", unit.name.name, _declaration(code_parts.units((unit,), dialect)))
    raise ValueError("no object for this unit")


def _file(tag: str, name: str, inside: str, more: str = "") -> tuple[str, str]:
    text = (
        '<?xml version="1.0" encoding="utf-8"?>\n'
        '<TcPlcObject Version="1.1.0.1">\n'
        f'  <{tag} Name="{name}" Id="{_id(name)}"{more}>\n{inside}  </{tag}>\n'
        "</TcPlcObject>\n"
    )
    return name + _SUFFIXES[tag], text.replace("\n", "\r\n")


def _member(member: BlockMember, owner: str, dialect: str) -> str:
    name = member.name.name
    if isinstance(member, Property):
        inside = _declaration(code_parts.declaration(member, dialect))
        for accessor in member.accessors:
            inside += _accessor(accessor, f"{owner}.{name}", dialect)
        tag = "Property"
    else:
        tag, inside = "Action", ""
        if not isinstance(member, Action):
            tag, inside = "Method", _declaration(code_parts.declaration(member, dialect))
        inside += _implementation(code_parts.body(member, dialect))
    opening = f'    <{tag} Name="{name}" Id="{_id(f"{owner}.{name}")}">\n'
    return f"{opening}{_indented(inside)}    </{tag}>\n"


def _accessor(accessor: Accessor, owner: str, dialect: str) -> str:
    word = accessor.keyword.capitalize()
    inside = _declaration(code_parts.accessor_declaration(accessor, dialect))
    inside += _implementation(code_parts.body(accessor, dialect))
    opening = f'    <{word} Name="{word}" Id="{_id(f"{owner}.{word}")}">\n'
    return f"{opening}{_indented(inside)}    </{word}>\n"


def _declaration(code: str) -> str:
    return f"    <Declaration>{cdata(code)}</Declaration>\n"


def _implementation(code: str) -> str:
    return f"    <Implementation>\n      <ST>{cdata(code)}</ST>\n    </Implementation>\n"


def _indented(xml: str) -> str:
    """The lines that begin an element one level deeper; code stays as it is."""
    lines = xml.split("\n")
    inside = False
    result: list[str] = []
    for line in lines:
        result.append(line if inside or not line else f"  {line}")
        if "<![CDATA[" in line:
            inside = True
        if "]]></" in line:
            inside = False
    return "\n".join(result)


def _id(name: str) -> str:
    return f"{{{uuid5(NAMESPACE_URL, f'fbgen:{name}')}}}"
