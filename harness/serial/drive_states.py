"""What each inverter that is served does now, for a person and for another program."""

from typing import NamedTuple

from harness.drives import Inverter
from harness.serial.drives import ServedDrives


class DriveState(NamedTuple):
    """One inverter. `state` is off, tripped, running, stopping or stopped; `trip` "" without."""

    name: str
    series: str
    inv_no: int
    state: str
    direction: str
    frequency_hz: float
    set_point_hz: float
    current_percent: float
    trip: str
    network_command: bool
    network_frequency: bool
    replies: int


def drive_states(served: ServedDrives) -> list[DriveState]:
    """All inverters of a line, in their order."""
    return [
        DriveState(
            name=name,
            series=drive.series.id,
            inv_no=drive.inv_no,
            state=_state(drive),
            direction=drive.direction,
            frequency_hz=round(drive.frequency_hz, 2),
            set_point_hz=round(drive.set_point_hz, 2),
            current_percent=round(drive.current_percent, 2),
            trip=drive.trip_display,
            network_command=drive.network_command,
            network_frequency=drive.network_frequency,
            replies=served.log.answered[name],
        )
        for name, drive in served.drives.items()
    ]


def _state(drive: Inverter) -> str:
    if not drive.powered:
        return "off"
    if drive.tripped:
        return "tripped"
    if not drive.running:
        return "stopped"
    return "running" if drive.operation.mode.name == "RUN" else "stopping"
