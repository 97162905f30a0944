"""Where a fact comes from: a document with its section, or nowhere yet."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.located import Located
from fbgen.catalog.scalars import Real, Text
from fbgen.diagnostics import Diagnostic
from fbgen.nearest import nearest

Status = Literal["verified", "unverified"]


class Sourced(Located):
    """An entry that must name document and section, or say `status: unverified`.

    `source` may stand beside `unverified` too: it then says what the guess rests on.
    """

    source: Text | None = None
    status: Status = "verified"

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103: neither a source nor marked as unverified."""
        if self.status == "verified" and self.source is None:
            yield Diagnostic(
                "FB1103",
                "this entry names no source",
                self.span,
                "add source: with document and section, or status: unverified",
            )


def unknown_fields(owner: Located, names: Iterable[str]) -> Iterable[Diagnostic]:
    """FB1105: names in `unverified` that are no fields of the entry."""
    fields = type(owner).model_fields
    for name in names:
        if name not in fields:
            yield Diagnostic(
                "FB1105",
                f"a {type(owner).__name__} has no field '{name}'",
                owner.span_of("unverified"),
                nearest(name, fields),
            )


class Duration(Sourced):
    """A time in milliseconds."""

    ms: Annotated[Real, Field(ge=0)]

    @property
    def ns(self) -> int:
        """The time in nanoseconds."""
        return round(self.ms * 1_000_000)
