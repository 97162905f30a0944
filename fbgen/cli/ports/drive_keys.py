"""What the keys do while inverters are served: choose a drive, switch faults, trip, reset, end."""

from collections.abc import Callable
from typing import TYPE_CHECKING

from fbgen.diagnostics import DiagnosticError

if TYPE_CHECKING:
    from harness.serial import FaultSwitches, ServedDrives

LINE_FAULTS = {"n": "line_noise", "x": "line_broken", "b": "line_babbling", "m": "line_bytes_lost"}
DRIVE_FAULTS = {
    "d": "drive_disconnected",
    "l": "drive_answers_late",
    "s": "drive_slow",
    "o": "drive_local",
    "p": "drive_unpowered",
    "e": "drive_emergency_stop",
    "w": "drive_number_doubled",
}
KEYS = (
    "1-9 or + - choose a drive   t trip OC1   r reset   q end\n"
    "d disconnected  l late  s slow  o local  p no supply  e emergency stop  w number doubled\n"
    "of the line: n noise  m bytes lost  b babbling  x broken"
)


class DriveKeys:
    """Carries keys out for the drive that is chosen. `told` is what the last one did."""

    def __init__(self, served: "ServedDrives", faults: "FaultSwitches") -> None:
        self._served = served
        self._faults = faults
        self._names = tuple(served.drives)
        self._at = 0
        self.told = ""
        self.wants_end = False
        self._do: dict[str, Callable[[], str]] = {
            "t": self._trip,
            "r": self._reset,
            "+": lambda: self._choose(self._at + 1),
            "-": lambda: self._choose(self._at - 1),
        }

    @property
    def chosen(self) -> str:
        """The drive that keys are for."""
        return self._names[self._at]

    def press(self, keys: str) -> None:
        """Carry out some keys; others mean nothing."""
        for key in keys:
            try:
                self._press(key)
            except DiagnosticError as wrong:
                self.told = wrong.diagnostics[0].message

    def _press(self, key: str) -> None:
        if key == "q":
            self.wants_end = True
        elif key in self._do:
            self.told = self._do[key]()
        elif key in LINE_FAULTS:
            self._toggle(LINE_FAULTS[key], "line")
        elif key in DRIVE_FAULTS:
            self._toggle(DRIVE_FAULTS[key], self.chosen)
        elif key in "123456789" and int(key) <= len(self._names):
            self.told = self._choose(int(key) - 1)

    def _toggle(self, fault: str, place: str) -> None:
        is_on = self._faults.toggle(fault, place)
        self.told = f"{fault} on {place}: {'on' if is_on else 'off'}"

    def _choose(self, index: int) -> str:
        self._at = index % len(self._names)
        return f"{self.chosen} is chosen"

    def _trip(self) -> str:
        self._served.drives[self.chosen].trip("OC1")
        return f"{self.chosen} trips with OC1"

    def _reset(self) -> str:
        self._served.drives[self.chosen].reset()
        return f"{self.chosen} is reset at its panel"
