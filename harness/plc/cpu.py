"""The simulated CPU: scan by scan, with process image, direct access and operating modes.

A scan takes time. At its start the inputs are copied into the process image; then the program runs
on values that do not change; the outputs are copied to the DP master when the execution time is
over, or when the last of its accesses to hardware is through if that is later.

STOP is CLEAR for the DP master. What an S7 does at a restart: initial values in the data blocks,
but for remanent ones after a warm restart; an empty process image; then OB100 (or OB102, if there
is one, after a cold restart), then OB1. A cyclic interrupt or an error block interrupts what runs.
"""

from collections.abc import Callable
from enum import Enum
from functools import partial

from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.lang.checked import Program
from harness.engine.interface import Engine, EngineFactory, Limits
from harness.engine.organization import (
    ACCESS_ERROR,
    PROGRAMMING_ERROR,
    TIME_ERROR,
    CyclicInterrupt,
    cyclic_interrupts,
    organization_blocks,
)
from harness.engine.tasks import CyclicTask, cyclic_tasks, startup_blocks
from harness.fieldbus import DpMaster, Station
from harness.kernel import NS_PER_MS, Event, Kernel
from harness.plc.error_events import (
    ASYNCHRONOUS_PRIORITY,
    PROGRAMMING_FAULTS,
    ErrorEvent,
    ImageErrors,
    diagnosis_event,
    image_events,
    programming_event,
    station_event,
)
from harness.plc.hardware_access import HardwareAccess, missing_ob
from harness.plc.interrupts import Interrupts
from harness.plc.io_module import IoModule
from harness.plc.settings import CpuSettings


class CpuMode(Enum):
    """The operating mode."""

    STOP = "stop"
    STARTUP = "startup"
    RUN = "run"


class Restart(Enum):
    """WARM keeps what is remanent, COLD forgets everything."""

    WARM = "warm"
    COLD = "cold"


