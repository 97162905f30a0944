"""Which inverters are on a line, as options say it: series, INV-NO, names, parameters."""

import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog, Drive
from fbgen.catalog.comno_names import named_comno
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest

if TYPE_CHECKING:
    from harness.drives import ReplyTime
    from harness.serial import DriveToServe

_NUMBERS = re.compile(r"(\d{1,3})(?:-(\d{1,3}))?")
_MOST = 64
_SPEC = re.compile(r"(?P<series>[^:=]+):(?P<numbers>[0-9,-]+)(?:=(?P<name>[A-Za-z_]\w*))?")


@dataclass(frozen=True, slots=True)
class NamedDrive:
    """One inverter of a line: what it is called, its series, its number."""

    name: str
    series: Drive
    inv_no: int


def named_drives(
    specs: Sequence[str], series: str | None, numbers: str | None, catalog: Catalog
) -> list[NamedDrive]:
    """The inverters of `--drive SERIES:INV-NO[=NAME]` and of `--series` with `--inv-no`.

    Without anything it is one of --series, or a vf-s11, with INV-NO 1. Raises DiagnosticError
    FB9035 with everything that is wrong, FB1205 for a series that is not there.
    """
    found: list[Diagnostic] = []
    drives: list[NamedDrive] = []
    if series is not None or numbers is not None or not specs:
        known = catalog.drive(series or "vf-s11")
        for number in _numbers(numbers or "1", "--inv-no", found):
            drives.append(NamedDrive(f"vf{number}", known, number))
    for spec in specs:
        match = _SPEC.fullmatch(spec)
        if match is None:
            found.append(_wrong(f"'{spec}' says no drive", "write --drive vf-s11:11 or vf-s15:3-5"))
            continue
        known = catalog.drive(match["series"])
        chosen = _numbers(match["numbers"], "--drive", found)
        if match["name"] and len(chosen) > 1:
            found.append(_wrong(f"'{spec}' gives one name to several", "name them one by one"))
        drives += [NamedDrive(match["name"] or f"vf{number}", known, number) for number in chosen]
    found += _twice(drives)
    if found:
        raise DiagnosticError(found)
    return drives


def drives_to_serve(
    drives: Sequence[NamedDrive],
    settings: Sequence[str],
    reply_time: "ReplyTime | None",
    wired: str | None,
) -> "list[DriveToServe]":
    """The same with the parameters of `--set [DRIVE.]COMNO=VALUE`.

    Raises DiagnosticError FB9035 with everything that is wrong.
    """
    from harness.drives import ReplyTime
    from harness.serial import DriveToServe

    found: list[Diagnostic] = []
    parameters: dict[str, dict[str, float]] = {item.name: {} for item in drives}
    for setting in settings:
        key, equals, text = setting.partition("=")
        name, dot, rest = key.partition(".")
        if dot and name not in parameters:
            found.append(_wrong(f"there is no drive '{name}'", nearest(name, parameters)))
            continue
        value = _value(text) if equals else None
        if value is None:
            help_ = "write --set max_frequency=60 or --set vf2.F803=3"
            found.append(_wrong(f"'{setting}' gives no ComNo a value", help_))
            continue
        for item in drives:
            if not dot or item.name == name:
                try:
                    comno = named_comno(item.series, rest if dot else key)
                except DiagnosticError as wrong:
                    found += wrong.diagnostics
                else:
                    parameters[item.name][comno.name] = value
    if found:
        raise DiagnosticError(dict.fromkeys(found))
    return [
        DriveToServe(
            *(item.name, item.series, item.inv_no, parameters[item.name]),
            reply_time=reply_time or ReplyTime(),
            port=wired,
        )
        for item in drives
    ]


def _numbers(text: str, option: str, found: list[Diagnostic]) -> list[int]:
    numbers: list[int] = []
    for part in text.split(","):
        match = _NUMBERS.fullmatch(part.strip())
        first, last = (int(match[1]), int(match[2] or match[1])) if match else (1, 0)
        if not 0 <= first <= last or last - first >= _MOST:
            found.append(_wrong(f"{option}: '{part}' is no INV-NO", "write 11, 1-5 or 1,3,7"))
        numbers += range(first, last + 1) if last - first < _MOST else ()
    return numbers


def _twice(drives: Sequence[NamedDrive]) -> list[Diagnostic]:
    found = []
    for index, drive in enumerate(drives):
        before = drives[:index]
        if any(other.inv_no == drive.inv_no for other in before):
            help_ = "each needs a number of its own; the fault drive_number_doubled gives one twice"
            found.append(_wrong(f"INV-NO {drive.inv_no} is given twice", help_))
        elif any(other.name == drive.name for other in before):
            found.append(_wrong(f"the name '{drive.name}' is given twice", "choose another"))
    return found


def _value(text: str) -> float | None:
    try:
        value = float(text)
    except ValueError:
        return None
    return value if abs(value) < 1e9 else None


def _wrong(message: str, help_: str) -> Diagnostic:
    return Diagnostic("FB9035", message, None, help_)
