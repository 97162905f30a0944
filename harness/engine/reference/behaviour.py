"""What every standard function block has: a call, and a memory beside its variables.

A behaviour gets the storages of its inputs and outputs in declared order, so that their names,
which differ from family to family, do not matter to it.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from fbgen.dataclass import dataclass
from harness.engine.interface import State
from harness.engine.reference.storage import Storage


@dataclass(frozen=True, slots=True)
class Call:
    """One call of a standard block: as what (`TON`, without the type behind it) and when."""

    name: str
    now_ns: int


class Behaviour(ABC):
    """The behaviour of one instance of a standard block; `remembered` names its memory."""

    __slots__ = ()
    remembered: ClassVar[tuple[str, ...]] = ()

    @abstractmethod
    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """One call."""

    def snapshot(self) -> State:
        """What it remembers."""
        return tuple(getattr(self, name) for name in self.remembered)

    def restore(self, state: State) -> None:
        """Back to what it remembered."""
        assert isinstance(state, tuple)
        for name, value in zip(self.remembered, state, strict=True):
            setattr(self, name, value)
