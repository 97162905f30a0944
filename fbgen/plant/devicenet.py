"""DeviceNet in the plant file: a scanner of the PLC, and drives with an option on its network."""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import BeforeValidator, Field

from fbgen.catalog import Catalog, Located, OptionValue
from fbgen.catalog.scalars import Real, Text, Whole
from fbgen.diagnostics import Diagnostic
from fbgen.plant import devicenet_checks
from fbgen.plant.parameters import DeviceNetDriveParameters


def _as_text(value: object) -> object:
    """A number by itself is one instance of two: the check says so, not the type."""
    return str(value) if isinstance(value, int) and not isinstance(value, bool) else value


DeviceNetConnection = Literal["polled", "change_of_state", "cyclic"]


class DeviceNetDrive(Located):
    """One inverter with a DeviceNet option in it.

    `type`: the id of the option in the catalogue. `series`: id of the inverter series. `mac`: the
    MAC ID that the switches of the option say. `assemblies`: instances of output and input, as
    100/150. `connection`: change of state and cyclic inputs come beside the polled ones.
    `packet_rate_ms`: the expected packet rate. `input_address`: first byte of its inputs in the
    image that the scanner has in the PLC. `output_address`: the same for its outputs. `settings`:
    parameters of the option by their names in the catalogue. `parameters`: first values of the
    block's. `options`: those of the option, and of the series. `max_frequency_hz`: its parameter
    FH.
    """

    name: str
    title: Text | None = None
    type: str
    series: str
    max_frequency_hz: Real
    mac: Whole
    assemblies: Annotated[str, BeforeValidator(_as_text)]
    connection: DeviceNetConnection = "polled"
    packet_rate_ms: Annotated[Whole, Field(ge=1, le=65535)] = 100
    input_address: Whole
    output_address: Whole
    settings: dict[str, Whole] = Field(default_factory=dict)
    parameters: DeviceNetDriveParameters = Field(default_factory=DeviceNetDriveParameters)
    options: dict[str, OptionValue] = Field(default_factory=dict)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about this drive."""
        assert isinstance(known, Catalog)
        return devicenet_checks.drive(self, known)


class DeviceNetNetwork(Located):
    """One network with its scanner and its drives.

    `rate`: kbit/s. `mac`: the MAC ID of the scanner. `scan_ms`: how often it polls.
    `active_address`: first of 8 input bytes in which the scanner shows who exchanges data, bit
    N % 8 of byte N / 8 for MAC ID N; blocks need it, a program of your own may do without.
    `drives`: who is on the network.
    """

    name: str
    title: Text | None = None
    rate: Whole = 500
    mac: Annotated[Whole, Field(ge=0, le=63)] = 0
    scan_ms: Annotated[Whole, Field(ge=1, le=1000)] = 10
    active_address: Whole | None = None
    drives: tuple[DeviceNetDrive, ...] = Field(min_length=1)

    def problems(self) -> Iterable[Diagnostic]:
        """FB2053: one MAC ID for two nodes."""
        return devicenet_checks.macs_twice(self)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about this network."""
        assert isinstance(known, Catalog)
        return devicenet_checks.network(self, known)
