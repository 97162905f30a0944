"""What an inverter is made of: the ComNos that it needs, and the parameters that it comes with."""

from fbgen.catalog import ComNo, Drive
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.wire.toshiba import ErrorCode
from harness.drives import inter_drive, operation
from harness.drives.settings import InverterSettings

_REFUSALS = {
    ErrorCode.CANNOT_EXECUTE: "it cannot be written, or not while the inverter runs",
    ErrorCode.DATA: "the value lies outside the range",
    ErrorCode.COM_NO: "there is no such cell",
}


def check_complete(series: Drive) -> None:
    """FB7103 unless the series has every ComNo that the simulation stands on, by its name."""
    names = {comno.name for comno in series.comnos}
    wanted = (*operation.PARAMETERS, *inter_drive.SCALING)
    if missing := [name for name in wanted if name not in names]:
        raise error(
            "FB7103",
            f"the series '{series.id}' cannot be simulated: it has no {', '.join(missing)}",
            series.span,
            "give these ComNos under these names, as vf-s11.yaml does",
        )


def delivered(series: Drive, settings: InverterSettings) -> dict[int, int]:
    """The parameters of the settings as words. FB7101 for all that the series would not take."""
    words: dict[int, int] = {}
    found: list[Diagnostic] = []
    for key, value in settings.parameters.items():
        comno = series.comno(key)
        word = comno.to_word(value)
        if comno.storage != "eeprom":
            found.append(not_taken(comno, value, ErrorCode.CANNOT_EXECUTE))
        elif not comno.minimum_word <= word <= comno.maximum_word:
            found.append(not_taken(comno, value, ErrorCode.DATA))
        words[comno.number] = word
    if found:
        raise DiagnosticError(found)
    return words


def not_taken(comno: ComNo, value: float, refused: ErrorCode) -> Diagnostic:
    """FB7101 for a value that the inverter refuses."""
    unit = f" {comno.unit}" if comno.unit else ""
    low, high = comno.to_value(comno.minimum_word), comno.to_value(comno.maximum_word)
    return Diagnostic(
        "FB7101",
        f"the inverter does not take {value:g}{unit} for {comno.name} ({comno.hex}): "
        f"{_REFUSALS[refused]}",
        help=f"the range is {low:g} to {high:g}{unit}",
    )
