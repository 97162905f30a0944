"""Faults that a person switches on and off while inverters are served."""

from collections.abc import Mapping

from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.faults import FIELD_FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.installation.field_level import FieldLevel
from harness.serial.drives import LINE

Setting = bool | int | float | str


class FaultSwitches:
    """Which faults there are now, by their kind and place."""

    def __init__(self, field: FieldLevel) -> None:
        self._field = field
        self._faults: dict[tuple[str, str], Fault] = {}

    @property
    def on(self) -> tuple[tuple[str, str], ...]:
        """Kind and place of each, in the order in which they came."""
        return tuple(self._faults)

    def switch(self, name: str, place: str, is_on: bool, settings: Mapping[str, Setting]) -> None:
        """Begin or end a fault; what is so already stays so, but for settings that are given.

        Raises DiagnosticError FB9037 for a fault or place that is not there, FB8004 for settings,
        and what the fault does not allow.
        """
        key = name, self.place_of(name, place)
        if not is_on:
            if key in self._faults:
                self._faults.pop(key).clear()
            return
        if key in self._faults and not settings:
            return
        kind = FIELD_FAULTS[name]
        fault = kind.make(self._field, key[1], fault_settings(kind, settings, {}))
        if key in self._faults:
            self._faults.pop(key).clear()
        self._faults[key] = fault
        fault.inject()

    def toggle(self, name: str, place: str) -> bool:
        """On if it is off, off if it is on; what it is now. As `switch`."""
        is_on = (name, self.place_of(name, place)) not in self._faults
        self.switch(name, place, is_on, {})
        return is_on

    def place_of(self, name: str, place: str) -> str:
        """The place of a fault: a drive by its name or INV-NO, or the line.

        Raises DiagnosticError FB9037.
        """
        if name not in FIELD_FAULTS:
            raise error("FB9037", f"there is no fault '{name}'", None, nearest(name, FIELD_FAULTS))
        if FIELD_FAULTS[name].target is not Target.DRIVE:
            if place not in ("", LINE):
                message = f"the fault '{name}' happens to the line, not to '{place}'"
                raise error("FB9037", message, None, f"write '{LINE}', or nothing")
            return LINE
        return drive_name(self._field, place)


def drive_name(field: FieldLevel, place: str) -> str:
    """The drive of a name or an INV-NO; the only one there is for nothing. FB9037."""
    if not place and len(field.drives) == 1:
        return next(iter(field.drives))
    for name, drive in field.drives.items():
        own = drive.registers.word(drive.series.link.inv_no)
        if place == name or (place.isdecimal() and int(place) == own):
            return name
    message = f"there is no drive '{place}'" if place else "it is not said which drive"
    raise error("FB9037", message, None, nearest(place, field.drives))
