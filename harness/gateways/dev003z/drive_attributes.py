"""Attributes of the inverter's side: Motor Data, Control Supervisor, AC/DC Drive.

Currents are in 100 mA of the rated current that Motor Data holds, torque in Nm of the rated torque
that an option of the catalogue gives, times as those of the inverter are, in ms / 2^TimeScale.
"""

from collections.abc import Callable, Mapping

from fbgen.catalog.devicenet_objects import Attribute, ObjectClass
from fbgen.wire.devicenet import Status
from fbgen.wire.toshiba import ErrorCode
from harness.gateways.dev003z.assemblies import FREQUENCY_COMMAND, OUTPUT_FREQUENCY
from harness.gateways.dev003z.commands import MAXIMUM_FREQUENCY
from harness.gateways.dev003z.parts import Parts

_ALARM, _CURRENT, _TORQUE, _POWER = 0xFC91, 0xFD03, 0xFD18, 0xFD30
_HOURS = 0xFE14
_ACCELERATION, _DECELERATION = 0x0009, 0x0010
_UPPER, _LOWER = 0x0012, 0x0013
_WHOLE = 10_000
"""100.00 % as monitors show it."""
_TENTH_MS = 100
_TEN_WATT = 10

Getter = Callable[[], int]
Setter = Callable[[int], Status | None]

REFUSALS: Mapping[ErrorCode, Status] = {
    ErrorCode.DATA: Status.INVALID_ATTRIBUTE_VALUE,
    ErrorCode.COM_NO: Status.OBJECT_DOES_NOT_EXIST,
    ErrorCode.CANNOT_EXECUTE: Status.DEVICE_STATE_CONFLICT,
}
"""Why the inverter refuses -> general status code."""


def refusal(error: ErrorCode | None) -> Status | None:
    """Why a cell could not be written, as a general status code."""
    if error is None:
        return None
    return REFUSALS.get(error, Status.DEVICE_STATE_CONFLICT)


