"""No run command goes out that nobody asks for in the PLC.

Who asks: `control` with enable and run, manualRun, jog or preset, or a sequence of the drive that
is executed. What was asked for up to 500 ms ago counts, as a telegram may have waited and been
repeated; a restart of the CPU ends it. Of a gateway for process data counts what the master sends
to it: what it does with the drives by itself is not the PLC's doing.
"""

from collections.abc import Iterator

from harness.installation import Installation
from harness.kernel import NS_PER_MS
from harness.plc import CpuMode
from harness.rules.drive_variables import Unit, drive_reader, run_sequences
from harness.rules.rule import Rule, Watch
from harness.rules.run_commands import tell_run_commands

_REMEMBERED_NS = 500 * NS_PER_MS
_CONTROL = ("enable", "run", "manualRun", "jog", "preset")


def _watch(plant: Installation) -> Watch:
    found: list[str] = []
    asked: dict[str, int] = {}
    variables = [f"control.{name}" for name in _CONTROL]
    with_data: tuple[Unit, ...] = (*plant.interface_entries, *plant.plan.devicenet)
    read_interfaces = drive_reader(plant, with_data, variables)
    for name in run_sequences(plant):
        variables += [f"{name}.execute", f"{name}.busy"]
    on_lines: tuple[Unit, ...] = (*plant.telegram_entries, *plant.plan.serial)
    read_lines = drive_reader(plant, on_lines, variables)

    def changed(mode: CpuMode) -> None:
        if mode is not CpuMode.RUN:
            asked.clear()

    def told(name: str, word: int, start_ns: int) -> None:
        since_ns = asked.get(name)
        if since_ns is None or start_ns - since_ns > _REMEMBERED_NS:
            found.append(f"a run command ({word:04X}) went out to {name}, unasked")

    plant.cpu.on_mode.append(changed)
    tell_run_commands(plant, told)

    def broken() -> Iterator[str]:
        now_ns = plant.kernel.now_ns
        for name, (enable, *values) in (*read_lines(), *read_interfaces()):
            controls, executed = values[: len(_CONTROL) - 1], values[len(_CONTROL) - 1 :]
            if any(executed) or (enable and any(controls)):
                asked[name] = now_ns
        yield from found
        found.clear()

    return broken


RULE = Rule("no_command_unasked", "No run command goes out that nobody asks for", _watch)
