"""The user's plant: its PLC, gateways, drives and sequences."""

from collections.abc import Iterable
from typing import Annotated, Any, Literal, TypeAlias

from pydantic import ConfigDict, Field, SerializerFunctionWrapHandler, model_serializer

from fbgen.catalog import AccessWay, Catalog, Located, OptionValue
from fbgen.catalog.scalars import Flag, Octets, Real, Text, Whole
from fbgen.diagnostics import Diagnostic
from fbgen.plant import checks
from fbgen.plant.devicenet import DeviceNetDrive, DeviceNetNetwork
from fbgen.plant.drive import PlantDrive
from fbgen.plant.families import (
    FAMILIES,
    LANGUAGES,
    Family,
    FileLayout,
    PlantDialect,
    PlcFamily,
)
from fbgen.plant.gsd_file import GsdFile
from fbgen.plant.parameters import LineParameters
from fbgen.plant.prefix import USUAL_PREFIX
from fbgen.plant.serial_line import ModbusFrames, SerialLine

HIGHEST_BLOCK = 7999
"""The highest number of a block that an S7-300 or S7-400 takes; small CPUs take fewer."""


_OF_GSD = ("gsd", "modules")
_WHERE_THERE = ("devicenet", "modbus_frames")

TextLanguage = Literal["en", "de"]
"""The language of comments, titles and trip texts."""


def layout_or_gsd(schema: dict[str, Any]) -> None:
    """In the JSON Schema a gateway says its layout, or which GSD file does."""
    schema["required"].remove("layout")
    schema["anyOf"] = [{"required": ["layout"]}, {"required": ["gsd"]}]


