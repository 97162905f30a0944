"""The other drives on the line of a drive, for faults in which one is taken for another."""

from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.drives import Inverter
from harness.installation.field_level import FieldLevel


def neighbour(plant: FieldLevel, drive: str, named: str | None) -> Inverter:
    """The drive that is named, or the first other one on the line of `drive`.

    Raises DiagnosticError FB7520 if there is no such drive on that line.
    """
    others = plant.neighbours(drive)
    if named is None and others:
        return plant.drives[others[0]]
    if named is not None and named in others:
        return plant.drives[named]
    missing = "no other drive" if named is None else f"no other drive '{named}'"
    raise error(
        "FB7520",
        f"there is {missing} on the line of '{drive}'",
        None,
        nearest(named, others) if named and others else "it takes two drives on one line",
    )
