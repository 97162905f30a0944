"""The CPU never goes to STOP by itself."""

from collections.abc import Iterator

from harness.installation import Installation
from harness.plc import CpuMode
from harness.rules.rule import Rule, Watch


def _watch(plant: Installation) -> Watch:
    stopped: list[str] = []

    def changed(mode: CpuMode) -> None:
        if mode is CpuMode.STOP:
            stopped.extend(found.message for found in plant.cpu.diagnostics)

    plant.cpu.on_mode.append(changed)

    def broken() -> Iterator[str]:
        for why in stopped:
            yield f"the CPU went to STOP: {why}"
        stopped.clear()

    return broken


RULE = Rule("cpu_runs", "The CPU never goes to STOP by itself", _watch)
