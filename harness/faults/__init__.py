"""Faults that a scenario can inject, one file each; each file ends with its `FAULT`.

Those of drives and of lines need no PLC: `FIELD_FAULTS` happen to any drives on a line.
"""

from fbgen.named_modules import NamedModules
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.installation import Installation
from harness.installation.field_level import FieldLevel

__all__ = ["FAULTS", "FIELD_FAULTS", "Fault", "FaultSettings", "FaultType", "Target"]

_OF_THE_FIELD = (
    "drive_alarm",
    "drive_answers_for_another",
    "drive_answers_late",
    "drive_disconnected",
    "drive_eeprom_worn",
    "drive_emergency_stop",
    "drive_local",
    "drive_number_doubled",
    "drive_parameters_locked",
    "drive_slow",
    "drive_tripped",
    "drive_unpowered",
    "line_babbling",
    "line_broken",
    "line_broken_one_way",
    "line_bytes_delayed",
    "line_bytes_doubled",
    "line_bytes_lost",
    "line_noise",
)
_NAMES = (
    "cpu_jitter",
    "cpu_overrun",
    "cpu_retentive_lost",
    "cpu_stopped",
    "cpu_unpowered",
    "devicenet_bus_off",
    "devicenet_interrupted",
    "devicenet_mac_doubled",
    "devicenet_scanner_idle",
    "devicenet_wrong_assembly",
    *_OF_THE_FIELD,
    "gateway_buffer_overwritten",
    "gateway_diagnosis",
    "gateway_reports",
    "gateway_slow",
    "gateway_trigger_stuck",
    "gateway_unpowered",
    "master_stopped",
    "module_failed",
    "profibus_clear",
    "profibus_freeze_held",
    "profibus_interrupted",
    "profibus_jitter",
    "profibus_plug_pulled",
    "profibus_sync_held",
    "profibus_watchdog_expired",
    "profibus_wrong_configuration",
    "transfers_refused",
    "transfers_torn",
)

FAULTS: NamedModules[FaultType[Installation]] = NamedModules("harness.faults", "FAULT", _NAMES)
"""By the name that scenarios use, which is that of the module."""

FIELD_FAULTS: NamedModules[FaultType[FieldLevel]] = NamedModules(
    "harness.faults", "FAULT", _OF_THE_FIELD
)
"""Those of drives and lines."""
