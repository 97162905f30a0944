"""What has to be set by hand at an inverter or a gateway: parameters and switches."""

from collections.abc import Iterable
from typing import Literal

from fbgen.catalog.scalars import Real, SnakeName, Text
from fbgen.catalog.sourced import Sourced
from fbgen.diagnostics import Diagnostic


class Setting(Sourced):
    """A parameter that is set at the inverter for this kind of plant, by the name of its ComNo.

    `value` is physical, `plant` names what of the plant file it is; with neither the machine
    decides. `when` says where it is wanted only; without it, it is always wanted.
    """

    comno: SnakeName
    value: Real | None = None
    plant: Literal["inv_no", "max_frequency_hz"] | None = None
    when: Text | None = None
    why: Text

    @property
    def always(self) -> bool:
        """Whether every inverter has it, so that it can be compared."""
        return self.when is None and (self.value is not None or self.plant is not None)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: two values."""
        yield from super().problems()
        if self.value is not None and self.plant is not None:
            message = f"the setting of '{self.comno}' has a value and takes one from the plant file"
            yield Diagnostic("FB1107", message, self.span_of("plant"), "give one of the two")


class Switch(Sourced):
    """A switch of a device: where it is and how it stands, or its part in the PROFIBUS address.

    `shows` is for rotary switches: `ones` and `tens` of the address. `adds` is for switches that
    are on or off: what an ON one adds to the address.
    """

    name: Text
    where: Text
    stands: Text | None = None
    shows: Literal["ones", "tens"] | None = None
    adds: Literal[1, 2, 4, 8, 16, 32, 64] | None = None

    def position(self, address: int) -> str:
        """How it stands for an address."""
        if self.adds is not None:
            return "ON" if address & self.adds else "OFF"
        if self.shows is not None:
            return str(address % 10 if self.shows == "ones" else address // 10)
        return self.stands or ""

    def problems(self) -> Iterable[Diagnostic]:
        """FB1107: neither a position nor a part of the address, or more than one of them."""
        yield from super().problems()
        if [self.stands, self.shows, self.adds].count(None) != 2:
            message = f"the switch {self.name} needs either a position or a part of the address"
            yield Diagnostic("FB1107", message, self.span, "give one of stands:, shows: and adds:")
