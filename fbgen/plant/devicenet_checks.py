"""What can be wrong with a DeviceNet network although every single field is right."""

from collections.abc import Iterator
from math import ceil
from typing import TYPE_CHECKING

from fbgen.catalog import Catalog, DeviceNetGateway
from fbgen.catalog.devicenet_gateways import AssemblyPair
from fbgen.diagnostics import Diagnostic, Note
from fbgen.nearest import nearest
from fbgen.plant.drive_checks import chosen_options, frequencies, unknown_series
from fbgen.wire.devicenet_fragments import io_frames

if TYPE_CHECKING:
    from fbgen.plant.devicenet import DeviceNetDrive, DeviceNetNetwork

ACTIVE_LENGTH = 8
"""A bit for each of 64 MAC IDs."""
_PERIODS = 4
"""Expected packet rates without a message after which a connection is lost."""


def macs_twice(item: "DeviceNetNetwork") -> Iterator[Diagnostic]:
    """FB2053: a MAC ID that two nodes have."""
    first: dict[int, DeviceNetNetwork | DeviceNetDrive] = {item.mac: item}
    for drive in item.drives:
        earlier = first.setdefault(drive.mac, drive)
        if earlier is not drive:
            place, who = earlier.span_of("mac"), "first here"
            if "mac" not in earlier.model_fields_set:
                place, who = earlier.span, f"the scanner has {earlier.mac} if nothing is said"
            yield Diagnostic(
                "FB2053",
                f"MAC ID {drive.mac} is given twice on this network",
                drive.span_of("mac"),
                "every node of a network, the scanner too, needs its own",
                (Note(who, place),),
            )


def network(item: "DeviceNetNetwork", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2053: a rate that an option cannot be set to; scans that are too rare, or too many."""
    for entry in {drive.type: option_of(drive, catalog) for drive in item.drives}.values():
        if entry is not None and item.rate not in entry.devicenet.baud_rates.values():
            rates = ", ".join(str(rate) for rate in entry.devicenet.baud_rates.values())
            message = f"a {entry.id} cannot be set to {item.rate} kbit/s"
            yield Diagnostic("FB2053", message, item.span_of("rate"), f"use {rates}")
            return
    for drive in item.drives:
        waits_ms = _PERIODS * drive.packet_rate_ms
        if waits_ms <= item.scan_ms:
            yield Diagnostic(
                "FB2053",
                f"'{drive.name}' takes its connection for lost {waits_ms} ms after a poll, and is "
                f"polled every {item.scan_ms} ms",
                drive.span_of("packet_rate_ms"),
                f"use {item.scan_ms // _PERIODS + 1} ms at least, or scan more often",
            )
    needed_ms = _scan_bits(item, catalog) / item.rate
    if needed_ms > item.scan_ms:
        place = "scan_ms" if "scan_ms" in item.model_fields_set else "drives"
        yield Diagnostic(
            "FB2053",
            f"the frames of one scan take {needed_ms:.1f} ms at {item.rate} kbit/s, and a scan "
            f"begins every {item.scan_ms} ms",
            item.span_of(place),
            f"let scan_ms: be {ceil(needed_ms)} at least, better twice that",
        )


def _scan_bits(item: "DeviceNetNetwork", catalog: Catalog) -> int:
    """Bits on the cable in one scan: outputs and inputs of every drive."""
    found = 0
    for drive in item.drives:
        entry = option_of(drive, catalog)
        pair = None if entry is None else assemblies_of(drive, entry)
        if pair is not None:
            for size in (pair.output.length, pair.input.length):
                found += sum(frame.bits for frame in io_frames(0, bytes(size), size))
    return found


def option_of(item: "DeviceNetDrive", catalog: Catalog) -> DeviceNetGateway | None:
    """The option in the catalogue, None if there is none of this id."""
    entry = catalog.gateways.get(item.type)
    return entry if isinstance(entry, DeviceNetGateway) else None


def instances(pair: AssemblyPair) -> str:
    """How a plant file names a pair of assemblies."""
    return f"{pair.output.instance}/{pair.input.instance}"


def assemblies_of(item: "DeviceNetDrive", entry: DeviceNetGateway) -> AssemblyPair | None:
    """The pair that the drive exchanges, None if the option has none of these instances."""
    return {instances(pair): pair for pair in entry.assemblies}.get(item.assemblies)


def drive(item: "DeviceNetDrive", catalog: Catalog) -> Iterator[Diagnostic]:
    """FB2001 type, FB2003 options and settings, FB2008 and FB2009 series, FB2010 maximum frequency,
    FB2053 MAC ID and assemblies."""
    series = catalog.drives.get(item.series)
    if series is None:
        yield unknown_series(item, item.series, catalog)
    else:
        yield from frequencies(item, item.parameters, item.max_frequency_hz, series)
    entry = option_of(item, catalog)
    if entry is None:
        known = [one.id for one in catalog.gateways.values() if isinstance(one, DeviceNetGateway)]
        message = f"there is no DeviceNet option '{item.type}'"
        yield Diagnostic("FB2001", message, item.span_of("type"), nearest(item.type, known))
        return
    if series is not None and series.id not in entry.series:
        yield Diagnostic(
            "FB2008",
            f"a {entry.id} does not fit into {series.id}",
            item.span_of("series"),
            f"it fits into {', '.join(entry.series)}",
        )
    low, high = entry.devicenet.minimum_mac, entry.devicenet.maximum_mac
    if not low <= item.mac <= high:
        message = f"a {entry.id} cannot have the MAC ID {item.mac}"
        yield Diagnostic("FB2053", message, item.span_of("mac"), f"use {low} to {high}")
    if assemblies_of(item, entry) is None:
        named = item.assemblies.split("/")
        fit = [instances(pair) for pair in entry.assemblies]
        near = [pair for pair in fit if set(pair.split("/")) & set(named)]
        yield Diagnostic(
            "FB2053",
            f"a {entry.id} has no assemblies '{item.assemblies}'",
            item.span_of("assemblies"),
            f"write output and input: {' or '.join(near) if near else ', '.join(fit)}",
        )
    yield from _settings(item, entry)
    of_series = () if series is None else series.options
    yield from chosen_options(item, item.options, (*entry.options, *of_series), entry.id)


def _settings(item: "DeviceNetDrive", entry: DeviceNetGateway) -> Iterator[Diagnostic]:
    known = {one.name: one for one in entry.parameters if one.name != entry.assembly_parameter}
    for name, value in item.settings.items():
        place = item.item_span_of("settings", name)
        if name not in known:
            shown = {one.display: one.name for one in known.values()}
            help_text = nearest(name, known)
            if name in shown:
                help_text = f"{name} is '{shown[name]}'"
            if name == entry.assembly_parameter:
                help_text = "assemblies: says it already; leave it out"
            message = f"{entry.id} has no parameter '{name}' to be set here"
            yield Diagnostic("FB2003", message, place, help_text)
        elif not known[name].minimum <= value <= known[name].maximum:
            low, high = known[name].minimum, known[name].maximum
            message = f"{value} is no value of {known[name].display} ({name})"
            yield Diagnostic("FB2003", message, place, f"use {low} to {high}")