class PlantGateway(Located):
    """One gateway with the drives on its line.

    `dp_master` is the number of the DP master system that it belongs to: a plant with more gateways
    than a PROFIBUS has addresses has several.
    `input_address` and `output_address` are the first bytes of its data in the PLC's input and
    output area; identifiers follow each other without a gap. `hardware_identifier` is what
    DPRD_DAT and DPWR_DAT of S7-1200 and S7-1500 take. `status_poll` reads the trip code and the
    status of every drive in turn while no command waits. `gsd` is the GSD file of the device, from
    the folder of the plant file, `modules` what is plugged of it; layout and identifiers then come
    from there. `identifiers` are the configuration identifiers of the module where the catalogue's
    are an assumption and there is no GSD file. `eeprom` lets the program write parameters into the
    EEPROM of the drives. `diagnosis_address` is the LADDR under which an S7 reads the diagnosis of
    the station; without one nothing reads it.
    """

    model_config = ConfigDict(json_schema_extra=layout_or_gsd)

    name: str
    title: Text | None = None
    type: str
    gsd: GsdFile | None = None
    modules: tuple[str, ...] = ()
    layout: str
    identifiers: Octets | None = None
    profibus_address: Whole
    dp_master: Annotated[Whole, Field(ge=1, le=32)] = 1
    access: AccessWay
    input_address: Whole | None = None
    output_address: Whole | None = None
    hardware_identifier: Annotated[Whole, Field(ge=1, le=65535)] | None = None
    diagnosis_address: Annotated[Whole, Field(ge=1, le=65535)] | None = None
    status_poll: Flag = True
    eeprom: Flag = False
    parameters: LineParameters = Field(default_factory=LineParameters)
    options: dict[str, OptionValue] = Field(default_factory=dict)
    drives: tuple[PlantDrive, ...] = Field(min_length=1)

    @model_serializer(mode="wrap")
    def _without_no_gsd(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """A GSD file counts for the hash of the plant where there is one."""
        data: dict[str, Any] = handler(self)
        return {key: data[key] for key in data if key not in _OF_GSD or data[key]}

    def problems(self) -> Iterable[Diagnostic]:
        """FB2006: one INV-NO or one channel for two drives."""
        return checks.places_of_drives(self)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about this gateway."""
        assert isinstance(known, Catalog)
        return checks.gateway(self, known)


PlantUnit: TypeAlias = PlantGateway | SerialLine | DeviceNetNetwork
"""What drives are connected to; a block is generated for each."""


class BlockNumbers(Located):
    """The numbers that FBs, FCs, DBs and UDTs of dialect step7 may have, each kind from `first`."""

    first: Annotated[Whole, Field(ge=1, le=HIGHEST_BLOCK)] = 200
    last: Annotated[Whole, Field(ge=1, le=HIGHEST_BLOCK)] = 399

    def problems(self) -> Iterable[Diagnostic]:
        """FB2020: the range ends before it begins."""
        return checks.block_numbers(self)


class Plant(Located):
    """A plant file. Sequences are ids of the catalogue, generated for every drive they fit.

    `cpu` is the CPU of the family, for its work memory. `poll_limit_ms` is how long reading the
    state of all drives of a gateway may take. `language` is that of comments and texts. `prefix` is
    how the names of blocks begin; `files` says whether each stands in a file of its own, None what
    is usual for the dialect. `error_obs` says whether the organization blocks for errors that an
    S7-300 or S7-400 needs are generated, or whether the project has its own. `serial` are lines at
    communication modules of the PLC itself. `modbus_frames` says for all lines with MODBUS whether
    Modbus_Master of the CPU sends and receives (instruction), or the blocks build the frames
    themselves (own); without it Modbus_Master where the PLC has it. `devicenet` are networks at
    scanners of the PLC.
    """

    version: Literal[1]
    name: str
    title: Text | None = None
    dialect: PlantDialect
    plc: PlcFamily
    cpu: str | None = None
    cycle_time_ms: Annotated[Real, Field(gt=0, le=6000)] = 10
    poll_limit_ms: Annotated[Real, Field(gt=0, le=3_600_000)] = 2000
    prefix: str = USUAL_PREFIX
    language: TextLanguage = "en"
    files: FileLayout | None = None
    block_numbers: BlockNumbers = Field(default_factory=BlockNumbers)
    error_obs: Literal["generate", "mine"] = "generate"
    sequences: tuple[str, ...] = ()
    gateways: tuple[PlantGateway, ...] = ()
    serial: tuple[SerialLine, ...] = ()
    modbus_frames: ModbusFrames | None = None
    devicenet: tuple[DeviceNetNetwork, ...] = ()

    @model_serializer(mode="wrap")
    def _without_what_is_not_there(self, handler: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """DeviceNet and a choice of frames count for the hash of the plant where there are some."""
        data: dict[str, Any] = handler(self)
        return {key: data[key] for key in data if key not in _WHERE_THERE or data[key]}

    @property
    def series_of_drives(self) -> dict[str, str]:
        """The series of every drive, by the drive's name."""
        return {drive.name: drive.series for drive in self.drives}

    @property
    def devicenet_drives(self) -> tuple[DeviceNetDrive, ...]:
        """All drives on DeviceNet, in the order of the file."""
        return tuple(drive for network in self.devicenet for drive in network.drives)

    @property
    def gateway_types(self) -> frozenset[str]:
        """The ids in the catalogue of its gateways and DeviceNet options."""
        options = (drive.type for drive in self.devicenet_drives)
        return frozenset((*(gateway.type for gateway in self.gateways), *options))

    @property
    def family(self) -> Family:
        """What the PLC can do."""
        return FAMILIES[self.plc]

    @property
    def code_dialect(self) -> str:
        """The dialect of the language in which its text is written."""
        return LANGUAGES[self.dialect]

    @property
    def modbus_by_instruction(self) -> bool:
        """Whether the lines with MODBUS, where there are some, are those of Modbus_Master."""
        if not any(line.family == "modbus" for line in self.serial):
            return False
        return self.family.modbus_master and self.modbus_frames != "own"

    @property
    def has_error_blocks(self) -> bool:
        """Whether OB82, OB85, OB86 and OB122 are generated: they note what slaves do."""
        return self.family.classic and self.error_obs == "generate" and bool(self.gateways)

    @property
    def units(self) -> tuple[PlantUnit, ...]:
        """Everything that drives are connected to."""
        return (*self.gateways, *self.serial, *self.devicenet)

    @property
    def drives(self) -> tuple[PlantDrive | DeviceNetDrive, ...]:
        """All drives of all gateways, lines and networks."""
        return tuple(drive for unit in self.units for drive in unit.drives)

    @property
    def gateways_and_lines(self) -> tuple[PlantGateway | SerialLine, ...]:
        """All units but DeviceNet networks."""
        return (*self.gateways, *self.serial)

    @property
    def numbered_drives(self) -> tuple[PlantDrive, ...]:
        """Those that get telegrams, by their inverter numbers."""
        drives = (drive for unit in self.gateways_and_lines for drive in unit.drives)
        return tuple(drive for drive in drives if drive.channel is None)

    def problems(self) -> Iterable[Diagnostic]:
        """What the parts of the plant say about each other."""
        return checks.plant(self)

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What the catalogue says about the plant as a whole."""
        assert isinstance(known, Catalog)
        yield from checks.sequences(self, known)
        yield from checks.addresses(self, known)
