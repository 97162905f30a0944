"""What a running program needs from the controller around it: time, memory, hardware.

The engines know nothing else of the controller. `harness.plc` implements it with a simulated CPU;
`StandaloneEnvironment` serves blocks that are run on their own.
"""

from collections.abc import Mapping
from functools import lru_cache
from typing import Protocol

from fbgen.diagnostics import error
from fbgen.lang.types import Scalar, Type
from fbgen.source import Span
from harness.engine.services import Services
from harness.engine.stubbed_instructions import carry_out
from harness.kernel import Kernel


class Area(Protocol):
    """A variable handed to a system instruction as an area of bytes (ANY, VARIANT).

    Bytes are in S7 layout: big endian, BOOLs packed, words aligned to even addresses.
    """

    @property
    def type(self) -> Type:
        """The declared type of the variable."""
        ...

    @property
    def length(self) -> int:
        """Its length in bytes."""
        ...

    def read(self) -> bytes:
        """All bytes of the variable."""
        ...

    def write(self, data: bytes) -> None:
        """Set the variable from its first `len(data)` bytes; the rest stays."""
        ...


@lru_cache
def places_of(text: str) -> tuple[tuple[int, int], ...]:
    """Byte and count of each place in a text such as `256:1 257:1 260:2`."""
    parts = (place.split(":") for place in text.split())
    return tuple((int(byte), int(count)) for byte, count in parts)


class Environment(Protocol):
    """The controller as a running program sees it."""

    @property
    def now_ns(self) -> int:
        """The instant of the running scan, in nanoseconds; timers follow it."""
        ...

    @property
    def classic(self) -> bool:
        """True for S7-300 and S7-400, whose timers go on in their calls only."""
        ...

    @property
    def inputs(self) -> bytearray:
        """The process image of the inputs."""
        ...

    @property
    def outputs(self) -> bytearray:
        """The process image of the outputs."""
        ...

    @property
    def markers(self) -> bytearray:
        """The bit memory."""
        ...

    @property
    def services(self) -> Services:
        """The calendar clock, and the stubs of the user."""
        ...

    def read_peripheral(self, byte: int, count: int) -> int:
        """`count` bytes (1, 2, 4) straight from the hardware, big endian, as an unsigned number."""
        ...

    def read_several(self, places: str) -> tuple[int, ...] | None:
        """What calls of `read_peripheral` give, one for each place and in the same order.

        None, and nothing has happened yet, if anything could happen between them. `places` has
        byte and count of each, as in `256:1 257:1 260:2`.
        """
        ...

    def write_peripheral(self, byte: int, count: int, value: int) -> None:
        """`count` bytes (1, 2, 4) straight to the hardware, big endian."""
        ...

    def write_several(self, places: str, values: tuple[int, ...]) -> bool:
        """What calls of `write_peripheral` do, one for each value and in the same order.

        False, and nothing has happened yet, if anything could happen between them. `places` has
        byte and count of each, as for `read_several`.
        """
        ...

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        """Carry out a system instruction and give its result.

        `arguments` has the input values, and an `Area` for each output and area parameter.
        """
        ...


class StandaloneEnvironment:
    """A controller without hardware: a clock and memory, for blocks that run on their own."""

    __slots__ = ("inputs", "kernel", "markers", "outputs", "services")

    def __init__(self, kernel: Kernel | None = None, image_bytes: int = 1024) -> None:
        self.kernel = kernel or Kernel()
        self.services = Services()
        self.inputs = bytearray(image_bytes)
        self.outputs = bytearray(image_bytes)
        self.markers = bytearray(image_bytes)

    @property
    def now_ns(self) -> int:
        """The instant of the virtual clock."""
        return self.kernel.now_ns

    @property
    def classic(self) -> bool:
        """It is a CPU of today."""
        return False

    def read_peripheral(self, byte: int, count: int) -> int:
        """Without hardware the inputs are what somebody put into the image."""
        return int.from_bytes(self.inputs[byte : byte + count], "big")

    def read_several(self, places: str) -> tuple[int, ...] | None:
        """Without hardware nothing happens between two reads."""
        return tuple(self.read_peripheral(byte, count) for byte, count in places_of(places))

    def write_peripheral(self, byte: int, count: int, value: int) -> None:
        """Without hardware the outputs end in the image."""
        self.outputs[byte : byte + count] = value.to_bytes(count, "big")

    def write_several(self, places: str, values: tuple[int, ...]) -> bool:
        """Without hardware nothing happens between two writes."""
        for (byte, count), value in zip(places_of(places), values, strict=True):
            self.write_peripheral(byte, count, value)
        return True

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        """There is no hardware that could carry out an instruction; a stub may do it."""
        stub = self.services.stubs.find(name)
        if stub is not None:
            return carry_out(stub, name, arguments, span)
        raise error(
            "FB6001",
            f"{name} needs a controller with hardware, and this block runs on its own",
            span,
            "run it in a plant (a scenario with a plant file), or give it a stub",
        )
