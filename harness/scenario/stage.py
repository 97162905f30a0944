"""What a scenario plays on: a whole simulated plant, or one block with nothing around it."""

from collections.abc import Callable, Sequence
from typing import Protocol

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, Note
from fbgen.source import Span
from harness.installation import Installation
from harness.kernel import Kernel
from harness.scenario.named_things import Readable
from harness.scenario.paths import Writable


class PathsOfStage(Protocol):
    """Resolves the names of a scenario. Errors are FB8003 with the nearest names."""

    def readable(self, path: str, span: Span | None) -> Readable:
        """What a path gives."""
        ...

    def writable(self, path: str, span: Span | None) -> Writable:
        """What a path can be set to."""
        ...


class Stage(Protocol):
    """A plant or a block, with time that passes."""

    @property
    def kernel(self) -> Kernel:
        """The clock."""
        ...

    @property
    def dialect(self) -> str:
        """The dialect of the PLC text."""
        ...

    @property
    def catalog(self) -> Catalog:
        """What the words are called."""
        ...

    @property
    def paths(self) -> PathsOfStage:
        """Its names."""
        ...

    @property
    def installation(self) -> Installation | None:
        """The plant; None for a block on its own."""
        ...

    @property
    def after_scan(self) -> list[Callable[[], None]]:
        """Called when a cycle of the program is through."""
        ...

    def start(self) -> None:
        """Begin at the time 0."""
        ...

    def run_for(self, duration_ns: int) -> None:
        """Let time pass."""
        ...

    def call(self, cycles: int) -> None:
        """So many cycles of the block."""
        ...

    def past(self) -> Sequence[Note]:
        """What went before, for a failure: the last telegrams, why the CPU is in STOP."""
        ...

    def stopped(self) -> Diagnostic | None:
        """FB8012 if the CPU has gone to STOP by itself."""
        ...
