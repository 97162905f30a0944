"""Where manuals contradict themselves or each other, and which reading the catalogue takes."""

from collections.abc import Iterable
from typing import Literal

from pydantic import Field

from fbgen.catalog.scalars import EntryId, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic, Note


class Finding(Sourced):
    """One place: what stands there, how it is read here, and why.

    `source` is the place in the manual. `unverified`: nothing settles it, and the reading is a
    choice. `kind` tells a slip of the pen from what changes how a program must behave.
    """

    name: SnakeName
    kind: Literal["contradiction", "typo", "lost_text"]
    says: Text
    taken: Text
    why: Text


class Manual(Sourced):
    """A manual, by what is wrong in it; `devices` are the gateways and series that it is about."""

    version: Literal[1]
    id: EntryId
    title: Text
    description: Text | None = None
    devices: tuple[EntryId, ...] = Field(min_length=1)
    findings: tuple[Finding, ...] = Field(min_length=1)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 a name twice; FB1103 no source."""
        yield from super().problems()
        seen: dict[str, Finding] = {}
        for finding in self.findings:
            first = seen.setdefault(finding.name, finding)
            if first is not finding:
                yield Diagnostic(
                    "FB1102",
                    f"the name '{finding.name}' stands twice in the manual '{self.id}'",
                    finding.span_of("name"),
                    "",
                    (Note("first here", first.span_of("name")),),
                )
