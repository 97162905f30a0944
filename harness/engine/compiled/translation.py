"""A checked program as Python: written and compiled once, loaded on any number of controllers.

Writing and compiling takes longer than simulating a minute of a plant, and tests load one program
again and again. So a translation refers to nothing of a controller; what the memory of a controller
has to make for itself are its links. Whoever looks on by a probe has a translation of its own.
"""

from collections import OrderedDict
from collections.abc import Mapping
from types import CodeType
from typing import TYPE_CHECKING, NamedTuple

from fbgen.dataclass import dataclass
from fbgen.lang.checked import Program
from harness.engine.environment import Environment
from harness.engine.interface import Limits

if TYPE_CHECKING:
    from harness.engine.compiled.data.model import Model
    from harness.engine.compiled.data.shapes import Shapes
    from harness.engine.compiled.shortening.facts import Facts
    from harness.engine.compiled.watching.probes import Probe
    from harness.engine.compiled.written import Written


@dataclass(frozen=True, slots=True)
class Unit:
    """A piece of the Python, compiled."""

    file_name: str
    written: "Written"
    code: CodeType


@dataclass(frozen=True, slots=True, eq=False)
class Translation:
    """All of a program: a unit for each block, then the classes of structures, then a unit that
    gives the global variables their first values."""

    model: "Model"
    facts: "Facts"
    shapes: "Shapes"
    blocks: tuple[Unit, ...]
    structures: Unit
    globals: Unit


class Kind(NamedTuple):
    """What a translation depends on beside the program: a kind of controller."""

    image_sizes: tuple[int, int, int]
    classic: bool
    leaves: bool
    call_depth: int
    loop_passes: int


_KEPT = 32
_translations: OrderedDict[tuple[int, Kind], Translation] = OrderedDict()


def translation_of(
    program: Program,
    library: Mapping[str, type],
    environment: Environment,
    limits: Limits,
    probe: "Probe | None",
) -> Translation:
    """The translation for a kind of controller; without a probe one that others may have, too.

    `library` has the classes of the standard blocks. Raises DiagnosticError FB6050 for what is
    nested too deep.
    """
    areas = (environment.inputs, environment.outputs, environment.markers)
    inputs, outputs, markers = map(len, areas)
    kind = Kind(
        *((inputs, outputs, markers), environment.classic),
        environment.services.leftovers is not None,
        *(limits.call_depth, limits.loop_passes),
    )
    if probe is not None:
        return _translated(program, library, kind, probe)
    key = id(program), kind
    if key not in _translations:
        _enter(program, kind, _translated(program, library, kind, None))
    _translations.move_to_end(key)
    return _translations[key]


def shared(program: Program) -> dict[Kind, Translation]:
    """The known translations of a program, by the kinds of controller that they are for."""
    return {kind: one for (key, kind), one in _translations.items() if key == id(program)}


def share(program: Program, known: Mapping[Kind, Translation]) -> None:
    """Let a program have these translations, which another process has made of it."""
    for kind, translation in known.items():
        _enter(program, kind, translation)


def _enter(program: Program, kind: Kind, translation: Translation) -> None:
    _translations[id(program), kind] = translation
    while len(_translations) > _KEPT:
        _translations.popitem(last=False)


def _translated(
    program: Program, library: Mapping[str, type], kind: Kind, probe: "Probe | None"
) -> Translation:
    # What is kept needs nothing of what writes Python, which takes longer to import than to run.
    from harness.engine.compiled.translating import translated  # noqa: PLC0415

    return translated(program, library, kind, probe)
