"""What the simulated devices do not do, as the list beside their code says."""

from collections.abc import Iterator

from fbgen.docs.document import Page, Row, Section, Table
from fbgen.docs.subject import Subject

GROUP = "Manuals"
PAGE = "not-modelled"
_LEAD = (
    "What runs in fbgen test, fbgen demo and fbgen sim is a model. This is what it leaves out, so "
    "that nobody takes a test that passes for more than it shows."
)


def not_modelled_pages(subject: Subject) -> Iterator[Page]:
    """One page, if the list was handed in."""
    if subject.not_modelled:
        rows = tuple(
            Row(((one.part,), (one.what,), (one.instead,))) for one in subject.not_modelled
        )
        table = Table(("Part", "Not modelled", "Instead"), rows)
        section = Section("What is left out", (table,), "list")
        title = "What the simulators do not model"
        yield Page(PAGE, title, GROUP, (_LEAD,), (section,), "simulators not modelled limits")
