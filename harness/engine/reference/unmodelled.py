"""An instance of a function block that only a stub of the user carries out."""

from collections.abc import Sequence

from harness.engine.interface import State
from harness.engine.reference.behaviour import Behaviour, Call
from harness.engine.reference.storage import Storage
from harness.engine.stubs import StubState


class Unmodelled(Behaviour):
    """Has the stub's Python object; what that remembers is no part of the program's state."""

    __slots__ = ("state",)

    def __init__(self) -> None:
        self.state = StubState()

    def run(self, inputs: Sequence[Storage], outputs: Sequence[Storage], call: Call) -> None:
        """Called from outside there is nothing to do; the program calls it as a `RoutineCall`."""

    def snapshot(self) -> State:
        """Nothing of the program."""
        return ()

    def restore(self, state: State) -> None:
        """Nothing of the program."""
