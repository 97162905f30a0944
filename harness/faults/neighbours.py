"""The other drives on the line of a drive, for faults in which one is taken for another."""

from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.drives import Inverter
from harness.installation import Installation


def neighbour(plant: Installation, drive: str, named: str | None) -> Inverter:
    """The drive that is named, or the first other one on the line of `drive`.

    Raises DiagnosticError FB7520 if there is no such drive on that line.
    """
    gateway = next(
        entry for entry in plant.plan.gateways if drive in {item.name for item in entry.drives}
    )
    on_a_line = gateway.name in plant.gateways
    others = [item.name for item in gateway.drives if item.name != drive and on_a_line]
    if named is None and others:
        return plant.drives[others[0]]
    if named in others:
        return plant.drives[named]
    missing = "no other drive" if named is None else f"no other drive '{named}'"
    raise error(
        "FB7520",
        f"there is {missing} on the line of '{drive}'",
        None,
        nearest(named, others) if named and others else "it takes two drives behind one gateway",
    )
