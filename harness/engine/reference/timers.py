"""TON, TOF, TP and TONR on the controller's clock.

ET counts whole ticks of its type, milliseconds for TIME. A negative PT counts as zero. A timing
that has ended stays so whatever PT says. What is called as another timer than before starts anew.

On S7-1200/1500 (`tia`, but not on an S7-300/400) PT counts as it is at the start of the timing, and
Q and ET are brought up to date by each call and each time the program reads them (TIA Portal help,
"IEC timers"): `t(IN := NOT t.Q, ...)` resets the timer before anybody has seen Q. Elsewhere each
call looks at PT anew (IEC 61131-3 leaves it open; SFB3 to SFB5 inferred), and only a call changes Q
and ET.

Sources: IEC 61131-3 third edition, table 46 and figure 15 (timing diagrams); TIA Portal help for
TONR, RESET_TIMER and PRESET_TIMER.
"""

from collections.abc import Mapping, Sequence
from typing import ClassVar

from fbgen.lang.types import Elementary
from harness.engine.interface import Value
from harness.engine.reference.behaviour import Behaviour, Call
from harness.engine.reference.storage import InstanceStorage, Storage

_NS_PER_TICK = {32: 1_000_000, 64: 1}


class Timer(Behaviour):
    """One timing. `began_ns` is None while nothing is timed; all times are nanoseconds.

    `collected_ns` is what TONR had collected before the present timing began, `called_as` the name
    of the last call. `today` says that it is one of an S7-1200/1500.
    """

    __slots__ = (
        *("began_ns", "called_as", "collected_ns", "ended", "preset_ns", "previous"),
        "today",
    )
    remembered: ClassVar[tuple[str, ...]] = (
        *("began_ns", "called_as", "collected_ns", "ended", "preset_ns", "previous"),
    )

    def __init__(self, today: bool) -> None:
        self.today = today
        self.called_as = ""
        self.previous = False
        self.began_ns: int | None = None
        self.collected_ns = 0
        self.ended = False
        self.preset_ns = 0

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """One call: IN, PT to Q, ET; for TONR also R."""
        signal, preset = inputs[0].read(), inputs[-1].read()
        kind = outputs[1].kind
        assert isinstance(signal, bool)
        assert isinstance(preset, int)
        assert isinstance(kind, Elementary)
        tick_ns = _NS_PER_TICK[kind.bits]
        given_ns = max(preset, 0) * tick_ns
        if self.called_as not in ("", call.name):
            self.restore(Timer(self.today).snapshot())
        if not self.today and not self.ended:
            self.preset_ns = given_ns
        self.called_as = call.name
        match call.name:
            case "TON":
                is_on, elapsed_ns = self._on_delay(signal, given_ns, call.now_ns)
            case "TOF":
                is_on, elapsed_ns = self._off_delay(signal, given_ns, call.now_ns)
            case "TP":
                is_on, elapsed_ns = self._pulse(signal, given_ns, call.now_ns)
            case _:
                resets = inputs[1].read() is True
                is_on, elapsed_ns = self._collect(signal, resets, given_ns, call.now_ns)
        self.previous = signal
        outputs[0].write(is_on)
        outputs[1].write(elapsed_ns // tick_ns)

    def _on_delay(self, signal: bool, given_ns: int, now_ns: int) -> tuple[bool, int]:
        """TON: TRUE from the call on at which ET reaches PT; with PT = 0 at once."""
        if not signal:
            self._stop()
            return False, 0
        if self.began_ns is None:
            self._begin(given_ns, now_ns)
        return self._is_over(now_ns), self._elapsed_ns(now_ns)

    def _off_delay(self, signal: bool, given_ns: int, now_ns: int) -> tuple[bool, int]:
        """TOF: on with IN, off when IN has been FALSE for PT. ET stays at PT when it is over.

        Before IN was ever TRUE nothing is timed and Q is FALSE.
        """
        if signal:
            self._stop()
            return True, 0
        if self.previous:
            self._begin(given_ns, now_ns)
        if self.began_ns is None:
            return False, 0
        return not self._is_over(now_ns), self._elapsed_ns(now_ns)

    def _pulse(self, signal: bool, given_ns: int, now_ns: int) -> tuple[bool, int]:
        """TP: a rising edge of IN makes Q TRUE for PT, whatever IN does meanwhile.

        ET stays at PT until IN is FALSE. An edge at the call that finds the end starts anew.
        """
        rises = signal and not self.previous
        if self.began_ns is not None and self._is_over(now_ns) and (rises or not signal):
            self._stop()
        if self.began_ns is None and rises:
            self._begin(given_ns, now_ns)
        if self.began_ns is None:
            return False, 0
        return not self._is_over(now_ns), self._elapsed_ns(now_ns)

    def _collect(self, signal: bool, resets: bool, given_ns: int, now_ns: int) -> tuple[bool, int]:
        """TONR: adds up the time that IN is TRUE; Q stays until R. R wins."""
        if resets:
            self._stop()
            return False, 0
        if signal and self.began_ns is None:
            self.began_ns = now_ns
            if not self.ended:
                self.preset_ns = given_ns
        if self.began_ns is None:
            return self.ended, self.collected_ns
        is_on, elapsed_ns = self._is_over(now_ns), self._elapsed_ns(now_ns)
        if not signal:
            self.began_ns, self.collected_ns = None, elapsed_ns
        return is_on, elapsed_ns

    def _begin(self, given_ns: int, now_ns: int) -> None:
        self.began_ns = now_ns
        self.collected_ns = 0
        self.ended = False
        self.preset_ns = given_ns

    def _stop(self) -> None:
        self.began_ns = None
        self.collected_ns = 0
        self.ended = False

    def _elapsed_ns(self, now_ns: int) -> int:
        """How long it has been timing, at most PT."""
        assert self.began_ns is not None
        if self.ended:
            return self.preset_ns
        return min(self.collected_ns + now_ns - self.began_ns, self.preset_ns)

    def _is_over(self, now_ns: int) -> bool:
        """True once PT has passed."""
        self.ended = self.ended or self._elapsed_ns(now_ns) >= self.preset_ns
        return self.ended


def control_timer(instance: InstanceStorage, inputs: Mapping[str, Value]) -> None:
    """PRESET_TIMER: another PT, also for what is being timed; RESET_TIMER: everything is zero."""
    timer = instance.standard
    assert isinstance(timer, Timer)
    preset = inputs.get("PT")
    if preset is None:
        timer.restore(Timer(timer.today).snapshot())
        for part in instance.parts.values():
            part.write(False if isinstance(part.read(), bool) else 0)
        return
    assert isinstance(preset, int)
    kind = instance.parts["pt"].kind
    assert isinstance(kind, Elementary)
    instance.parts["pt"].write(preset)
    timer.preset_ns = max(preset, 0) * _NS_PER_TICK[kind.bits]
