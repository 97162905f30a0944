"""A run that is over comes again only after a new one; of drives on lines see `spent_runs`.

Behind a gateway for process data and on DeviceNet it is over when the drive is gone or has tripped,
when the CPU has started, and when the block took it back. From then on `run` has to be FALSE in one
scan, with the drive there and without a trip, before a run command goes out again: no drive starts
by itself. What the program holds by coast, DC brake or a missing interlock may go on.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.plc import CpuMode
from harness.rules.drive_variables import Unit, drive_reader
from harness.rules.rule import Rule, Watch
from harness.rules.run_commands import run_bits_of
from harness.rules.spent_runs import watch_lines

_CONTROL = ("manual", "run", "manualRun", "jog", "coast", "dcBrake", "interlock")
_STATE = ("command", "online", "tripped")
_VARIABLES = (*(f"state.{name}" for name in _STATE), *(f"control.{name}" for name in _CONTROL))


def _watch(plant: Installation) -> Watch:
    entries = plant.interface_entries
    units: tuple[Unit, ...] = (*entries, *plant.plan.devicenet)
    read = drive_reader(plant, units, _VARIABLES)
    masks = {
        drive.name: plant.catalog.process_data_gateway(entry.type).word("command").field("run").mask
        for entry in entries
        for drive in entry.drives
    }
    masks |= {name: run_bits_of(option)[1] for name, option in plant.options.items()}
    runs: set[str] = set()
    spent = set(masks)

    def changed(mode: CpuMode) -> None:
        if mode is not CpuMode.RUN:
            spent.update(masks)
            runs.clear()

    plant.cpu.on_mode.append(changed)

    on_lines = watch_lines(plant)

    def broken() -> Iterator[str]:
        yield from on_lines()
        if plant.cpu.mode is not CpuMode.RUN or not plant.cpu.scans:
            return
        for name, (command, online, tripped, *control) in read():
            manual, run, manual_run, jog, coast, brake, interlock = control
            assert isinstance(command, int)
            if not online or tripped:
                spent.add(name)
            wanted = bool(manual_run if manual else run) or bool(jog)
            if command & masks[name]:
                if name in spent:
                    yield f"{name} is told to run again ({command:04X}), and run was never FALSE"
                runs.add(name)
            elif name in runs:
                runs.remove(name)
                if interlock and not (coast or brake):
                    spent.add(name)
            if not wanted and online and not tripped:
                spent.discard(name)

    return broken


RULE = Rule(
    "no_run_again", "A run that was taken back comes again only after run was FALSE", _watch
)
