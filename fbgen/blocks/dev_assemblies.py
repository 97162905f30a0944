"""What the assemblies of a drive on DeviceNet carry: which field is which word of the blocks.

Of the assemblies 102, 105, 152 and 155 parameters of the option choose it; the plant file has them.
"""

from collections.abc import Iterator, Mapping

from fbgen.catalog import Assembly, AssemblyPair, Catalog, ComNo, DeviceNetGateway, Drive
from fbgen.catalog.devicenet_gateways import AssemblyField, Selection
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.plant import DeviceNetDrive, assemblies_of

_CONTROLS = {"basic_control": 1, "extended_control": 2, "command": 3}
"""How a drive is told what to do, by the name of its word: the input `kind` of DEV_Drive."""
_BASIC, _COMMAND_WORD = 1, 3

_MEMBERS = {
    **{"control": "control", "command": "control", "status": "status"},
    **{"speed": "speed", "frequency": "speed"},
    **{"function": "request", "index": "number", "data": "data"},
}
"""Field of an assembly -> member of typeDevOutput or typeDevInput. FUNCTION is a reserved word."""
_RESPONSE = {"request": "response"}

_COMMANDS = {"command_word_option": "control", "frequency_setpoint_option": "speed"}
_MONITORS = {
    **{"status": "status", "output_frequency": "speed"},
    **{"output_current": "current", "output_voltage": "voltage"},
}
"""What a word that a parameter chooses carries, by the name of its cell -> the member it is."""
_NEEDED = frozenset({"control", "status", "speed"})
"""The members without which a drive cannot be commanded, or not be seen."""


def pair_of(drive: DeviceNetDrive, entry: DeviceNetGateway) -> AssemblyPair:
    """The assemblies of a drive of a plant that was checked."""
    pair = assemblies_of(drive, entry)
    assert pair is not None, "checked when the plant was read"
    return pair


def kind_of(pair: AssemblyPair) -> int:
    """By the word that commands; where parameters choose the words it is the command word."""
    words = (field.word for field in pair.output.fields)
    return next((_CONTROLS[word] for word in words if word in _CONTROLS), _COMMAND_WORD)


def has_links(pair: AssemblyPair) -> bool:
    """Whether its data can take run, stop and set-point away from the terminals."""
    return kind_of(pair) != _BASIC


def has_command_word(pair: AssemblyPair) -> bool:
    """Whether its data know more than run, stop, direction and reset."""
    return kind_of(pair) == _COMMAND_WORD


@dataclass(frozen=True, slots=True)
class Side:
    """One direction of a drive's data: its assembly, what words can be chosen, which are known."""

    drive: DeviceNetDrive
    entry: DeviceNetGateway
    series: Drive
    assembly: Assembly
    selections: tuple[Selection, ...]
    known: Mapping[str, str]

    @property
    def is_output(self) -> bool:
        """Whether it goes to the drive."""
        return self.known is _COMMANDS

    def chosen(self, field: AssemblyField) -> int | None:
        """The communication number that a field carries, None for nothing or what is no choice."""
        if field.parameter is None:
            return None
        parameter = self.entry.parameter(field.parameter)
        value = self.drive.settings.get(parameter.name, parameter.default)
        return next((item.comno for item in self.selections if item.code == value), None)

    def cell(self, member: str) -> ComNo:
        """The cell of the inverter that a member is."""
        return self.series.comno(next(name for name, one in self.known.items() if one == member))

    def members(self) -> Mapping[str, str]:
        """What each field is for the blocks; `words[3]` is the user's own business."""
        numbers = {self.series.comno(name).number: member for name, member in self.known.items()}
        found: dict[str, str] = {}
        place = 0
        for field in self.assembly.fields:
            if field.parameter is None:
                member = _MEMBERS[field.name]
                found[field.name] = member if self.is_output else _RESPONSE.get(member, member)
                continue
            place += 1
            member = numbers.get(self.chosen(field) or 0, "")
            taken = member in found.values()
            found[field.name] = f"words[{place}]" if taken or not member else member
        return found


def sides_of(drive: DeviceNetDrive, catalog: Catalog) -> tuple[Side, Side]:
    """Its outputs and its inputs."""
    entry, series = catalog.devicenet_gateway(drive.type), catalog.drive(drive.series)
    pair = pair_of(drive, entry)
    return (
        Side(drive, entry, series, pair.output, entry.commands, _COMMANDS),
        Side(drive, entry, series, pair.input, entry.monitors, _MONITORS),
    )


def wrong_choices(drive: DeviceNetDrive, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5019: words that a drive needs are not chosen, or one is chosen twice."""
    for side in sides_of(drive, catalog):
        yield from _missing(side)
        if side.is_output:
            yield from _twice(side)


def _missing(side: Side) -> Iterator[Diagnostic]:
    found = side.members().values()
    choosing = [field.parameter for field in side.assembly.fields if field.parameter is not None]
    for member in dict.fromkeys(side.known.values()):
        if member not in _NEEDED or member in found:
            continue
        cell = side.cell(member)
        code = next(item.code for item in side.selections if item.comno == cell.number)
        yield Diagnostic(
            "FB5019",
            f"nothing of assembly {side.assembly.instance} of '{side.drive.name}' carries "
            f"{cell.hex} ({cell.title})",
            side.drive.span_of("assemblies"),
            f"add one of them to settings: {', '.join(choosing)}, with the value {code}; set it at "
            "the inverter, too",
        )


def _twice(side: Side) -> Iterator[Diagnostic]:
    """The later word would undo what the first one says."""
    first: dict[int, str] = {}
    for field in side.assembly.fields:
        number = side.chosen(field)
        if number is None or field.parameter is None:
            continue
        earlier = first.setdefault(number, field.parameter)
        if earlier != field.parameter:
            yield Diagnostic(
                "FB5019",
                f"two words of assembly {side.assembly.instance} of '{side.drive.name}' carry "
                f"{number:04X}",
                side.drive.item_span_of("settings", field.parameter),
                f"{earlier} chooses it already: the second would undo what the first one says",
            )
