"""A checked program as Python: written and compiled once, loaded on any number of controllers.

Writing and compiling takes longer than simulating a minute of a plant, and tests load one program
again and again. So a translation refers to nothing of a controller; what the memory of a controller
has to make for itself are its links. Whoever looks on by a probe has a translation of its own.
"""

from collections import OrderedDict
from collections.abc import Iterator, Mapping
from types import CodeType
from typing import NamedTuple

from fbgen.dataclass import dataclass
from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.lang.types import StructType
from harness.engine.compiled.blocks import Written, write_block, write_structures
from harness.engine.compiled.code import Listing
from harness.engine.compiled.facts import Facts
from harness.engine.compiled.generation import room_for_generation
from harness.engine.compiled.initials import Initializer
from harness.engine.compiled.model import GLOBALS, Model, bytes_name, is_scalar
from harness.engine.compiled.passes import may_exceed
from harness.engine.compiled.probes import Probe
from harness.engine.compiled.shapes import Shapes
from harness.engine.environment import Environment
from harness.engine.interface import Limits


@dataclass(frozen=True, slots=True)
class Unit:
    """A piece of the Python, compiled."""

    file_name: str
    written: Written
    code: CodeType


@dataclass(frozen=True, slots=True, eq=False)
class Translation:
    """All of a program: a unit for each block, then the classes of structures, then a unit that
    gives the global variables their first values."""

    model: Model
    facts: Facts
    shapes: Shapes
    blocks: tuple[Unit, ...]
    structures: Unit
    globals: Unit


class _Kind(NamedTuple):
    """What a translation depends on beside the program: a kind of controller."""

    image_sizes: tuple[int, int, int]
    classic: bool
    leaves: bool
    call_depth: int
    loop_passes: int


_KEPT = 32
_translations: OrderedDict[tuple[int, _Kind], Translation] = OrderedDict()


def translation_of(
    program: Program,
    library: Mapping[str, type],
    environment: Environment,
    limits: Limits,
    probe: Probe | None,
) -> Translation:
    """The translation for a kind of controller; without a probe one that others may have, too.

    `library` has the classes of the standard blocks. Raises DiagnosticError FB6050 for what is
    nested too deep.
    """
    areas = (environment.inputs, environment.outputs, environment.markers)
    inputs, outputs, markers = map(len, areas)
    kind = _Kind(
        *((inputs, outputs, markers), environment.classic),
        environment.services.leftovers is not None,
        *(limits.call_depth, limits.loop_passes),
    )
    if probe is not None:
        return _translated(program, library, kind, probe)
    key = id(program), kind
    known = _translations.get(key)
    if known is None:
        known = _translations[key] = _translated(program, library, kind, None)
        while len(_translations) > _KEPT:
            _translations.popitem(last=False)
    _translations.move_to_end(key)
    return known


def _translated(
    program: Program, library: Mapping[str, type], kind: _Kind, probe: Probe | None
) -> Translation:
    model = Model(program, library)
    sizes = dict(zip("IQM", kind.image_sizes, strict=True))
    shapes = Shapes(model, sizes, leaves=kind.leaves)
    facts = Facts(program, kind.call_depth)
    with room_for_generation():
        facts.counts_loops = may_exceed(program, facts, kind.loop_passes)
        blocks = tuple(_blocks(facts, shapes, probe))
    variables = _globals(model)
    # The structures come last, because writing blocks and globals discovers them.
    structures = _unit("<structures>", Written(write_structures(model), {}, {}))
    return Translation(model, facts, shapes, blocks, structures, variables)


def _blocks(facts: Facts, shapes: Shapes, probe: Probe | None) -> Iterator[Unit]:
    problems: list[DiagnosticError] = []
    for block in shapes.model.program.bodies:
        try:
            written = write_block(block, facts, shapes, probe=probe)
        except DiagnosticError as problem:
            problems.append(problem)
            continue
        yield _unit(f"<{block.name}>", written)
    if problems:
        raise DiagnosticError([one for problem in problems for one in problem.diagnostics])


def _globals(model: Model) -> Unit:
    """First values of all global variables; composite ones get their module-level names, too."""
    initializer = Initializer(model)
    listing = Listing()
    for part in model.global_record.parts:
        lines = initializer.part(f"{GLOBALS}.{part.slot}", part)
        if part.bit is not None and isinstance(part.type, StructType):
            model.discover(part.type)
            lines = [f"{GLOBALS}.{part.slot} = {bytes_name(part)}"]
        for line in lines:
            listing.add(line)
        if not is_scalar(part.type):
            listing.add(f"{part.slot} = {GLOBALS}.{part.slot}")
    return _unit("<globals>", Written(listing, {}, {}))


def _unit(file_name: str, written: Written) -> Unit:
    return Unit(file_name, written, compile(written.listing.text, file_name, "exec"))
