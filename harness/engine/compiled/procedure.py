"""One PLC block while it is turned into Python: its functions, its names, what it has split off.

Python cannot nest loops deeper than 20, indentation deeper than 100, brackets deeper than 200, and
its compiler gives up on long chains. What is nested deeper than `DEEPEST_*` moves into a function
of its own. Then the temporary variables of the block live in an object, the frame, that all its
functions share; such a block is written a second time with `framed` set.
"""

import re
from collections.abc import Callable, Sequence, Set

from fbgen.diagnostics import error
from fbgen.lang import checked
from fbgen.lang.checked import Block, Variable, VariableKind
from fbgen.lang.types import Type
from fbgen.source import Span
from harness.engine.compiled.code import Code, Level, Listing, Site
from harness.engine.compiled.data.initials import Initializer
from harness.engine.compiled.data.model import GLOBALS, has_memory, is_scalar
from harness.engine.compiled.data.names import Names
from harness.engine.compiled.data.placement import Bytes
from harness.engine.compiled.data.shapes import Shapes
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.shortening.intervals import Intervals
from harness.engine.compiled.shortening.paths import Path
from harness.engine.compiled.watching.probes import Moment, Probe, Probed
from harness.engine.compiled.written import Link

DEEPEST_EXPRESSION = 60
DEEPEST_INDENT = 60
DEEPEST_LOOPS = 15
DEEPEST_NESTING = 1000
"""How deep statements or expressions may be nested in all; beyond that FB6050 is raised."""


class FrameNeededError(Exception):
    """The block is nested so deep that its variables must be shared between functions."""


class BlockContext:
    """What all functions of one block share while they are written.

    `tables` are objects at module level, by their names; `links` those that each controller makes
    for itself. `parts` are the functions that were split off,
    finished. `shapes` knows what lies in bytes, and how large the areas I, Q and M are.
    """

    __slots__ = (
        *("block", "facts", "framed", "initializer", "links", "model", "names", "parts"),
        *("probe", "python_name", "shapes", "storage", "tables", "_count", "_path_names"),
    )

    def __init__(
        self,
        block: Block,
        facts: Facts,
        shapes: Shapes,
        *,
        probe: Probe | None,
        framed: bool,
    ) -> None:
        self.block = block
        self.model = model = shapes.model
        self.facts = facts
        self.shapes = shapes
        self.probe = probe
        self.framed = framed
        self.initializer = Initializer(model)
        self.names = Names(model.names)
        self.python_name = model.name_of(block)
        self.parts: list[Listing] = []
        self.tables: dict[str, object] = {}
        self.links: dict[str, Link] = {}
        self.storage: dict[Variable, str] = {}
        self._path_names: dict[Path, str] = {}
        self._count = 0

    def path_name(self, path: Path, declared: str) -> str:
        """The local for a structure inside of another one, called like its field if it can be."""
        if path not in self._path_names:
            self._path_names[path] = self.names.give(declared)
        return self._path_names[path]

    @property
    def arguments(self) -> str:
        """The parameters of a function that was split off."""
        return "self, frame" if has_memory(self.block) else "frame"

    def new_name(self, what: str) -> str:
        """A new module-level name."""
        self._count += 1
        return f"_{self.python_name}_{what}_{self._count}"

    def shared_table(self, name: str, content: object) -> str:
        """The name of a module-level constant that is the same for all blocks."""
        self.tables[name] = content
        return name

    def table(self, what: str, content: object) -> str:
        """The name of a new module-level constant."""
        name = self.new_name(what)
        self.tables[name] = content
        return name

    def link(self, what: str, make: Callable[[Bytes, Type], object], kind: Type) -> str:
        """The name of something at module level that each controller makes for itself."""
        self.model.discover(kind)
        name = self.new_name(what)
        self.links[name] = Link(make, kind)
        return name


class Loop:
    """An open loop: what has to be done before the next pass, and before leaving it."""

    __slots__ = ("before_continue",)

    def __init__(self, before_continue: Callable[["Procedure"], None] | None) -> None:
        self.before_continue = before_continue


