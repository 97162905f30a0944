"""What can be wrong with an inverter, whatever it is connected to."""

from collections.abc import Iterable, Iterator

from fbgen.catalog import Catalog, Drive, Located, Option, OptionValue
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import nearest
from fbgen.plant.parameters import DeviceNetDriveParameters, DriveParameters


def unknown_series(item: Located, series: str, catalog: Catalog) -> Diagnostic:
    """FB2009: a series that is not there."""
    message = f"there is no drive series '{series}'"
    return Diagnostic("FB2009", message, item.span_of("series"), nearest(series, catalog.drives))


def frequencies(
    item: Located,
    parameters: DriveParameters | DeviceNetDriveParameters,
    highest: float,
    series: Drive,
) -> Iterator[Diagnostic]:
    """FB2010: a maximum frequency that the series does not take, a lowest set-point above it."""
    limit = series.comno(series.link.maximum_frequency)
    low, high = limit.minimum, limit.maximum
    lowest = parameters.min_frequency_hz
    if low is not None and high is not None and not low <= highest <= high:
        yield Diagnostic(
            "FB2010",
            f"{highest:g} Hz is no maximum frequency of {series.title}",
            item.span_of("max_frequency_hz"),
            f"use {low:g} to {high:g} Hz",
        )
    elif lowest > highest:
        yield Diagnostic(
            "FB2010",
            f"the lowest set-point, {lowest:g} Hz, lies above the highest, {highest:g} Hz",
            parameters.span_of("min_frequency_hz"),
            "exchange the two, or take min_frequency_hz out",
        )


def chosen_options(
    owner: Located, chosen: dict[str, OptionValue], options: Iterable[Option], device: str
) -> Iterator[Diagnostic]:
    """FB2003: options that are not there, or do not take the value."""
    known = {option.id: option for option in options}
    for name, value in chosen.items():
        if name not in known:
            message = f"{device} has no option '{name}'"
            help_text = nearest(name, known)
            yield Diagnostic("FB2003", message, owner.item_span_of("options", name), help_text)
            continue
        try:
            known[name].check(value)
        except DiagnosticError as wrong:
            for found in wrong.diagnostics:
                place = owner.item_span_of("options", name)
                yield Diagnostic("FB2003", found.message, place, found.help)
