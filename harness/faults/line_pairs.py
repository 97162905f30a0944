"""The pairs of wire of a line, as faults name them by the direction of the telegrams."""

from typing import Literal

from harness.installation.field_level import FieldLevel
from harness.line import Pair

Direction = Literal["both", "to_drives", "from_drives"]


def pairs(plant: FieldLevel, gateway: str, direction: Direction = "both") -> tuple[Pair, ...]:
    """The pairs behind a gateway; with two wires both directions share one."""
    line = plant.lines[gateway]
    chosen = {"to_drives": (line.master_pair,), "from_drives": (line.slave_pair,)}
    return chosen.get(direction, (line.master_pair, line.slave_pair))
