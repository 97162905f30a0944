"""The kinds of gateways: which model reads a gateway's file."""

from collections.abc import Mapping
from types import MappingProxyType

from fbgen.catalog.devicenet_gateways import DeviceNetGateway
from fbgen.catalog.gateways import Gateway
from fbgen.catalog.process_data_gateways import ProcessDataGateway
from fbgen.catalog.telegram_gateways import TelegramGateway

GATEWAY_KINDS: Mapping[str, type[Gateway]] = MappingProxyType(
    {
        "telegrams": TelegramGateway,
        "process_data": ProcessDataGateway,
        "devicenet": DeviceNetGateway,
    }
)
"""What `kind` says -> model of the file; the first where it says none."""
