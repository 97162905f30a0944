"""How drives are connected to their gateway: by numbers on a line, or each at a channel of its own.

What one kind of gateway has and the other has not is told here, so that nothing in a plant file is
without effect.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from fbgen.catalog import ProcessDataGateway, ToshibaProtocol
from fbgen.diagnostics import Diagnostic
from fbgen.plant.modules import layout_of, why_not

if TYPE_CHECKING:
    from fbgen.plant.plant import PlantGateway

_ONLY_PROCESS_DATA = ("identifiers", "eeprom", "diagnosis_address")
"""Keys of a gateway that one for telegrams does not have."""


def telegram_gateway(item: "PlantGateway", protocol: ToshibaProtocol) -> Iterator[Diagnostic]:
    """FB2024 no INV-NO, or a channel; FB2007 out of range; FB2026 keys of other gateways."""
    numbers = protocol.inv_numbers["binary"]
    for member in item.drives:
        if member.channel is not None:
            yield Diagnostic(
                "FB2024",
                f"a {item.type} has no channels",
                member.span_of("channel"),
                "give the drive its number on the line instead: inv_no",
            )
        elif "inv_no" not in member.model_fields_set:
            yield Diagnostic(
                "FB2024",
                f"the drive '{member.name}' has no number on the line of its gateway",
                member.span,
                "add inv_no: as parameter F802 of the drive has it",
            )
        elif not numbers.minimum <= member.inv_no <= numbers.maximum:
            yield Diagnostic(
                "FB2007",
                f"no inverter can have the INV-NO {member.inv_no}",
                member.span_of("inv_no"),
                f"use {numbers.minimum} to {numbers.maximum}; FF (255) addresses all inverters",
            )
    for key in _ONLY_PROCESS_DATA:
        if key in item.model_fields_set:
            yield Diagnostic(
                "FB2026",
                f"{key} means nothing for a {item.type}",
                item.span_of(key),
                "leave it out",
            )


def _with_channel(entry: ProcessDataGateway, channel: str) -> str:
    """Which layouts have it; empty if none."""
    found = [
        one.name
        for one in entry.layouts
        if channel in {each.name.upper() for each in entry.channels_of(one)}
    ]
    return f"it is in the layout{'s' if found[1:] else ''} {', '.join(found)}" if found else ""


def process_data_gateway(item: "PlantGateway", entry: ProcessDataGateway) -> Iterator[Diagnostic]:
    """FB2024 channels; FB2025 identifiers; FB2026 keys of gateways for telegrams."""
    layout = next((one for one in entry.layouts if one.name == item.layout), None)
    channels = [one.name.upper() for one in entry.channels_of(layout)] if layout else ["A", "B"]
    for member in item.drives:
        if "inv_no" in member.model_fields_set:
            yield Diagnostic(
                "FB2024",
                f"a {item.type} does not know its drives by numbers",
                member.span_of("inv_no"),
                f"give the drive its channel instead: channel: {' or '.join(channels)}",
            )
        elif member.channel is None:
            yield Diagnostic(
                "FB2024",
                f"the drive '{member.name}' has no channel at its gateway",
                member.span,
                f"add channel: {' or '.join(channels)}",
            )
        elif member.channel not in channels:
            yield Diagnostic(
                "FB2024",
                f"layout '{item.layout}' has no channel {member.channel}",
                member.span_of("channel"),
                _with_channel(entry, member.channel) or f"it has {' and '.join(channels)}",
            )
    if layout is not None:
        yield from _module(item, entry)
    if "retries" in item.parameters.model_fields_set:
        yield Diagnostic(
            "FB2026",
            f"retries means nothing for a {item.type}: its jobs are never repeated",
            item.parameters.span_of("retries"),
            "leave it out",
        )
    for member in item.drives:
        if "error_pause_ms" in member.parameters.model_fields_set:
            yield Diagnostic(
                "FB2026",
                f"error_pause_ms means nothing behind a {item.type}, which sends all the time",
                member.parameters.span_of("error_pause_ms"),
                "leave it out",
            )


def _module(item: "PlantGateway", entry: ProcessDataGateway) -> Iterator[Diagnostic]:
    if item.identifiers is not None and (
        reason := why_not(item.identifiers, entry.layout(item.layout))
    ):
        yield Diagnostic(
            "FB2025",
            f"the identifiers {item.identifiers.hex(' ').upper()} do not fit: {reason}",
            item.span_of("identifiers"),
            "copy them from the line Module of the GSD file, for the module of this size",
        )
    layout = layout_of(item, entry)
    if item.eeprom and not entry.has_parameter_channel(layout):
        yield Diagnostic(
            "FB2026",
            f"eeprom means nothing with layout '{layout.name}', which has no parameter channel",
            item.span_of("eeprom"),
            "leave it out, or choose a module with a parameter channel",
        )
