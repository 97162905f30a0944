"""A plant with something changed, checked as the file itself is."""

from fbgen.catalog import Catalog
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.plant.families import FAMILIES, USUAL_PLC
from fbgen.plant.plant import Plant


def problems_of(plant: Plant, catalog: Catalog) -> list[Diagnostic]:
    """What is wrong in a plant that was changed after it was read."""
    return [
        *plant.problems(),
        *plant.problems_against(catalog),
        *(item for unit in plant.units for item in unit.problems_against(catalog)),
    ]


def changed(plant: Plant, catalog: Catalog, **values: object) -> Plant:
    """The plant with other values of its fields. Raises DiagnosticError with what is wrong then."""
    other = plant.model_copy(update=values)
    if found := problems_of(other, catalog):
        raise DiagnosticError(found)
    return other


def in_dialect(plant: Plant, dialect: str, catalog: Catalog) -> Plant:
    """The plant in another dialect of `LANGUAGES`.

    Where its PLC does not read it, the usual one takes its place; where that has no Modbus_Master
    the blocks build the frames of MODBUS themselves. Raises DiagnosticError with what the plant
    asks for and that PLC does not have.
    """
    if dialect == plant.dialect:
        return plant
    reads_it = dialect in plant.family.dialects
    plc = plant.plc if reads_it else USUAL_PLC[dialect]
    cpu = plant.cpu if reads_it else None
    frames = plant.modbus_frames if FAMILIES[plc].modbus_master else None
    return changed(plant, catalog, dialect=dialect, plc=plc, cpu=cpu, modbus_frames=frames)
