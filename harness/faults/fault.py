"""What a fault is: something that begins, goes on and ends, at one place of the plant."""

from dataclasses import dataclass
from enum import Enum
from typing import Protocol

from fbgen.catalog import Located
from harness.installation import Installation


class Target(Enum):
    """What a fault happens to. `WHOLE` needs no name."""

    WHOLE = "the plant"
    GATEWAY = "a gateway"
    DRIVE = "a drive"


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


class FaultMaker(Protocol):
    """Makes the fault for a place; `on` is "" for the whole plant."""

    def __call__(self, plant: Installation, on: str, settings: FaultSettings) -> Fault:
        """The fault, not yet injected."""
        ...


@dataclass(frozen=True, slots=True)
class FaultType:
    """A kind of fault as scenarios name it."""

    name: str
    title: str
    target: Target
    make: FaultMaker
    settings: type[FaultSettings] = FaultSettings
