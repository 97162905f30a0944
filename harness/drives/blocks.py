"""Which ComNos the words of a block transfer stand for, as parameters of the inverter choose.

F870 and F871 choose what is written, F875 to F879 what is read; 0 chooses nothing. VF-S15 RS485
manual E6581913, pp. 13 and 34; which value stands for which ComNo is the catalogue's.
"""

from fbgen.catalog import Blocks
from harness.drives.registers import Registers


class BlockTransfer:
    """The choices of one inverter; both protocols use the same."""

    __slots__ = ("_blocks", "_registers")

    def __init__(self, blocks: Blocks, registers: Registers) -> None:
        self._blocks = blocks
        self._registers = registers

    def written(self, count: int) -> list[int | None]:
        """The ComNos of the first `count` words that are written, None for a word for nothing."""
        blocks = self._blocks
        return [self._chosen(name, blocks.write_choices) for name in blocks.write[:count]]

    def read(self, count: int) -> list[int | None]:
        """The ComNos of the first `count` words that are read, None for a word of nothing."""
        blocks = self._blocks
        return [self._chosen(name, blocks.read_choices) for name in blocks.read[:count]]

    def _chosen(self, name: str, choices: dict[int, str]) -> int | None:
        registers = self._registers
        chosen = choices.get(registers.word(name))
        return None if chosen is None else registers.number(chosen)
