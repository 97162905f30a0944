"""A page for each manual: where it contradicts itself or another, the reading taken, and why."""

from collections.abc import Iterator

from fbgen.catalog import Manual
from fbgen.docs.document import Facts, Link, Page, Phrase, Row, Section, Table
from fbgen.docs.page_names import device_page, manual_page
from fbgen.docs.sources import Sources
from fbgen.docs.subject import Subject
from fbgen.docs.texts import listed

GROUP = "Manuals"
_LEAD = (
    "What stands there in two ways, cannot be right or is lost in the text, the reading that the "
    "catalogue takes, and why. Where nothing settles it, the reading is a choice and marked as "
    "unverified."
)


def manual_pages(subject: Subject) -> Iterator[Page]:
    """Manuals that are about devices of the site."""
    shown = {device.id for device in subject.devices}
    for manual in subject.catalog.manuals.values():
        if not shown.isdisjoint(manual.devices):
            yield _page(manual, shown)


def _page(manual: Manual, shown: set[str]) -> Page:
    sources = Sources()
    rows = tuple(
        Row(
            (
                (item.kind.replace("_", " "),),
                *((item.says,), (item.taken,), (item.why,)),
                sources.of(item.source, item.status),
            ),
            item.name,
            f"{manual.title} {item.name} {item.says}",
        )
        for item in manual.findings
    )
    about = listed(_device(name, shown) for name in manual.devices)
    columns = ("What", "It says", "Taken", "Why", "Place")
    sections = (
        Section("In short", (Facts((("About", about),)),), "facts"),
        Section("Inconsistencies", (Table(columns, rows),), "findings"),
        *sources.sections(),
    )
    return Page(manual_page(manual.id), manual.title, GROUP, (_LEAD,), sections, manual.title)


def _device(name: str, shown: set[str]) -> Phrase:
    return (Link(name, device_page(name)),) if name in shown else (name,)
