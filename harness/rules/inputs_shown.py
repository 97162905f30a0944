"""The program that runs shows what it was generated from.

`TOS_Plant.inputsHash` has the eight digits that stand in the heads of all its blocks; where they
differ, blocks of several generations have been mixed. A program without such heads shows nothing,
and none does before its first scan or while the CPU is in STOP.
"""

import re
from collections.abc import Iterator

from fbgen.plant import with_prefix
from harness.installation import Installation
from harness.plc import CpuMode
from harness.rules.rule import Rule, Watch

_HEAD = re.compile(r"\bfbgen \d[^\n]*\b([0-9A-F]{8})\b")


def _watch(plant: Installation) -> Watch:
    engine = plant.cpu.engine
    texts = {block.span.source.text for block in engine.program.blocks.values()}
    heads = {int(digits, 16) for text in texts for digits in _HEAD.findall(text)}
    path = f"{with_prefix('TOS_Plant', plant.plan.prefix)}.inputsHash"
    read = engine.reader([path] if heads else [])

    def broken() -> Iterator[str]:
        runs = plant.cpu.mode is CpuMode.RUN and plant.cpu.scans > 0
        for shown in read() if runs else ():
            if heads != {shown}:
                stand = ", ".join(f"{one:08X}" for one in sorted(heads))
                yield f"{path} is 16#{shown:08X}, and in the heads stands {stand}"

    return broken


RULE = Rule("inputs_shown", "TOS_Plant.inputsHash is that of all blocks that run", _watch)
