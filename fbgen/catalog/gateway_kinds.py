"""The kinds of gateways: which model reads a gateway's file, and the schema of both together."""

from collections.abc import Mapping
from types import MappingProxyType

from pydantic import RootModel

from fbgen.catalog.gateways import Gateway
from fbgen.catalog.process_data_gateways import ProcessDataGateway
from fbgen.catalog.telegram_gateways import TelegramGateway
from fbgen.catalog.yaml_nodes import Document, YamlMapping
from fbgen.diagnostics import error
from fbgen.nearest import nearest

GATEWAY_KINDS: Mapping[str, type[Gateway]] = MappingProxyType(
    {"telegrams": TelegramGateway, "process_data": ProcessDataGateway}
)
"""What `kind` says -> model of the file."""


class GatewayFile(RootModel[TelegramGateway | ProcessDataGateway]):
    """A gateway's file of whatever kind."""


def gateway_kind(document: Document) -> type[Gateway]:
    """The model for a gateway's file; `telegrams` where it says no kind. Raises FB1007."""
    data = document.data
    if not isinstance(data, YamlMapping) or "kind" not in data:
        return TelegramGateway
    kind = data["kind"]
    if isinstance(kind, str) and kind in GATEWAY_KINDS:
        return GATEWAY_KINDS[kind]
    raise error(
        "FB1007",
        f"found '{kind}', expected one of: {', '.join(GATEWAY_KINDS)}",
        data.value_spans["kind"],
        help=nearest(str(kind), GATEWAY_KINDS),
    )
