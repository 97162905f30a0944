"""An inverter in the plant file, whatever it is connected to."""

from collections.abc import Iterable
from typing import Literal

from pydantic import Field

from fbgen.catalog import Catalog, Located, OptionValue
from fbgen.catalog.scalars import Real, Text, Whole
from fbgen.diagnostics import Diagnostic
from fbgen.plant import checks
from fbgen.plant.parameters import DriveParameters


class PlantDrive(Located):
    """One inverter. `max_frequency_hz` is its parameter FH.

    `inv_no` is its number on the line of a gateway that has one, `channel` its port at a gateway
    for process data.
    """

    name: str
    title: Text | None = None
    inv_no: Whole = 0
    channel: Literal["A", "B"] | None = None
    series: str
    max_frequency_hz: Real
    parameters: DriveParameters = Field(default_factory=DriveParameters)
    options: dict[str, OptionValue] = Field(default_factory=dict)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about this drive."""
        assert isinstance(known, Catalog)
        return checks.drive(self, known)
