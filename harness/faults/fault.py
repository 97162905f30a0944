"""What a fault is: something that begins, goes on and ends, at one place of the plant."""

from collections.abc import Mapping
from enum import Enum
from typing import Annotated, Generic, Protocol, TypeVar

from pydantic import Field

from fbgen.catalog import Located
from fbgen.catalog.scalars import Real
from fbgen.dataclass import dataclass
from harness.installation import Installation

Plant_contra = TypeVar("Plant_contra", contravariant=True)
"""What a fault needs around it: a whole installation, or drives on lines (`FieldLevel`)."""

Probability = Annotated[Real, Field(gt=0, le=1)]
"""A probability that is not 0."""


class Target(Enum):
    """What a fault happens to. `WHOLE` needs no name; `TELEGRAMS` is a gateway with a line, `LINE`
    its line, or a serial line of the PLC, whose module is `MODULE`; `OPTION` a drive by the option
    that is in it."""

    WHOLE = "plant"
    GATEWAY = "gateway"
    TELEGRAMS = "gateway for telegrams"
    LINE = "line"
    MODULE = "serial line"
    DRIVE = "drive"
    NETWORK = "DeviceNet network"
    OPTION = "drive on DeviceNet"

    def places(self, plant: Installation) -> Mapping[str, object]:
        """What has a name in the plant and can have such a fault; empty for the whole plant."""
        if self is Target.GATEWAY:
            return plant.stations
        if self is Target.TELEGRAMS:
            return plant.gateways
        if self is Target.LINE:
            return {**plant.gateways, **plant.devices.modules}
        if self is Target.MODULE:
            return plant.devices.modules
        if self is Target.NETWORK:
            return plant.networks
        if self is Target.OPTION:
            return plant.options
        return plant.drives if self is Target.DRIVE else {}


class FaultSettings(Located):
    """Settings of a fault; each fault has its own, those without any use this one."""


class Fault(Protocol):
    """One fault at one place."""

    def inject(self) -> None:
        """It begins."""
        ...

    def clear(self) -> None:
        """It ends; what it has left behind stays."""
        ...


class FaultMaker(Protocol[Plant_contra]):
    """Makes the fault for a place; `on` is "" for the whole plant.

    Making it does nothing to the plant. Raises DiagnosticError for settings that the place at hand
    does not allow.
    """

    def __call__(self, plant: Plant_contra, on: str, settings: FaultSettings) -> Fault:
        """The fault, not yet injected."""
        ...


@dataclass(frozen=True, slots=True)
class FaultType(Generic[Plant_contra]):
    """A kind of fault as scenarios name it."""

    name: str
    title: str
    target: Target
    make: FaultMaker[Plant_contra]
    settings: type[FaultSettings] = FaultSettings
