"""The README in the output folder: how the text gets into the PLC, and what it is.

The pages are templates in `docs/`, one for each language, and can be replaced like any other.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict
from pathlib import Path, PurePosixPath

import fbgen
from fbgen.artefacts.hmi_tags import CONNECTION
from fbgen.artefacts.memory import (
    BYTES_A_BLOCK,
    BYTES_A_CALL,
    BYTES_AN_OPERAND,
    WorkMemory,
)
from fbgen.artefacts.readme_devicenet import network_rows, without_command_word, without_links
from fbgen.artefacts.readme_serial import serial_notes, serial_poll, serial_row, serial_worst
from fbgen.artefacts.readme_wiring import settings_of_drives, wiring
from fbgen.artefacts.view import PlantLists, place_in
from fbgen.blocks.dev_parameters import has_channel
from fbgen.blocks.line_times import line_times
from fbgen.blocks.literals import one_line
from fbgen.blocks.plan import longest_pause
from fbgen.blocks.poll_cycle import poll_cycle
from fbgen.blocks.status_codes import status_rows
from fbgen.catalog import TelegramGateway
from fbgen.emit.environment import TemplateRenderer
from fbgen.emit.generated import Artefact
from fbgen.emit.layout import GLOBALS
from fbgen.lang import ast
from fbgen.plant import PlantGateway, PlantUnit, cpus_of, plugged

_KINDS = {
    ast.BlockKind.FUNCTION: "FC",
    ast.BlockKind.FUNCTION_BLOCK: "FB",
    ast.BlockKind.ORGANIZATION_BLOCK: "OB",
    ast.BlockKind.PROGRAM: "PROGRAM",
}
_SUFFIXES = {
    ".udt": ("a data type", "ein Datentyp"),
    ".scl": ("blocks", "Bausteine"),
    ".db": ("a data block", "ein Datenbaustein"),
    ".sdf": ("the symbol table with the numbers", "die Symboltabelle mit den Nummern"),
    ".st": ("the program", "das Programm"),
    ".TcPOU": ("a block", "ein Baustein"),
    ".TcDUT": ("a data type", "ein Datentyp"),
    ".TcGVL": ("global variables", "globale Variablen"),
    ".xml": ("the project in PLCopen XML", "das Projekt in PLCopen XML"),
}
_LISTS = {
    "plc_tags.xlsx": ("inputs and outputs as PLC tags", "Ein- und Ausgänge als PLC-Variablen"),
    "io.csv": ("what each input and output is", "was jeder Ein- und Ausgang ist"),
    "hmi_tags.xlsx": ("tags of the HMI", "Variablen der HMI"),
    "hmi_tags.csv": ("tags for an HMI", "Variablen für eine HMI"),
    "alarms.xlsx": ("alarms of the HMI", "Meldungen der HMI"),
    "alarms.csv": ("alarms with word and bit", "Meldungen mit Wort und Bit"),
    "watch.csv": ("what to watch", "was zu beobachten ist"),
    "parameters.md": (
        "what must be set at each drive and gateway",
        "was an jedem Antrieb und Gateway einzustellen ist",
    ),
    "parameters.csv": ("the same as a table", "dasselbe als Tabelle"),
}
_ACCESS = {
    "per_identifier": (
        "Access `per_identifier`: the program reads and writes each configuration identifier by an "
        "access of its own, past the process image; each of them is consistent in itself. Keep the "
        "module's identifiers in this order at consecutive addresses.",
        "Zugriff `per_identifier`: Das Programm liest und schreibt jede Kennung mit einem eigenen "
        "Zugriff am Prozessabbild vorbei; jede ist in sich konsistent. Die Kennungen des Moduls "
        "müssen in dieser Reihenfolge lückenlos liegen.",
    ),
    "process_image": (
        "Access `process_image`: the addresses must lie in the process image that is updated "
        "with OB1 (or with the task that calls the blocks). It is torn at identifier boundaries.",
        "Zugriff `process_image`: Die Adressen müssen im Prozessabbild liegen, das mit OB1 (oder "
        "der aufrufenden Task) aktualisiert wird. Es reißt an Kennungsgrenzen.",
    ),
    "dpxx_dat": (
        "Access `dpxx_dat`: one identifier with consistency over its whole length covers the "
        "frame; DPRD_DAT and DPWR_DAT (SFC14, SFC15) move it as a whole.",
        "Zugriff `dpxx_dat`: Eine Kennung mit Konsistenz über die ganze Länge deckt den "
        "Rahmen ab; DPRD_DAT und DPWR_DAT (SFC14, SFC15) übertragen ihn als Ganzes.",
    ),
}
_TRIGGER = {
    "per_identifier": (
        "The trigger byte of a line goes last.",
        "Das Triggerbyte einer Linie kommt zuletzt.",
    ),
    "process_image": (
        "So the trigger of a line follows its data one cycle later.",
        "Deshalb folgt der Trigger einer Linie seinen Daten einen Zyklus später.",
    ),
}
_INVENTED = (
    "Layout `{0}` is invented: **no GSD file offers this module**. It is there for tests and for a "
    "GSD file that you change yourself.",
    "Layout `{0}` ist erfunden: **keine GSD-Datei bietet dieses Modul**. Es dient Tests und einer "
    "GSD-Datei, die Sie selbst ändern.",
)


def readme(
    lists: PlantLists,
    memory: WorkMemory,
    artefacts: Sequence[Artefact],
    templates: Sequence[Path] = (),
) -> Artefact:
    """README.md in the language of the plant. Raises DiagnosticError FB5003, FB5004."""
    renderer = TemplateRenderer(templates)
    marked = renderer.render(
        f"docs/README.{lists.language}.md.jinja", _context(lists, memory, artefacts)
    )
    text = renderer.table.source("README.md", marked).text
    lines = [line.rstrip() for line in text.split("\n")]
    kept = [line for index, line in enumerate(lines) if line or (index and lines[index - 1])]
    return Artefact("README.md", "\n".join(kept).encode("utf-8"))


def _context(
    lists: PlantLists, memory: WorkMemory, artefacts: Sequence[Artefact]
) -> dict[str, object]:
    plant, generated = lists.plant, lists.generated
    names = {item.name for item in artefacts}
    owned = [file.name for file in generated.files if file.is_owned]
    return {
        "plant": {"name": plant.name},
        "version": fbgen.__version__,
        "inputs": generated.inputs_hash,
        "dialect": plant.dialect,
        "per_block": plant.files == "per_block",
        "classic": plant.family.classic,
        "error_obs": plant.has_error_blocks,
        "cycle_ms": f"{plant.cycle_time_ms:g}",
        "connection": CONNECTION,
        "plc_tags": next((name for name in names if name.endswith("plc_tags.xlsx")), ""),
        "main": lists.name("TOS_Main"),
        "restart": lists.name("TOS_Restart"),
        "longest_pause": longest_pause(plant),
        "data": lists.name("TOS_Plant"),
        "globals": lists.name(GLOBALS),
        "parameters": lists.name("TOS_Parameters"),
        "parameters_file": owned[0] if owned else "",
        "owned": bool(owned),
        "sources": [file.name for file in generated.files if file.is_program],
        "whole_frame": any(item.access == "dpxx_dat" for item in plant.gateways),
        "gsd": [_gsd(item) for item in _types_on_lines(lists)],
        "named_gsd": list(_named_gsd(lists)),
        "without_gsd": any(item.gsd is None for item in lists.at_channels),
        "lines": bool(lists.on_lines),
        "channels": [_gateway(item, lists) for item in lists.at_channels],
        "with_parameters": [_gateway(item, lists) for item in _with_parameters(lists)],
        "without_parameters": [
            item.name for item in lists.at_channels if item not in _with_parameters(lists)
        ],
        "device_channels": [
            f"{network.name}.{drive.name}"
            for network in plant.devicenet
            for drive in network.drives
            if has_channel(drive, lists.catalog)
        ],
        "diagnosed": [
            item.name
            for item in lists.at_channels
            if item.diagnosis_address is not None and plant.family.whole_frame
        ],
        "eeprom": [item.name for item in lists.at_channels if item.eeprom],
        "assumed": [item.name for item in lists.at_channels if lists.layout(item).unverified],
        "gateways": [_gateway(item, lists) for item in plant.gateways],
        "serial": [serial_row(item, lists) for item in plant.serial],
        "devicenet": list(network_rows(lists)),
        "without_links": without_links(lists),
        "without_command_word": without_command_word(lists),
        "serial_notes": [*serial_notes(lists), *wiring(lists), *settings_of_drives(lists)],
        "io": any(name.endswith("_io.csv") for name in names),
        "units": [_unit(item) for item in plant.units],
        "access_notes": list(_access_notes(lists)),
        "sequences": [_sequence(name, lists) for name in plant.sequences],
        "unpolled": [
            *(item.name for item in lists.on_lines if not item.status_poll),
            *(item.name for item in plant.serial if not item.status_poll),
        ],
        "polls": [
            *(_poll(item, lists) for item in lists.on_lines if item.status_poll),
            *(serial_poll(item, lists) for item in plant.serial if item.status_poll),
        ],
        "worst": [
            *(_worst(item, lists) for item in lists.on_lines),
            *(serial_worst(item, lists) for item in plant.serial),
        ],
        "status_codes": status_rows(lists.language, _having(lists)),
        "sheets": next((name for name in names if name.endswith("_parameters.md")), ""),
        "memory": _memory(memory, lists) if cpus_of(plant.plc) else None,
        "files": list(_files(lists, artefacts)),
        "numbered": bool(lists.numbers),
        "blocks": list(_blocks(lists, memory)),
    }


def _having(lists: PlantLists) -> list[str]:
    """What the plant has that brings status codes of its own."""
    found = {
        "lines": lists.on_lines,
        "channels": lists.at_channels,
        "sequences": lists.plant.sequences,
        "parameters": _with_parameters(lists),
        "serial": lists.plant.serial,
        "devicenet": lists.plant.devicenet,
    }
    return [name for name, items in found.items() if items]


def _gateway(gateway: PlantGateway, lists: PlantLists) -> dict[str, object]:
    layout = lists.layout(gateway)
    return {
        "name": gateway.name,
        "address": gateway.profibus_address,
        "layout": layout.name,
        "identifiers": layout.identifiers.hex(" ").upper(),
        "inputs": _place("I", gateway.input_address, layout.input_length, gateway, lists),
        "outputs": _place("Q", gateway.output_address, layout.output_length, gateway, lists),
        "access": gateway.access,
        **_unit(gateway),
    }


def _unit(unit: PlantUnit) -> dict[str, object]:
    return {
        "name": unit.name,
        "drives": [
            {
                "name": drive.name,
                "inv_no": place_in(drive),
                "series": drive.series,
                "max_frequency": f"{drive.max_frequency_hz:g}",
            }
            for drive in unit.drives
        ],
    }


def _with_parameters(lists: PlantLists) -> tuple[PlantGateway, ...]:
    """The gateways whose module has a parameter channel."""
    return tuple(
        item
        for item in lists.at_channels
        if lists.catalog.process_data_gateway(item.type).has_parameter_channel(lists.layout(item))
    )


def _types_on_lines(lists: PlantLists) -> Iterator[TelegramGateway]:
    for name in dict.fromkeys(item.type for item in lists.on_lines):
        yield lists.catalog.telegram_gateway(name)


def _gsd(entry: TelegramGateway) -> dict[str, str]:
    return {
        "file": entry.profibus.gsd_file,
        "ident": f"{entry.profibus.ident_number:04X}",
    }


def _named_gsd(lists: PlantLists) -> Iterator[dict[str, str]]:
    """What the GSD files say that the plant file names."""
    for gateway in lists.plant.gateways:
        chosen = plugged(gateway, lists.catalog.profibus_gateway(gateway.type))
        if gateway.gsd is not None and chosen is not None:
            yield {
                "gateway": gateway.name,
                "file": one_line(gateway.gsd.path),
                "ident": f"{chosen.station.ident_number:04X}",
                "content": gateway.gsd.content_hash[:8],
                "modules": one_line(chosen.names),
                "parameters": chosen.user_parameters.hex(" ").upper(),
            }


def _place(
    area: str, first: int | None, length: int, gateway: PlantGateway, lists: PlantLists
) -> str:
    if first is None:
        return f"HW-ID {gateway.hardware_identifier}, {length} {lists.in_words('bytes', 'Byte')}"
    return f"{area}B{first} - {area}B{first + length - 1}"


def _access_notes(lists: PlantLists) -> Iterator[str]:
    for access in dict.fromkeys(item.access for item in lists.plant.gateways):
        note = lists.in_words(*_ACCESS[access])
        if access in _TRIGGER and any(item.access == access for item in lists.on_lines):
            note = f"{note} {lists.in_words(*_TRIGGER[access])}"
        yield note
    for gateway in {item.layout: item for item in lists.plant.gateways}.values():
        if lists.layout(gateway).invented:
            yield lists.in_words(*_INVENTED).format(gateway.layout)


def _sequence(name: str, lists: PlantLists) -> dict[str, str]:
    title = one_line(lists.catalog.sequence(name).title)
    return {"id": name, "block": lists.name(f"TOS_Seq_{name}"), "title": title}


def _poll(gateway: PlantGateway, lists: PlantLists) -> dict[str, object]:
    found = poll_cycle(lists.plant, gateway, lists.catalog)
    return asdict(found) | {
        "reads": found.reads,
        "read_ms": f"{found.read_ms:g}",
        "round_ms": f"{found.round_ms:g}",
    }


def _worst(entry: PlantGateway, lists: PlantLists) -> Mapping[str, str]:
    times = line_times(lists.plant, entry, lists.catalog)
    return {
        "gateway": entry.name,
        "telegram": f"{times.telegram_ms:.0f}",
        "wait": f"{times.wait_ms:.0f}",
        "emergency_stop": f"{times.emergency_stop_ms:.0f}",
    }


def _memory(memory: WorkMemory, lists: PlantLists) -> dict[str, object]:
    rule = lists.in_words(
        f"{BYTES_A_BLOCK} for a block, {BYTES_AN_OPERAND} for an operand, "
        f"{BYTES_A_CALL} for a call",
        f"{BYTES_A_BLOCK} je Baustein, {BYTES_AN_OPERAND} je Operand, {BYTES_A_CALL} je Aufruf",
    )
    code, data = lists.in_words("code", "Code"), lists.in_words("data", "Daten")
    cpus = []
    for cpu in cpus_of(lists.plant.plc):
        mark = "" if cpu.documented else " *"
        if cpu.data_kib is None:
            room = f"{cpu.code_kib} KiB"
            share = _share(memory.code + memory.data, cpu.code_kib)
        else:
            room = f"{code} {cpu.code_kib} KiB, {data} {cpu.data_kib} KiB"
            of_data = _share(memory.data, cpu.data_kib)
            share = f"{code} {_share(memory.code, cpu.code_kib)}, {data} {of_data}"
        cpus.append({"name": cpu.name + mark, "room": room, "share": share})
    return {"code": memory.code, "data": memory.data, "rule": rule, "cpus": cpus}


def _share(size: int, kib: int) -> str:
    return f"{100 * size / (1024 * kib):.0f} %"


def _files(lists: PlantLists, artefacts: Sequence[Artefact]) -> Iterator[Mapping[str, str]]:
    for file in lists.generated.files:
        purpose = lists.in_words(*_SUFFIXES[PurePosixPath(file.name).suffix])
        if file.is_owned:
            purpose = lists.in_words(
                "your parameters, written once", "Ihre Parameter, einmal geschrieben"
            )
        yield {"name": file.name, "purpose": purpose}
    for item in artefacts:
        part = item.name.removeprefix(f"{lists.plant.name}_")
        english, german = _LISTS.get(part, ("a watch table", "eine Beobachtungstabelle"))
        yield {"name": item.name, "purpose": lists.in_words(english, german)}


def _blocks(lists: PlantLists, memory: WorkMemory) -> Iterator[Mapping[str, object]]:
    sizes = {block.name: block.size for block in memory.blocks}
    for file in lists.canonical.units:
        for unit in file.units:
            if not isinstance(unit, ast.Block | ast.DataBlock | ast.TypeDeclaration):
                continue
            name = unit.name.name
            numbered = lists.numbers.get(name)
            yield {
                "name": name,
                "kind": _kind(unit),
                "number": f"{numbered[0]}{numbered[1]}" if numbered else name,
                "title": next((one.text for one in unit.header if one.keyword == "TITLE"), ""),
                "size": sizes.get(name, ""),
            }


def _kind(unit: ast.Block | ast.DataBlock | ast.TypeDeclaration) -> str:
    if isinstance(unit, ast.Block):
        return _KINDS[unit.kind]
    return "DB" if isinstance(unit, ast.DataBlock) else "UDT"
