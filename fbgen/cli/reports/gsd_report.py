"""What `fbgen gsd` prints, as text and as JSON."""

import json
from collections.abc import Iterator, Sequence
from pathlib import Path

from fbgen.catalog import AccessWay, Catalog, PublishedProfibus, access_ways, placed_identifiers
from fbgen.cli.table import indented, table
from fbgen.dataclass import dataclass
from fbgen.plant import FAMILIES, OLDER_CPUS_MOVE, move_of, not_a_way, refusal
from fbgen.wire.gsd import Configuration, GsdModule, GsdStation
from fbgen.wire.profibus import Extent, Slot, slot_table

_WAYS: tuple[AccessWay, ...] = ("per_identifier", "process_image", "dpxx_dat")


@dataclass(frozen=True, slots=True)
class GsdReport:
    """A file, its station, the modules that are plugged (None: nothing says which), where the data
    begin in the PLC, and the catalogue to compare with."""

    file: Path
    station: GsdStation
    chosen: Configuration | None
    address: int
    catalog: Catalog


@dataclass(frozen=True, slots=True)
class _Reached:
    """How PLCs of these families reach the data by an access way; `reason`: why they do not."""

    families: tuple[str, ...]
    titles: str
    access: AccessWay
    reason: str


def gsd_text(found: GsdReport) -> str:
    """For a person."""
    station = found.station
    parts = [f"{found.file.name}: {station.model} {station.revision}".rstrip()]
    parts.append(table(["what", "value"], [row for row in _facts(found) if row[1]]))
    parts.append("Modules\n\n" + _modules_table(station.modules))
    if found.chosen is None:
        parts.append("--module NAME shows slots, addresses and access ways of a module.")
        return "\n\n".join(parts)
    chosen = found.chosen
    first = f"addresses from {found.address}"
    parts.append(f"Slots of {chosen.names}, {first}\n\n" + _slots_table(chosen, found.address))
    parts.append("How a PLC reaches them\n\n" + _reach_table(chosen))
    parts.append("\n".join(_whole_frame(chosen)))
    parts.append("For the plant file\n\n" + indented(_for_the_plant_file(found, chosen)))
    return "\n\n".join(parts)


def gsd_json(found: GsdReport) -> dict[str, object]:
    """For another program."""
    station, chosen = found.station, found.chosen
    limits = station.limits
    return {
        "file": found.file.name,
        "ident_number": f"{station.ident_number:04X}",
        "gsd_revision": station.gsd_revision,
        "vendor": station.vendor,
        "model": station.model,
        "revision": station.revision,
        "hardware_release": station.hardware_release,
        "software_release": station.software_release,
        "order_number": station.order_number,
        "station": "master" if station.is_master else "slave",
        "modular": station.modular,
        "dpv1": station.dpv1,
        "rates": [{"rate": rate.name, "max_tsdr_bits": rate.max_tsdr} for rate in station.rates],
        "auto_baud": station.auto_baud,
        "sync": station.sync,
        "freeze": station.freeze,
        "fail_safe": station.fail_safe,
        "set_slave_address": station.set_slave_address,
        "min_slave_interval_us": station.min_slave_interval_us,
        "max_diagnosis_bytes": station.max_diagnosis_bytes,
        "max_modules": limits.modules,
        "max_input_bytes": limits.inputs,
        "max_output_bytes": limits.outputs,
        "max_data_bytes": limits.data,
        "user_parameters": station.parameters.hex(" ").upper(),
        "modules": [
            {
                "name": module.name,
                "identifiers": module.code.hex(" ").upper(),
                "output_bytes": module.output_length,
                "input_bytes": module.input_length,
                "user_parameters": module.parameters.hex(" ").upper(),
            }
            for module in station.modules
        ],
        "unknown_keywords": sorted({line.keyword for line in station.unknown}),
        "warnings": [warning.as_json() for warning in station.warnings],
        "catalog": list(_in_catalog(found)),
        "chosen": None if chosen is None else _chosen_json(chosen, found.address),
    }


def _chosen_json(chosen: Configuration, address: int) -> dict[str, object]:
    placed = placed_identifiers(chosen.code)
    return {
        "modules": [module.name for module in chosen.modules],
        "identifiers": chosen.code.hex(" ").upper(),
        "output_bytes": chosen.output_length,
        "input_bytes": chosen.input_length,
        "user_parameters": chosen.user_parameters.hex(" ").upper(),
        "slots": [
            {
                "slot": slot.number,
                "identifier": slot.identifier.code.hex(" ").upper(),
                "output_bytes": slot.identifier.output_length,
                "output_address": slot.output_address,
                "output_consistent_bytes": _consistent(slot.identifier.outputs),
                "input_bytes": slot.identifier.input_length,
                "input_address": slot.input_address,
                "input_consistent_bytes": _consistent(slot.identifier.inputs),
                "moved": move_of(place),
            }
            for slot, place in zip(_slots(chosen, address), placed, strict=True)
        ],
        "access": [
            {"plc": family, "access": item.access, "possible": not item.reason}
            | ({"reason": item.reason} if item.reason else {})
            for item in _reached(chosen)
            for family in item.families
        ],
    }


