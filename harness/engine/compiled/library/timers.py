"""TON, TOF, TP and TONR: they follow the clock of the controller.

One class has the memory of all four, because TIA lets one IEC_TIMER be called as any of them.
On S7-1200/1500 (`today`) the preset counts as it was when the timing started, and who reads Q or ET
brings them up to date by `_now`; elsewhere the preset counts as it is in each call, and Q and ET
change in a call only. Sources: IEC 61131-3 third edition, figure 15; TIA Portal help, "IEC timers".
"""

from typing import ClassVar, Protocol

_NS_PER_MS = 1_000_000


class Clock(Protocol):
    """What timers follow."""

    @property
    def now_ns(self) -> int:
        """The instant of the running scan, in nanoseconds."""
        ...


class Timer:
    """What the timers remember.

    `_start` is the instant of the call that started the timing, `_called` the method of the call:
    the class's own (`_method`) if nothing else is said.
    """

    __slots__ = (
        *("ET", "IN", "PT", "Q", "R", "_before", "_called", "_collected", "_preset", "_start"),
    )
    _method: ClassVar[str] = ""

    def __init__(self) -> None:
        self._called = self._method
        self.IN = self.R = self.Q = self._before = False
        self.PT = self.ET = self._preset = self._collected = 0
        self._start: int | None = None


def control(timer: Timer, preset: int | None) -> None:
    """RESET_TIMER, or PRESET_TIMER with the time that is to count from now on."""
    if preset is None:
        Timer.__init__(timer)
    else:
        timer.PT = timer._preset = preset


def turn(timer: Timer, method: str) -> None:
    """The instance is called as another timer than before: it starts anew."""
    timer._called = method
    timer.Q = timer._before = False
    timer.ET = timer._preset = timer._collected = 0
    timer._start = None


METHODS = {"TON": "_ton", "TOF": "_tof", "TP": "_tp", "TONR": "_tonr"}
"""The method of each timer, by its canonical name."""


FOLLOWING = frozenset({"q", "et"})
"""What a timer shows of the time that has passed."""


def _running_timer(clock: Clock, tick: int, latched: bool) -> type[Timer]:
    """The timers of one clock with ticks of `tick` nanoseconds.

    The methods find the clock in this function's variables, because that is what Python reads
    fastest.
    """

    class RunningTimer(Timer):
        __slots__ = ()

        def _ton(self) -> None:
            if not self.IN:
                self.Q = False
                self.ET = 0
                self._start = None
            elif not self.Q:
                now = clock.now_ns
                start = self._start
                if start is None:
                    start = self._start = now
                    self._preset = self.PT
                passed = (now - start) // tick
                preset = self._preset if latched else self.PT
                if passed >= preset:
                    self.Q = True
                    self.ET = preset if preset > 0 else 0
                else:
                    self.ET = passed

        def _tof(self) -> None:
            if self.IN:
                self.Q = True
                self.ET = 0
                self._start = None
            elif self.Q:
                now = clock.now_ns
                start = self._start
                if start is None:
                    start = self._start = now
                    self._preset = self.PT
                passed = (now - start) // tick
                preset = self._preset if latched else self.PT
                if passed >= preset:
                    self.Q = False
                    self.ET = preset if preset > 0 else 0
                else:
                    self.ET = passed

        def _tp(self) -> None:
            rising = self.IN and not self._before
            self._before = self.IN
            start = self._start
            if start is not None:
                preset = self._preset if latched else self.PT
                passed = (clock.now_ns - start) // tick
                if passed < preset:
                    self.ET = passed
                    return
                self.Q = False
                self.ET = preset if preset > 0 else 0
                self._start = None
            if rising:
                self._preset = self.PT
                self.ET = 0
                if self._preset > 0:
                    self.Q = True
                    self._start = clock.now_ns
            elif not self.IN:
                self.ET = 0

        def _tonr(self) -> None:
            if self.R:
                self.Q = False
                self.ET = self._collected = 0
                self._start = None
                return
            if self.Q:
                return
            now = clock.now_ns
            start = self._start
            if start is not None:
                self._collected += now - start
            elif self.IN:
                self._preset = self.PT
            self._start = now if self.IN else None
            if start is not None or self.IN:
                preset = self._preset if latched else self.PT
                passed = self._collected // tick
                if passed >= preset:
                    self.Q = True
                    self.ET = preset if preset > 0 else 0
                else:
                    self.ET = passed

    return RunningTimer


def _now(timer: Timer) -> Timer:
    """The timer as it is at this instant."""
    if timer._start is not None:
        getattr(timer, timer._called)()
    return timer


def timer_classes(clock: Clock, *, today: bool) -> dict[str, type[Timer]]:
    """The timers of one controller, by canonical name."""
    classes: dict[str, type[Timer]] = {}
    reading = {"_now": _now} if today else {}
    for suffix, tick in (("", _NS_PER_MS), ("_LTIME", 1)):
        base = _running_timer(clock, tick, latched=today)
        for name, method in METHODS.items():
            parts = {"__slots__": (), "_method": method, **reading}
            classes[name + suffix] = type(name + suffix, (base,), parts)
    for name, like in (("IEC_TIMER", "TON"), ("IEC_LTIMER", "TON_LTIME")):
        classes[name] = type(name, (classes[like],), {"__slots__": ()})
    return classes
