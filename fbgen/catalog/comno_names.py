"""The names by which people call a ComNo: those of the catalogue, of the panel, and short ones."""

from collections.abc import Iterator

from fbgen.catalog.drives import ComNo, Drive
from fbgen.diagnostics import error
from fbgen.nearest import nearest

_SHORT = {
    "frequency": "setpoint",
    "max_frequency": "maximum_frequency",
    "current": "output_current",
}
"""Names that the catalogue gives to a part of the link between a master and an inverter."""


_ROLES = ("command", "setpoint", "status", "trip", "alarm")
"""Those of the link that are no words of a ComNo's own name."""


def named_comno(series: Drive, key: str) -> ComNo:
    """The ComNo of a name or number of the catalogue, of the panel (`F802`), or a short name.

    Short names are `frequency`, `max_frequency`, `current`, and those of the link, as `command`
    and `trip`. Raises DiagnosticError FB1105 with the nearest names.
    """
    for known in (key, *_others(series, key)):
        for comno in series.comnos:
            if known in (comno.name, comno.hex) or known.upper() in (comno.hex, f"0X{comno.hex}"):
                return comno
    names = [comno.name for comno in series.comnos] + [comno.hex for comno in series.comnos]
    names += [*_SHORT, *(role for role in type(series.link).model_fields if role in _ROLES)]
    raise error("FB1105", f"'{series.id}' has no ComNo '{key}'", help=nearest(key, names))


def _others(series: Drive, key: str) -> Iterator[str]:
    """What else the key may mean, by names and numbers of the catalogue."""
    for comno in series.comnos:
        if comno.display is not None and comno.display.casefold() == key.casefold():
            yield comno.name
    role = _SHORT.get(key, key)
    if role in type(series.link).model_fields:
        name = getattr(series.link, role)
        if name is not None:
            yield name
