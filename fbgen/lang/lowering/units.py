"""A whole plant in IEC: all units, in an order in which each is declared before it is used."""

from collections.abc import Iterable, Iterator

from fbgen.lang.ast import (
    ArraySpec,
    Block,
    BlockKind,
    Configuration,
    DataBlock,
    Declaration,
    DirectAddress,
    Globals,
    Name,
    NamedType,
    StructSpec,
    TypeDeclaration,
    TypeSpec,
    Unit,
    VarSection,
)
from fbgen.lang.lowering.blocks import header_comments, lower_block
from fbgen.lang.lowering.configuration import configuration
from fbgen.lang.lowering.context import Context
from fbgen.lang.lowering.findings import Findings
from fbgen.lang.lowering.globals import lower_data_block
from fbgen.lang.lowering.plant import PlantText
from fbgen.lang.lowering.schedule import Schedule
from fbgen.lang.lowering.target import Target
from fbgen.lang.lowering.types import TypeLowering
from fbgen.lang.walk import walk

_KIND_ORDER = (BlockKind.FUNCTION, BlockKind.FUNCTION_BLOCK, BlockKind.PROGRAM)


def lower_units(
    plant: PlantText, target: Target, schedule: Schedule, findings: Findings
) -> tuple[Unit, ...]:
    """Types, functions, function blocks, programs and, if there is need of one, a configuration."""
    context = Context(plant, target, findings)
    types = [_type(context, one) for one in plant.types.values()]
    variables = [
        lower_data_block(context, unit) for unit in plant.units if isinstance(unit, DataBlock)
    ]
    blocks = [lower_block(context, one) for one in plant.blocks.values()]
    variables += sorted(context.located_variables.values(), key=_place_in_image)
    units: list[Unit] = list(_ordered_types([*types, *context.new_types]))
    for kind in _KIND_ORDER:
        units += _ordered_blocks([block for block in blocks if block.kind is kind])
    programs = [block for block in blocks if block.kind is BlockKind.PROGRAM]
    if target.has_free_globals:
        if variables:
            units.insert(_behind_types(units), _globals(variables))
    elif programs or variables:
        units.append(_configuration(plant, schedule, variables, programs))
    return tuple(units)


def _place_in_image(declaration: Declaration) -> tuple[str, int, int]:
    address = declaration.at
    assert isinstance(address, DirectAddress), "only these are located"
    return address.area, address.byte, address.bit


def _configuration(
    plant: PlantText, schedule: Schedule, variables: list[Declaration], programs: list[Block]
) -> Configuration:
    place = programs[0].span if programs else plant.units[0].span
    names = [block.name.name for block in programs]
    return configuration(place._replace(end=place.start), schedule, variables, names)


def _behind_types(units: list[Unit]) -> int:
    return sum(isinstance(unit, TypeDeclaration) for unit in units)


def _globals(variables: list[Declaration]) -> Globals:
    place = variables[0].span._replace(end=variables[0].span.start)
    return Globals(place, VarSection(place, "VAR_GLOBAL", (), tuple(variables)))


def _type(context: Context, declaration: TypeDeclaration) -> TypeDeclaration:
    name = context.names.check(declaration.name.name, declaration.name.span)
    types = TypeLowering(context, name, None)
    spec: TypeSpec
    if isinstance(declaration.type, StructSpec):
        spec = types.structure(declaration.type)
    else:
        spec = types.type_spec(declaration.type, "")
    leading = (
        *declaration.leading,
        *header_comments(declaration.header),
        *declaration.header_comments,
    )
    return TypeDeclaration(
        declaration.span,
        Name(declaration.name.span, name),
        (),
        spec,
        declaration.initial,
        leading,
        (),
        declaration.closing,
    )


def _ordered_types(types: Iterable[TypeDeclaration]) -> list[TypeDeclaration]:
    known = {one.name.name.casefold(): one for one in types}
    order: dict[str, TypeDeclaration] = {}

    def place(key: str) -> None:
        if key in known and key not in order:
            declaration = known.pop(key)
            for name in _names_of_types(declaration.type):
                place(name.casefold())
            order[key] = declaration

    for key in list(known):
        place(key)
    return list(order.values())


def _ordered_blocks(blocks: Iterable[Block]) -> list[Block]:
    known = {one.name.name.casefold(): one for one in blocks}
    order: dict[str, Block] = {}

    def place(key: str) -> None:
        if key in known and key not in order:
            block = known.pop(key)
            for name in _names_used_by(block):
                place(name.casefold())
            order[key] = block

    for key in list(known):
        place(key)
    return list(order.values())


def _names_used_by(block: Block) -> Iterator[str]:
    for section in block.sections:
        for declaration in section.declarations:
            yield from _names_of_types(declaration.type)
    for node in walk(block.body):
        if isinstance(node, Name):
            yield node.name


def _names_of_types(spec: TypeSpec) -> Iterator[str]:
    if isinstance(spec, NamedType):
        yield spec.name
    elif isinstance(spec, ArraySpec):
        yield from _names_of_types(spec.element)
    elif isinstance(spec, StructSpec):
        for declaration in spec.fields:
            yield from _names_of_types(declaration.type)
