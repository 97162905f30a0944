"""What is tied into the address space of a CPU: slaves of its DP master, and its own modules."""

from collections.abc import Sequence
from typing import Protocol

from fbgen.wire.profibus import Slot


class ModuleAddresses(Protocol):
    """Where the data of a module lie."""

    @property
    def name(self) -> str:
        """For messages."""
        ...

    @property
    def input_address(self) -> int:
        """First byte of the inputs."""
        ...

    @property
    def output_address(self) -> int:
        """First byte of the outputs."""
        ...


class IoModule(Protocol):
    """Input and output bytes that a CPU reads and writes.

    `slots` are what DPRD_DAT and DPWR_DAT reach, each by a LADDR of its own. `failed`: the data
    cannot be reached. `queued`: a bus cycle is asked for already, or none is needed.
    `inputs_pending`: the next bus cycle brings other inputs.
    """

    @property
    def settings(self) -> ModuleAddresses:
        """Its addresses."""
        ...

    @property
    def slots(self) -> Sequence[Slot]:
        """Its modules, if it has several."""
        ...

    @property
    def inputs(self) -> bytearray:
        """What the CPU reads."""
        ...

    @property
    def outputs(self) -> bytearray:
        """What the CPU wrote last."""
        ...

    @property
    def failed(self) -> bool:
        """See above."""
        ...

    @property
    def queued(self) -> bool:
        """See above."""
        ...

    @property
    def inputs_pending(self) -> bool:
        """See above."""
        ...

    def write(self, offset: int, data: bytes) -> None:
        """The CPU writes outputs."""
        ...
