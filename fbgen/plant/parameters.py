"""What the parameter block of the PLC holds when it is written for the first time.

From then on the block belongs to the user, and its values count. Dialects whose text is one file
(iec, plcopen) have no block of their own for it: there the values are taken from the plant file
each time.
"""

from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog import Located
from fbgen.catalog.scalars import Flag, Real, Whole


class DriveParameters(Located):
    """First values of a drive's parameters.

    `min_frequency_hz`: a lower set-point is raised to it. `at_setpoint_hz`: how far the frequency
    may be off while the drive counts as at set-point. `error_pause_ms`: after a command without
    acknowledgement, before the same one is tried again. `local_inhibits`: a drive that obeys its
    panel or terminals is not told to run. `interlock_inhibits`: where the interlock was missing, a
    new run is needed.
    """

    min_frequency_hz: Annotated[Real, Field(ge=0, le=655.35)] = 0
    at_setpoint_hz: Annotated[Real, Field(gt=0, le=655.35)] = 0.5
    error_pause_ms: Annotated[Whole, Field(ge=0, le=3_600_000)] = 1000
    local_inhibits: Flag = True
    interlock_inhibits: Flag = True


class DeviceNetDriveParameters(Located):
    """First values of a drive's parameters on DeviceNet.

    `min_frequency_hz`: a lower set-point is raised to it. `at_setpoint_hz`: how far the frequency
    may be off while the drive counts as at set-point. `local_inhibits`: a drive that obeys its
    panel or terminals is not told to run. `interlock_inhibits`: where the interlock was missing, a
    new run is needed. `speed_unit`: what the program gives its set-points in, `hz` or `rpm` (1/min
    of the motor).
    """

    min_frequency_hz: Annotated[Real, Field(ge=0, le=655.35)] = 0
    at_setpoint_hz: Annotated[Real, Field(gt=0, le=655.35)] = 0.5
    local_inhibits: Flag = True
    interlock_inhibits: Flag = True
    speed_unit: Literal["hz", "rpm"] = "hz"


class LineParameters(Located):
    """First values of a line's parameters.

    `timeout_ms`: limit for one attempt of a telegram; without it what the times of gateway and
    drives add up to. `retries`: attempts after the first one.
    """

    timeout_ms: Annotated[Whole, Field(ge=1, le=60_000)] | None = None
    retries: Annotated[Whole, Field(ge=0, le=10)] = 2
