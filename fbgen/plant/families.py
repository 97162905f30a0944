"""What the PLC families can do that a plant file depends on.

Sources: TIA Portal help, DPRD_DAT and DPWR_DAT; the sizes of the address areas are those of the
largest CPU of a family (recalled from the CPU manuals, found in no document at hand).
"""

from dataclasses import dataclass
from types import MappingProxyType
from typing import Literal, get_args

PlcFamily = Literal["s7-1200", "s7-1500", "s7-300", "s7-400", "iec"]
PlantDialect = Literal["tia", "iec"]
PLANT_DIALECTS: tuple[PlantDialect, ...] = get_args(PlantDialect)
"""The dialects that blocks are generated in."""


@dataclass(frozen=True, slots=True)
class Family:
    """A PLC family.

    `last_address` is the last byte of the input and of the output area. `whole_frame` says whether
    it has DPRD_DAT and DPWR_DAT (SFC14 and SFC15), `hardware_identifiers` whether these take a
    hardware identifier rather than a start address. `image_moves_whole` says whether the process
    image may hold a consistent identifier of 3 or more than 4 bytes.
    """

    name: PlcFamily
    title: str
    dialects: tuple[PlantDialect, ...]
    last_address: int
    whole_frame: bool
    hardware_identifiers: bool
    image_moves_whole: bool

    @property
    def classic(self) -> bool:
        """S7-300 and S7-400: no optimized access, timers are system function blocks."""
        return self.name in ("s7-300", "s7-400")


FAMILIES = MappingProxyType(
    {
        family.name: family
        for family in (
            Family("s7-1200", "S7-1200", ("tia",), 1023, True, True, True),
            Family("s7-1500", "S7-1500", ("tia",), 32767, True, True, True),
            Family("s7-300", "S7-300", ("tia",), 8191, True, False, False),
            Family("s7-400", "S7-400", ("tia",), 16383, True, False, False),
            Family("iec", "a PLC by IEC 61131-3", ("iec",), 65535, False, False, True),
        )
    }
)
"""All families by name."""
