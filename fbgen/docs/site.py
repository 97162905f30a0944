"""All pages of a site in the order of its menu."""

from collections.abc import Iterable, Iterator
from itertools import chain

from fbgen.dataclass import dataclass
from fbgen.docs.document import Link, Page
from fbgen.docs.pages.blocks import block_pages
from fbgen.docs.pages.comnos import comno_pages
from fbgen.docs.pages.gateways import gateway_pages
from fbgen.docs.pages.manuals import manual_pages
from fbgen.docs.pages.not_modelled import not_modelled_pages
from fbgen.docs.pages.overview import overview_page
from fbgen.docs.pages.protocols import protocol_pages
from fbgen.docs.pages.series import series_pages
from fbgen.docs.pages.trips import trip_pages
from fbgen.docs.pages.usage import usage_pages
from fbgen.docs.pages.words import word_pages
from fbgen.docs.subject import Subject
from fbgen.docs.usage import usage_of


@dataclass(frozen=True, slots=True)
class Site:
    """The pages; the first is the one to begin with. `title` stands at the head of each."""

    title: str
    pages: tuple[Page, ...]
    version: str

    def broken_links(self) -> Iterator[tuple[Page, Link]]:
        """Links that lead nowhere."""
        known = {page.id: set(page.anchors()) for page in self.pages}
        for page in self.pages:
            for link in page.links():
                anchors = known.get(link.page or page.id)
                if anchors is None or (link.anchor and link.anchor not in anchors):
                    yield page, link


def build_site(subject: Subject, version: str) -> Site:
    """The pages of a subject."""
    usage = usage_of(subject.programs, subject.catalog)
    parts: Iterable[Iterator[Page]] = (
        gateway_pages(subject),
        series_pages(subject),
        word_pages(subject, usage),
        comno_pages(subject),
        trip_pages(subject),
        protocol_pages(subject),
        block_pages(subject, usage),
        usage_pages(subject, usage),
        manual_pages(subject),
        not_modelled_pages(subject),
    )
    pages = tuple(chain.from_iterable(parts))
    return Site(subject.title, (overview_page(subject, pages), *pages), version)
