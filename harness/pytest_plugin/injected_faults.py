"""Faults for tests in Python: injected and cleared by their names, as in scenario files."""

from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.faults import FAULTS, Fault, Target
from harness.faults.settings import fault_settings
from harness.installation import Installation


class InjectedFaults:
    """The faults of one plant. Mistakes raise DiagnosticError FB8004, FB8005."""

    def __init__(self, plant: Installation) -> None:
        self._plant = plant
        self._there: dict[tuple[str, str], Fault] = {}

    def inject(self, name: str, on: str = "", **settings: bool | int | float | str) -> None:
        """Begin a fault; `on` names the gateway or drive."""
        kind = FAULTS.get(name)
        if kind is None:
            raise error("FB8004", f"there is no fault '{name}'", help=nearest(name, FAULTS))
        places = kind.target.places(self._plant)
        if kind.target is not Target.WHOLE and on not in places:
            what = kind.target.value
            message = f"the fault '{name}' needs a {what}, and there is no {what} '{on}'"
            raise error("FB8004", message, help=nearest(on, places))
        if (name, on) in self._there:
            raise error("FB8005", f"the fault '{name}' is still there", help="clear it first")
        read = fault_settings(kind, settings, dict.fromkeys(settings))
        fault = kind.make(self._plant, on, read)
        fault.inject()
        self._there[name, on] = fault

    def clear(self, name: str, on: str = "") -> None:
        """End a fault."""
        fault = self._there.pop((name, on), None)
        if fault is None:
            there = ", ".join(f"{one} on {where}" if where else one for one, where in self._there)
            message = f"there is no fault '{name}' to clear"
            raise error("FB8005", message, help=f"there is: {there or 'no fault'}")
        fault.clear()
