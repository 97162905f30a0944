"""How served inverters are shown: a live table on a terminal, plain lines elsewhere."""

import sys
from collections.abc import Callable
from time import monotonic
from typing import TYPE_CHECKING

from fbgen.cli.frames.frame_lines import FrameLines, frame_bytes
from fbgen.cli.output import say
from fbgen.cli.ports.drive_keys import KEYS, DriveKeys

if TYPE_CHECKING:
    from rich.console import RenderableType

    from harness.serial import DriveState, FaultSwitches, HeardFrame, ServedDrives

_SHOWN_EVERY_S = 0.25
_QUIET_S = 0.03
"""Drawing takes some milliseconds: it waits for a while in which nothing is due."""
_SHORT_S = 0.002
"""To look at thirty drives takes less."""
_PATIENCE_S = 1.0
_FRAMES = 6


class LineDisplay:
    """One line each time a drive does something else; with `frames` one for each frame, too."""

    def __init__(
        self,
        served: "ServedDrives",
        states: "Callable[[], list[DriveState]]",
        lines: FrameLines,
        *,
        frames: bool,
    ) -> None:
        self._served = served
        self._states = states
        self._lines = lines
        self._known: dict[str, str] = {}
        if frames:
            served.log.told.append(self._frame)

    def look(self, idle_s: float) -> None:
        """Tell what has changed, unless something is just about to happen."""
        if idle_s < _SHORT_S:
            return
        for state in self._states():
            text = _doing(state)
            if self._known.get(state.name) != text:
                self._known[state.name] = text
                say(f"{self._time()}  {state.name} (INV-NO {state.inv_no}) {text}")

    def end(self) -> None:
        """Nothing is left to do."""

    def _frame(self, frame: "HeardFrame") -> None:
        text = self._lines.line(frame.direction, frame.data)
        say(f"{self._time(frame.time_ns)}  {frame_bytes(frame.data)}  {text}")

    def _time(self, time_ns: int | None = None) -> str:
        now_ns = self._served.kernel.now_ns if time_ns is None else time_ns
        return f"{now_ns / 1e9:9.3f} s"


class TableDisplay:
    """A table that is drawn anew four times a second, with the last frames and the keys."""

    def __init__(
        self,
        served: "ServedDrives",
        states: "Callable[[], list[DriveState]]",
        lines: FrameLines,
        faults: "FaultSwitches",
        keys: DriveKeys,
    ) -> None:
        from rich.console import Console
        from rich.live import Live

        self._served = served
        self._states = states
        self._lines = lines
        self._faults = faults
        self._keys = keys
        self._said: list[str] = []
        self._shown_s = 0.0
        served.log.told.append(self._frame)
        self._live: Live = Live(
            console=Console(file=sys.stderr), auto_refresh=False, transient=True
        )
        self._live.start()

    def look(self, idle_s: float) -> None:
        """Draw anew if it is time to and nothing is about to happen."""
        waited_s = monotonic() - self._shown_s
        if waited_s > _PATIENCE_S or (waited_s > _SHOWN_EVERY_S and idle_s > _QUIET_S):
            self._live.update(self._content(), refresh=True)
            self._shown_s = monotonic()

    def end(self) -> None:
        """Take the table away."""
        self._live.stop()

    def _frame(self, frame: "HeardFrame") -> None:
        arrow = {"request": ">", "reply": "<"}.get(frame.direction, "?")
        text = self._lines.line(frame.direction, frame.data)
        self._said.append(f"{frame.time_ns / 1e9:9.3f} s {arrow} {frame_bytes(frame.data)}  {text}")
        del self._said[:-_FRAMES]

    def _content(self) -> "RenderableType":
        from rich.console import Group
        from rich.table import Table
        from rich.text import Text

        table = Table()
        for heading in ("", "drive", "series", "INV-NO", "state", "Hz", "set-point", "A %", "trip"):
            table.add_column(heading, no_wrap=True)
        table.add_column("replies", justify="right")
        for state in self._states():
            mark = "*" if state.name == self._keys.chosen else ""
            table.add_row(
                *(mark, state.name, state.series, str(state.inv_no), _moving(state)),
                *(f"{state.frequency_hz:.2f}", f"{state.set_point_hz:.2f}"),
                *(f"{state.current_percent:.1f}", state.trip, str(state.replies)),
            )
        log = self._served.log
        counts = f"{log.requests} requests, {log.replies} replies, {log.unknown} unknown frames"
        faults = ", ".join(f"{name} on {place}" for name, place in self._faults.on)
        below = [*self._said, counts, f"faults: {faults or 'none'}", KEYS, self._keys.told]
        return Group(table, Text("\n".join(below), no_wrap=True, overflow="ellipsis"))


def _doing(state: "DriveState") -> str:
    if state.state in ("off", "tripped"):
        return f"{state.state} {state.trip}".rstrip()
    source = "network" if state.network_command else "panel or terminals"
    return f"{_moving(state)}, set-point {state.set_point_hz:.2f} Hz, commanded by {source}"


def _moving(state: "DriveState") -> str:
    return f"{state.state} {state.direction}" if state.state == "running" else state.state