class Cpu(HardwareAccess):
    """One CPU with its DP master.

    `diagnostics` says why it went to STOP, `programming_errors` what OB121 has kept it from
    stopping for. `scans` counts the scans since the last start. The functions in `after_scan` are
    called when the program of a scan is through, those in `on_mode` when the mode has changed.
    """

    __slots__ = (
        "_depth",
        "_engine",
        "_failed",
        "_free_ns",
        "_image_errors",
        "_image_failed",
        "_interrupts",
        "_life",
        "_obs",
        "_postponed",
        "_priority",
        "_reporting",
        "_restart",
        "_scan_event",
        "_started_ns",
        "_synchronous",
        "_tasks",
        "after_scan",
        "diagnostics",
        "master",
        "mode",
        "on_mode",
        "programming_errors",
        "scans",
    )

    def __init__(self, kernel: Kernel, settings: CpuSettings, master: DpMaster) -> None:
        super().__init__(kernel, settings, master)
        self._engine: Engine | None = None
        self._tasks: list[CyclicTask] = []
        self._obs: dict[int, str] = {}
        self._interrupts = Interrupts(kernel, (), self._run_interrupt, self._lose)
        self._failed: set[str] = set()
        self._reporting: set[str] = set()
        self._image_failed: set[IoModule] = set()
        self._image_errors = settings.image_errors or settings.family.image_errors
        self._synchronous: set[int] = set()
        self._priority = 1
        self._restart = Restart.WARM
        self._scan_event: Event | None = None
        self._depth = 0
        self._postponed: list[Callable[[], None]] = []
        self._life = self._started_ns = self._free_ns = 0
        self.master = master
        self.mode = CpuMode.STOP
        self.scans = 0
        self.diagnostics: list[Diagnostic] = []
        self.programming_errors: list[Diagnostic] = []
        self.after_scan: list[Callable[[], None]] = []
        self.on_mode: list[Callable[[CpuMode], None]] = []
        master.observers.append(self._station_changed)

    # --- building ---------------------------------------------------------------------------

    def load(self, program: Program, factory: EngineFactory, limits: Limits | None = None) -> None:
        """Load a program; the CPU goes to STOP.

        Raises DiagnosticError FB7404, FB7410, FB7411 as `cyclic_tasks`.
        """
        self.stop()
        obs = self.settings.obs
        self._tasks = cyclic_tasks(program, obs)
        self._obs = organization_blocks(program, obs)
        self._interrupts = Interrupts(
            self._kernel, cyclic_interrupts(program, obs), self._run_interrupt, self._lose
        )
        self._engine = factory(program, self, limits or Limits())

    @property
    def engine(self) -> Engine:
        """The loaded program. Raises DiagnosticError FB7405 if there is none."""
        if self._engine is None:
            raise error("FB7405", "the CPU has no program", None, "load a program first")
        return self._engine

    def _data_block(self, number: int) -> bytearray | None:
        return None if self._engine is None else self._engine.data_block(number)

    # --- operating modes --------------------------------------------------------------------

    def start(self, restart: Restart = Restart.WARM) -> None:
        """To RUN, through a restart, as soon as every station exchanges data or has failed.

        The scans begin whole cycle times after this instant, whatever the phase of the bus.

        Raises DiagnosticError FB7405 without a program.
        """
        engine = self.engine
        self.stop()
        self.diagnostics.clear()
        self.programming_errors.clear()
        self.scans = 0
        self.slave_diagnosis.forget()
        self.inputs[:] = bytes(len(self.inputs))
        keep = self.settings.remanent_marker_bytes if restart is Restart.WARM else 0
        self.markers[keep:] = bytes(len(self.markers) - keep)
        self._begin()
        self._supply(there=True)
        for module in self.serial_ports:
            module.cpu_started()
        self._restart = restart
        engine.reset(warm=restart is Restart.WARM)
        self.master.start()
        self._set_mode(CpuMode.STARTUP)
        self._started_ns = self._kernel.now_ns
        self._go_on_when_free()

    def stop(self) -> None:
        """To STOP: the program rests, the outputs are off, the master sends CLEAR."""
        if self.mode is CpuMode.STOP:
            return
        self._life += 1
        self._interrupts.end()
        if self._scan_event is not None:
            self._kernel.cancel(self._scan_event)
            self._scan_event = None
        self.outputs[:] = bytes(len(self.outputs))
        for station in self.master.stations:
            station.write(0, bytes(len(station.outputs)))
        for module in self.serial_ports:
            module.cpu_stopped()
        self.master.clear()
        self._set_mode(CpuMode.STOP)

    def at_checkpoint(self, action: Callable[[], None]) -> None:
        """Do something that no program may be interrupted for: now, or when what runs is through.

        An S7 takes a request for STOP at its cycle checkpoint.
        """
        if self._depth:
            self._postponed.append(action)
        else:
            action()

    def power_off(self) -> None:
        """No supply: the master falls silent, too, and so do the modules of the PLC itself."""
        self.stop()
        self.master.stop()
        self._supply(there=False)

    def power_on(self) -> None:
        """Supply comes, and the switch is at STOP: the master sends zeros."""
        self.stop()
        self._supply(there=True)
        self.master.start()
        self.master.clear()

    def lose_retentive(self) -> None:
        """Forget everything that outlives a warm restart, as an empty battery does.

        For a CPU in STOP. Raises DiagnosticError FB7405 without a program.
        """
        self._begin()
        self.markers[:] = bytes(len(self.markers))
        self.engine.reset(warm=False)

    def _set_mode(self, mode: CpuMode) -> None:
        self.mode = mode
        for observer in self.on_mode:
            observer(mode)

    def _go_on_when_free(self) -> None:
        """Look whether all is ready on the CPU's own grid, which no bus cycle shifts."""
        cycle_ns = self.settings.cycle_ns
        cycles = -((self._started_ns - self._kernel.now_ns) // cycle_ns)
        self._kernel.at(self._started_ns + cycles * cycle_ns, self._go_on)

    def _go_on(self) -> None:
        """From STARTUP to RUN once all stations are where they will be."""
        if self.mode is not CpuMode.STARTUP or not all(
            station.failed or station.transfers for station in self.master.stations
        ):
            return
        self.master.operate()
        self._set_mode(CpuMode.RUN)
        self._begin()
        self._failed = {one.settings.name for one in self.master.stations if one.failed}
        self._reporting = {one.settings.name for one in self.master.stations if one.reporting}
        self._image_failed.clear()
        self._synchronous.clear()
        self._priority = 1
        warm = self._restart is Restart.WARM
        for name in startup_blocks(self.engine.program, self.settings.obs, warm=warm):
            if not self._run((name,)):
                return
        for task in self._tasks:
            task.due_ns, task.was_true = self._instant_ns, False
        self._interrupts.begin()
        self._schedule(self._instant_ns)

    def _run(self, blocks: tuple[str, ...], start: bytes = b"") -> bool:
        """Run blocks one after the other; False if that took the CPU to STOP."""
        life, engine = self._life, self._engine
        assert engine is not None, "only a loaded program is started"
        self._depth += 1
        for block in blocks:
            try:
                engine.run_block(block, start)
            except DiagnosticError as failure:
                if not self._programming_error(failure):
                    self._crash(failure)
            if life != self._life:
                break
        self._depth -= 1
        while self._postponed and not self._depth:
            self._postponed.pop(0)()
        return life == self._life

    def _run_interrupt(self, block: str, start: bytes = b"") -> None:
        """Run a block now, in the middle of whatever runs, which goes on when it is through."""
        life, pending = self._life, self._scan_event
        if pending is not None:
            self._kernel.cancel(pending)  # no scan begins meanwhile
        now_ns, instant_ns = self.now_ns, self._instant_ns
        self._begin()
        self._run((block,), start)
        self._instant_ns += instant_ns - self.now_ns
        self.now_ns = now_ns
        if life != self._life:
            return
        waits_since_ns = now_ns
        if pending is not None:
            waits_since_ns = min(task.due_ns for task in self._tasks)
            self._schedule(max(self._free_ns, self._kernel.now_ns))
        took_ns = self._kernel.now_ns - waits_since_ns
        if took_ns > self.settings.watchdog_ns:
            self._crash(_too_slow(self._tasks[0].name, took_ns, self.settings.watchdog_ns))
        self._quiet_until_ns = 0

    def _lose(self, interrupt: CyclicInterrupt) -> None:
        """An interrupt is due again before it has run."""
        self._time_error(
            missing_ob(TIME_ERROR, f"'{interrupt.block}' is due again before it has run")
            if self.settings.family.classic
            else None
        )

    def _time_error(self, failure: DiagnosticError | None) -> bool:
        """Run OB80 if there is one; otherwise the failure, if any, takes the CPU to STOP."""
        if TIME_ERROR in self._obs:
            self._run_interrupt(self._obs[TIME_ERROR])
        elif failure is not None:
            self._crash(failure)
        return self.mode is CpuMode.RUN

    # --- error events -----------------------------------------------------------------------

    def _access_error(self, event: ErrorEvent) -> int:
        """OB122, or STOP on an S7-300/400 without it; 0 is read."""
        if self.settings.family.classic and ACCESS_ERROR not in self._obs:
            self.access_errors += 1
            raise missing_ob(ACCESS_ERROR, event.what)
        self._synchronous_error(event)
        return super()._access_error(event)

    def _programming_error(self, failure: DiagnosticError) -> bool:
        """OB121 of an S7-300/400; False if the fault of the program takes the CPU to STOP.

        The block that has the error ends there: no engine can go on behind it.
        """
        codes = [found.code for found in failure.diagnostics]
        if (
            not self.settings.family.classic
            or PROGRAMMING_ERROR not in self._obs
            or PROGRAMMING_ERROR in self._synchronous
            or any(code not in PROGRAMMING_FAULTS for code in codes)
        ):
            return False
        self.programming_errors += failure.diagnostics
        self._synchronous_error(programming_event(codes[0]))
        return True

    def _synchronous_error(self, event: ErrorEvent) -> None:
        """Run OB121 or OB122 in the priority class of what runs, not inside of itself."""
        if event.number in self._obs and event.number not in self._synchronous:
            self._synchronous.add(event.number)
            priority = max(self._priority, self._interrupts.priority_class)
            self._run_interrupt(self._obs[event.number], self._start_of(event, priority))
            self._synchronous.discard(event.number)

    def _asynchronous_error(self, event: ErrorEvent) -> bool:
        """Run OB82, OB85 or OB86; an S7-300/400 without it goes to STOP, and False is given."""
        if event.number not in self._obs:
            if self.settings.family.classic:
                self._crash(missing_ob(event.number, event.what))
            return self.mode is CpuMode.RUN
        before, self._priority = self._priority, ASYNCHRONOUS_PRIORITY
        self._run_interrupt(self._obs[event.number], self._start_of(event, ASYNCHRONOUS_PRIORITY))
        self._priority = before
        return self.mode is CpuMode.RUN

    def _start_of(self, event: ErrorEvent, priority: int) -> bytes:
        """The start information, which only the blocks of an S7-300/400 have in this form."""
        if not self.settings.family.classic:
            return b""
        return event.start(priority, self.services.calendar_ns + self._kernel.now_ns)

    def _crash(self, failure: DiagnosticError) -> None:
        self.diagnostics += failure.diagnostics
        self.stop()

    def _station_changed(self, station: Station) -> None:
        if self.mode is CpuMode.STARTUP:
            self._go_on_when_free()
        elif self.mode is CpuMode.RUN:
            self._station_failed_or_came(station)

    def _station_failed_or_came(self, station: Station) -> None:
        """OB86 when a station fails and when it is back, OB82 when its diagnosis comes and goes."""
        name, address = station.settings.name, station.settings.address
        if station.failed != (name in self._failed):
            self._failed ^= {name}
            if not self._asynchronous_error(station_event(name, address, failed=station.failed)):
                return
        if station.reporting != (name in self._reporting):
            self._reporting ^= {name}
            first = station.slots[0]
            self._asynchronous_error(diagnosis_event(name, first, reported=station.reporting))

    def _image_updated(self, station: IoModule, *, reading: bool) -> bool:
        """OB85 for a station in the process image that fails, or is well again.

        False if that took the CPU to STOP.
        """
        errors = self._image_errors
        if not self.settings.family.classic or errors is ImageErrors.NONE:
            return True
        if errors is ImageErrors.CHANGES:
            if station.failed == (station in self._image_failed):
                return True
            if not reading:
                self._image_failed ^= {station}
        elif not station.failed:
            return True
        return all(
            self._asynchronous_error(event)
            for slot in station.slots
            for event in image_events(slot, reading=reading, errors=errors, bad=station.failed)
        )

    # --- the scan ---------------------------------------------------------------------------

    def _schedule(self, free_ns: int) -> None:
        """Arrange for the next scan, not before the CPU is free."""
        self._free_ns = free_ns
        tasks = self._tasks
        due_ns = tasks[0].due_ns
        if len(tasks) > 1:
            due_ns = min(task.due_ns for task in tasks)
        self._scan_event = self._kernel.at(due_ns if due_ns > free_ns else free_ns, self._scan)

    def _scan(self) -> None:
        self._scan_event = None
        self._begin()
        start_ns = self.now_ns
        settings, image = self.settings, self._image
        task = self._tasks[0]  # they stand in the order of their priorities
        if task.due_ns > start_ns:
            task = next(other for other in self._tasks if other.due_ns <= start_ns)
        if image and not self._read_inputs():
            return
        if task.single and not task.is_wanted(self.engine):
            task.ran(start_ns, settings.cycle_ns)
            self._schedule(start_ns)
            return
        if not self._run(task.blocks):
            return
        end_ns = start_ns + settings.execution_ns
        if settings.execution_jitter_ns:
            end_ns += self._kernel.random.randrange(settings.execution_jitter_ns + 1)
        if self._instant_ns > end_ns:
            end_ns = self._instant_ns
        if end_ns - start_ns > settings.watchdog_ns and not self._time_error(
            _too_slow(task.name, end_ns - start_ns, settings.watchdog_ns)
        ):
            return
        self.scans += 1
        for observer in self.after_scan:
            observer()
        if image and self._has_outputs():
            self._kernel.at(end_ns, partial(self._write_outputs, self._life))
        task.ran(start_ns, settings.cycle_ns)
        self._schedule(end_ns)

    def _read_inputs(self) -> bool:
        """The process image of the inputs; False if that took the CPU to STOP."""
        for station in self._image:
            at, length = station.settings.input_address, len(station.inputs)
            self.inputs[at : at + length] = self.link.read(station, 0, length)
            if (station.failed or self._image_failed) and not self._image_updated(
                station, reading=True
            ):
                return False
        return True

    def _has_outputs(self) -> bool:
        """True if the process image holds outputs that the master does not have yet."""
        for station in self._image:
            at = station.settings.output_address
            if self.outputs[at : at + len(station.outputs)] != station.outputs:
                return True
            if station.failed or self._image_failed:
                return True
        return False

    def _write_outputs(self, life: int) -> None:
        if life != self._life:
            return
        for station in self._modules.image:
            at = station.settings.output_address
            self.link.write(station, 0, bytes(self.outputs[at : at + len(station.outputs)]))
            if (station.failed or self._image_failed) and not self._image_updated(
                station, reading=False
            ):
                return


def _too_slow(task: str, took_ns: int, allowed_ns: int) -> DiagnosticError:
    return error(
        "FB7409",
        f"a scan of {task} took {took_ns / NS_PER_MS:g} ms, "
        f"the cycle watchdog allows {allowed_ns / NS_PER_MS:g} ms",
        None,
        "let the program do less in one scan, or allow a longer cycle monitoring time",
    )
