"""The values that steps move: does the ComNo take them, and do both count in the same unit?"""

from collections.abc import Iterator

from fbgen.catalog.drives import ComNo, Drive
from fbgen.catalog.located import Located
from fbgen.catalog.sequences import Parameter, Result, Sequence
from fbgen.catalog.steps import ReadStep, WriteStep
from fbgen.diagnostics import Diagnostic, DiagnosticError


def written_value(sequence: Sequence, step: WriteStep, drive: Drive) -> Iterator[Diagnostic]:
    """FB1107: a literal that the inverter refuses, a parameter in the unit of another ComNo."""
    comno = _comno(drive, step.write)
    if comno is None:
        return
    if step.parameter is not None:
        named = [one for one in sequence.parameters if one.name == step.parameter]
        yield from _scale(step, "parameter", named, comno, drive)
    if step.literal is None or comno.word is not None:
        return
    is_known = not {"minimum", "maximum"} & {*comno.unverified}
    if is_known and not comno.minimum_word <= step.literal <= comno.maximum_word:
        low, high = comno.to_value(comno.minimum_word), comno.to_value(comno.maximum_word)
        value = f"{comno.to_value(step.literal):g} {comno.unit}".rstrip()
        yield Diagnostic(
            "FB1107",
            f"{step.literal:04X} is {value}, which {comno.hex} '{comno.name}' does not take",
            step.span_of("literal"),
            f"use {comno.minimum_word:04X} to {comno.maximum_word:04X}, "
            f"{low:g} to {high:g} {comno.unit}".rstrip(),
        )


def read_value(sequence: Sequence, step: ReadStep, drive: Drive) -> Iterator[Diagnostic]:
    """FB1107: a result in the unit of another ComNo."""
    comno = _comno(drive, step.read)
    if comno is not None:
        named = [one for one in sequence.results if one.name == step.into]
        yield from _scale(step, "into", named, comno, drive)


def _scale(
    step: Located,
    field: str,
    named: list[Parameter] | list[Result],
    comno: ComNo,
    drive: Drive,
) -> Iterator[Diagnostic]:
    for one in named:
        scale = None if one.scaled_by is None else _comno(drive, one.scaled_by)
        if scale is None or (scale.resolution == comno.resolution and scale.unit == comno.unit):
            continue
        yield Diagnostic(
            "FB1107",
            f"'{one.name}' counts like '{scale.name}' in {_count(scale)}, "
            f"{comno.hex} '{comno.name}' in {_count(comno)}",
            step.span_of(field),
            f"say scaled_by: {comno.name} where '{one.name}' is declared",
        )


def _count(comno: ComNo) -> str:
    return f"{comno.resolution:g} {comno.unit}".rstrip()


def _comno(drive: Drive, name: str) -> ComNo | None:
    """The ComNo; a name that the series does not have is told elsewhere."""
    try:
        return drive.comno(name)
    except DiagnosticError:
        return None
