"""The list of blocks, types and data blocks that a plant needs, in the order of dependence.

Each kind of gateway, serial lines and DeviceNet have a family of blocks each; only the families
that the plant needs are generated. What belongs to the plant as a whole, TOS_Plant, TOS_Parameters,
TOS_Main, the start and the error blocks, and the scaling functions, is called the same in all.
"""

from collections.abc import Iterable, Mapping

from fbgen.blocks.dev_blocks import devicenet_family, devicenet_problems
from fbgen.blocks.family import FamilyPlan
from fbgen.blocks.gateways import several_masters
from fbgen.blocks.line_blocks import line_family, line_problems
from fbgen.blocks.literals import SclText, milliseconds
from fbgen.blocks.names import name_conflicts
from fbgen.blocks.pbdp_blocks import pbdp_family, pbdp_problems
from fbgen.blocks.scaling import other_counts, scaling
from fbgen.blocks.serial_blocks import serial_family, serial_problems
from fbgen.blocks.specs import BlockSpec, block, data_block
from fbgen.blocks.texts import ENGLISH, Texts
from fbgen.catalog import Catalog, ProcessDataGateway, origin
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.plant import Plant, PlantGateway, gsd_warnings

_TIMER = "{InstructionName := 'TON_TIME'; LibVersion := '1.0'} : TON_TIME"
_CLASSIC_TIMER = ": TON"
"""How an instance of the on-delay timer is declared; TON is SFB 4 on S7-300/400."""

_WITH_STARTUP_BLOCKS = ("tia", "step7")
"""Dialects of PLCs that may keep data over a restart, and have OB100 to say so."""
_LONGEST_PAUSE_MS = 200.0
_LONGEST_PAUSE_CYCLES = 5
"""How long after a call the next one counts as a start of the PLC where no block says so."""
ERROR_BLOCKS = ("OB82", "OB85", "OB86", "OB122")
"""The organization blocks without which an error event takes an S7-300/400 to STOP."""
_SCALING = ("TOS_HzToWord", "TOS_WordToHz", "TOS_WordToPercent")


@dataclass(frozen=True, slots=True)
class BlockPlan:
    """All units of a plant, and what every template is told."""

    specs: tuple[BlockSpec, ...]
    context: Mapping[str, object]
    warnings: tuple[Diagnostic, ...] = ()


@dataclass(frozen=True, slots=True)
class PlantView:
    """The plant as templates see it. `most_drives`: of one line."""

    name: str
    most_drives: int


def plan_blocks(plant: Plant, catalog: Catalog, texts: Texts = ENGLISH) -> BlockPlan:
    """Which blocks the plant needs; the catalogue is in the language of `texts` already.

    Raises DiagnosticError for what cannot be generated.
    """
    known = [catalog.sequence(name) for name in plant.sequences]
    lines, channels = _by_kind(plant, catalog)
    found = [*name_conflicts(plant, known)]
    found += [*line_problems(lines, catalog), *pbdp_problems(channels, catalog)]
    found += other_counts(plant, catalog)
    if plant.serial:
        found += serial_problems(plant, lines, catalog)
    found += devicenet_problems(plant, catalog)
    if found:
        raise DiagnosticError(found)
    families = []
    if lines:
        families.append(line_family(plant, lines, catalog, texts))
    if channels:
        families.append(pbdp_family(plant, channels, catalog, texts))
    if plant.serial:
        families.append(serial_family(plant, catalog, texts))
    if plant.devicenet:
        families.append(devicenet_family(plant, catalog, texts))
    specs = _once(spec for family in families for spec in family.types)
    specs += [block(name) for name in _SCALING]
    specs += [spec for family in families for spec in family.exchanged]
    specs += _once(spec for family in families for spec in family.blocks)
    specs.append(data_block("TOS_Plant"))
    specs += [spec for family in families for spec in family.data]
    specs += [data_block("TOS_Parameters"), block("TOS_Main")]
    if plant.dialect in _WITH_STARTUP_BLOCKS:
        specs.append(block("TOS_Restart"))
    if plant.has_error_blocks:
        specs.append(data_block("TOS_Errors"))
        specs += [block(name) for name in ERROR_BLOCKS]
    context = _plant_context(plant, families, catalog, texts)
    of_families = (found for family in families for found in family.warnings)
    warnings = (*of_families, *gsd_warnings(plant, catalog))
    return BlockPlan(tuple(specs), context, warnings)


def _once(specs: Iterable[BlockSpec]) -> list[BlockSpec]:
    """Each unit once: families share types, sequences and what reads the state of drives."""
    return list({spec.name: spec for spec in specs}.values())


def _by_kind(plant: Plant, catalog: Catalog) -> tuple[list[PlantGateway], list[PlantGateway]]:
    """The gateways with a line, and those for process data."""
    lines: list[PlantGateway] = []
    channels: list[PlantGateway] = []
    for item in plant.gateways:
        is_process_data = isinstance(catalog.gateway(item.type), ProcessDataGateway)
        (channels if is_process_data else lines).append(item)
    return lines, channels


def _plant_context(
    plant: Plant, families: list[FamilyPlan], catalog: Catalog, texts: Texts
) -> dict[str, object]:
    by_name = {view.name: view for family in families for view in family.units}
    context: dict[str, object] = {"serial": False, "modbus": False}
    for family in reversed(families):
        context |= family.context
    counts = [family.context.get("most_drives", 0) for family in families]
    most_drives = max(count for count in counts if isinstance(count, int))
    return context | {
        "optimized": "FALSE" if plant.family.classic else "TRUE",
        "longest_pause": longest_pause(plant),
        "on_delay": _CLASSIC_TIMER if plant.family.classic else _TIMER,
        "plant": PlantView(plant.name, most_drives),
        "gateways": tuple(by_name[item.name] for item in plant.gateways),
        "units": tuple(by_name[item.name] for item in plant.units),
        "station_mask": "16#0000FFFF" if several_masters(plant) else "16#000000FF",
        "scaling": scaling(catalog.drive(plant.drives[0].series), texts),
    }


def longest_pause(plant: Plant) -> SclText | None:
    """From one call to the next at most while the PLC runs; None where OB100 tells of a start."""
    if plant.dialect in _WITH_STARTUP_BLOCKS:
        return None
    place = origin("cycle_time_ms", plant)
    return milliseconds(max(_LONGEST_PAUSE_MS, _LONGEST_PAUSE_CYCLES * plant.cycle_time_ms), place)
