"""The page to begin with."""

from collections.abc import Sequence
from itertools import groupby

from fbgen.docs.document import Bullets, Link, Page, Paragraph, Phrase, Section
from fbgen.docs.subject import Subject

_GROUPS = {
    "Gateways": "Cyclic data, identifiers, lamps, times, and what the documents leave open.",
    "Inverters": "What a series is, what has to be set, terminal functions.",
    "Words": "Command, status, control and alarm words bit by bit, each with a decoder.",
    "ComNos": "All communication numbers with unit, range, default; a converter to words.",
    "Trips and alarms": "Codes, what the panel shows, likely causes.",
    "Blocks": "What each block does, its state diagram, its codes; which block uses which bit.",
    "Manuals": "Where manuals contradict themselves, the reading taken; what is not modelled.",
    "Protocols": "Frames, commands, errors on the line of the inverters.",
}


def overview_page(subject: Subject, pages: Sequence[Page]) -> Page:
    """What there is, by groups."""
    sections = [_protection()]
    for group, members in groupby(pages, lambda page: page.group):
        links = tuple[Phrase, ...]((Link(page.title, page.id),) for page in members)
        about = Paragraph((_GROUPS[group],))
        anchor = group.lower().replace(" ", "-")
        sections.append(Section(group, (about, Bullets(links)), anchor))
    lead: Phrase = (
        "How every bit is used: words, communication numbers, telegrams and trips, each with the "
        "document that says so. What rests on no document is marked as unverified.",
    )
    return Page("index", subject.title, "Start", lead, tuple(sections))


def _protection() -> Section:
    text: Phrase = (
        "Nothing that is sent by communication is a safety function. An emergency stop by telegram "
        "stops a process; people are protected by STO and by hard-wired terminals.",
    )
    return Section("Before anything moves", (Paragraph(text, "warning"),), "protection")
