"""A plant whose line is swept: its program, drives that number their answers, somebody who asks.

The requests go where the users of the generated blocks put theirs, into the channels of TOS_Line.
One installation serves many runs: all supplies go, the clock moves on to an instant at which bus
grid and trigger poll have their start again, and everything begins anew. What a run shows
depends on its conditions alone, not on what ran before.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import field, replace
from math import ceil
from zlib import crc32

from fbgen.blocks.line_times import line_times
from fbgen.catalog import Catalog
from fbgen.dataclass import dataclass
from fbgen.lang.types import Scalar
from fbgen.plant import Plant, with_prefix
from fbgen.source import Source
from fbgen.wire.toshiba import ASCII_START
from harness.fieldbus import CycleTimes
from harness.installation import PlantSetup, build_plant, generated_sources
from harness.kernel import NS_PER_MS, NS_PER_S
from harness.line import Transmission
from harness.plc import CpuMode, CpuSettings, Restart
from harness.rules.answers import Answer, answer_in
from harness.rules.repeats_allowed import spacers_of
from harness.sweep.answering import AnsweringDrive, AnswerValues
from harness.sweep.conditions import ACCESS_LAYOUTS, Conditions
from harness.sweep.requests import (
    BROADCAST,
    Ask,
    Die,
    EmergencyStop,
    Outcome,
    Pause,
    Request,
    Revive,
    Step,
)

Alteration = Callable[[Sequence[Source]], Sequence[Source]]
"""Changes the PLC text before it is loaded: another program in place of the generated one."""

_GRID_NS = 60 * NS_PER_MS
"""All bus periods of whole milliseconds up to 6 and the trigger poll begin together so often."""

_REPLY = ("done", "error", "status", "data")
"""What is looked at of a channel's reply."""

_LONGEST_RUN_NS = 60 * NS_PER_S
_SETTLING_NS = 300 * NS_PER_MS
"""What is still on its way when the last request has ended goes out in this time."""


@dataclass(frozen=True, slots=True)
class Frame:
    """What the gateway has sent to the drives, without start code and checksum."""

    start_ns: int
    end_ns: int
    telegram: bytes


@dataclass(slots=True)
class Observation:
    """One run: what was asked, what the PLC gave to the gateway, what went over the line.

    `silent` has, for each of `outcomes`, the drives that were silent meanwhile. `triggers` are the
    instants at which the program changed the trigger byte. `stopped` says why the CPU went to STOP;
    `finished` tells that everything was asked and has ended; `stop_edge_ns` is when the
    emergency stop came.
    """

    conditions: Conditions
    outcomes: list[Outcome] = field(default_factory=list)
    silent: list[frozenset[int]] = field(default_factory=list)
    triggers: list[int] = field(default_factory=list)
    frames: list[Frame] = field(default_factory=list)
    answers: list[Answer] = field(default_factory=list)
    stopped: str = ""
    finished: bool = False
    stop_edge_ns: int | None = None

    @property
    def stop_latency_ns(self) -> int | None:
        """From the edge of the emergency stop to the end of its broadcast on the line."""
        if self.stop_edge_ns is None:
            return None
        for frame in self.frames:
            if frame.telegram[0] == BROADCAST and frame.start_ns > self.stop_edge_ns:
                return frame.end_ns - self.stop_edge_ns
        return None


