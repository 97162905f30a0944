"""A loaded program in which the body of a block can be exchanged, and which can change controllers.

Writing and compiling a whole program takes longer than most runs of it. Who runs many variants of
one program, as a mutation run does, loads it once, exchanges one body at a time and hands the same
engine to one controller after the other.
"""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from types import CodeType
from typing import Any

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Block, Program, Statement
from fbgen.lang.types import Elementary, Scalar
from fbgen.source import Span
from harness.engine.compiled.blocks import write_block
from harness.engine.compiled.code import Listing
from harness.engine.compiled.data.model import has_memory
from harness.engine.compiled.engine import CompiledEngine
from harness.engine.compiled.generation import room_for_generation
from harness.engine.compiled.watching.probes import Probe
from harness.engine.environment import Area, Environment
from harness.engine.interface import Limits
from harness.engine.services import Services


class CurrentController:
    """The controller that an engine is on at present."""

    __slots__ = ("present",)

    def __init__(self, present: Environment) -> None:
        self.present = present

    @property
    def now_ns(self) -> int:
        """The instant of the running scan."""
        return self.present.now_ns

    @property
    def classic(self) -> bool:
        """True for S7-300 and S7-400."""
        return self.present.classic

    @property
    def inputs(self) -> bytearray:
        """The process image of the inputs."""
        return self.present.inputs

    @property
    def outputs(self) -> bytearray:
        """The process image of the outputs."""
        return self.present.outputs

    @property
    def markers(self) -> bytearray:
        """The bit memory."""
        return self.present.markers

    @property
    def services(self) -> Services:
        """The calendar clock, and the stubs of the user."""
        return self.present.services

    def read_peripheral(self, byte: int, count: int) -> int:
        """Bytes straight from the hardware."""
        return self.present.read_peripheral(byte, count)

    def read_several(self, places: str) -> tuple[int, ...] | None:
        """Several accesses at once, where nothing can happen between them."""
        return self.present.read_several(places)

    def write_peripheral(self, byte: int, count: int, value: int) -> None:
        """Bytes straight to the hardware."""
        self.present.write_peripheral(byte, count, value)

    def write_several(self, places: str, values: tuple[int, ...]) -> bool:
        """Several accesses at once, where nothing can happen between them."""
        return self.present.write_several(places, values)

    def instruction(self, name: str, arguments: Mapping[str, Scalar | Area], span: Span) -> Scalar:
        """Carry out a system instruction."""
        return self.present.instruction(name, arguments, span)


class ReplaceableEngine(CompiledEngine):
    """A compiled engine whose blocks can be given other bodies for a while.

    A body may read and write no variables beyond those that the block's own one reads and writes,
    and call nothing else: what is known of the whole program is not worked out again.
    """

    __slots__ = ("_controller", "_first_state")

    def __init__(
        self, program: Program, environment: Environment, limits: Limits | None = None
    ) -> None:
        self._controller = CurrentController(environment)
        super().__init__(program, self._controller, limits)
        self._facts = self._facts.counting_loops()
        self._first_state = self.snapshot()

    def move_to(self, environment: Environment) -> None:
        """Go to another controller of the same kind, with initial values everywhere."""
        self._controller.present = environment
        self.restore(self._first_state)

    def text_of(self, name: str) -> str:
        """What a block of the program itself is written as.

        Two engines that write a block alike can run each other's other bodies of it.
        """
        return self._listings[f"<{name}>"].text

    def compiled_body(
        self, block: Block, body: Sequence[Statement], probe: Probe | None = None
    ) -> "CompiledBody":
        """Other statements for a block, ready to be used.

        Raises DiagnosticError FB6050 for a body that is nested too deep.
        """
        with room_for_generation():
            written = write_block(block, self._facts, self._bytes.shapes, probe=probe, body=body)
        names = {
            **written.names(self._bytes),
            **(probe.names if probe is not None else {}),
        }
        code = compile(written.listing.text, f"<{block.name}>", "exec")
        of_any = not written.links and all(
            isinstance(one, Elementary) for one in written.tables.values()
        )
        return CompiledBody(block.name, written.listing, names, code, of_any)

    @contextmanager
    def using(self, body: "CompiledBody") -> Iterator[None]:
        """Run a block with other statements than its own, as long as the context is open."""
        block = self._program.blocks[body.block.casefold()]
        file_name = f"<{block.name}>"
        names = self._namespace
        before = dict(names)
        listing = self._listings[file_name]
        class_name = self._model.name_of(block) if has_memory(block) else None
        python_class = None if class_name is None else names[class_name]
        runs = {} if python_class is None else _runs(python_class)
        try:
            names |= body.names
            exec(body.code, names)
            self._listings[file_name] = body.listing
            if python_class is not None and class_name is not None:
                _give(python_class, _runs(names[class_name]))
                names[class_name] = python_class
            self._runs.clear()
            yield
        finally:
            if python_class is not None:
                _give(python_class, runs)
            names.clear()
            names.update(before)
            self._listings[file_name] = listing
            self._runs.clear()


@dataclass(frozen=True, slots=True)
class CompiledBody:
    """Statements that an engine can run in the place of those of a block.

    `of_any` if they refer to nothing of the engine that they were written for.
    """

    block: str
    listing: Listing
    names: Mapping[str, object]
    code: CodeType
    of_any: bool


_METHODS = ("_run", "_uncounted")


def _runs(python_class: type) -> dict[str, Any]:
    """The functions of a block's class that hold its statements."""
    return {name: vars(python_class)[name] for name in _METHODS if name in vars(python_class)}


def _give(python_class: type, runs: Mapping[str, Any]) -> None:
    for name, function in runs.items():
        setattr(python_class, name, function)
