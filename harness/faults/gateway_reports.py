"""A gateway reports a status code without a cause in the plant, until the next valid telegram.

Codes: HMS Anybus Communicator EtherNet/IP manual HMSI-27-314, status codes in Generic Data Mode,
printed page 105.
"""

from functools import partial
from typing import Literal

from fbgen.catalog import TelegramGateway
from harness.faults.fault import Fault, FaultSettings, FaultType, Target
from harness.faults.holding import Event
from harness.installation import Installation


class ReportSettings(FaultSettings):
    """`code` is the catalogue's name of a status code."""

    code: Literal["frame_error", "offline_timeout", "buffer_overrun", "other_error"] = "other_error"


def _make(plant: Installation, on: str, settings: FaultSettings) -> Fault:
    assert isinstance(settings, ReportSettings)
    entry = next(entry for entry in plant.plan.gateways if entry.name == on)
    code = _code(plant.catalog.telegram_gateway(entry.type), settings.code)
    return Event(partial(plant.gateways[on].report, code))


def _code(gateway: TelegramGateway, name: str) -> int:
    return next(entry.code for entry in gateway.status_codes if entry.name == name)


FAULT = FaultType(
    "gateway_reports",
    "A gateway reports a status code of its own until a valid telegram",
    Target.TELEGRAMS,
    _make,
    ReportSettings,
)
