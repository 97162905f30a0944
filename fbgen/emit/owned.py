"""Files that are written once and then belong to the user: does what stands in them still fit?

The parameter block names every line and every drive of the plant. When the plant changes, the
user's file stays as it is, and what is missing or too much in it is told.
"""

from collections.abc import Iterator, Sequence
from pathlib import Path

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, Severity
from fbgen.emit.generated import GeneratedFile, GeneratedSet
from fbgen.kept_folder import read_content
from fbgen.lang import ast
from fbgen.lang.containers import XML_SUFFIXES, read_text
from fbgen.plant import LANGUAGES
from fbgen.source import Source, Span

_SHOWN = 4
"""So many missing values are named; the rest is counted."""


@dataclass(frozen=True, slots=True)
class _Values:
    """What a file gives values: paths such as `gw1.pump.maxFrequency`, each with its place."""

    places: dict[str, Span]
    wrong: tuple[Diagnostic, ...] = ()


def misfits(generated: GeneratedSet, folder: Path) -> list[Diagnostic]:
    """FB5023 for each file of the user's that does not fit the plant any more."""
    found: list[Diagnostic] = []
    for file in generated.files:
        data = read_content(folder / file.name) if file.is_owned else None
        if data is not None and data != file.data:
            found += _misfits(file, data, folder / file.name, generated.dialect)
    return found


def _misfits(file: GeneratedFile, data: bytes, path: Path, dialect: str) -> Iterator[Diagnostic]:
    text = data.decode("utf-8-sig", "replace").replace("\r\n", "\n")
    theirs = _values(Source(path.as_posix(), text), dialect)
    if theirs.wrong:
        first = theirs.wrong[0]
        yield _misfit(f"{path} cannot be read: {first.message}", first.span, first.help)
        return
    wanted = _values(Source(file.name, file.text), dialect)
    yield from _too_much(theirs, wanted)
    given = {name.casefold() for name in theirs.places}
    missing = [name for name in wanted.places if name.casefold() not in given]
    if missing:
        more = f" and {len(missing) - _SHOWN} more" if len(missing) > _SHOWN else ""
        yield _misfit(
            f"{path} gives no value to {', '.join(missing[:_SHOWN])}{more}",
            None,
            "add them, or delete the file and generate again: it is written anew then",
        )


def _too_much(theirs: _Values, wanted: _Values) -> Iterator[Diagnostic]:
    """What the plant does not have: a drive or line that is gone as a whole is told once."""
    spelled = {name.casefold() for name in wanted.places}
    owners = {_owner(name) for name in spelled}
    gone: dict[str, list[str]] = {}
    for name in theirs.places:
        if name.casefold() not in spelled:
            owner = _owner(name)
            gone.setdefault(name if owner.casefold() in owners else owner, []).append(name)
    for what, names in gone.items():
        place = theirs.places[names[0]]
        if names == [what]:
            message = f"the parameter {what} does not exist any more"
            yield _misfit(message, place, "take the line out; the file is yours")
        else:
            message = f"{what} does not exist any more; the first of its parameters stands here"
            lines = f"the {len(names)} lines" if len(names) > 1 else "the line"
            yield _misfit(message, place, f"take {lines} of {what} out; the file is yours")


def _owner(name: str) -> str:
    """The drive or line whose parameter it is."""
    return name.rpartition(".")[0]


def _misfit(message: str, place: Span | None, help_text: str) -> Diagnostic:
    return Diagnostic("FB5023", message, place, help_text, severity=Severity.WARNING)


def _values(source: Source, dialect: str) -> _Values:
    is_xml = Path(source.name).suffix.lower() in XML_SUFFIXES
    document = read_text(source, LANGUAGES[dialect], is_xml)
    places: dict[str, Span] = {}
    for unit in document.file.units:
        if isinstance(unit, ast.DataBlock):
            for assignment in unit.assignments:
                places[".".join(_path(assignment.target))] = assignment.span
        elif isinstance(unit, ast.Globals):
            for declaration in unit.section.declarations:
                places |= dict(_in_literal((), declaration.initial))
    return _Values(places, tuple(document.findings))


def _path(target: ast.Expression) -> list[str]:
    names: list[str] = []
    while isinstance(target, ast.Member):
        names.append(target.name)
        target = target.base
    if isinstance(target, ast.Name):
        names.append(target.name)
    return names[::-1]


def _in_literal(path: Sequence[str], value: ast.Expression | None) -> Iterator[tuple[str, Span]]:
    if not isinstance(value, ast.StructLiteral):
        return
    for field in value.fields:
        inner = (*path, field.name)
        if isinstance(field.value, ast.StructLiteral):
            yield from _in_literal(inner, field.value)
        else:
            yield ".".join(inner), field.span
