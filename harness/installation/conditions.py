"""Conditions of a drive that have no effect where it stands."""

from collections.abc import Iterator

from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant
from fbgen.source import Span
from harness.installation.setup import DriveConditions


def without_effect(
    plan: Plant, drive: str, conditions: DriveConditions, places: dict[str, Span | None]
) -> Iterator[Diagnostic]:
    """FB7503 for each; `places` has where `port` and `reply_time` of the drive are written."""
    on_devicenet = {item.name for item in plan.devicenet_drives}
    on_lines = {item.name: line for line in plan.serial for item in line.drives}
    if drive in on_devicenet:
        advice = "leave it out: a DeviceNet option is inside of the drive, and no line goes to it"
        if conditions.port is not None:
            message = f"'{drive}' is on DeviceNet, where no port is at a line"
            yield Diagnostic("FB7503", message, places.get("port"), advice)
        if conditions.reply_time_ns is not None:
            message = f"'{drive}' is on DeviceNet, where it answers no telegrams"
            yield Diagnostic("FB7503", message, places.get("reply_time"), advice)
    elif drive in on_lines and conditions.port is not None:
        line = on_lines[drive]
        yield Diagnostic(
            "FB7503",
            f"'{drive}' is on the serial line '{line.name}', whose wires say which port is at it",
            places.get("port"),
            f"leave it out, or change wires: of the line, which has {line.wires}",
        )
