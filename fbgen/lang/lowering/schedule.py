"""How often programs run: what TIA Portal keeps in the device configuration."""

from fbgen.dataclass import dataclass


@dataclass(frozen=True, slots=True)
class Schedule:
    """One task for all programs. `interval_ns` is its period in nanoseconds; priority 0 is first.

    The names are those of the configuration, the resource and its type, and the task.
    """

    interval_ns: int = 10_000_000
    priority: int = 0
    configuration: str = "Config0"
    resource: str = "Res0"
    resource_type: str = "PLC"
    task: str = "MainTask"
