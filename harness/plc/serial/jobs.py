"""What the instructions for serial lines have in common: edges, kept inputs, a start of the CPU.

Inferred: a job under way ends with an error where the module does not answer any more.
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping

from fbgen.lang.types import Scalar
from harness.engine.block_models import Outputs
from harness.plc.serial.module import SerialModule
from harness.plc.serial.ports import SerialPorts

IDLE, FIRST_CALL, NEXT_CALL = 0x7000, 0x7001, 0x7002
MODULE_MISSING = 0x8282


class PortInstruction(ABC):
    """One instance. Inputs that a call leaves out are those of the call before."""

    __slots__ = ("_epoch", "_inputs", "_ports", "_was")

    areas: tuple[str, ...] = ()
    port_name = "PORT"

    def __init__(self, ports: SerialPorts) -> None:
        self._ports = ports
        self._inputs: dict[str, Scalar] = {}
        self._was = False
        self._epoch = -1
        self.forget()

    def call(self, inputs: Mapping[str, Scalar], areas: Mapping[str, bytes]) -> Outputs:
        """One call of the program."""
        self._inputs.update(inputs)
        module = self._ports.reach(self.number(self.port_name))
        if module is not None and module.epoch != self._epoch:
            self._epoch = module.epoch
            self._was = False
            self.forget()
        return self.run(module, areas)

    @abstractmethod
    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """What the call does; `module` is None if none answers at the port."""

    @abstractmethod
    def forget(self) -> None:
        """The CPU has started: no job is under way."""

    def rises(self, name: str = "REQ") -> bool:
        """True for a rising edge of an input."""
        before, self._was = self._was, self.flag(name)
        return self._was and not before

    def flag(self, name: str) -> bool:
        """An input of type BOOL."""
        return bool(self._inputs.get(name, False))

    def number(self, name: str, default: int = 0) -> int:
        """A numeric input."""
        value = self._inputs.get(name, default)
        assert isinstance(value, int)
        return value

    def text(self, name: str) -> str:
        """An input that is characters."""
        return str(self._inputs.get(name, ""))


class TimedInstruction(PortInstruction):
    """A job of one access: begun by an edge of REQ, over when the module has had its time."""

    __slots__ = ("_due_ns",)

    _due_ns: int | None

    def forget(self) -> None:
        """No job is under way."""
        self._due_ns = None

    def run(self, module: SerialModule | None, areas: Mapping[str, bytes]) -> Outputs:
        """REQ, PORT and what the job takes to DONE, ERROR, STATUS."""
        rises = self.rises()
        if module is None:
            was_ns, self._due_ns = self._due_ns, None
            return failed(MODULE_MISSING) if rises or was_ns is not None else idle()
        if self._due_ns is not None:
            if self._ports.now_ns < self._due_ns:
                return idle(NEXT_CALL)
            self._due_ns = None
            self.end(module)
            return done()
        if not rises:
            return idle()
        if status := self.begin(module, areas):
            return failed(status)
        self._due_ns = self._ports.now_ns + module.transfer_ns
        return idle(FIRST_CALL)

    @abstractmethod
    def begin(self, module: SerialModule, areas: Mapping[str, bytes]) -> int:
        """What happens with the edge. Gives the status of what is wrong, or 0."""

    def end(self, module: SerialModule) -> None:
        """What happens when the time is over; of settings nothing, they count from the edge on."""


def idle(status: int = IDLE) -> Outputs:
    """Nothing has ended in this call."""
    return Outputs(DONE=False, ERROR=False, STATUS=status)


def done(status: int = 0) -> Outputs:
    """The job has ended without error."""
    return Outputs(DONE=True, ERROR=False, STATUS=status)


def failed(status: int) -> Outputs:
    """The job has ended with an error."""
    return Outputs(DONE=False, ERROR=True, STATUS=status)
