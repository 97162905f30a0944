"""The parameter sheet of each drive: what has to be set at inverter, option board and gateway.

For the person at the inverter with its manual in the other hand: one sheet a drive in Markdown, and
the same as one table in CSV. What the sequence `check_parameters` compares is marked.
"""

from collections.abc import Iterator
from typing import NamedTuple

from fbgen.artefacts.devicenet_settings import (
    OptionSetting,
    inverter_settings,
    option_settings,
)
from fbgen.artefacts.readme_serial import MODULE_TITLES
from fbgen.artefacts.text_table import csv_table
from fbgen.artefacts.view import PlantLists, place_in
from fbgen.blocks.checked_settings import sheets, spelled_out
from fbgen.blocks.drive_settings import drive_settings, value_of
from fbgen.catalog import (
    CheckStep,
    ComNo,
    Drive,
    Gateway,
    Setting,
    Switch,
    TelegramGateway,
)
from fbgen.emit.generated import Artefact
from fbgen.plant import (
    DeviceNetDrive,
    DeviceNetNetwork,
    PlantDrive,
    PlantGateway,
    PlantUnit,
    SerialLine,
    module_of,
)

CHECK = "check_parameters"
_HEADINGS = {
    "en": (
        *("gateway", "drive", "INV-NO", "parameter", "ComNo", "title", "value", "unit"),
        *("word", "meaning", "only if", "why", "compared", "source"),
    ),
    "de": (
        *("Gateway", "Antrieb", "INV-NO", "Parameter", "ComNo", "Titel", "Wert", "Einheit"),
        *("Wort", "Bedeutung", "nur wenn", "Grund", "verglichen", "Quelle"),
    ),
}


def parameter_sheets(lists: PlantLists) -> Iterator[Artefact]:
    """The sheets of all drives in Markdown, and as a table in CSV."""
    lines = _Lines(lists)
    text = "\n".join(_document(lists, lines)) + "\n"
    yield Artefact(lists.file_name("parameters.md"), text.encode("utf-8"))
    rows = [_HEADINGS[lists.language], *_rows(lists, lines)]
    yield Artefact(lists.file_name("parameters.csv"), csv_table(rows))


def _compared(lists: PlantLists) -> frozenset[int]:
    """The ComNos that the plant's own check reads back."""
    if CHECK not in lists.plant.sequences:
        return frozenset()
    of_plant = sheets(lists.plant, lists.catalog)
    said = spelled_out(lists.catalog.sequence(CHECK), of_plant[0], of_plant)
    checks = (step for step in said.steps if isinstance(step, CheckStep))
    return frozenset(of_plant[0].series.comno(step.check).number for step in checks)


class _Line(NamedTuple):
    """What a sheet says about a parameter that is set to a value: the cells behind the drive's in
    the table, and the line in Markdown."""

    cells: tuple[str, ...]
    markdown: str


class _Lines:
    """The lines of all sheets. Drives of one series behind gateways of one kind have most of them
    in common."""

    def __init__(self, lists: PlantLists) -> None:
        self._lists = lists
        self._compared = _compared(lists)
        self._settings: dict[tuple[str, str], tuple[Setting, ...]] = {}
        self._known: dict[tuple[str, str, float | None, str], _Line] = {}

    def settings(self, gateway: PlantGateway | SerialLine, series: Drive) -> tuple[Setting, ...]:
        """What the drive needs behind this gateway: one for process data has no line to be set
        for, a serial line is what the plant file says."""
        if isinstance(gateway, SerialLine):
            key = series.id, gateway.name
            if key not in self._settings:
                self._settings[key] = drive_settings(
                    self._lists.plant, gateway, series, self._lists.catalog, self._lists.in_words
                )
            return self._settings[key]
        is_process_data = self._lists.is_process_data(gateway)
        key = series.id, "channels" if is_process_data else "lines"
        if key not in self._settings:
            of_line = {"baud_rate", "parity", series.link.inv_no, series.link.timeout}
            left_out = of_line if is_process_data else set()
            self._settings[key] = tuple(
                setting for setting in series.settings if setting.comno not in left_out
            )
        return self._settings[key]

    def lines(self, unit: PlantUnit, drive: PlantDrive | DeviceNetDrive) -> Iterator[_Line]:
        """Those of a drive."""
        series = self._lists.catalog.drive(drive.series)
        if isinstance(drive, DeviceNetDrive):
            for item in option_settings(self._lists, drive):
                yield self._of_option(item)
            settings = tuple(inverter_settings(self._lists, drive, series))
        else:
            assert not isinstance(unit, DeviceNetNetwork), "its drives are of another kind"
            settings = self.settings(unit, series)
        for setting in settings:
            value = value_of(setting, drive)
            key = series.id, setting.comno, value, setting.why
            if key not in self._known:
                self._known[key] = self._line(series, setting, value)
            yield self._known[key]

    def _of_option(self, item: OptionSetting) -> _Line:
        known, lists = item.parameter, self._lists
        value = item.value * known.resolution
        meaning = lists.texts(known.values.get(item.value, ""))
        title = lists.texts(known.title)
        source = known.source or lists.in_words("unverified", "unbelegt")
        cells = (
            *(known.display, f"{known.number:04X}", title, _number(value), known.unit),
            *(f"{item.value:04X}", meaning, "", item.why, "", source),
        )
        shown = f"**{_number(value)}** {known.unit}".strip()
        in_document = (
            *("", known.display, f"{known.number:04X}", shown),
            *(meaning or title, item.why, source),
        )
        return _Line(cells, f"| {' | '.join(_cell(cell) for cell in in_document)} |")

    def _line(self, series: Drive, setting: Setting, value: float | None) -> _Line:
        lists = self._lists
        comno = series.comno(setting.comno)
        is_compared = comno.number in self._compared
        meaning = _meaning(lists, comno, value)
        source = _source(lists, setting)
        cells = (
            *(comno.display or "", comno.hex, comno.title),
            *(_number(value), comno.unit if value is not None else ""),
            "" if value is None else f"{comno.to_word(value):04X}",
            *(meaning, setting.when or "", setting.why),
            lists.in_words("yes", "ja") if is_compared else "",
            source,
        )
        shown = f"**{_number(value)}** {comno.unit}".strip() if value is not None else "-"
        only = lists.in_words("only if", "nur wenn")
        why = f"{only} {setting.when}: {setting.why}" if setting.when else setting.why
        in_document = (
            *("*" if is_compared else "", comno.display or "", comno.hex, shown),
            *(meaning or comno.title, why, source),
        )
        return _Line(cells, f"| {' | '.join(_cell(cell) for cell in in_document)} |")


