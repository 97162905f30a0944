"""The input terminals of an inverter, and which of their functions act.

Which terminal has which function is set by the ComNos `input_function_<terminal>` (F111 and
following); the function of `input_function_always` (F110) acts always. A function with an inverted
number acts while its terminal is off. The terminals are the bits of the word `input_terminals`.
Sources: VF-AS1 RS485 manual E6581315, 8.1 (48, 56 and 58, from F110 to F118).
"""

from fbgen.catalog import Drive
from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.drives.registers import Registers

FORCED_LOCAL, FORCED_RUN, SPECIFIED_SPEED = "forced_local", "forced_run", "specified_speed"
"""Functions that win over the command words, by their names in the catalogue."""

_WORD = "input_terminals"
FUNCTION_OF = "input_function_"
"""How the names of the ComNos begin that give terminals their functions."""
_ALWAYS = "always"


class Terminals:
    """Which terminals are on: `word` has them as FD06 shows them."""

    __slots__ = ("_functions", "_masks", "_registers", "_selecting", "_series", "word")

    def __init__(self, series: Drive, registers: Registers) -> None:
        words = [word for word in series.words if word.name == _WORD]
        self._series = series
        self._registers = registers
        self._masks = {field.name: field.mask for word in words for field in word.bits}
        self._functions = series.terminal_functions
        names = {comno.name for comno in series.comnos}
        self._selecting = {
            name: FUNCTION_OF + name
            for name in (*self._masks, _ALWAYS)
            if FUNCTION_OF + name in names
        }
        self.word = 0

    @property
    def names(self) -> tuple[str, ...]:
        """The terminals that there are."""
        return tuple(self._masks)

    def is_on(self, name: str) -> bool:
        """Whether a terminal is on. FB7105 for one that the series does not have."""
        return bool(self.word & self._mask(name))

    def switch(self, name: str, on: bool) -> None:
        """Switch a terminal. FB7105 for one that the series does not have."""
        mask = self._mask(name)
        self.word = self.word | mask if on else self.word & ~mask

    def acting(self, names: tuple[str, ...]) -> str | None:
        """The first of these functions that acts, None if none does."""
        if not names:
            return None
        chosen = [
            (self._registers.word(comno), name == _ALWAYS or bool(self.word & self._masks[name]))
            for name, comno in self._selecting.items()
        ]
        for name in names:
            for function in self._functions:
                if function.name == name and (
                    (function.number, True) in chosen or (function.inverted, False) in chosen
                ):
                    return name
        return None

    def _mask(self, name: str) -> int:
        if name in self._masks:
            return self._masks[name]
        raise error(
            "FB7105",
            f"'{self._series.id}' has no input terminal '{name}'",
            help=nearest(name, self._masks),
        )
