"""How a TOSPBDP001 is made: its layout, its times, and what its documents leave open.

The manual (TOSPBDP001 v1.1) tells most of it. The hardware is an HMS Anybus Communicator in Generic
Data Mode, and what the manual does not tell follows the manuals of that device (HMSI-27-314,
printed pages 103-105; HMSI-27-306, printed page 33). Each of these choices is an enumeration here
whose first member is the default.
"""

from enum import Enum

from fbgen.dataclass import dataclass
from harness.kernel import NS_PER_MS
from harness.line import GATEWAY_FORMAT, SerialFormat


class ErrorCounter(Enum):
    """Where the counter of faulty telegrams starts after a valid one."""

    RESTART = "restart"
    CONTINUE = "continue"


class ErrorCode(Enum):
    """The status code while faulty telegrams are received: 00 as HMS says, or still 1F."""

    HMS = "hms"
    UNCHANGED = "unchanged"


class StatusToggle(Enum):
    """When new status information toggles bit 15.

    WHEN_TAKEN: code and data are always up to date, bit 15 waits until the PLC has taken the
    previous information. ALWAYS: with every change. POST_WHEN_TAKEN: the whole word stays until
    the PLC has taken it.
    """

    WHEN_TAKEN = "when_taken"
    ALWAYS = "always"
    POST_WHEN_TAKEN = "post_when_taken"


class OfflineOutputs(Enum):
    """What goes on towards the drives while PROFIBUS is down.

    NO_SCANNING: nothing at all, as the manual says (section 7). FREEZE: the heartbeat goes on with
    the last outputs. CLEAR: so it does, and the outputs count as zeros.
    """

    NO_SCANNING = "no_scanning"
    FREEZE = "freeze"
    CLEAR = "clear"


class OfflineInputs(Enum):
    """What the reply bytes show after the offline timeout of the sub-network."""

    FREEZE = "freeze"
    CLEAR = "clear"


class StartupLock(Enum):
    """Whether telegrams wait until the PLC says Data Valid (control bit 13) for the first time."""

    NONE = "none"
    DATA_VALID = "data_valid"


class SubnetErrorLed(Enum):
    """Which lamp turns red for "stopped, subnet error or timeout".

    The manual prints it at the device status; on HMS devices it is at the subnet status, so the
    rows of the printed table may have slipped.
    """

    DEVICE_STATUS = "device_status"
    SUBNET_STATUS = "subnet_status"


@dataclass(frozen=True, slots=True)
class CyclicLayout:
    """Where things lie in the cyclic data; offsets in bytes from 0.

    `telegram` holds the pieces (first, behind last) of the outputs that make up INV-NO, CMD, ComNo
    and DATA. In the inputs the status word is followed by these six bytes.
    """

    name: str
    configuration: bytes
    output_length: int
    input_length: int
    control_offset: int
    trigger_offset: int
    telegram: tuple[tuple[int, int], ...]

    def telegram_of(self, outputs: bytes) -> bytes:
        """INV-NO, CMD, ComNo and DATA out of the outputs."""
        return b"".join([outputs[start:end] for start, end in self.telegram])


@dataclass(frozen=True, slots=True)
class TosSettings:
    """One TOSPBDP001. Times in nanoseconds; 0 switches off what may be off.

    `startup_ns` is how long the device initialises after power-on; no document tells it.
    `heartbeat` is the whole frame.
    """

    layout: CyclicLayout
    ident_number: int = 0x1803
    user_parameter_bytes: int = 0
    serial_format: SerialFormat = GATEWAY_FORMAT
    processing_ns: int = 5 * NS_PER_MS
    trigger_poll_ns: int = 0
    trigger_power_on: int = 0x00
    heartbeat: bytes = b"(**P08800001)\r"
    heartbeat_ns: int = 500 * NS_PER_MS
    power_on_status: int = 0x9F00
    startup_ns: int = 0
    error_counter: ErrorCounter = ErrorCounter.RESTART
    error_code: ErrorCode = ErrorCode.HMS
    status_toggle: StatusToggle = StatusToggle.WHEN_TAKEN
    offline_timeout_ns: int = 0
    offline_inputs: OfflineInputs = OfflineInputs.FREEZE
    offline_outputs: OfflineOutputs = OfflineOutputs.NO_SCANNING
    startup_lock: StartupLock = StartupLock.NONE
    subnet_error_led: SubnetErrorLed = SubnetErrorLed.DEVICE_STATUS
