"""CTU, CTD and CTUD in every width, edges, and the two latches.

Sources: IEC 61131-3 third edition, tables 43 to 45; for F_TRIG at its first call, which differs
between S7 and IEC, TIA Portal help, "F_TRIG".
"""

from fbgen.lang.types import DINT, INT, LINT, SINT, UDINT, UINT, ULINT, USINT


class UpCounter:
    """CTU: counts rising edges of CU."""

    __slots__ = ("CU", "CV", "PV", "Q", "R", "_before")
    _maximum: int

    def __init__(self) -> None:
        self.CU = self.R = self.Q = self._before = False
        self.PV = self.CV = 0

    def _run(self) -> None:
        rising = self.CU and not self._before
        self._before = self.CU
        if self.R:
            self.CV = 0
        elif rising and self._maximum > self.CV:
            self.CV += 1
        self.Q = self.CV >= self.PV


class DownCounter:
    """CTD: counts rising edges of CD down."""

    __slots__ = ("CD", "CV", "LD", "PV", "Q", "_before")
    _minimum: int

    def __init__(self) -> None:
        self.CD = self.LD = self.Q = self._before = False
        self.PV = self.CV = 0

    def _run(self) -> None:
        rising = self.CD and not self._before
        self._before = self.CD
        if self.LD:
            self.CV = self.PV
        elif rising and self._minimum < self.CV:
            self.CV -= 1
        self.Q = self.CV <= 0


class UpDownCounter:
    """CTUD: both; two edges at once change nothing."""

    __slots__ = ("CD", "CU", "CV", "LD", "PV", "QD", "QU", "R", "_before_down", "_before_up")
    _minimum: int
    _maximum: int

    def __init__(self) -> None:
        self.CU = self.CD = self.R = self.LD = self.QU = self.QD = False
        self._before_up = self._before_down = False
        self.PV = self.CV = 0

    def _run(self) -> None:
        up = self.CU and not self._before_up
        down = self.CD and not self._before_down
        self._before_up, self._before_down = self.CU, self.CD
        if self.R:
            self.CV = 0
        elif self.LD:
            self.CV = self.PV
        elif up and not down:
            if self._maximum > self.CV:
                self.CV += 1
        elif down and not up and self._minimum < self.CV:
            self.CV -= 1
        self.QU = self.CV >= self.PV
        self.QD = self.CV <= 0


class RisingEdge:
    """R_TRIG."""

    __slots__ = ("CLK", "Q", "_before")

    def __init__(self) -> None:
        self.CLK = self.Q = self._before = False

    def _run(self) -> None:
        self.Q = self.CLK and not self._before
        self._before = self.CLK


class FallingEdge:
    """F_TRIG; `_first` is what counts as the value before the first call."""

    __slots__ = ("CLK", "Q", "_before")
    _first: bool

    def __init__(self) -> None:
        self.CLK = self.Q = False
        self._before = self._first

    def _run(self) -> None:
        self.Q = self._before and not self.CLK
        self._before = self.CLK


class SetDominant:
    """SR."""

    __slots__ = ("Q1", "R", "S1")

    def __init__(self) -> None:
        self.S1 = self.R = self.Q1 = False

    def _run(self) -> None:
        self.Q1 = self.S1 or (self.Q1 and not self.R)


class ResetDominant:
    """RS."""

    __slots__ = ("Q1", "R1", "S")

    def __init__(self) -> None:
        self.S = self.R1 = self.Q1 = False

    def _run(self) -> None:
        self.Q1 = not self.R1 and (self.S or self.Q1)


def counter_classes(dialect: str) -> dict[str, type]:
    """The counters, edges and latches, by canonical name."""
    classes: dict[str, type] = {}
    for kind in (INT, SINT, DINT, LINT, USINT, UINT, UDINT, ULINT):
        suffix = "" if kind == INT else f"_{kind.name}"
        ends = {"__slots__": (), "_minimum": kind.minimum, "_maximum": kind.maximum}
        for name, base in (("CTU", UpCounter), ("CTD", DownCounter), ("CTUD", UpDownCounter)):
            classes[name + suffix] = type(name + suffix, (base,), dict(ends))
    first = dialect not in ("tia", "step7")
    classes["F_TRIG"] = type("F_TRIG", (FallingEdge,), {"__slots__": (), "_first": first})
    classes |= {"R_TRIG": RisingEdge, "SR": SetDominant, "RS": ResetDominant}
    return classes
