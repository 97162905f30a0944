"""One block as what a scenario plays on: called once each cycle, with nothing around it.

Time passes from call to call as on a CPU: a cycle is due at the time 0 and then each cycle time.
`call` goes on to the instant of the next cycles and stays at the last of them; waiting calls the
block at each cycle that begins before the time is over.
"""

from collections.abc import Callable, Sequence
from functools import partial

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.engine.compiled.watching.last_writes import last_write
from harness.engine.loading import LoadedProgram
from harness.kernel import Kernel
from harness.scenario.addresses import Place
from harness.scenario.kinds import Found, ValueKind, no_bytes
from harness.scenario.named_things import Readable
from harness.scenario.paths import Writable
from harness.scenario.plc_variables import kind_of_type, reading, variable_kind
from harness.trace.blocks import BlockRecorder
from harness.trial import Subject

ROOTS = ("block", "plc", "address")


class BlockPaths:
    """`block.VARIABLE` is one of the block, `plc.VARIABLE` a global one, `address.IB0` a byte."""

    def __init__(self, program: LoadedProgram, subject: Subject) -> None:
        self._engine = program.engine
        self._subject = subject
        self._kinds: dict[tuple[str, str], ValueKind] = {}

    def readable(self, path: str, span: Span | None) -> Readable:
        """What a path gives. Raises DiagnosticError FB8003."""
        root, rest = _split(path, span)
        if root == "block":
            writer = partial(self._subject.last_write, rest)
            return Readable(self._kind(rest, span), lambda: self._subject.value(rest), writer)
        if root == "address":
            place = Place(self._engine.environment, rest, span)
            return Readable(kind_of_type(self._engine.program, path, place.type), place.read)
        kind = self._kind_of_global(rest, span)
        writer = partial(last_write, self._engine, rest)
        return Readable(kind, reading(self._engine, rest), writer)

    def writable(self, path: str, span: Span | None) -> Writable:
        """What a path can be set to. Raises DiagnosticError FB8003."""
        root, rest = _split(path, span)
        if root == "block":
            writer = partial(self._subject.last_write, rest)
            return Writable(self._kind(rest, span), self._setter(rest), writer)
        if root == "address":
            place = Place(self._engine.environment, rest, span)
            return Writable(kind_of_type(self._engine.program, path, place.type), place.write)
        engine = self._engine
        kind = self._kind_of_global(rest, span)
        writer = partial(last_write, engine, rest)
        return Writable(kind, lambda value: engine.set_global(rest, no_bytes(value)), writer)

    def _setter(self, path: str) -> Callable[[Found], None]:
        return lambda value: self._subject.set(path, no_bytes(value))

    def _kind(self, path: str, span: Span | None) -> ValueKind:
        known = self._kinds.get(("block", path))
        if known is None:
            try:
                kind = self._subject.type_of(path)
            except DiagnosticError as wrong:
                raise _unknown(wrong, "in the block", span) from None
            known = kind_of_type(self._engine.program, path, kind)
            self._kinds["block", path] = known
        return known

    def _kind_of_global(self, path: str, span: Span | None) -> ValueKind:
        known = self._kinds.get(("plc", path))
        if known is None:
            try:
                self._engine.global_value(path)
            except DiagnosticError as wrong:
                raise _unknown(wrong, "in the PLC", span) from None
            known = self._kinds["plc", path] = variable_kind(self._engine.program, path)
        return known


def _split(path: str, span: Span | None) -> tuple[str, str]:
    root, _, rest = path.partition(".")
    if root not in ROOTS:
        message = f"there is no kind of thing '{root}' beside a block on its own"
        advice = nearest(root, ROOTS) if rest else f"write block.{path}"
        raise error("FB8003", message, span, advice)
    if not rest:
        raise error("FB8003", "a variable must be named", span, f"write {root}.<variable>")
    return root, rest


def _unknown(wrong: DiagnosticError, where: str, span: Span | None) -> DiagnosticError:
    first = wrong.diagnostics[0]
    return error("FB8003", f"{where} {first.message}", span, first.help)


class BlockStage:
    """A block with its own state, its clock and its cycle."""

    installation = None

    def __init__(
        self, program: LoadedProgram, subject: Subject, cycle_ns: int, catalog: Catalog
    ) -> None:
        self.catalog = catalog
        self.program = program
        self.paths = BlockPaths(program, subject)
        self.after_scan: list[Callable[[], None]] = []
        self._subject = subject
        self._cycle_ns = cycle_ns
        self._due_ns = 0

    @property
    def dialect(self) -> str:
        """The dialect of the block."""
        return self.program.engine.program.dialect

    @property
    def kernel(self) -> Kernel:
        """The clock of the block."""
        return self.program.clock.kernel

    def start(self) -> None:
        """Everything has its initial value already."""

    def run_for(self, duration_ns: int) -> None:
        """Let time pass, with the cycles that begin in it."""
        kernel = self.kernel
        end_ns = kernel.now_ns + duration_ns
        while self._due_ns < end_ns:
            self.call(1)
        kernel.run_until(end_ns)

    def call(self, cycles: int) -> None:
        """So many cycles, the first one as soon as it is due."""
        for _ in range(cycles):
            self.kernel.run_until(self._due_ns)
            self._due_ns += self._cycle_ns
            self._subject.call()
            for told in self.after_scan:
                told()

    def record(self) -> BlockRecorder:
        """Record the variables of the block from now on."""
        recorder = BlockRecorder(self.program.engine, self._subject, self.kernel)
        self.after_scan.append(recorder.variables_written)
        return recorder

    def past(self) -> Sequence[Note]:
        """Nothing goes on beside the block."""
        return ()

    def stopped(self) -> Diagnostic | None:
        """There is no CPU that could stop: what the block cannot do is raised at once."""
        return None