def _facts(found: GsdReport) -> Iterator[list[str]]:
    station = found.station
    kind = "master" if station.is_master else "slave"
    if not station.is_master:
        kind = ("modular " if station.modular else "compact ") + kind
    yield ["vendor", station.vendor]
    yield ["ident number", f"{station.ident_number:04X}"]
    yield ["station", f"{kind}, DP-V{int(station.dpv1)}, GSD revision {station.gsd_revision}"]
    for what, text in (
        ("releases", ", ".join(filter(None, (station.hardware_release, station.software_release)))),
        ("order number", station.order_number),
    ):
        if text:
            yield [what, text]
    rates = ", ".join(rate.name for rate in station.rates)
    yield ["rates", rates + (" (found by itself)" if station.auto_baud else "")]
    if any(rate.max_tsdr is not None for rate in station.rates):
        times = ("-" if one.max_tsdr is None else str(one.max_tsdr) for one in station.rates)
        yield ["answers within", f"{', '.join(times)} bit times"]
    commands = [name for name, has in (("Sync", station.sync), ("Freeze", station.freeze)) if has]
    yield ["commands", " and ".join(commands) or "neither Sync nor Freeze"]
    yield ["in CLEAR it takes", "empty outputs" if station.fail_safe else "outputs of zeros"]
    yield ["its address is set", "by the master too" if station.set_slave_address else "at itself"]
    yield ["least interval", f"{station.min_slave_interval_us} us between two cycles"]
    yield ["diagnosis", f"up to {station.max_diagnosis_bytes} bytes"]
    limits = station.limits
    shown = [
        f"{most} {what}"
        for most, what in (
            (limits.modules, "module" if limits.modules == 1 else "modules"),
            (limits.outputs, "bytes out"),
            (limits.inputs, "bytes in"),
            (limits.data, "bytes together"),
        )
        if most is not None
    ]
    if shown:
        yield ["at most", ", ".join(shown)]
    yield ["user parameters", station.parameters.hex(" ").upper() or "none"]
    for text in _in_catalog(found):
        yield ["catalogue", text]


def _in_catalog(found: GsdReport) -> Iterator[str]:
    """The types of gateways with this ident number, and their layouts."""
    chosen = found.chosen
    for entry in found.catalog.profibus_gateways.values():
        profibus = entry.profibus
        if not isinstance(profibus, PublishedProfibus):
            continue
        if profibus.ident_number != found.station.ident_number:
            continue
        yield f"{entry.id}: {entry.title}"
        for layout in entry.layouts if chosen is not None else ():
            assert chosen is not None, "as asked above"
            lengths = f"{layout.output_length} bytes out, {layout.input_length} in"
            if layout.identifiers == chosen.code:
                yield f"{entry.id}, layout {layout.name}: the same identifiers"
            elif (layout.output_length, layout.input_length) == (
                chosen.output_length,
                chosen.input_length,
            ):
                yield f"{entry.id}, layout {layout.name}: other identifiers, {lengths} too"
            else:
                yield f"{entry.id}, layout {layout.name}: does not fit, {lengths}"


def _modules_table(modules: Sequence[GsdModule]) -> str:
    rows = [
        [
            module.name,
            str(module.output_length),
            str(module.input_length),
            _consistency(module.code),
            module.code.hex(" ").upper(),
        ]
        for module in modules
    ]
    return table(["module", "bytes out", "bytes in", "consistent", "identifiers"], rows)


def _consistency(code: bytes) -> str:
    kinds = dict.fromkeys(
        "as a whole" if item.consistent else f"by {'words' if item.unit_length == 2 else 'bytes'}"
        for item in placed_identifiers(code)
        if item.output_length or item.input_length
    )
    return ", ".join(kinds) or "-"


def _slots(chosen: Configuration, address: int) -> tuple[Slot, ...]:
    return slot_table(chosen.identifiers, address, address)