class DriveAttributes:
    """The attributes by class and name. Those without a meaning here keep what they are set to."""

    __slots__ = (
        "_cells",
        "_commands",
        "_getters",
        "_host",
        "_kept",
        "_rated_torque",
        "_setters",
        "_speeds",
        "_supervisor",
    )

    def __init__(self, parts: Parts, rated_torque: int) -> None:
        self._host = parts.host
        self._cells = parts.cells
        self._commands = parts.commands
        self._supervisor = parts.supervisor
        self._speeds = parts.speeds
        self._rated_torque = rated_torque
        self._kept = {
            (known.name, item.name): item.default
            for known in parts.gateway.objects
            for item in known.attributes
            if item.default is not None
        }
        self._getters: Mapping[tuple[str, str], Getter] = {
            **{("control_supervisor", name): get for name, get in self._of_supervisor().items()},
            **{("ac_dc_drive", name): get for name, get in self._of_drive().items()},
            ("motor_data", "pole_count"): lambda: self._speeds.poles,
        }
        self._setters: Mapping[tuple[str, str], Setter] = {
            **{("control_supervisor", name): put for name, put in self._to_supervisor().items()},
            **{("ac_dc_drive", name): put for name, put in self._to_drive().items()},
        }

    def knows(self, known: ObjectClass, name: str) -> bool:
        """Whether it has a value of an attribute other than what that begins with."""
        counted = name in ("number_of_attributes", "attribute_list")
        return counted or (known.name, name) in self._getters

    def get(self, known: ObjectClass, attribute: Attribute) -> int | bytes:
        """The value now."""
        if attribute.name == "number_of_attributes":
            return len(known.attributes)
        if attribute.name == "attribute_list":
            return bytes(item.id for item in known.attributes)
        getter = self._getters.get((known.name, attribute.name))
        return self._kept[known.name, attribute.name] if getter is None else getter()

    def set(self, known: ObjectClass, attribute: Attribute, value: int) -> Status | None:
        """Set it; why it is refused, or None."""
        setter = self._setters.get((known.name, attribute.name))
        if setter is None:
            self._kept[known.name, attribute.name] = value
            return None
        return setter(value)

    def status(self) -> Mapping[str, int]:
        """The bits of instances 70, 71 and 151 by their names."""
        supervisor = self._supervisor
        return {
            "faulted": int(self._host.tripped),
            "warning": int(self._read(_ALARM) != 0),
            "running_forward": int(supervisor.running_1),
            "running_reverse": int(supervisor.running_2),
            "ready": int(supervisor.ready),
            "control_from_net": int(self._host.network_command),
            "reference_from_net": int(self._host.network_frequency),
            "at_reference": self._at_reference(),
            "drive_status": int(supervisor.state),
        }

    # Reading

    def _of_supervisor(self) -> Mapping[str, Getter]:
        commands, supervisor, host = self._commands, self._supervisor, self._host
        return {
            "run_1": lambda: int(commands.runs[0]),
            "run_2": lambda: int(commands.runs[1]),
            "net_control": lambda: int(commands.net_control),
            "state": lambda: int(supervisor.state),
            "running_1": lambda: int(supervisor.running_1),
            "running_2": lambda: int(supervisor.running_2),
            "ready": lambda: int(supervisor.ready),
            "faulted": lambda: int(host.tripped),
            "warning": lambda: int(self._read(_ALARM) != 0),
            "fault_reset": lambda: int(commands.fault_reset),
            "control_from_net": lambda: int(host.network_command),
        }

    def _of_drive(self) -> Mapping[str, Getter]:
        commands, host, speeds = self._commands, self._host, self._speeds
        return {
            "at_reference": self._at_reference,
            "net_reference": lambda: int(commands.net_reference),
            "speed_actual": lambda: speeds.per_minute(self._read(OUTPUT_FREQUENCY)),
            "speed_reference": lambda: commands.speed,
            "current_actual": lambda: round(
                self._read(_CURRENT) * self._kept["motor_data", "rated_current"] / _WHOLE
            ),
            "torque_actual": lambda: round(self._read(_TORQUE) * self._rated_torque / _WHOLE),
            "power_actual": lambda: min(0x7FFF, self._read(_POWER) * _TEN_WATT),
            "acceleration_time": lambda: self._ramp(_ACCELERATION),
            "deceleration_time": lambda: self._ramp(_DECELERATION),
            "low_speed_limit": lambda: speeds.per_minute(self._read(_LOWER)),
            "high_speed_limit": lambda: speeds.per_minute(self._read(_UPPER)),
            "reference_from_net": lambda: int(host.network_frequency),
            "drive_on_hours": lambda: self._read(_HOURS),
        }

    def _at_reference(self) -> int:
        running = self._host.running
        return int(running and self._read(OUTPUT_FREQUENCY) == self._read(FREQUENCY_COMMAND))

    def _ramp(self, number: int) -> int:
        """From 0 to the high speed limit; the inverter's own times go to its maximum frequency."""
        maximum = self._read(MAXIMUM_FREQUENCY)
        part = self._read(_UPPER) / maximum if maximum else 1.0
        return min(0xFFFF, round(self._read(number) * _TENTH_MS * part * self._per_ms))

    @property
    def _per_ms(self) -> float:
        """How many units of the times a millisecond has."""
        return 2.0 ** self._kept["ac_dc_drive", "time_scale"]

    # Writing

    def _to_supervisor(self) -> Mapping[str, Setter]:
        return {
            "run_1": lambda value: self._run((bool(value), self._commands.runs[1])),
            "run_2": lambda value: self._run((self._commands.runs[0], bool(value))),
            "net_control": lambda value: self._link(control=bool(value)),
            "fault_reset": self._reset,
        }

    def _to_drive(self) -> Mapping[str, Setter]:
        return {
            "net_reference": lambda value: self._link(reference=bool(value)),
            "speed_reference": self._speed,
            "acceleration_time": lambda value: self._set_ramp(_ACCELERATION, value),
            "deceleration_time": lambda value: self._set_ramp(_DECELERATION, value),
            "low_speed_limit": lambda value: self._set_limit(_LOWER, value),
            "high_speed_limit": lambda value: self._set_limit(_UPPER, value),
        }

    def _run(self, runs: tuple[bool, bool]) -> None:
        self._commands.set_runs(*runs, self._supervisor.state)

    def _link(self, control: bool | None = None, reference: bool | None = None) -> None:
        commands = self._commands
        commands.set_links(
            control=commands.net_control if control is None else control,
            reference=commands.net_reference if reference is None else reference,
        )

    def _reset(self, value: int) -> None:
        self._commands.set_fault_reset(bool(value))

    def _speed(self, value: int) -> None:
        self._commands.set_speed(value)

    def _set_ramp(self, number: int, value: int) -> Status | None:
        upper = self._read(_UPPER)
        part = self._read(MAXIMUM_FREQUENCY) / upper if upper else 1.0
        tenths = round(value / self._per_ms * part / _TENTH_MS)
        return refusal(self._cells.write(number, min(0xFFFF, tenths)))

    def _set_limit(self, number: int, value: int) -> Status | None:
        return refusal(self._cells.write(number, self._speeds.hundredths_of_hz(value)))

    def _read(self, number: int) -> int:
        return self._cells.read(number) or 0
