"""The option of a drive has other assemblies than the scanner expects: c203 was set otherwise.

The numbers of bytes differ, so the scanner does not take what comes and the drive not what it gets.
The option begins anew with the other value, and once more when it is set right.
"""

from fbgen.catalog import AssemblyPair, DeviceNetGateway
from fbgen.catalog.scalars import Text
from fbgen.diagnostics import error
from fbgen.nearest import nearest
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Holding
from harness.gateways.dev003z import Dev003z
from harness.installation import Installation
from harness.installation.holds import Hold


class AssemblySettings(FaultSettings):
    """`assemblies` as in a plant file, such as 101/151; the first of another size if not said."""

    assemblies: Text | None = None


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    """FB7523 if the option has no such assemblies."""
    assert isinstance(settings, AssemblySettings)
    option = plant.options[on]
    known, name = option.gateway, option.gateway.assembly_parameter
    pair = _other(known, option, settings.assemblies)

    def present() -> int:
        return option.own[name]

    def put(setting: int) -> None:
        option.own.set(name, setting)
        if option.powered:
            option.node.restart()

    return Holding(plant, Hold((option, name), pair.setting, present, put))


def _other(known: DeviceNetGateway, option: Dev003z, named: str | None) -> AssemblyPair:
    pairs = {f"{pair.output.instance}/{pair.input.instance}": pair for pair in known.assemblies}
    if named is not None and named in pairs:
        return pairs[named]
    if named is not None:
        raise error(
            "FB7523", f"a {known.id} has no assemblies '{named}'", None, nearest(named, pairs)
        )
    length = option.assemblies.chosen.output.length
    return next(pair for pair in known.assemblies if pair.output.length != length)


FAULT = FaultType(
    "devicenet_wrong_assembly",
    "The option of a drive has other assemblies than the scanner expects",
    Target.OPTION,
    _make,
    AssemblySettings,
)
