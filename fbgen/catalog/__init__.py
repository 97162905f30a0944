"""What the devices are: the catalogue as a validated, frozen model."""

from fbgen.catalog.catalog import (
    OWN_SEQUENCES,
    Catalog,
    Replacement,
    load_catalog,
    with_own_sequences,
)
from fbgen.catalog.communication import (
    Blocks,
    Communication,
    InterDrive,
    ModbusAccess,
    ModbusService,
    SerialPort,
    ToshibaService,
)
from fbgen.catalog.connectors import Connector, Pin
from fbgen.catalog.devicenet_gateways import Assembly, AssemblyPair, DeviceNetGateway
from fbgen.catalog.drives import ComNo, Drive, TerminalFunction, Trip
from fbgen.catalog.gateways import Gateway, Led, LedState
from fbgen.catalog.layouts import (
    AccessWay,
    CyclicField,
    Layout,
    PlacedIdentifier,
    access_ways,
    covers_all,
    placed_identifiers,
)
from fbgen.catalog.located import Located, origin, validate
from fbgen.catalog.manuals import Finding, Manual
from fbgen.catalog.modbus_protocol import ModbusException, ModbusFunction, ModbusProtocol
from fbgen.catalog.options import Option, OptionValue
from fbgen.catalog.process_data_gateways import ParameterChannel, ProcessDataGateway
from fbgen.catalog.profibus_gateways import ProfibusGateway, PublishedProfibus
from fbgen.catalog.protocols import Command, ErrorCode, Frame, Protocol, ToshibaProtocol
from fbgen.catalog.sequences import Parameter, Result, Sequence, Telegram
from fbgen.catalog.settings import Setting, Switch
from fbgen.catalog.steps import (
    BranchStep,
    CheckStep,
    Condition,
    Delay,
    DelayStep,
    ReadStep,
    RepeatStep,
    SettingsStep,
    Step,
    WaitStep,
    WriteStep,
)
from fbgen.catalog.telegram_gateways import StatusCode, TelegramGateway
from fbgen.catalog.values import parse_word
from fbgen.catalog.words import BitField, DecodedField, Word, WordExample
from fbgen.catalog.yaml_nodes import Document, load_yaml

__all__ = [
    "AccessWay",
    "Assembly",
    "AssemblyPair",
    "BitField",
    "Blocks",
    "Catalog",
    "ComNo",
    "Command",
    "Communication",
    "CyclicField",
    "DecodedField",
    "Delay",
    "DelayStep",
    "BranchStep",
    "CheckStep",
    "Condition",
    "Connector",
    "RepeatStep",
    "WaitStep",
    "Document",
    "DeviceNetGateway",
    "Drive",
    "ErrorCode",
    "Frame",
    "Gateway",
    "InterDrive",
    "Layout",
    "Led",
    "LedState",
    "Located",
    "OWN_SEQUENCES",
    "Finding",
    "Manual",
    "ModbusAccess",
    "ModbusException",
    "ModbusFunction",
    "ModbusProtocol",
    "ModbusService",
    "Option",
    "OptionValue",
    "Parameter",
    "ParameterChannel",
    "Pin",
    "PlacedIdentifier",
    "ProcessDataGateway",
    "Protocol",
    "ProfibusGateway",
    "PublishedProfibus",
    "ReadStep",
    "Replacement",
    "Result",
    "Sequence",
    "SerialPort",
    "Setting",
    "SettingsStep",
    "StatusCode",
    "Step",
    "Switch",
    "Telegram",
    "TelegramGateway",
    "TerminalFunction",
    "ToshibaProtocol",
    "ToshibaService",
    "Trip",
    "Word",
    "WordExample",
    "WriteStep",
    "access_ways",
    "covers_all",
    "load_catalog",
    "load_yaml",
    "origin",
    "parse_word",
    "placed_identifiers",
    "validate",
    "with_own_sequences",
]
