"""What the PLC families can do that a plant file depends on.

Sources: TIA Portal help, DPRD_DAT and DPWR_DAT; the sizes of the address areas are those of the
largest CPU of a family (recalled from the CPU manuals, found in no document at hand).
"""

from types import MappingProxyType
from typing import Literal

from fbgen.dataclass import dataclass

PlcFamily = Literal["s7-1200", "s7-1500", "s7-300", "s7-400", "iec", "twincat"]
PlantDialect = Literal["tia", "step7", "iec", "twincat", "plcopen"]
FileLayout = Literal["one", "per_block"]
"""All blocks in one file, or each in its own."""


@dataclass(frozen=True, slots=True)
class Family:
    """A PLC family.

    `dialects` are those that its tools read, the usual one first. `last_address` is the last byte
    of the input and of the output area. `peripheral` says whether a program reaches the inputs and
    outputs past the process image, `whole_frame` whether it has DPRD_DAT and DPWR_DAT (SFC14 and
    SFC15), `hardware_identifiers` whether these take a hardware identifier rather than a start
    address. `image_moves_whole` says whether the process image may hold a consistent identifier of
    3 or more than 4 bytes, `modbus_master` whether it has Modbus_Comm_Load and Modbus_Master.
    """

    name: PlcFamily
    title: str
    dialects: tuple[PlantDialect, ...]
    last_address: int
    peripheral: bool
    whole_frame: bool
    hardware_identifiers: bool
    image_moves_whole: bool
    modbus_master: bool = False

    @property
    def classic(self) -> bool:
        """S7-300 and S7-400: no optimized access, timers are system function blocks."""
        return self.name in ("s7-300", "s7-400")


_S7 = {"peripheral": True, "whole_frame": True}
_BY_IDENTIFIER = {
    **_S7,
    "hardware_identifiers": True,
    "image_moves_whole": True,
    "modbus_master": True,
}
_BY_ADDRESS = {**_S7, "hardware_identifiers": False, "image_moves_whole": False}
_ONLY_IMAGE = {
    "peripheral": False,
    "whole_frame": False,
    "hardware_identifiers": False,
    "image_moves_whole": True,
}

FAMILIES = MappingProxyType(
    {
        family.name: family
        for family in (
            Family("s7-1200", "S7-1200", ("tia",), 1023, **_BY_IDENTIFIER),
            Family("s7-1500", "S7-1500", ("tia",), 32767, **_BY_IDENTIFIER),
            Family("s7-300", "S7-300", ("tia", "step7"), 8191, **_BY_ADDRESS),
            Family("s7-400", "S7-400", ("tia", "step7"), 16383, **_BY_ADDRESS),
            Family("iec", "a PLC by IEC 61131-3", ("iec", "plcopen"), 65535, **_ONLY_IMAGE),
            Family("twincat", "TwinCAT", ("twincat", "plcopen"), 65535, **_ONLY_IMAGE),
        )
    }
)
"""All families by name."""

USUAL_PLC: dict[str, PlcFamily] = {
    "tia": "s7-1500",
    "step7": "s7-300",
    "iec": "iec",
    "twincat": "twincat",
    "plcopen": "iec",
}
"""The family that a dialect is for where none is named that reads it."""

FILE_LAYOUTS: dict[PlantDialect, tuple[FileLayout, ...]] = {
    "tia": ("per_block", "one"),
    "step7": ("one", "per_block"),
    "iec": ("one", "per_block"),
    "twincat": ("per_block",),
    "plcopen": ("one",),
}
"""How a dialect's text can stand in files, the usual way first."""

LANGUAGES: dict[str, str] = {
    "tia": "tia",
    "step7": "step7",
    "iec": "iec",
    "twincat": "twincat",
    "plcopen": "iec",
}
"""The dialect of the language that stands in the files of a plant's dialect."""
