"""DPRD_DAT and DPWR_DAT (SFC14, SFC15) do nothing and give a RET_VAL, whatever the bus does.

Most of the values have a cause in the real world that a plant file cannot have, such as a length
or an address that fits no module. A program without these instructions sees nothing of it.
"""

from typing import Annotated, Literal

from pydantic import Field

from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.installation import Installation
from harness.installation.holds import attribute

ErrorCode = Annotated[str, Field(pattern=r"^16#8[0-9A-Fa-f]{3}$")]


class RefusalSettings(FaultSettings):
    """`ret_val` is what the instructions of this `direction` give."""

    ret_val: ErrorCode = "16#80B0"
    direction: Literal["both", "read", "write"] = "both"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, RefusalSettings)
    value = int(settings.ret_val.removeprefix("16#"), 16)
    both = ("refused_reading", "refused_writing")
    names = {"read": both[:1], "write": both[1:]}.get(settings.direction, both)
    data = plant.cpu.consistent_data
    return Holding(plant, *(attribute(data, name, value) for name in names))


FAULT = FaultType(
    "transfers_refused",
    "DPRD_DAT and DPWR_DAT (SFC14, SFC15) fail with a RET_VAL",
    Target.WHOLE,
    _make,
    RefusalSettings,
)
