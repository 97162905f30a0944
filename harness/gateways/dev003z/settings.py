"""How a DEV003Z is set up: its switches, its own parameters, and options of the catalogue."""

from collections.abc import Mapping
from dataclasses import field

from fbgen.catalog import OptionValue
from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class Dev003zSettings:
    """What differs from a new one.

    `series` is that of the inverter, `mac` and `baud` are switches: `baud` is the value of the
    attribute, not the rate. `parameters` are counts by the names of
    the catalogue, such as `assembly_instances`; `options` are those of the catalogue.
    """

    series: str = "vf-s15"
    mac: int = 63
    baud: int = 2
    parameters: Mapping[str, int] = field(default_factory=dict)
    options: Mapping[str, OptionValue] = field(default_factory=dict)
