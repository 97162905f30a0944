"""Writes a checked program as Python, and compiles that."""

from collections.abc import Iterator, Mapping

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.checked import Program
from fbgen.lang.types import StructType
from harness.engine.compiled.blocks import write_block, write_structures
from harness.engine.compiled.code import Listing
from harness.engine.compiled.data.initials import Initializer
from harness.engine.compiled.data.model import GLOBALS, Model, bytes_name, is_scalar
from harness.engine.compiled.data.shapes import Shapes
from harness.engine.compiled.generation import room_for_generation
from harness.engine.compiled.shortening.facts import Facts
from harness.engine.compiled.shortening.passes import may_exceed
from harness.engine.compiled.translation import Kind, Translation, Unit
from harness.engine.compiled.watching.probes import Probe
from harness.engine.compiled.written import Written


def translated(
    program: Program, library: Mapping[str, type], kind: Kind, probe: Probe | None
) -> Translation:
    """The translation for a kind of controller. Raises DiagnosticError FB6050."""
    model = Model(program, library)
    sizes = dict(zip("IQM", kind.image_sizes, strict=True))
    shapes = Shapes(model, sizes, leaves=kind.leaves)
    facts = Facts(program, kind.call_depth)
    with room_for_generation():
        facts.counts_loops = may_exceed(program, facts, kind.loop_passes)
        writers = probe.writers if probe is not None else None
        if writers is not None:
            writers.in_tables = _has_bytes(shapes)
        blocks = tuple(_blocks(facts, shapes, probe))
    variables = _globals(model)
    # The structures come last, because writing blocks and globals discovers them.
    structures = _unit("<structures>", Written(write_structures(model, writers), {}, {}))
    return Translation(model, facts, shapes, blocks, structures, variables)


def _has_bytes(shapes: Shapes) -> bool:
    """Whether something lies in bytes, where no note fits beside it."""
    program = shapes.model.program
    return (
        bool(program.byte_memory)
        or any(record.size for record in shapes.model.block_records)
        or any(kind.is_union for kind in program.structures.values())
        or any(shapes.frame(block).size for block in program.bodies)
    )


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