def _slots_table(chosen: Configuration, address: int) -> str:
    rows = [
        [
            str(slot.number),
            slot.identifier.code.hex(" ").upper(),
            _place("Q", slot.output_address, slot.identifier.outputs),
            _place("I", slot.input_address, slot.identifier.inputs),
            _consistency(slot.identifier.code),
            move_of(place),
        ]
        for slot, place in zip(
            _slots(chosen, address), placed_identifiers(chosen.code), strict=True
        )
    ]
    lengths = [f"{chosen.output_length} bytes", f"{chosen.input_length} bytes"]
    rows.append(["", "", *lengths, "", ""])
    return table(["slot", "identifier", "outputs", "inputs", "consistent", "moved"], rows)


def _place(area: str, first: int | None, extent: Extent | None) -> str:
    if first is None or extent is None:
        return "-"
    last = first + extent.length - 1
    return f"{area}B{first}" if last == first else f"{area}B{first} - {area}B{last}"


def _consistent(extent: Extent | None) -> int:
    return extent.consistent_bytes if extent is not None else 0


def _reach_table(chosen: Configuration) -> str:
    rows = [
        [item.titles, item.access, f"no: {item.reason}" if item.reason else "yes"]
        for item in _reached(chosen)
    ]
    shown = [
        [titles if index == 0 or rows[index - 1][0] != titles else "", access, text]
        for index, (titles, access, text) in enumerate(rows)
    ]
    return table(["PLC", "access", "possible"], shown)


def _reached(chosen: Configuration) -> Iterator[_Reached]:
    """Families with the same answers stand together."""
    placed = placed_identifiers(chosen.code)
    ways = access_ways(placed)
    answers: dict[tuple[str, ...], list[str]] = {}
    for name, family in FAMILIES.items():
        reasons = []
        for way in _WAYS:
            no = refusal(way, placed, family, chosen.names)
            lacking = (way == "dpxx_dat" and not family.whole_frame) or (
                way == "per_identifier" and not family.peripheral
            )
            if way in ways or lacking:
                reasons.append("" if no is None else no.message)
            else:
                reasons.append(not_a_way(way))
        key = tuple(reason.replace(family.title, "this PLC") for reason in reasons)
        answers.setdefault(key, []).append(name)
    for reasons_of_all, names in answers.items():
        titles = ", ".join(FAMILIES[name].title for name in FAMILIES if name in names)
        for way, reason in zip(_WAYS, reasons_of_all, strict=True):
            yield _Reached(tuple(names), titles, way, reason)


def _whole_frame(chosen: Configuration) -> Iterator[str]:
    """What DPRD_DAT and DPWR_DAT do with the whole frame."""
    placed = placed_identifiers(chosen.code)
    with_outputs = [one for one in placed if one.output_length]
    with_inputs = [one for one in placed if one.input_length]
    yield "DPRD_DAT and DPWR_DAT (SFC14, SFC15) reach one slot by one call."
    if "dpxx_dat" in access_ways(placed):
        yield f"Here it has all data: {chosen.output_length} bytes out, {chosen.input_length} in."
    elif max(len(with_outputs), len(with_inputs)) > 1:
        yield (
            "Over the whole frame S7-300 and S7-400 refuse the call (80B1); S7-1200 and S7-1500 "
            "move the first slot alone and report no error."
        )
    elif all(one.consistent for one in placed):
        yield "Here each direction is a slot of its own; dpxx_dat needs one slot for both."
    else:
        yield (
            f"Here it has all of a direction, consistent only {_consistency(chosen.code)}: S7-300 "
            "and S7-400 may refuse it (8090)."
        )
    longest = max(
        (max(one.output_length, one.input_length) for one in placed if one.consistent), default=0
    )
    if longest > OLDER_CPUS_MOVE:
        yield (
            f"Older S7-300 and S7-400 move {OLDER_CPUS_MOVE} consistent bytes at most, not "
            f"{longest}: see the data sheet of the CPU."
        )


def _for_the_plant_file(found: GsdReport, chosen: Configuration) -> str:
    names = ", ".join(json.dumps(module.name) for module in chosen.modules)
    placed = placed_identifiers(chosen.code)
    s7 = FAMILIES["s7-1500"]
    ways = [way for way in access_ways(placed) if refusal(way, placed, s7, chosen.names) is None]
    lines = [
        f"gsd: {json.dumps(found.file.as_posix())}   # from the folder of the plant file",
        f"modules: [{names}]",
        f"access: {'   # or '.join(ways)}",
        f"input_address: {found.address}",
        f"output_address: {found.address}",
    ]
    if "dpxx_dat" in ways:
        lines.append("# on S7-1200 and S7-1500 instead of the two: hardware_identifier:")
    return "\n".join(lines)
