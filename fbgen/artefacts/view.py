"""What every list is made from: the plant with its catalogue entries and the program of it."""

from collections.abc import Iterator
from functools import cached_property

from fbgen.artefacts.variables import PlcVariable, variables
from fbgen.blocks.alarms import LINE_ALARMS, Alarm, drive_alarms, that_can_come
from fbgen.blocks.dev_alarms import DEV_DRIVE_ALARMS, NETWORK_ALARMS
from fbgen.blocks.pbdp_alarms import GATEWAY_ALARMS, PBDP_DRIVE_ALARMS
from fbgen.blocks.serial_alarms import SERIAL_ALARMS
from fbgen.blocks.texts import ENGLISH, Texts
from fbgen.catalog import Catalog, Layout, ProcessDataGateway
from fbgen.dataclass import dataclass
from fbgen.emit.generated import CanonicalProgram, GeneratedSet
from fbgen.emit.symbol_table import numbers_of
from fbgen.plant import (
    DeviceNetDrive,
    DeviceNetNetwork,
    Plant,
    PlantDrive,
    PlantGateway,
    PlantUnit,
    SerialLine,
    layout_of,
    with_prefix,
)

_SEPARATOR = "\n"
"""Stands between the names of a path, and in none of them."""


@dataclass(frozen=True)
class PlantLists:
    """A plant, what was generated for it, and the language of texts for people.

    The texts of the catalogue are in that language already; `texts` has those that are no fields.
    """

    plant: Plant
    catalog: Catalog
    generated: GeneratedSet
    language: str
    texts: Texts = ENGLISH

    @property
    def canonical(self) -> CanonicalProgram:
        """The program before it got its dialect."""
        assert self.generated.canonical is not None, "generate() keeps it"
        return self.generated.canonical

    def name(self, usual: str) -> str:
        """A block of the plant by its usual name."""
        return with_prefix(usual, self.plant.prefix)

    def is_process_data(self, gateway: PlantUnit) -> bool:
        """Whether it is a gateway for process data: no other gateway, no line, no network."""
        if not isinstance(gateway, PlantGateway):
            return False
        return isinstance(self.catalog.profibus_gateway(gateway.type), ProcessDataGateway)

    @cached_property
    def on_lines(self) -> tuple[PlantGateway, ...]:
        """The gateways with a line."""
        return tuple(item for item in self.plant.gateways if not self.is_process_data(item))

    @cached_property
    def at_channels(self) -> tuple[PlantGateway, ...]:
        """The gateways for process data."""
        return tuple(item for item in self.plant.gateways if self.is_process_data(item))

    def layout(self, gateway: PlantGateway) -> Layout:
        """The module that it is configured with."""
        return layout_of(gateway, self.catalog.profibus_gateway(gateway.type))

    def file_name(self, part: str) -> str:
        """The name of a list: `conveyor_alarms.csv`."""
        return f"{self.plant.name}_{part}"

    def in_words(self, english: str, german: str) -> str:
        """A text in the language of the plant."""
        return german if self.language == "de" else english

    @cached_property
    def variables(self) -> tuple[PlcVariable, ...]:
        """Commands and states of all drives and lines. Sequences are left out: they are for the
        program of the plant."""
        found = self.canonical
        sequences = [self.name(f"typeTos_{name}") for name in self.plant.sequences]
        return variables(found.program, found.units, self.name("TOS_Plant"), sequences)

    @cached_property
    def numbers(self) -> dict[str, tuple[str, int]]:
        """Kind and number of each unit where the dialect numbers them: `TOS_Main`: FC, 207."""
        if self.plant.dialect != "step7":
            return {}
        units = [unit for file in self.canonical.units for unit in file.units]
        return numbers_of(units, self.plant)

    def address(self, variable: PlcVariable) -> str:
        """The absolute address where there is one, else ""."""
        numbered = self.numbers.get(variable.block)
        return variable.address(numbered[1]) if numbered else ""

    def variable(self, *path: str) -> PlcVariable:
        """The variable at this path below the data block."""
        return self._by_path[_SEPARATOR.join(path).casefold()]

    @cached_property
    def _by_path(self) -> dict[str, PlcVariable]:
        return {_SEPARATOR.join(one.path).casefold(): one for one in self.variables}

    @cached_property
    def tag_names(self) -> dict[PlcVariable, str]:
        """A name without dots for each variable, as an HMI wants it; each only once."""
        given: dict[PlcVariable, str] = {}
        taken: set[str] = set()
        for variable in self.variables:
            stem = name = variable.name.replace(".", "_")
            count = 1
            while name.casefold() in taken:
                count += 1
                name = f"{stem}_{count}"
            taken.add(name.casefold())
            given[variable] = name
        return given

    def alarms(self) -> Iterator["PlacedAlarm"]:
        """All alarms of all lines and drives, without those that can never come."""
        for gateway in self.plant.units:
            of_line: tuple[Alarm, ...] = LINE_ALARMS
            of_drives = drive_alarms(self.plant.sequences)
            if isinstance(gateway, SerialLine):
                of_line = SERIAL_ALARMS
            elif isinstance(gateway, DeviceNetNetwork):
                of_line, of_drives = NETWORK_ALARMS, DEV_DRIVE_ALARMS
            elif self.is_process_data(gateway):
                of_line, of_drives = GATEWAY_ALARMS, PBDP_DRIVE_ALARMS
            word = self.variable(gateway.name, "line", "alarms")
            for alarm in that_can_come(of_line, [gateway]):
                yield PlacedAlarm(alarm, word, gateway)
            for drive in gateway.drives:
                word = self.variable(gateway.name, drive.name, "alarms")
                for alarm in that_can_come(of_drives, [gateway]):
                    yield PlacedAlarm(alarm, word, gateway, drive)


def place_in(drive: PlantDrive | DeviceNetDrive) -> str:
    """What a drive is found by: its inverter number, channel or MAC ID."""
    if isinstance(drive, DeviceNetDrive):
        return f"MAC ID {drive.mac}"
    return drive.channel or str(drive.inv_no)


@dataclass(frozen=True, slots=True)
class PlacedAlarm:
    """An alarm of a line, or of one of its drives, and the word in which its bit lies."""

    alarm: Alarm
    word: PlcVariable
    gateway: PlantUnit
    drive: PlantDrive | DeviceNetDrive | None = None

    @property
    def name(self) -> str:
        """The owner and the cause: `gw1_pump_tripped`."""
        owner = self.drive.name if self.drive else "line"
        return f"{self.gateway.name}_{owner}_{self.alarm.name}"

    def text(self, language: str) -> str:
        """What the operator reads, with the owner's title, or its name, in front."""
        owner = self.drive or self.gateway
        return f"{' '.join((owner.title or owner.name).split())}: {self.alarm.text(language)}"
