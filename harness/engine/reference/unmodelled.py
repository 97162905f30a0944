"""An instance of a function block that only a stub of the user carries out."""

from collections.abc import Mapping, Sequence

from fbgen.lang.checked import RoutineCall
from harness.engine.interface import State, Value
from harness.engine.reference.behaviour import Behaviour, Call
from harness.engine.reference.storage import InstanceStorage, Storage
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


def keep_inputs(instance: InstanceStorage, call: RoutineCall, inputs: Mapping[str, Value]) -> None:
    """The inputs that are given stay in the instance, where the program can read them."""
    for name, expression in call.inputs:
        variable = instance.variable(name.casefold())
        if variable is not None and variable.type == expression.type:
            instance.parts[name.casefold()].write(inputs[name])
