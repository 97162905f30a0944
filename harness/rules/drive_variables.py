"""The variables of the drives in TOS_Plant, for rules."""

from collections.abc import Callable, Iterable, Sequence

from fbgen.plant import DeviceNetNetwork, PlantGateway, SerialLine, with_prefix
from harness.engine.interface import Value
from harness.installation import Installation

Unit = PlantGateway | SerialLine | DeviceNetNetwork
"""What drives are connected to."""
ReadDrives = Callable[[], "list[tuple[str, Sequence[Value]]]"]
"""The values of each drive, with its name."""


def drive_reader(
    plant: Installation, units: Iterable[Unit], variables: Sequence[str]
) -> ReadDrives:
    """What reads these variables, such as `polled.lost`, of all drives of the units at once."""
    data = with_prefix("TOS_Plant", plant.plan.prefix)
    names, paths = [], []
    for unit in units:
        for drive in unit.drives:
            names.append(drive.name)
            paths += [f"{data}.{unit.name}.{drive.name}.{name}" for name in variables]
    read, count = plant.cpu.engine.reader(paths), len(variables)

    def values() -> list[tuple[str, Sequence[Value]]]:
        all_values = tuple(read())
        return [(name, all_values[at * count : (at + 1) * count]) for at, name in enumerate(names)]

    return values


def run_sequences(plant: Installation) -> tuple[str, ...]:
    """The sequences of the plant that write the command word with its run bit."""
    sequences = plant.catalog.sequences
    return tuple(
        name
        for name in plant.plan.sequences
        if any("run" in (getattr(step, "bits", None) or ()) for step in sequences[name].steps)
        or sequences[name].telegrams
    )
