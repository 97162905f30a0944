"""The PROFIBUS DP master class 1 beside the CPU: its cycle, its modes, its slaves.

The cycle runs on its own grid, not on the CPU's scan, so the phase between them is real. A slave is
polled in a simulated cycle only if something is new on either side. In CLEAR a slave whose GSD says
Fail_Safe = 0 gets telegrams full of zeros and the command Clear_Data (TOSPBDP001 GSD file; the
zeros are recalled). A stopped master sends nothing at all.
"""

from collections.abc import Callable
from enum import Enum

from fbgen.diagnostics import error
from fbgen.wire.dp import ControlCommand
from harness.fieldbus.cycle import CycleGrid, CycleTimes
from harness.fieldbus.slave import DpSlave
from harness.fieldbus.station import Station, StationSettings, Transfer
from harness.kernel import Event, Kernel

_BEFORE_ALL_ELSE = -1
"""The bus cycle of an instant comes before what else happens at that instant."""


class MasterMode(Enum):
    """What the master sends: nothing, zeros, or the outputs."""

    STOP = "stop"
    CLEAR = "clear"
    OPERATE = "operate"


class DpMaster:
    """A master with its slaves. It begins in STOP; once started it is in CLEAR until `operate`.

    `clearing` is True if every slave gets zeros, `cut` while the bus is cut (set `connected`), and
    `halted` while the master itself has stopped, whatever the CPU asks it for.
    Functions in `taps` get every simulated transfer. Functions in `observers` are called when a
    station has failed, was refused, or exchanges data again, those in `on_mode` when the mode may
    have changed.
    """

    __slots__ = (
        "_clear_due",
        "_clear_forced",
        "_clear_wanted",
        "_event",
        "_grid",
        "_kernel",
        "_queue",
        "_running",
        "address",
        "clearing",
        "cut",
        "halted",
        "observers",
        "on_mode",
        "stations",
        "taps",
    )

    def __init__(self, kernel: Kernel, times: CycleTimes | None = None, address: int = 1) -> None:
        self._kernel = kernel
        self._grid = CycleGrid(times or CycleTimes(), kernel.random)
        self._queue: list[Station] = []
        self._event: Event | None = None
        self._running = False
        self._clear_due = self._clear_wanted = True
        self._clear_forced = False
        self.clearing = True
        self.cut = self.halted = False
        self.address = address
        self.stations: list[Station] = []
        self.taps: list[Callable[[Transfer], None]] = []
        self.observers: list[Callable[[Station], None]] = []
        self.on_mode: list[Callable[[], None]] = []

    # --- building ---------------------------------------------------------------------------

    def add(self, settings: StationSettings, slave: DpSlave) -> Station:
        """Enter a slave into the configuration.

        Raises DiagnosticError FB7204 for an address that another station has.
        """
        for other in self.stations:
            if other.settings.address == settings.address:
                raise error(
                    "FB7204",
                    f"the stations '{other.settings.name}' and '{settings.name}' both have "
                    f"PROFIBUS address {settings.address}",
                    None,
                    "give every slave an address of its own",
                )
        station = Station(self, settings, slave)
        self.stations.append(station)
        self.request(station)
        return station

    def set_times(self, times: CycleTimes) -> None:
        """Other times of the cycle. The master must be stopped: the grid begins anew."""
        assert not self._running, "a running master keeps its grid"
        if self._event is not None:
            self._kernel.cancel(self._event)
            self._event = None
            self._on_grid()
        self._grid = CycleGrid(times, self._kernel.random)

    # --- modes ------------------------------------------------------------------------------

    @property
    def mode(self) -> MasterMode:
        """What the master sends now."""
        if not self._running or self.halted:
            return MasterMode.STOP
        return MasterMode.CLEAR if self.clearing else MasterMode.OPERATE

    def start(self) -> None:
        """Begin to poll: parameters and configuration first, then zeros or the outputs."""
        if not self._running:
            self._running = True
            if self.halted:
                self._fail_all()
            else:
                self._begin()
            self._mode_changed()

    def operate(self) -> None:
        """Send the outputs of the CPU, from the next cycle on; while stopped, once started."""
        self._clear_wanted = False
        if not self._clear_forced:
            self.clearing = self._clear_due = False
            self._request_all()
            self._mode_changed()

    def clear(self) -> None:
        """Send zeros instead of the outputs and Clear_Data, from the next cycle on."""
        self._clear_wanted = True
        self.clearing = self._clear_due = True
        self._request_all()
        self._mode_changed()

    def stop(self) -> None:
        """Send nothing any more; the slaves are left to their watchdogs."""
        if self._running:
            self._running = False
            if not self.halted:
                self._end_polling()
            self._mode_changed()

    # --- faults of the master ---------------------------------------------------------------

    @property
    def clear_forced(self) -> bool:
        """True while the master stays in CLEAR although the CPU is in RUN."""
        return self._clear_forced

    @clear_forced.setter
    def clear_forced(self, forced: bool) -> None:
        self._clear_forced = forced
        if forced and not self.clearing:
            self.clearing = self._clear_due = True
            self._request_all()
            self._mode_changed()
        elif not forced and not self._clear_wanted:
            self.operate()

    def halt(self) -> None:
        """The master stops by itself: silence, and no station can be reached by the CPU."""
        self.halted = True
        if self._running:
            self._end_polling()
            self._fail_all()
        self._mode_changed()

    def resume(self) -> None:
        """The master goes on as the CPU wants it, with all slaves from the beginning."""
        self.halted = False
        if self._running:
            self._begin()
        self._mode_changed()

    @property
    def times(self) -> CycleTimes:
        """Period, phase and jitter of the cycle as they are."""
        return self._grid.times

    @property
    def jitter_ns(self) -> int:
        """The largest delay of a cycle; it may change at any time."""
        return self._grid.times.jitter_ns

    @jitter_ns.setter
    def jitter_ns(self, jitter_ns: int) -> None:
        self._grid.jitter(jitter_ns)

    def _mode_changed(self) -> None:
        for observer in self.on_mode:
            observer()

    # --- the bus ----------------------------------------------------------------------------

    @property
    def connected(self) -> bool:
        """False while the bus is cut right behind the master, so that no slave is reached."""
        return not self.cut

    @connected.setter
    def connected(self, connected: bool) -> None:
        if connected is not self.cut:
            return
        self.cut = not connected
        if not connected:
            self._end_polling()
        self._request_all()

    def global_control(self, command: ControlCommand, groups: int = 0) -> None:
        """Send Global_Control now; `groups` 00 means all slaves."""
        if not self._running or self.halted:
            return
        for station in self.stations:
            if station.reached:
                station.slave.global_control(command, groups)

    # --- the cycle --------------------------------------------------------------------------

    def request(self, station: Station) -> None:
        """Poll this station in the next cycle: something is new."""
        if station.queued or not self._running or self.halted:
            return
        station.queued = True
        self._queue.append(station)
        if self._event is None:
            due_ns = self._grid.after(self._kernel.now_ns)
            self._event = self._kernel.at(due_ns, self._on_grid, _BEFORE_ALL_ELSE)

    def cycle(self) -> None:
        """One cycle right now, beside the grid: how a transfer to the CPU gets torn."""
        if self._event is not None:
            self._kernel.cancel(self._event)
        self._on_grid()

    @property
    def now_ns(self) -> int:
        """The instant of the cycle that runs."""
        return self._kernel.now_ns

    def last_cycle_ns(self) -> int:
        """The instant of the latest cycle of the grid."""
        return self._grid.up_to(self._kernel.now_ns)

    def next_cycle_ns(self, time_ns: int) -> int:
        """The first instant of the grid that is later than `time_ns`."""
        return self._grid.after(time_ns)

    def report(self, station: Station) -> None:
        """The station has failed, was refused, or exchanges data again."""
        for observer in self.observers:
            observer(station)

    def _on_grid(self) -> None:
        self._event = None
        polled, self._queue = self._queue, []
        for station in polled:
            station.queued = False
        if not self._running or self.halted:
            return
        if self._clear_due:
            self._clear_due = False
            self.global_control(ControlCommand.CLEAR_DATA)
        for station in polled:
            station.poll()

    def _begin(self) -> None:
        for station in self.stations:
            station.restart()
        self._request_all()

    def _end_polling(self) -> None:
        last_ns = self.last_cycle_ns()
        for station in self.stations:
            station.slave.polling_ended(last_ns)

    def _fail_all(self) -> None:
        for station in self.stations:
            station.fail()

    def _request_all(self) -> None:
        for station in self.stations:
            self.request(station)
