"""Faults of telegrams have no meaning for drives that get none."""

from fbgen.diagnostics import error
from harness.installation.field_level import FieldLevel


def require_telegrams(plant: FieldLevel, drive: str, what: str) -> None:
    """Raises DiagnosticError FB7522 for a drive on DeviceNet."""
    if not plant.gets_telegrams(drive):
        raise error(
            "FB7522",
            f"'{drive}' is on DeviceNet, where {what}",
            None,
            "use devicenet_bus_off, devicenet_interrupted, devicenet_mac_doubled, drive_unpowered, "
            "or drive_disconnected in both directions",
        )
