"""Drives on lines, behind a TOSPBDP001 or at the PLC itself, whose run is over.

It is over when the CPU or the line was away, when the drive is seen tripped, when `enable` is
FALSE, and when the drive is missed while it has no supply. From then on `run` has to be FALSE in
one scan in which all is well before a run command goes out again. Half a second is left for a
telegram that was on its way; what a sequence sends is asked for by itself.
"""

from collections.abc import Iterator

from fbgen.plant import with_prefix
from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.plc import CpuMode
from harness.rules.drive_variables import Unit, drive_reader, run_sequences
from harness.rules.rule import Watch
from harness.rules.run_commands import tell_run_commands

_ON_ITS_WAY_NS = 500 * NS_PER_MS
_STATE = ("state.tripped", "polled.lost")
_CONTROL = tuple(f"control.{name}" for name in ("enable", "manual", "run", "manualRun", "jog"))


class _Runs:
    """Since when the run of each drive is over, and when a sequence was executed for it."""

    def __init__(self, plant: Installation, units: tuple[Unit, ...]) -> None:
        self.found: list[str] = []
        self._plant = plant
        self._names = [drive.name for unit in units for drive in unit.drives]
        self._spent = dict.fromkeys(self._names, 0)
        self._executed: dict[str, int] = {}
        plant.cpu.on_mode.append(self._changed)
        tell_run_commands(plant, self._told)

    def _changed(self, mode: CpuMode) -> None:
        if mode is not CpuMode.RUN:
            for name in self._names:
                self._over(name)

    def _over(self, name: str) -> None:
        self._spent.setdefault(name, self._plant.kernel.now_ns)

    def _told(self, name: str, word: int, start_ns: int) -> None:
        since_ns = self._spent.get(name)
        if since_ns is None or start_ns - since_ns < _ON_ITS_WAY_NS:
            return
        executed_ns = self._executed.get(name)
        if executed_ns is None or start_ns - executed_ns > _ON_ITS_WAY_NS:
            self.found.append(
                f"{name} is told to run again ({word:04X}), and run was never FALSE since its run "
                "was over"
            )

    def look(self, name: str, *, over: bool, wanted: bool, executed: bool) -> None:
        """A drive as a scan has left it."""
        if executed:
            self._executed[name] = self._plant.kernel.now_ns
        if over:
            self._over(name)
        elif not wanted:
            self._spent.pop(name, None)


def watch_lines(plant: Installation) -> Watch:
    """What tells, behind each scan, which drives were told to run again."""
    units: tuple[Unit, ...] = (*plant.telegram_entries, *plant.plan.serial)
    runs = _Runs(plant, units)
    data = with_prefix("TOS_Plant", plant.plan.prefix)
    read_lines = plant.cpu.engine.reader([f"{data}.{unit.name}.line.online" for unit in units])
    counts = [len(unit.drives) for unit in units]
    sequences = [f"{name}.{what}" for name in run_sequences(plant) for what in ("execute", "busy")]
    read = drive_reader(plant, units, (*_STATE, *_CONTROL, *sequences))

    def broken() -> Iterator[str]:
        if plant.cpu.mode is CpuMode.RUN and plant.cpu.scans:
            online = [
                up for up, count in zip(read_lines(), counts, strict=True) for _ in range(count)
            ]
            for up, (name, (tripped, lost, enable, *rest)) in zip(online, read(), strict=True):
                manual, run, manual_run, jog, *executed = rest
                gone = lost and not plant.drives[name].powered
                runs.look(
                    name,
                    over=not up or bool(tripped) or not enable or bool(gone),
                    wanted=bool(manual_run if manual else run) or bool(jog),
                    executed=any(executed),
                )
        yield from runs.found
        runs.found.clear()

    return broken
