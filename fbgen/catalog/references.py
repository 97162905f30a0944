"""Names in one catalogue file that stand for entries of another: do they exist?"""

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from fbgen.catalog.drives import Drive
from fbgen.catalog.located import Located
from fbgen.catalog.sequences import DelayStep, Parameter, Result, Sequence, WriteStep
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest

if TYPE_CHECKING:
    from fbgen.catalog.catalog import Catalog


def unresolved(catalog: "Catalog", broken: Collection[tuple[str, str]]) -> Iterator[Diagnostic]:
    """FB1105 for every name that nothing has.

    `broken` holds folder and file stem of entries that could not be read: names that stand for
    those are not reported a second time.
    """
    lost = {
        kind: {stem for folder, stem in broken if folder == kind}
        for kind in ("drives", "protocols")
    }
    protocols = {*catalog.protocols, *lost["protocols"]}
    series = {*catalog.drives, *lost["drives"]}
    for drive in catalog.drives.values():
        yield from _named(drive, "protocol", drive.protocol, protocols, "protocol")
    for gateway in catalog.gateways.values():
        yield from _named(gateway, "protocol", gateway.protocol, protocols, "protocol")
        for name in gateway.series:
            yield from _named(gateway, "series", name, series, "drive series")
    for sequence in catalog.sequences.values():
        for name in sequence.series:
            yield from _named(sequence, "series", name, series, "drive series")
            if (wanted := catalog.drives.get(name)) is not None:
                yield from _sequence(sequence, wanted)


def _named(
    owner: Located, field: str, name: str, known: Collection[str], kind: str
) -> Iterator[Diagnostic]:
    if name not in known:
        yield Diagnostic(
            "FB1105", f"there is no {kind} '{name}'", owner.span_of(field), nearest(name, known)
        )


def _sequence(sequence: Sequence, drive: Drive) -> Iterator[Diagnostic]:
    items: tuple[Parameter | Result, ...] = (*sequence.parameters, *sequence.results)
    for item in items:
        if item.scaled_by is not None:
            yield from _comno(item, "scaled_by", item.scaled_by, drive, "")
    for step in sequence.steps:
        if isinstance(step, WriteStep):
            yield from _comno(step, "write", step.write, drive, "w")
            yield from _bits(step, drive)
        elif not isinstance(step, DelayStep):
            yield from _comno(step, "read", step.read, drive, "r")


def _comno(
    owner: Located, field: str, name: str, drive: Drive, access: str
) -> Iterator[Diagnostic]:
    try:
        comno = drive.comno(name)
    except DiagnosticError as unknown:
        for found in unknown.diagnostics:
            yield Diagnostic(found.code, found.message, owner.span_of(field), found.help)
        return
    if access not in comno.access:
        verb = "written" if access == "w" else "read"
        yield Diagnostic(
            "FB1107",
            f"{comno.hex} '{comno.name}' of '{drive.id}' cannot be {verb}",
            owner.span_of(field),
        )


def _bits(step: WriteStep, drive: Drive) -> Iterator[Diagnostic]:
    names = [*(step.bits or ()), *step.bits_from]
    try:
        comno = drive.comno(step.write)
    except DiagnosticError:
        return
    if names and comno.word is None:
        yield Diagnostic(
            "FB1105", f"{comno.hex} of '{drive.id}' is no bit word", step.span_of("write")
        )
        return
    places = {name: step.item_span_of("bits", at) for at, name in enumerate(step.bits or ())}
    places |= {name: step.item_span_of("bits_from", name) for name in step.bits_from}
    for name in names:
        try:
            drive.word(comno.word or "").field(name)
        except DiagnosticError as unknown:
            for found in unknown.diagnostics:
                yield Diagnostic("FB1105", found.message, places[name], found.help)
