"""The kinds of protocols: which model reads a protocol's file."""

from collections.abc import Mapping
from types import MappingProxyType

from fbgen.catalog.modbus_protocol import ModbusProtocol
from fbgen.catalog.protocols import Protocol, ToshibaProtocol

PROTOCOL_KINDS: Mapping[str, type[Protocol]] = MappingProxyType(
    {"toshiba": ToshibaProtocol, "modbus": ModbusProtocol}
)
"""What `kind` says -> model of the file; the first where it says none."""
