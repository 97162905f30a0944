"""A gateway with another configuration, or another device, stands in the place of the right one.

The master's Chk_Cfg or Set_Prm is refused, so no data are exchanged (EN 50170 volume 2).
"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Literal

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.fieldbus import SlaveType
from harness.installation import Installation
from harness.installation.holds import Hold

_ONE_INPUT_BYTE = b"\x10"


class ConfigurationSettings(FaultSettings):
    """`refuses` says what does not fit: the configuration, or the ident number of the device."""

    refuses: Literal["configuration", "ident_number"] = "configuration"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, ConfigurationSettings)
    slave = plant.stations[on].slave
    if settings.refuses == "configuration":
        other = replace(slave.type, configuration=slave.type.configuration + _ONE_INPUT_BYTE)
    else:
        other = replace(slave.type, ident_number=slave.type.ident_number ^ 1)

    def present() -> SlaveType:
        return slave.type

    return Holding(plant, Hold((slave, "type"), other, present, slave.become, _any))


def _any(types: Iterable[SlaveType]) -> SlaveType:
    """All are wrong alike; the first one stays."""
    return next(iter(types))


FAULT = FaultType(
    "profibus_wrong_configuration",
    "The configuration of a gateway is not the one that the master expects",
    Target.GATEWAY,
    _make,
    ConfigurationSettings,
)
