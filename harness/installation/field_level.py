"""Drives on lines, whatever else there is: all that a fault of a drive or a line needs."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Protocol

from harness.drives import Inverter
from harness.installation.holds import Hold, Holds
from harness.kernel import Kernel
from harness.line import Line


class FieldLevel(Protocol):
    """A whole installation is one, and so are drives that are served at a port."""

    @property
    def kernel(self) -> Kernel:
        """The clock."""
        ...

    @property
    def holds(self) -> Holds:
        """What faults hold."""
        ...

    @property
    def lines(self) -> Mapping[str, Line]:
        """The lines by their names."""
        ...

    @property
    def drives(self) -> Mapping[str, Inverter]:
        """The inverters by their names."""
        ...

    def neighbours(self, drive: str) -> Sequence[str]:
        """The names of the other drives on the line of a drive."""
        ...

    def gets_telegrams(self, drive: str) -> bool:
        """Whether a drive is asked by telegrams at its serial port."""
        ...

    def cable(self, drive: str) -> Iterable[Hold[bool]]:
        """What is cut with the cable of a drive beside its two directions."""
        ...
