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

_HIGHEST = ".maxfrequency"
_SHOWN = 4
"""So many missing values are named; the rest is counted."""


@dataclass(frozen=True, slots=True)
class _Values:
    """What a file gives values: paths such as `gw1.pump.maxFrequency`, each with its place, and the
    values where they are numbers."""

    places: dict[str, Span]
    numbers: dict[str, float]
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
    yield from _of_another_scale(theirs, wanted)
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


def _of_another_scale(theirs: _Values, wanted: _Values) -> Iterator[Diagnostic]:
    """Highest frequencies that are not those of the plant file. Of all values they alone must be
    what is set at the inverter, and the parameter sheet takes them from the plant file."""
    of_plant = {name.casefold(): number for name, number in wanted.numbers.items()}
    for name, number in theirs.numbers.items():
        other = of_plant.get(name.casefold(), number)
        if name.casefold().endswith(_HIGHEST) and number != other:
            yield _misfit(
                f"{name} is {number:g} Hz here, and max_frequency_hz of the plant file is "
                f"{other:g} Hz",
                theirs.places[name],
                "set-points are scaled by the value here, and the parameter sheet has that of the "
                "plant file: both must be the highest frequency (FH) that is set at the inverter",
            )


def _owner(name: str) -> str:
    """The drive or line whose parameter it is."""
    return name.rpartition(".")[0]


def _misfit(message: str, place: Span | None, help_text: str) -> Diagnostic:
    return Diagnostic("FB5023", message, place, help_text, severity=Severity.WARNING)


def _values(source: Source, dialect: str) -> _Values:
    is_xml = Path(source.name).suffix.lower() in XML_SUFFIXES
    document = read_text(source, LANGUAGES[dialect], is_xml)
    values: dict[str, tuple[Span, ast.Expression | None]] = {}
    for unit in document.file.units:
        if isinstance(unit, ast.DataBlock):
            for assignment in unit.assignments:
                name = ".".join(_path(assignment.target))
                values[name] = assignment.span, assignment.value
        elif isinstance(unit, ast.Globals):
            for declaration in unit.section.declarations:
                values |= dict(_in_literal((), declaration.initial))
    return _Values(
        {name: span for name, (span, _) in values.items()},
        {
            name: value.value
            for name, (_, value) in values.items()
            if isinstance(value, ast.Literal) and isinstance(value.value, int | float)
        },
        tuple(document.findings),
    )


def _path(target: ast.Expression) -> list[str]:
    names: list[str] = []
    while isinstance(target, ast.Member):
        names.append(target.name)
        target = target.base
    if isinstance(target, ast.Name):
        names.append(target.name)
    return names[::-1]


def _in_literal(
    path: Sequence[str], value: ast.Expression | None
) -> Iterator[tuple[str, tuple[Span, ast.Expression | None]]]:
    if not isinstance(value, ast.StructLiteral):
        return
    for field in value.fields:
        inner = (*path, field.name)
        if isinstance(field.value, ast.StructLiteral):
            yield from _in_literal(inner, field.value)
        else:
            yield ".".join(inner), (field.span, field.value)
