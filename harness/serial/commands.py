"""The commands of the control socket: a line of text in, plain data out.

docs/reference/control.md has the whole list. Places are names of drives, or their INV-NO.
"""

import shlex
from collections.abc import Callable, Mapping
from dataclasses import replace
from math import isfinite
from types import MappingProxyType

from fbgen.catalog.comno_names import named_comno
from fbgen.diagnostics import DiagnosticError, error
from fbgen.nearest import nearest
from harness.drives import Inverter
from harness.faults import FIELD_FAULTS
from harness.serial.drive_states import drive_states
from harness.serial.drives import ServedDrives
from harness.serial.fault_switches import FaultSwitches, Setting, drive_name

Answer = dict[str, object]
_SWITCH = {"on": True, "off": False}
_FRAMES = 10


class Commands:
    """Carries commands out. `wants_end` is True when somebody has asked for the end."""

    def __init__(self, served: ServedDrives, faults: FaultSwitches) -> None:
        self._served = served
        self._faults = faults
        self.wants_end = False
        self._known: Mapping[str, tuple[str, Callable[[list[str]], Answer]]] = MappingProxyType(
            {
                "help": ("", self._help),
                "state": ("[DRIVE]", self._state),
                "frames": ("[N]", self._frames),
                "faults": ("", self._list_faults),
                "fault": ("NAME [PLACE] on|off [SETTING=VALUE ...]", self._fault),
                "trip": ("DRIVE DISPLAY", self._trip),
                "reset": ("DRIVE", self._reset),
                "power": ("DRIVE on|off", self._power),
                "get": ("DRIVE COMNO", self._get),
                "set": ("DRIVE COMNO=VALUE ...", self._set),
                "load": ("DRIVE PERCENT", self._load),
                "quit": ("", self._quit),
            }
        )

    def answer(self, line: str) -> Answer:
        """The answer to a command; `ok` says whether it was carried out, `errors` why not."""
        try:
            return {"ok": True} | self._carry_out(line)
        except DiagnosticError as wrong:
            return {"ok": False, "errors": [item.as_json() for item in wrong.diagnostics]}

    def _carry_out(self, line: str) -> Answer:
        try:
            words = shlex.split(line)
        except ValueError:
            raise error("FB9037", "a quote is not closed", None, "close it") from None
        name, arguments = (words[0], words[1:]) if words else ("", [])
        if name not in self._known:
            raise error("FB9037", f"there is no command '{name}'", None, nearest(name, self._known))
        return self._known[name][1](arguments)

    def _wrong(self, name: str) -> DiagnosticError:
        return error(
            "FB9037",
            f"this is not how '{name}' is written",
            None,
            f"write: {name} {self._known[name][0]}".rstrip(),
        )

    def _drive(self, place: str) -> Inverter:
        return self._served.drives[drive_name(self._served, place)]

    def _help(self, arguments: list[str]) -> Answer:
        return {"commands": {name: usage for name, (usage, _) in self._known.items()}}

    def _state(self, arguments: list[str]) -> Answer:
        states = drive_states(self._served)
        if arguments:
            wanted = drive_name(self._served, arguments[0])
            states = [item for item in states if item.name == wanted]
        log, bridge = self._served.log, self._served.bridge
        return {
            "time_s": round(self._served.kernel.now_ns / 1e9, 6),
            "drives": [item._asdict() for item in states],
            "line": {
                "requests": log.requests,
                "replies": log.replies,
                "unknown": log.unknown,
                "bytes_received": bridge.received,
                "bytes_sent": bridge.sent,
            },
        }

    def _frames(self, arguments: list[str]) -> Answer:
        text = arguments[0] if arguments else str(_FRAMES)
        if not text.isdecimal() or len(arguments) > 1:
            raise self._wrong("frames")
        kept = list(self._served.log.frames)[-int(text) :] if int(text) else []
        return {
            "frames": [
                {
                    "time_s": round(frame.time_ns / 1e9, 6),
                    "direction": frame.direction,
                    "bytes": frame.data.hex(" ").upper(),
                    "drive": frame.drive,
                }
                for frame in kept
            ]
        }

    def _list_faults(self, arguments: list[str]) -> Answer:
        return {
            "on": [{"fault": name, "place": place} for name, place in self._faults.on],
            "known": {name: kind.title for name, kind in FIELD_FAULTS.items()},
        }

    def _fault(self, arguments: list[str]) -> Answer:
        at = next((index for index, word in enumerate(arguments) if word in _SWITCH), 0)
        if at not in (1, 2):
            raise self._wrong("fault")
        name, place = arguments[0], arguments[1] if at == 2 else ""
        settings = dict(self._setting(word) for word in arguments[at + 1 :])
        self._faults.switch(name, place, _SWITCH[arguments[at]], settings)
        return {"on": [{"fault": kind, "place": where} for kind, where in self._faults.on]}

    def _setting(self, word: str) -> tuple[str, Setting]:
        name, equals, text = word.partition("=")
        if not equals:
            raise self._wrong("fault")
        if text in ("true", "false"):
            return name, text == "true"
        for kind in (int, float):
            try:
                return name, kind(text)
            except ValueError:
                continue
        return name, text

    def _trip(self, arguments: list[str]) -> Answer:
        if len(arguments) != 2:
            raise self._wrong("trip")
        self._drive(arguments[0]).trip(arguments[1])
        return self._state(arguments[:1])

    def _reset(self, arguments: list[str]) -> Answer:
        if len(arguments) > 1:
            raise self._wrong("reset")
        place = arguments[0] if arguments else ""
        self._drive(place).reset()
        return self._state(arguments)

    def _power(self, arguments: list[str]) -> Answer:
        if not arguments or arguments[-1] not in _SWITCH or len(arguments) > 2:
            raise self._wrong("power")
        place = arguments[0] if len(arguments) == 2 else ""
        drive = self._drive(place)
        if _SWITCH[arguments[-1]]:
            drive.power_on()
        else:
            drive.power_off()
        return self._state(arguments[:-1])

    def _get(self, arguments: list[str]) -> Answer:
        if len(arguments) != 2:
            raise self._wrong("get")
        drive = self._drive(arguments[0])
        comno = named_comno(drive.series, arguments[1])
        word = drive.read_word(comno.number)
        return {
            "com_no": comno.hex,
            "name": comno.name,
            "word": f"{word:04X}",
            "value": comno.to_value(word),
            "unit": comno.unit,
        }

    def _set(self, arguments: list[str]) -> Answer:
        pairs = [word.partition("=") for word in arguments[1:]]
        if not pairs:
            raise self._wrong("set")
        drive = self._drive(arguments[0])
        for key, _, text in pairs:
            comno = named_comno(drive.series, key)
            drive.set_parameter(comno.number, self._number("set", text))
        return {}

    def _load(self, arguments: list[str]) -> Answer:
        if len(arguments) != 2:
            raise self._wrong("load")
        drive = self._drive(arguments[0])
        drive.load = replace(drive.load, torque_percent=self._number("load", arguments[1]))
        return self._state(arguments[:1])

    def _number(self, command: str, text: str) -> float:
        try:
            number = float(text)
        except ValueError:
            raise self._wrong(command) from None
        if not isfinite(number):
            raise self._wrong(command)
        return number

    def _quit(self, arguments: list[str]) -> Answer:
        self.wants_end = True
        return {}
