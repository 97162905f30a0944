"""Modules of a GSD file, plugged: what the master sends in Chk_Cfg, how long the data are."""

from collections.abc import Iterator, Sequence

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.source import Span
from fbgen.wire.gsd.station import GsdModule, GsdStation
from fbgen.wire.profibus import Identifier

LONGEST_DATA = 244
"""Data_Exchange carries up to 244 bytes in each direction."""


@dataclass(frozen=True, slots=True)
class Configuration:
    """Modules in the order in which they are plugged."""

    station: GsdStation
    modules: tuple[GsdModule, ...]

    @property
    def code(self) -> bytes:
        """The data of Chk_Cfg."""
        return b"".join(module.code for module in self.modules)

    @property
    def identifiers(self) -> tuple[Identifier, ...]:
        """All identifiers one by one."""
        return tuple(item for module in self.modules for item in module.identifiers)

    @property
    def output_length(self) -> int:
        """Bytes from the PLC to the slave."""
        return sum(module.output_length for module in self.modules)

    @property
    def input_length(self) -> int:
        """Bytes from the slave to the PLC."""
        return sum(module.input_length for module in self.modules)

    @property
    def user_parameters(self) -> bytes:
        """User_Prm_Data of Set_Prm, as the file presets them."""
        return self.station.user_parameters(self.modules)

    @property
    def names(self) -> str:
        """The modules for a message: 'Binary Mode', 'Reserve'."""
        return ", ".join(f"'{module.name}'" for module in self.modules)


def choose(
    station: GsdStation,
    names: Sequence[str] = (),
    places: Sequence[Span | None] = (),
    lengths: tuple[int, int] | None = None,
) -> Configuration:
    """The modules of these names, plugged in this order; without names those that alone can be.

    These are the preset ones, or the module of a station with a single one, or the single one that
    carries `lengths` (bytes out and in) where these are known. Presets that cannot be pulled come
    first. `places` are where the names stand, the last one for
    what is said about all of them. Raises DiagnosticError FB1310 for a name that is not there,
    FB1311 for modules that cannot be plugged so, or where nothing says which.
    """
    where = [*places, *[None] * (len(names) + 1 - len(places))]
    presets = [module for module in station.modules if module.preset]
    if not names:
        alone = presets or [_only_module(station, lengths, where[0])]
        return Configuration(station, tuple(alone))
    plugged: list[GsdModule] = []
    findings: list[Diagnostic] = []
    for name, place in zip(names, where, strict=False):
        try:
            plugged.append(_module(station, name, place))
        except DiagnosticError as wrong:
            findings += wrong.diagnostics
    if findings:
        raise DiagnosticError(findings)
    if station.fixed_presets:
        where = [*[places[-1] if places else None] * len(presets), *where]
        plugged = [*presets, *(module for module in plugged if not module.preset)]
    found = Configuration(station, tuple(plugged))
    if problems := list(_impossible(found, where)):
        raise DiagnosticError(problems)
    return found


def _only_module(
    station: GsdStation, lengths: tuple[int, int] | None, place: Span | None
) -> GsdModule:
    fitting = [
        module
        for module in station.modules
        if lengths is None or (module.output_length, module.input_length) == lengths
    ]
    candidates = fitting if len(fitting) == 1 else station.modules
    if len(candidates) == 1:
        return candidates[0]
    if not station.modules:
        raise error("FB1311", f"{station.source.name} defines no module", place)
    raise error(
        "FB1311",
        f"{station.source.name} has {len(station.modules)} modules, and nothing says which of them "
        "are plugged",
        place,
        nearest("", (module.name for module in fitting or station.modules)),
    )


def _module(station: GsdStation, name: str, place: Span | None) -> GsdModule:
    wanted = " ".join(name.split())
    found = [one for one in station.modules if one.name == wanted]
    found = found or [one for one in station.modules if one.name.lower() == wanted.lower()]
    if not found:
        raise error(
            "FB1310",
            f"{station.source.name} has no module '{wanted}'",
            place,
            nearest(wanted, (module.name for module in station.modules)),
        )
    if len({one.code for one in found}) > 1:
        raise error(
            "FB1311",
            f"{station.source.name} has {len(found)} modules '{wanted}' with different identifiers",
            place,
            "rename one of them in a copy of the file",
        )
    return found[0]


def _impossible(chosen: Configuration, places: Sequence[Span | None]) -> Iterator[Diagnostic]:
    station, limits = chosen.station, chosen.station.limits
    count = len(chosen.modules)
    if limits.modules is not None and count > limits.modules:
        yield Diagnostic(
            "FB1311",
            f"{station.source.name} takes at most {limits.modules} modules, not {count}",
            places[-1],
            "take some of them out",
        )
    outputs, inputs = chosen.output_length, chosen.input_length
    for length, most, what in (
        (outputs, limits.outputs or LONGEST_DATA, "out"),
        (inputs, limits.inputs or LONGEST_DATA, "in"),
        (outputs + inputs, limits.data or 2 * LONGEST_DATA, "out and in together"),
    ):
        if length > most:
            yield Diagnostic(
                "FB1311",
                f"the modules carry {length} bytes {what}, {station.source.name} allows {most}",
                places[-1],
                "plug fewer or shorter modules",
            )
    slots = {slot.number: slot for slot in station.slots}
    for number, (module, place) in enumerate(zip(chosen.modules, places, strict=False), start=1):
        slot = slots.get(number)
        if slot is not None and not slot.takes(module):
            fitting = [one.name for one in station.modules if slot.takes(one)]
            yield Diagnostic(
                "FB1311",
                f"'{module.name}' cannot be plugged in slot {number}, '{slot.name}'",
                place,
                nearest(module.name, fitting),
            )