class Procedure:
    """One Python function while it is written.

    `aliases` has the locals that hold the value of a variable, too, `paths` those that hold a
    structure inside of another one, and `known` what is known of values: of loop variables, and
    behind conditions. `at_hand` has the locals with what was read
    from the hardware already, by the identity of the node. `assigned` is the expression whose value
    is being assigned. `timer` was called a moment ago, and no time can have passed since.
    `gathered` is there while values for
    the hardware are collected instead of written. `split` marks a function that was split off; any
    other one returns by `return_line`. `unwritten` is there while attributes need not be written:
    it has those that a local has a newer value of, with the local.
    """

    __slots__ = (
        *(
            "_reads",
            "_sites",
            "_temporaries",
            "aliases",
            "arguments",
            "assigned",
            "at_hand",
            "context",
            "gathered",
            "known",
            "listing",
            "paths",
        ),
        *("loops", "name", "nesting", "return_line", "split", "timer", "unwritten"),
    )

    def __init__(self, context: BlockContext, name: str, nesting: int, split: bool) -> None:
        self.context = context
        self.name = name
        self.arguments = ""
        self.nesting = nesting
        self.split = split
        self.return_line = "return"
        self.unwritten: dict[str, str] | None = None
        self.listing = Listing()
        self.loops: list[Loop] = []
        self.aliases: dict[Variable, str] = {}
        self.paths: dict[Path, str] = {}
        self.known: Intervals = {}
        self.at_hand: dict[int, str] = {}
        self.assigned: checked.Expression | None = None
        self.timer: Variable | None = None
        self.gathered: list[str] | None = None
        self._sites: list[Site] = []
        self._reads: list[tuple[checked.Place, str]] = []
        self._temporaries = 0

    # --- writing ------------------------------------------------------------------------------

    def temporary(self) -> str:
        """A new local name."""
        self._temporaries += 1
        return f"_{self._temporaries}"

    def site(self, text: str, node: checked.Expression, position: str = "") -> None:
        """Remember that the lines of the present statement may stop here."""
        self._sites.append(Site(text, node, position))

    def reads(self, node: checked.Place, text: str) -> None:
        """Remember how the present statement reads a place, to show its value if it stops."""
        self._reads.append((node, text))

    def forget_sites(self) -> None:
        """A new statement or condition begins."""
        self._sites = []
        self._reads = []

    def line(self, text: str) -> None:
        """Write a line; what was remembered by `site` may stand in it."""
        if self._sites:
            self.listing.note(self._sites, self._reads)
        self.listing.add(text)

    def lines(self, texts: Sequence[str]) -> None:
        """Write several lines."""
        for text in texts:
            self.line(text)

    def probed(self, node: Probed, moment: Moment) -> str:
        """What a probe wants to run at a moment of a node; "" if there is none that does."""
        probe = self.context.probe
        return probe.line(node, moment) if probe is not None else ""

    def probe(self, node: Probed, moment: Moment) -> None:
        """Write what a probe wants to run at a moment of a node."""
        if line := self.probed(node, moment):
            self.forget_sites()
            self.lines(line.split("\n"))

    def decisions(self, node: checked.Expression) -> Sequence[str]:
        """The mappings that a probe wants a decision to take its result from."""
        probe = self.context.probe
        return probe.decisions(node) if probe is not None else ()

    def enter(self, span: Span) -> None:
        """One level of statements or expressions deeper; raises FB6050 at the limit."""
        self.nesting += 1
        if self.nesting > DEEPEST_NESTING:
            raise error(
                "FB6050",
                f"this is nested more than {DEEPEST_NESTING} levels deep",
                span,
                "move the inner part into a block of its own",
            )

    # --- variables ----------------------------------------------------------------------------

    def storage(self, variable: Variable) -> str:
        """The Python text of the variable's own storage; a cell if the variable has one."""
        known = self.context.storage
        if variable not in known:
            known[variable] = self._storage(variable)
        return known[variable]

    def _storage(self, variable: Variable) -> str:
        context = self.context
        if variable.kind is VariableKind.THIS:
            return "self"
        if variable.kind is VariableKind.GLOBAL:
            return context.model.global_name(variable)
        if variable.kind not in (VariableKind.TEMP, VariableKind.RESULT) and has_memory(
            context.block
        ):
            part = context.model.block_record(context.block).by_key[variable.name.casefold()]
            return f"self.{part.slot}"
        name = context.names.of(variable.name)
        return f"frame.{name}" if context.framed else name

    def owner(self, variable: Variable) -> tuple[str, str]:
        """The object and the attribute that hold a variable that is no Python local."""
        text = self.storage(variable)
        base, _, attribute = text.rpartition(".")
        return base or GLOBALS, attribute

    def forget(self, written: Set[Variable | None]) -> None:
        """What was known of these variables holds no longer."""
        if any(one is not None and one.kind is VariableKind.THIS for one in written):
            # A method of the instance may write all that lives on.
            own = (VariableKind.TEMP, VariableKind.RESULT)
            self.known = {one: known for one, known in self.known.items() if one.kind in own}
        if not written.isdisjoint(self.known):
            self.known = {
                variable: interval
                for variable, interval in self.known.items()
                if variable not in written
            }

    def has_cell(self, variable: Variable) -> bool:
        """True if the variable is reached through a cell, because others refer to it."""
        return is_scalar(variable.type) and variable in self.context.facts.cells

    def text_of(self, variable: Variable) -> str:
        """The Python text that reads and writes a variable."""
        text = self.storage(variable)
        return f"{text}.value" if self.has_cell(variable) else text

    # --- splitting ----------------------------------------------------------------------------

    def start_part(self, what: str, more: Sequence[str] = ()) -> "Procedure":
        """A new function of the block, with its head written. Close it with `finish_part`.

        `more` are locals of this function that the new one needs.
        """
        context = self.context
        if not context.framed:
            raise FrameNeededError
        part = Procedure(context, context.new_name(what), self.nesting, split=True)
        part.listing.span = self.listing.span
        part.arguments = ", ".join((context.arguments, *more))
        part.line(f"def {part.name}({part.arguments}):")
        part.listing.indent = 4
        return part

    def finish_part(self, part: "Procedure") -> str:
        """The text of a call of a finished function."""
        self.context.parts.append(part.listing)
        return f"{part.name}({part.arguments})"

    def split_off(self, code: Code) -> Code:
        """An expression that is nested too deep, as the call of a function with it."""
        used = [
            name
            for name in dict.fromkeys((*self.aliases.values(), *self.paths.values()))
            if re.search(rf"(?<!\.)\b{name}\b", code.text)
        ]
        part = self.start_part("value", used)
        part._sites += self._sites
        part._reads += self._reads
        part.line(f"return {code.text}")
        return code._replace(text=self.finish_part(part), level=Level.ATOM, depth=1, simple=False)

    def fresh(self, kind: Type) -> str:
        """An expression for a new value of a type."""
        return self.context.initializer.fresh(kind)
