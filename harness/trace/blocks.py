"""Records a block on its own: its variables when a call is through, and what a scenario does."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Protocol

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import IN_OUTS, LIVING
from fbgen.lang.types import Type
from fbgen.source import Span
from harness.engine.compiled.watching.last_writes import LastWrite
from harness.engine.interface import Engine, Value
from harness.engine.loading import engine_name
from harness.kernel import Kernel
from harness.trace.log import ChangeLog
from harness.trace.marks import Marks
from harness.trace.model import Trace
from harness.trace.places import Places, place_of
from harness.trace.variables import block_channels


class Recordable(Protocol):
    """A block whose variables can be read, by their paths in it."""

    @property
    def name(self) -> str:
        """The block."""
        ...

    @property
    def outputs(self) -> tuple[str, ...]:
        """What it gives, its result included."""
        ...

    def type_of(self, path: str) -> Type:
        """The type of a variable. Raises DiagnosticError."""
        ...

    def value(self, path: str) -> Value:
        """What a variable holds. Raises DiagnosticError."""
        ...

    def last_write(self, path: str) -> LastWrite | None:
        """The line that wrote it last; None where nobody takes notes."""
        ...


def _variables(engine: Engine, subject: Recordable) -> Iterator[tuple[str, Type]]:
    """What a block keeps from call to call, what is behind its in-outs, and its result."""
    declared: set[str] = set()
    for variable in engine.program.blocks[subject.name.casefold()].variables:
        if variable.kind in LIVING or variable.kind in IN_OUTS:
            declared.add(variable.name.casefold())
            yield variable.name, variable.type
    for name in subject.outputs:
        if name.casefold() not in declared:
            yield name, subject.type_of(name)


class BlockRecorder:
    """Listens to a block from now on; `look` is for whoever calls it.

    The channels have the paths of scenario files, `block.VARIABLE`. What cannot be read, such as an
    in-out before the first call, has no value until it can.
    """

    def __init__(self, engine: Engine, subject: Recordable, kernel: Kernel) -> None:
        self._engine = engine
        self._subject = subject
        self._kernel = kernel
        self.begin_ns = kernel.now_ns
        self._places = Places()
        self.marks = Marks(kernel, self._places)
        self._log = ChangeLog()
        self._paths = {
            self._log.add(channel): channel.path.partition(".")[2]
            for channel in block_channels(engine.program, subject.name, _variables(engine, subject))
        }
        self._writes: dict[int, object] = {}
        self.variables_written()

    @property
    def now_ns(self) -> int:
        """The instant of the block."""
        return self._kernel.now_ns

    def variables_written(self, by: Mapping[str, Span | None] = MappingProxyType({})) -> None:
        """Somebody has written variables: the block in a call, or who drives it."""
        now_ns = self._kernel.now_ns
        places = {path.casefold(): self._places.of(span) for path, span in by.items()}
        for number, path in self._paths.items():
            try:
                value = self._subject.value(path)
            except DiagnosticError:
                continue
            if isinstance(value, bool | int | float | str):
                writer = places.get(f"block.{path}".casefold()) if by else self._writer(number)
                self._log.note(number, now_ns, value, writer)

    def _writer(self, number: int) -> int | None:
        last: LastWrite | None = self._subject.last_write(self._paths[number])
        if last is None or last.span is None or self._writes.get(number) is last.entry:
            return None
        self._writes[number] = last.entry
        return self._places.number(place_of(last.span, instance=last.instance))

    def finish(self, title: str = "", scenario: str = "") -> Trace:
        """All that was recorded so far. Recording goes on."""
        return Trace(
            title,
            scenario,
            self._kernel.seed,
            engine_name(self._engine),
            self._engine.program.dialect,
            bool(self._writes),
            self.begin_ns,
            self.now_ns,
            (),
            tuple(self._places.found),
            tuple(self._log.channels),
            tuple(self._log.changes),
            marks=tuple(self.marks.found),
        )
