"""What every gateway on PROFIBUS DP has: its side as a slave, layouts of its cyclic data."""

from collections.abc import Iterable

from pydantic import Field

from fbgen.catalog.gateways import Gateway, unknown_name
from fbgen.catalog.layouts import Layout
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.scalars import Count, EntryId, Flag, HexWord, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic


class Profibus(Sourced):
    """The gateway as a PROFIBUS DP slave. Addresses are those the switches can set."""

    minimum_address: Count
    maximum_address: Count
    default_address: Count | None = None
    sync: Flag
    freeze: Flag
    auto_baud: Flag
    set_slave_address: Flag


class PublishedProfibus(Profibus):
    """A slave whose GSD file is public: what only that file tells."""

    ident_number: HexWord
    gsd_file: Text
    default_address: Count
    fail_safe: Flag
    max_diagnosis_bytes: Count
    min_slave_interval_us: Count
    max_tsdr_bits: dict[str, Count]


class ProfibusGateway(Gateway):
    """A gateway that is a DP slave. `protocol` is the one that it speaks with the inverters."""

    protocol: EntryId
    profibus: Profibus
    default_layout: EntryId
    layouts: tuple[Layout, ...] = Field(min_length=1)

    def layout(self, name: str) -> Layout:
        """The layout of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.layouts, name, "FB1105", f"'{self.id}' has no layout '{name}'")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name that is not there."""
        yield from super().problems()
        yield from no_duplicates(self.layouts, "name", lambda item: item.name, "layout")
        yield from unknown_name(self, "default_layout", self.default_layout, self.layouts)