def _rows(lists: PlantLists, lines: _Lines) -> Iterator[tuple[str, ...]]:
    for gateway in lists.plant.units:
        for drive in gateway.drives:
            place = gateway.name, drive.name, place_in(drive)
            for line in lines.lines(gateway, drive):
                yield (*place, *line.cells)


def _document(lists: PlantLists, lines: _Lines) -> Iterator[str]:
    plant = lists.plant
    title = lists.in_words("Parameter sheets", "Parameterblätter")
    yield f"# {title}: {plant.title or plant.name}"
    yield ""
    if lists.on_lines or plant.serial:
        yield lists.in_words(
            "Set this by hand at each inverter, its option board and each gateway. Rate, parity "
            "and protocol (F800, F801, F807, F820, F829) take effect when the supply was off "
            "until the display was dark.",
            "Das ist an jedem Umrichter, seiner Optionsplatine und jedem Gateway von Hand "
            "einzustellen. Rate, Parität und Protokoll (F800, F801, F807, F820, F829) wirken, wenn "
            "die Versorgung aus war, bis die Anzeige dunkel war.",
        )
    else:
        yield lists.in_words(
            "Set this by hand at each inverter and each gateway.",
            "Das ist an jedem Umrichter und jedem Gateway von Hand einzustellen.",
        )
    yield ""
    if CHECK in plant.sequences:
        yield lists.in_words(
            f"`TOS_Seq_{CHECK}` reads the rows marked with * back and reports what deviates.",
            f"`TOS_Seq_{CHECK}` liest die Zeilen mit * zurück und meldet Abweichungen.",
        )
    elif lists.on_lines or plant.serial:
        yield lists.in_words(
            f"With `{CHECK}` among the sequences of the plant file the PLC reads them back.",
            f"Mit `{CHECK}` bei den Sequenzen der Anlagendatei liest die SPS sie zurück.",
        )
    for gateway in plant.gateways:
        yield from _gateway(lists, gateway)
        for drive in gateway.drives:
            yield from _sheet(lists, lines, gateway, drive)
    for serial in plant.serial:
        yield from _serial(lists, serial)
        for drive in serial.drives:
            yield from _sheet(lists, lines, serial, drive)
    for network in plant.devicenet:
        yield from _network(lists, network)
        for member in network.drives:
            yield from _sheet_on_devicenet(lists, lines, network, member)


def _gateway(lists: PlantLists, gateway: PlantGateway) -> Iterator[str]:
    entry = lists.catalog.profibus_gateway(gateway.type)
    yield ""
    yield f"## Gateway {gateway.title or gateway.name}"
    yield ""
    address = lists.in_words("PROFIBUS address", "PROFIBUS-Adresse")
    yield f"{gateway.type}, {address} {gateway.profibus_address}; {_line(lists, entry)}"
    yield ""
    yield from _switches(lists, entry.switches, gateway.profibus_address)


