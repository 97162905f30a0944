"""A page for each series with its trips and alarms: code, panel, meaning, likely cause."""

from collections.abc import Iterator

from fbgen.catalog import Drive
from fbgen.docs.document import Bullets, Code, Link, Page, Phrase, Row, Section, Table
from fbgen.docs.page_names import comno_link, device_page, trip_anchor, trip_page, word_page
from fbgen.docs.sources import Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import code

GROUP = "Trips and alarms"
_BLOCKS: tuple[Phrase, ...] = (
    (
        *("The blocks of a drive do the same at every trip: ", Code("state.tripped"), " comes, "),
        *(Code("state.trip"), " and the alarm list say it in the words of the table above."),
    ),
    (
        *("The run is over: ", Code("state.inhibited"), " stays until ", Code("run"), " has been "),
        "FALSE once behind the trip, so no drive starts again by itself.",
    ),
    (
        *(
            "A rising edge of ",
            Code("control.reset"),
            " resets it, with enable TRUE. The inverter ",
        ),
        "does not answer that and restarts: nothing is sent to it for the time of a reset, "
        "then the network takes its commands again and set-point and command are sent anew.",
    ),
    ("Telegrams to a tripped drive are answered as before, and the poll goes on.",),
    ("Nothing is reset without being asked for. The cause has to be gone before.",),
)


def trip_pages(subject: Subject) -> Iterator[Page]:
    """One page a series that has any."""
    for series in subject.drives.values():
        if series.trips:
            yield _page(series)


def _page(series: Drive) -> Page:
    sources = Sources()
    rows = tuple(
        Row(
            (
                code(f"{trip.code:04X}"),
                code(trip.display),
                (trip.meaning,),
                (trip.cause or "",),
                sources.of(trip.source, trip.status),
            ),
            trip_anchor(trip),
            f"{series.id} trip {trip.code:02X} {trip.display} {trip.meaning}",
        )
        for trip in sorted(series.trips, key=lambda trip: trip.code)
    )
    alarm = series.comno(series.link.alarm)
    trip_cell = series.comno(series.link.trip)
    lead: Phrase = (
        "What ",
        comno_link(series.id, trip_cell),
        " of ",
        Link(series.title, device_page(series.id)),
        " says after a trip, and the panel with it. While the inverter is tripped its replies have "
        "lower case commands (",
        Code("70"),
        " for ",
        Code("50"),
        "). Alarms that are no trip yet stand in ",
        comno_link(series.id, alarm),
        *((", ", Link("bit by bit", word_page(series.id, alarm.word))) if alarm.word else ()),
        ".",
    )
    table = Table(("Code", "Panel", "Meaning", "Likely cause", "Source"), rows)
    sections = (
        Section("Trips", (table,), "trips"),
        Section("What the blocks do", (Bullets(_BLOCKS),), "blocks"),
        *sources.sections(),
    )
    return Page(trip_page(series.id), f"Trips of {series.id}", GROUP, lead, sections)
