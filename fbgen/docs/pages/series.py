"""A page for each series of inverters: what it is, times, settings, terminal functions."""

from collections.abc import Iterator

from fbgen.catalog import Drive
from fbgen.docs.document import Facts, Link, Page, Phrase, Row, Section, Table
from fbgen.docs.page_names import comno_page, device_page, protocol_page, trip_page
from fbgen.docs.pages.device_parts import (
    options_section,
    switches_section,
    times_section,
    word_table,
)
from fbgen.docs.sources import Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code, with_unit

GROUP = "Inverters"


def series_pages(subject: Subject) -> Iterator[Page]:
    """One page each."""
    for series in subject.drives.values():
        yield _series(series)


def _series(series: Drive) -> Page:
    sources = Sources()
    rows: list[tuple[str, Phrase]] = [
        ("Protocol", (Link(series.protocol, protocol_page(series.protocol)),)),
        ("ComNos", (Link(f"all {len(series.comnos)}", comno_page(series.id)),)),
    ]
    if series.trips:
        rows.append(("Trips", (Link(f"all {len(series.trips)}", trip_page(series.id)),)))
    if series.like is not None:
        text = f"{series.like}: what is taken over from there is unverified"
        rows.append(("Like", (text,)))
    rows += [("Manual", (text,)) for text in series.manuals]
    rows.append(("Source", sources.of(series.source, series.status)))
    sections = [
        Section("In short", (Facts(tuple(rows)),), "facts"),
        Section("Words", (word_table(series),), "words"),
        times_section(series, sources),
    ]
    if series.settings:
        sections.append(_settings(series, sources))
    if series.terminal_functions:
        sections.append(_terminals(series, sources))
    if series.switches:
        sections.append(switches_section(series.switches, sources))
    if series.options:
        sections.append(options_section(series.options, sources))
    sections += sources.sections()
    lead: Phrase = (series.description or series.title,)
    found = f"{series.id} {series.title}"
    return Page(device_page(series.id), series.title, GROUP, lead, tuple(sections), found)


def _settings(series: Drive, sources: Sources) -> Section:
    rows = []
    for setting in series.settings:
        cell = series.comno(setting.comno)
        if setting.value is not None:
            value = with_unit(setting.value, cell.unit)
        else:
            value = (
                f"{setting.plant} of the plant file" if setting.plant else "as the machine needs"
            )
        shown = f"{cell.display} " if cell.display else ""
        cells: tuple[Phrase, ...] = (
            (f"{shown}", Link(cell.hex, comno_page(series.id), cell.hex)),
            *((value,), (setting.when or "always",), (setting.why,)),
            sources.of(setting.source, setting.status),
        )
        rows.append(Row(cells))
    columns = ("Parameter", "Value", "When", "Why", "Source")
    return Section("To be set at the inverter", (Table(columns, tuple(rows)),), "settings")


def _terminals(series: Drive, sources: Sources) -> Section:
    rows = tuple(
        Row(
            (
                (str(item.number),),
                (str(item.inverted) if item.inverted is not None else "",),
                code(item.name),
                (item.title,),
                sources.of(item.source, item.status),
            ),
            f"terminal-{item.name}",
            f"{series.id} terminal function {item.number} {item.title}",
        )
        for item in series.terminal_functions
    )
    columns = ("Number", "Inverted", "Name", "What it does", "Source")
    return Section("Terminal functions", (Table(columns, rows),), "terminals")