def _serial(lists: PlantLists, line: SerialLine) -> Iterator[str]:
    stop = lists.in_words("stop", "Stopp")
    yield ""
    yield f"## {lists.in_words('Serial line', 'Serielle Linie')} {line.title or line.name}"
    yield ""
    module = MODULE_TITLES[module_of(line, lists.plant.plc)]
    yield f"{module}; {line.baud} bit/s, 8 bit, {lists.texts(line.parity)}, 1 {stop}"


def _network(lists: PlantLists, network: DeviceNetNetwork) -> Iterator[str]:
    scanner = lists.in_words("scanner with", "Scanner mit")
    yield ""
    title = lists.in_words("DeviceNet network", "DeviceNet-Netz")
    yield f"## {title} {network.title or network.name}"
    yield ""
    yield f"{network.rate} kbit/s; {scanner} MAC ID {network.mac}"


def _line(lists: PlantLists, entry: Gateway) -> str:
    """How it talks to the drives."""
    if not isinstance(entry, TelegramGateway):
        return lists.in_words(
            "it finds speed and parity of each drive by itself",
            "Geschwindigkeit und Parität jedes Antriebs findet es selbst",
        )
    line = entry.subnetwork
    return (
        f"{line.baud} bit/s, {line.data_bits} bit, {lists.texts(line.parity)}, "
        f"{line.stop_bits} {lists.in_words('stop', 'Stopp')}"
    )


def _sheet(
    lists: PlantLists, lines: _Lines, gateway: PlantGateway | SerialLine, drive: PlantDrive
) -> Iterator[str]:
    series = lists.catalog.drive(drive.series)
    yield ""
    yield f"## {lists.in_words('Drive', 'Antrieb')} {drive.title or drive.name}"
    yield ""
    on_line = isinstance(gateway, SerialLine)
    behind = lists.in_words("line", "Linie") if on_line else "gateway"
    behind = lists.in_words(behind, behind.capitalize())
    channel = lists.in_words("channel", "Kanal")
    place = f"{channel} {drive.channel}" if drive.channel else f"INV-NO {drive.inv_no}"
    yield f"{series.title}, {place}, {behind} {gateway.name}"
    yield ""
    if not lines.settings(gateway, series):
        yield lists.in_words(
            "No document at hand says what has to be set at this series. Its highest frequency "
            f"(FH) must be that of the plant file: **{_number(drive.max_frequency_hz)}** Hz.",
            "Was bei dieser Baureihe einzustellen ist, sagt kein vorliegendes Dokument. Ihre "
            "höchste Frequenz (FH) muss die der Anlagendatei sein: "
            f"**{_number(drive.max_frequency_hz)}** Hz.",
        )
        return
    yield from _table(lists, lines.lines(gateway, drive))
    if isinstance(gateway, SerialLine):
        yield ""
        yield from _switches(lists, series.switches, 0)
    elif not lists.is_process_data(gateway):  # the option board is that of the line
        yield ""
        yield from _switches(lists, series.switches, gateway.profibus_address)


def _sheet_on_devicenet(
    lists: PlantLists, lines: _Lines, network: DeviceNetNetwork, drive: DeviceNetDrive
) -> Iterator[str]:
    series = lists.catalog.drive(drive.series)
    option = lists.catalog.devicenet_gateway(drive.type)
    yield ""
    yield f"## {lists.in_words('Drive', 'Antrieb')} {drive.title or drive.name}"
    yield ""
    of_network = lists.in_words("network", "Netz")
    yield f"{series.title}, {option.id}, MAC ID {drive.mac}, {of_network} {network.name}"
    yield ""
    yield from _table(lists, lines.lines(network, drive))


def _table(lists: PlantLists, lines: Iterator[_Line]) -> Iterator[str]:
    head = lists.in_words(
        "| | parameter | ComNo | value | meaning | why | source |",
        "| | Parameter | ComNo | Wert | Bedeutung | Grund | Quelle |",
    )
    yield from (head, "|---|---|---|---|---|---|---|")
    yield from (line.markdown for line in lines)


def _switches(lists: PlantLists, switches: tuple[Switch, ...], address: int) -> Iterator[str]:
    if not switches:
        return
    yield from (
        lists.in_words(
            "| switch | where | position | source |", "| Schalter | wo | Stellung | Quelle |"
        ),
        "|---|---|---|---|",
    )
    for switch in switches:
        stands = switch.position(address)
        if switch.stands is None:
            stands = f"**{stands}**"
        cells = (lists.texts(switch.name), switch.where, stands, _source(lists, switch))
        yield f"| {' | '.join(_cell(cell) for cell in cells)} |"


def _meaning(lists: PlantLists, comno: ComNo, value: float | None) -> str:
    return "" if value is None else lists.texts(comno.values.get(comno.to_word(value), ""))


def _source(lists: PlantLists, entry: Setting | Switch) -> str:
    return entry.source or lists.in_words("unverified", "unbelegt")


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:g}"


def _cell(text: str) -> str:
    return " ".join(text.split()).replace("|", "\\|")
