"""Names in one catalogue file that stand for entries of another: do they exist?"""

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from fbgen.catalog.communication_references import unresolved_communication
from fbgen.catalog.drives import ComNo, Drive
from fbgen.catalog.located import Located
from fbgen.catalog.named import named_in
from fbgen.catalog.profibus_gateways import ProfibusGateway
from fbgen.catalog.sequences import Parameter, Result, Sequence
from fbgen.catalog.step_values import read_value, written_value
from fbgen.catalog.steps import CheckStep, Condition, ReadStep, SettingsStep, WaitStep, WriteStep
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.source import Span

if TYPE_CHECKING:
    from fbgen.catalog.catalog import Catalog


def unresolved(catalog: "Catalog", broken: Collection[tuple[str, str]]) -> Iterator[Diagnostic]:
    """FB1105 for every name that nothing has.

    `broken` holds folder and file stem of entries that could not be read: names that stand for
    those are not reported a second time.
    """
    lost = {
        kind: {stem for folder, stem in broken if folder == kind}
        for kind in ("drives", "gateways", "protocols")
    }
    protocols = {*catalog.protocols, *lost["protocols"]}
    series = {*catalog.drives, *lost["drives"]}
    for drive in catalog.drives.values():
        yield from named_in(drive, "protocol", drive.protocol, protocols, "protocol")
        if drive.communication is not None:
            yield from unresolved_communication(drive, drive.communication, catalog, protocols)
    for gateway in catalog.gateways.values():
        if isinstance(gateway, ProfibusGateway):
            yield from named_in(gateway, "protocol", gateway.protocol, protocols, "protocol")
        for name in gateway.series:
            yield from named_in(gateway, "series", name, series, "drive series")
    devices = {*series, *catalog.gateways, *lost["gateways"]}
    for manual in catalog.manuals.values():
        for name in manual.devices:
            yield from named_in(manual, "devices", name, devices, "gateway or drive series")
    for sequence in catalog.sequences.values():
        for name in sequence.series:
            yield from named_in(sequence, "series", name, series, "drive series")
            if (wanted := catalog.drives.get(name)) is not None:
                yield from _sequence(sequence, wanted)


def _sequence(sequence: Sequence, drive: Drive) -> Iterator[Diagnostic]:
    items: tuple[Parameter | Result, ...] = (*sequence.parameters, *sequence.results)
    for item in items:
        if item.scaled_by is not None:
            yield from _comno(item, "scaled_by", item.scaled_by, drive, "")
    checked: set[int] = set()
    for step in sequence.steps:
        if isinstance(step, WriteStep):
            yield from _comno(step, "write", step.write, drive, "w")
            yield from _bits(step, drive)
            yield from written_value(sequence, step, drive)
        elif isinstance(step, ReadStep):
            yield from _comno(step, "read", step.read, drive, "r")
            yield from read_value(sequence, step, drive)
        elif isinstance(step, CheckStep):
            yield from _comno(step, "check", step.check, drive, "r")
            yield from _expected(step, drive, checked)
        elif isinstance(step, SettingsStep):
            yield from _all_settings(step, drive, checked)
        elif isinstance(step, WaitStep):
            yield from _comno(step, "wait", step.wait, drive, "r")
            yield from _awaited(step, step.until, drive)


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


def _awaited(step: WaitStep, until: Condition, drive: Drive) -> Iterator[Diagnostic]:
    """FB1105 and FB1107: bits or values that the ComNo of a wait does not have."""
    try:
        comno = drive.comno(step.wait)
    except DiagnosticError:
        return
    places = {name: until.item_span_of("bits", name) for name in until.bits}
    yield from _bits_of(comno, places, drive, step.span_of("wait"))
    for name, value in until.numbers.items():
        if not 0 <= round(value / comno.resolution) <= 0xFFFF:
            yield Diagnostic(
                "FB1107",
                f"{value:g} is no value of {comno.hex} '{comno.name}'",
                until.span_of(name),
                f"use 0 to {comno.to_value(0xFFFF):g} {comno.unit}".rstrip(),
            )


def _expected(step: CheckStep, drive: Drive, checked: set[int]) -> Iterator[Diagnostic]:
    """FB1102 a ComNo that was checked already; FB1107 no value, or one that it cannot have."""
    try:
        comno = drive.comno(step.check)
    except DiagnosticError:
        return
    if comno.number in checked:
        message = f"{comno.hex} '{comno.name}' is checked twice in one sequence"
        yield Diagnostic("FB1102", message, step.span_of("check"), "leave one of them out")
    checked.add(comno.number)
    if step.equals is None:
        if comno.name not in _on_sheets(drive):
            yield Diagnostic(
                "FB1107",
                f"no parameter sheet of '{drive.id}' says what {comno.hex} '{comno.name}' is to be",
                step.span_of("check"),
                "say it here with equals:, in the unit of the ComNo",
            )
    elif not 0 <= comno.to_word(step.equals) <= 0xFFFF:
        message = f"{step.equals:g} is no value of {comno.hex} '{comno.name}'"
        yield Diagnostic("FB1107", message, step.span_of("equals"))


def _on_sheets(drive: Drive) -> set[str]:
    """The ComNos of which a parameter sheet has a value: behind a gateway, or on a serial line."""
    names = {setting.comno for setting in drive.settings if setting.always}
    ports = () if drive.communication is None else drive.communication.ports
    for port in ports:
        of_port = (port.baud_rate, port.parity, port.inv_no, port.timeout, port.protocol)
        names |= {name for name in of_port if name is not None}
    return names | {drive.link.maximum_frequency}


def _all_settings(step: SettingsStep, drive: Drive, checked: set[int]) -> Iterator[Diagnostic]:
    """FB1102 a ComNo of a parameter sheet that was checked already."""
    names = _on_sheets(drive)
    for comno in drive.comnos:
        if comno.name in names:
            if comno.number in checked:
                message = f"{comno.hex} '{comno.name}' is checked twice in one sequence"
                place = step.span_of("check_settings")
                yield Diagnostic("FB1102", message, place, "leave one of them out")
            checked.add(comno.number)


def _bits(step: WriteStep, drive: Drive) -> Iterator[Diagnostic]:
    try:
        comno = drive.comno(step.write)
    except DiagnosticError:
        return
    places = {name: step.item_span_of("bits", at) for at, name in enumerate(step.bits or ())}
    places |= {name: step.item_span_of("bits_from", name) for name in step.bits_from}
    yield from _bits_of(comno, places, drive, step.span_of("write"))


def _bits_of(
    comno: ComNo, places: Mapping[str, Span | None], drive: Drive, whole: Span | None
) -> Iterator[Diagnostic]:
    """FB1105: named bits of a ComNo that is no bit word, or that has no such bit."""
    if places and comno.word is None:
        yield Diagnostic("FB1105", f"{comno.hex} of '{drive.id}' is no bit word", whole)
        return
    for name, place in places.items():
        try:
            drive.word(comno.word or "").field(name)
        except DiagnosticError as unknown:
            for found in unknown.diagnostics:
                yield Diagnostic("FB1105", found.message, place, found.help)
