"""The function blocks that come with the controller, by name; bistables, edges and counters.

Sources: IEC 61131-3 third edition, tables 43 (bistables), 44 (edges) and 45 (counters); TIA Portal
help for the edges at start-up.
"""

from collections.abc import Callable, Sequence
from functools import partial
from typing import ClassVar

from fbgen.lang.checked import AnyBlock, StandardBlock, VariableKind
from fbgen.lang.types import Elementary
from harness.engine.reference.behaviour import Behaviour, Call
from harness.engine.reference.storage import InstanceStorage, Storage
from harness.engine.reference.timers import Timer


class SetDominant(Behaviour):
    """SR: set wins."""

    __slots__ = ()

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """S1, R to Q1."""
        outputs[0].write(_flag(inputs[0]) or (_flag(outputs[0]) and not _flag(inputs[1])))


class ResetDominant(Behaviour):
    """RS: reset wins."""

    __slots__ = ()

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """S, R1 to Q1."""
        outputs[0].write(not _flag(inputs[1]) and (_flag(inputs[0]) or _flag(outputs[0])))


class Edge(Behaviour):
    """R_TRIG and F_TRIG: Q is TRUE for the call at which CLK changes to `level`.

    Before the first call CLK counts as `previous`. R_TRIG: FALSE, so that CLK = TRUE at the first
    call is an edge. F_TRIG: TRUE by the standard (its memory M is the inverted CLK and starts
    FALSE), so that CLK = FALSE at the first call is an edge; FALSE on S7, where it is none.
    """

    __slots__ = ("level", "previous")
    remembered: ClassVar[tuple[str, ...]] = ("previous",)

    def __init__(self, level: bool, previous: bool) -> None:
        self.level = level
        self.previous = previous

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """CLK to Q."""
        clock = _flag(inputs[0])
        outputs[0].write(clock == self.level and clock != self.previous)
        self.previous = clock


class CountUp(Behaviour):
    """CTU: counts rising edges of CU up to the end of the type; reset wins."""

    __slots__ = ("previous",)
    remembered: ClassVar[tuple[str, ...]] = ("previous",)

    def __init__(self) -> None:
        self.previous = False

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """CU, R, PV to Q, CV."""
        up, reset, preset = inputs
        at_end, count = outputs
        rises = _flag(up) and not self.previous
        self.previous = _flag(up)
        if _flag(reset):
            count.write(0)
        elif rises:
            _count_up(count)
        at_end.write(_number(count) >= _number(preset))


class CountDown(Behaviour):
    """CTD: counts rising edges of CD down to the end of the type; load wins."""

    __slots__ = ("previous",)
    remembered: ClassVar[tuple[str, ...]] = ("previous",)

    def __init__(self) -> None:
        self.previous = False

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """CD, LD, PV to Q, CV."""
        down, load, preset = inputs
        at_end, count = outputs
        rises = _flag(down) and not self.previous
        self.previous = _flag(down)
        if _flag(load):
            count.write(preset.read())
        elif rises:
            _count_down(count)
        at_end.write(_number(count) <= 0)


class CountUpDown(Behaviour):
    """CTUD: reset before load before counting; both edges at once change nothing."""

    __slots__ = ("previous_down", "previous_up")
    remembered: ClassVar[tuple[str, ...]] = ("previous_down", "previous_up")

    def __init__(self) -> None:
        self.previous_up = False
        self.previous_down = False

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """CU, CD, R, LD, PV to QU, QD, CV."""
        up, down, reset, load, preset = inputs
        at_top, at_bottom, count = outputs
        goes_up = _flag(up) and not self.previous_up
        goes_down = _flag(down) and not self.previous_down
        self.previous_up, self.previous_down = _flag(up), _flag(down)
        if _flag(reset):
            count.write(0)
        elif _flag(load):
            count.write(preset.read())
        elif goes_up and not goes_down:
            _count_up(count)
        elif goes_down and not goes_up:
            _count_down(count)
        at_top.write(_number(count) >= _number(preset))
        at_bottom.write(_number(count) <= 0)


def run_standard_block(instance: InstanceStorage, block: StandardBlock, now_ns: int) -> None:
    """One call of an instance whose inputs have been set, as `block` (IEC_TIMER can be several)."""
    assert instance.standard is not None
    inputs, outputs = _parameters(instance, block)
    instance.standard.run(inputs, outputs, Call(_family(block.name), now_ns))


def _parameters(instance: InstanceStorage, block: AnyBlock) -> tuple[list[Storage], list[Storage]]:
    parts = [
        (variable.kind, instance.parts[variable.name.casefold()]) for variable in block.variables
    ]
    inputs = [part for kind, part in parts if kind is VariableKind.INPUT]
    return inputs, [part for kind, part in parts if kind is VariableKind.OUTPUT]


def update_timer(instance: InstanceStorage, now_ns: int) -> None:
    """Bring Q and ET of a running timer up to date, where reading them does that."""
    timer = instance.standard
    if isinstance(timer, Timer) and timer.today and timer.began_ns is not None:
        inputs, outputs = _parameters(instance, instance.block)
        timer.run(inputs, outputs, Call(timer.called_as, now_ns))


def new_behaviour(name: str, dialect: str, *, classic: bool) -> Behaviour:
    """The behaviour of a standard block by its canonical name, such as `CTU` or `CTU_DINT`."""
    on_s7 = dialect in ("tia", "step7")
    timer = partial(Timer, today=dialect == "tia" and not classic)
    behaviours: dict[str, Callable[[], Behaviour]] = {
        "SR": SetDominant,
        "RS": ResetDominant,
        "R_TRIG": lambda: Edge(level=True, previous=False),
        "F_TRIG": lambda: Edge(level=False, previous=not on_s7),
        "CTU": CountUp,
        "CTD": CountDown,
        "CTUD": CountUpDown,
        "TON": timer,
        "TOF": timer,
        "TP": timer,
        "TONR": timer,
        "IEC": timer,
    }
    return behaviours[_family(name)]()


def _family(name: str) -> str:
    """The name without the type behind it."""
    return name if name in ("R_TRIG", "F_TRIG") else name.partition("_")[0]


def _flag(storage: Storage) -> bool:
    value = storage.read()
    assert isinstance(value, bool)
    return value


def _number(storage: Storage) -> int:
    value = storage.read()
    assert isinstance(value, int)
    return value


def _count_up(count: Storage) -> None:
    assert isinstance(count.kind, Elementary)
    count.write(min(_number(count) + 1, count.kind.maximum))


def _count_down(count: Storage) -> None:
    assert isinstance(count.kind, Elementary)
    count.write(max(_number(count) - 1, count.kind.minimum))
