"""The kinds of protocols: which model reads a protocol's file, and the schema of both together."""

from collections.abc import Mapping
from types import MappingProxyType

from pydantic import RootModel

from fbgen.catalog.modbus_protocol import ModbusProtocol
from fbgen.catalog.protocols import Protocol, ToshibaProtocol

PROTOCOL_KINDS: Mapping[str, type[Protocol]] = MappingProxyType(
    {"toshiba": ToshibaProtocol, "modbus": ModbusProtocol}
)
"""What `kind` says -> model of the file; the first where it says none."""


class ProtocolFile(RootModel[ToshibaProtocol | ModbusProtocol]):
    """A protocol's file of whatever kind."""
