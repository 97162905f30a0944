"""Lines and mappings that somebody adds to the generated code, to look on while a program runs.

Counters of what was reached and recorders of who wrote a value are such probes. They must not
change what the program does: a line is a plain Python statement about objects of the probe itself.
"""

from collections.abc import Callable, Mapping, Sequence
from enum import Enum
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.lang import checked
from fbgen.lang.checked import Expression, Program
from harness.engine.compiled.watching.writers import Writers

Probed: TypeAlias = checked.Statement | checked.Branch | checked.CaseArm


class Moment(Enum):
    """When a line runs, for the node it belongs to."""

    BEFORE = "before a statement"
    INSIDE = "first in a branch, an arm or a pass of a loop; of IF and CASE: where none is chosen"
    ENDED = "where the condition of UNTIL ends its loop"
    AFTER = "behind a statement that does not jump"


def no_decisions(_: Expression) -> Sequence[str]:
    """For a probe that does not look at decisions."""
    return ()


@dataclass(frozen=True, slots=True)
class Probe:
    """Something that looks on while a program runs.

    `line` gives the Python that runs at a moment of a node, in several lines if need be; "" for
    none. `decisions` gives the names of mappings from the vector of the conditions of a decision to
    its result (see the module `decisions`); they are asked each time the decision is made. It is
    called for all operators. `names` are the objects that lines and mappings name. `writers` is
    there if the probe wants to know who wrote what.
    """

    line: Callable[[Probed, Moment], str]
    names: Mapping[str, object]
    decisions: Callable[[Expression], Sequence[str]] = no_decisions
    writers: Writers | None = None


ProbeMaker: TypeAlias = Callable[[Program], Probe]
"""Makes a probe for the program that is about to be loaded."""


def together(probes: Sequence[Probe]) -> Probe | None:
    """Several probes as one; their `names` must differ, and one of them at most asks for `writers`.

    None if there is none.
    """
    if len(probes) < 2:
        return probes[0] if probes else None
    return Probe(
        lambda node, moment: "\n".join(
            line for probe in probes if (line := probe.line(node, moment))
        ),
        {name: value for probe in probes for name, value in probe.names.items()},
        lambda node: [name for probe in probes for name in probe.decisions(node)],
        next((probe.writers for probe in probes if probe.writers is not None), None),
    )


def writers_probe(_: Program) -> Probe:
    """A probe that only wants to know who wrote what: the engine then has `writers`."""
    writers = Writers()
    return Probe(lambda node, moment: "", writers.names, writers=writers)