class Rig:
    """One program in one installation, ready for runs that differ in times only."""

    def __init__(
        self, plan: Plant, catalog: Catalog, base: Conditions, alteration: Alteration | None = None
    ) -> None:
        """`plan` has one gateway; access way, layout and drives come from `base`.

        `catalog` says of the drives what `base` says (`with_reply_time`).
        """
        self._base = base
        plan = plant_in(plan, base)
        sources = None if alteration is None else alteration(generated_sources(plan, catalog))
        setup = PlantSetup(sources=sources, cpu=CpuSettings(tear_probability=base.torn))
        self._plant = plant = build_plant(plan, catalog, setup)
        (entry,) = plan.gateways
        self._gateway = plant.gateways[entry.name]
        self._poll_ns = catalog.telegram_gateway(entry.type).times.trigger_poll.ns
        line = plant.lines[entry.name]
        for inverter in plant.drives.values():
            inverter.power_off()
        self._values = AnswerValues()
        self._drives = {
            item.inv_no: AnsweringDrive(
                plant.kernel, line, catalog.drives[item.series], item.inv_no, self._values
            )
            for item in entry.drives
        }
        self.inv_nos = tuple(self._drives)
        self.spacers = spacers_of(catalog.drives[entry.drives[0].series])
        line.taps.append(self._heard)
        plant.cpu.after_scan.append(self._scanned)
        instance = with_prefix(f"TOS_Gateway_{entry.name}_DB", plan.prefix)
        self._channels = f"{instance}.statChannels"
        self._line = f"{with_prefix('TOS_Plant', plan.prefix)}.{entry.name}.line"
        paths = [f"{instance}.statFrameOut.trigger", f"{self._line}.online"]
        for channel in range(len(entry.drives) + 1):
            paths += [f"{self._channels}[{channel}].reply.{name}" for name in _REPLY]
        self._read = plant.cpu.engine.reader(paths)
        self.times = line_times(plan, entry, catalog)
        self._trigger = 0
        self._seen = Observation(base)
        self._steps: Iterator[Step] = iter(())
        self._open: list[Outcome] = []
        self._unwaited: list[Outcome] = []
        self._silent: set[int] = set()
        self._idle_until_ns = 0
        self._over = True

    def suits(self, conditions: Conditions) -> bool:
        """Whether these conditions differ from the rig's in times only."""
        base = self._base
        return (conditions.program, conditions.torn) == (base.program, base.torn)

    def run(self, conditions: Conditions, script: Sequence[Step]) -> Observation:
        """Everything from the supply on; `conditions` differ from the rig's in times only."""
        plant, kernel = self._plant, self._plant.kernel
        self._begin(conditions, script)
        self._gateway.power_on()
        kernel.run_for(conditions.scan_offset_ns)
        plant.cpu.start(Restart.COLD)
        limit_ns = kernel.now_ns + _LONGEST_RUN_NS
        while not self._over and kernel.now_ns < limit_ns:
            kernel.run_for(50 * NS_PER_MS)
            if plant.cpu.mode is CpuMode.STOP:
                self._seen.stopped = "; ".join(item.message for item in plant.cpu.diagnostics)
                break
        kernel.run_for(_SETTLING_NS)
        self._seen.finished = self._over
        return self._seen

    def _begin(self, conditions: Conditions, script: Sequence[Step]) -> None:
        plant, kernel = self._plant, self._plant.kernel
        plant.cpu.power_off()
        self._gateway.power_off()
        for drive in self._drives.values():
            drive.die()
        kernel.run_for(_SETTLING_NS)
        plant.master.set_times(CycleTimes(conditions.bus_period_ns))
        kernel.run_until(-(-kernel.now_ns // _GRID_NS) * _GRID_NS)
        poll_ns = self._poll_ns if conditions.trigger_poll else 0
        self._gateway.settings = replace(self._gateway.settings, trigger_poll_ns=poll_ns)
        seed = crc32(repr(conditions).encode())
        kernel.random.seed(seed)
        self._values.begin(seed)
        for drive in self._drives.values():
            drive.begin(conditions.reply_ns)
        self._seen = Observation(conditions)
        self._steps = iter(script)
        self._open, self._unwaited, self._silent = [], [], set()
        self._trigger = self._idle_until_ns = 0
        self._over = False

    # --- what is asked ------------------------------------------------------------------------

    def _scanned(self) -> None:
        """Between two scans: note the trigger, take replies, ask for the next."""
        now_ns = self._plant.kernel.now_ns
        trigger, online, *replies = self._read()
        assert isinstance(trigger, int)
        if trigger != self._trigger:
            self._trigger = trigger
            self._seen.triggers.append(now_ns)
        self._open = [outcome for outcome in self._open if not self._ended(outcome, replies)]
        self._unwaited = [item for item in self._unwaited if not self._ended(item, replies)]
        if online and not self._open and now_ns >= self._idle_until_ns:
            self._next()

    def _ended(self, outcome: Outcome, replies: Sequence[Scalar]) -> bool:
        channel = outcome.request.channel
        first = channel * len(_REPLY)
        done, failed, status, data = replies[first : first + len(_REPLY)]
        if not done and not failed:
            return False
        assert isinstance(status, int)
        assert isinstance(data, int)
        outcome.ended_ns = self._plant.kernel.now_ns
        outcome.done, outcome.status, outcome.data = bool(done), status, data
        path = f"{self._channels}[{channel}].reply"
        self._plant.cpu.engine.set_global(path, {"done": False, "error": False})
        return True

    def _next(self) -> None:
        """What is due of the script, up to the next request or pause."""
        for step in self._steps:
            if isinstance(step, Ask):
                for request in step.requests:
                    self._post(request)
                if step.wait:
                    return
                self._unwaited, self._open = [*self._unwaited, *self._open], []
            if isinstance(step, Pause):
                self._idle_until_ns = self._plant.kernel.now_ns + step.duration_ns
                return
            if isinstance(step, EmergencyStop):
                self._seen.stop_edge_ns = self._plant.kernel.now_ns
                self._plant.cpu.engine.set_global(f"{self._line}.emergencyStop", True)
            elif isinstance(step, Die):
                self._drives[step.inv_no].die()
                self._silent.add(step.inv_no)
            elif isinstance(step, Revive):
                self._drives[step.inv_no].revive()
                self._silent.discard(step.inv_no)
        self._over = True

    def _post(self, request: Request) -> None:
        outcome = Outcome(request, self._plant.kernel.now_ns)
        self._seen.outcomes.append(outcome)
        self._seen.silent.append(frozenset(self._silent))
        self._open.append(outcome)
        self._plant.cpu.engine.set_global(
            f"{self._channels}[{request.channel}].request",
            {
                "execute": True,
                "invNo": request.inv_no,
                "cmd": request.cmd,
                "comNo": request.com_no,
                "data": request.data,
                "replyExpected": request.reply_expected,
                "timeout": ceil(self.times.timeout_ms),
            },
        )

    # --- what went over the line --------------------------------------------------------------

    def _heard(self, transmission: Transmission) -> None:
        if transmission.sender is not self._gateway.port:
            if (answer := answer_in(transmission)) is not None:
                self._seen.answers.append(answer)
            return
        if transmission.data[:1] == bytes((ASCII_START,)):
            return
        frame = Frame(transmission.start_ns, transmission.end_ns, transmission.data[1:-1])
        self._seen.frames.append(frame)


def plant_in(plan: Plant, base: Conditions) -> Plant:
    """The plant with access way, layout and drives of these conditions."""
    (entry,) = plan.gateways
    drives = tuple(item for item in entry.drives if base.drive_zero or item.inv_no)
    changed = {"access": base.access, "layout": ACCESS_LAYOUTS[base.access], "drives": drives}
    return plan.model_copy(update={"gateways": (entry.model_copy(update=changed),)})


def with_reply_time(catalog: Catalog, reply_max_ms: int) -> Catalog:
    """The catalogue with drives that answer within so many milliseconds."""
    drives = {}
    for name, drive in catalog.drives.items():
        longest = drive.times.reply_max.model_copy(update={"ms": float(reply_max_ms)})
        times = drive.times.model_copy(update={"reply_max": longest})
        drives[name] = drive.model_copy(update={"times": times})
    return replace(catalog, drives=drives)
