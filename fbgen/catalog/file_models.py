"""Files of whatever kind as one model each, for their JSON Schemas.

Apart from the models themselves, because to make these takes as long as to read all gateways.
"""

from pydantic import RootModel

from fbgen.catalog.devicenet_gateways import DeviceNetGateway
from fbgen.catalog.modbus_protocol import ModbusProtocol
from fbgen.catalog.process_data_gateways import ProcessDataGateway
from fbgen.catalog.protocols import ToshibaProtocol
from fbgen.catalog.telegram_gateways import TelegramGateway


class GatewayFile(RootModel[TelegramGateway | ProcessDataGateway | DeviceNetGateway]):
    """A gateway's file of whatever kind."""


class ProtocolFile(RootModel[ToshibaProtocol | ModbusProtocol]):
    """A protocol's file of whatever kind."""
