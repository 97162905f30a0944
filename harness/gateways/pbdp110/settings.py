"""How a PBDP-110 is made: its modules, codes and times. Facts: PBDP-110 manual #10407-1.100-000."""

from collections.abc import Mapping
from dataclasses import field
from enum import Enum
from types import MappingProxyType

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_MS
from harness.line import SerialFormat


class BusLost(Enum):
    """What the drives do when the master is lost and the DP watchdog was active (section 2)."""

    LOCAL = "local"
    HOLD = "hold"


@dataclass(frozen=True, slots=True)
class AccessPlace:
    """Where the parameter channel of one drive lies: offsets of words in outputs and inputs."""

    action: int
    number: int
    data: int
    response: int
    response_number: int
    response_data: int


@dataclass(frozen=True, slots=True)
class ChannelPlace:
    """Where the data of one channel lie in a module, by offsets of words.

    `inputs` are in the order of `PbdpSettings.inputs`. Compact modules have no `access`.
    """

    command: int
    frequency: int
    inputs: tuple[int, ...]
    access: AccessPlace | None


@dataclass(frozen=True, slots=True)
class Module:
    """One of the modules of the GSD file; `places` has one entry for each channel that it has."""

    name: str
    configuration: bytes
    output_length: int
    input_length: int
    places: tuple[ChannelPlace, ...]


@dataclass(frozen=True, slots=True)
class DriveFacts:
    """What the interface knows of the parameters of the drive at a port (section 10.4)."""

    read_only: frozenset[int] = frozenset()
    write_only: frozenset[int] = frozenset()


@dataclass(frozen=True, slots=True)
class ChannelSettings:
    """A port for a drive. `diagnosis_mask` is its bit in the diagnosis byte, `facts` are
    those of the drive there.
    """

    name: str
    powers_gateway: bool
    diagnosis_mask: int
    facts: DriveFacts = DriveFacts()


@dataclass(frozen=True, slots=True)
class AccessCodes:
    """The codes of the parameter channel (sections 10.3 and 10.4).

    `request_shift` and `response_shift` are the places of the two bits in their words, `refusals`
    the error codes for what the drive answers, by its own error code.
    """

    request_shift: int
    response_shift: int
    idle: int
    read: int
    write_eeprom: int
    write_ram: int
    response_idle: int
    response_read: int
    response_written: int
    response_error: int
    read_only: int
    write_only: int
    other: int
    refusals: Mapping[int, int]


@dataclass(frozen=True, slots=True)
class PbdpSettings:
    """One PBDP-110. Times in nanoseconds.

    The master chooses among `modules`; the first one is the plant's. `inputs` are the cells of a
    drive that are read all the time, its status first. `online_mask` is the bit that the interface
    puts into the status, `reset_mask` the fault reset in the command. `formats` are tried in this
    order. After `attempts` without an answer the drive counts as gone. `local` are the numbers
    that the interface answers by itself. Ident number and the number of user parameters are those
    of a GSD file, where there is one.
    """

    modules: tuple[Module, ...]
    channels: tuple[ChannelSettings, ...]
    command: int
    frequency: int
    inputs: tuple[int, ...]
    online_mask: int
    reset_mask: int
    access: AccessCodes
    formats: tuple[SerialFormat, ...]
    ident_number: int = 0
    user_parameter_bytes: int = 0
    processing_ns: int = 1 * NS_PER_MS
    reply_timeout_ns: int = 200 * NS_PER_MS
    attempts: int = 3
    startup_ns: int = 0
    bus_lost: BusLost = BusLost.LOCAL
    local: Mapping[int, int] = field(default_factory=lambda: MappingProxyType({}))
    highest_address: int = 126
