"""What has to be set by hand at an inverter: its series says so behind a gateway, on a serial line
rate, parity, protocol and time-out are those of the line in the plant file.

Sources: TOSPBDP001 manual v1.1, 6 (F800, F801, F802, F803, FH); VF-AS1 RS485 manual E6581315, page
43 (the action of a time-out).
"""

from collections.abc import Callable, Iterator, Mapping

from fbgen.blocks.serial_times import serial_times
from fbgen.catalog import Catalog, Drive, SerialPort, Setting
from fbgen.plant import DeviceNetDrive, Plant, PlantDrive, PlantGateway, SerialLine, port_of

InWords = Callable[[str, str], str]
"""Chooses between a text in English and the same in German."""


def english(text: str, _: str) -> str:
    """The English one."""
    return text


def drive_settings(
    plant: Plant,
    unit: PlantGateway | SerialLine,
    series: Drive,
    catalog: Catalog,
    in_words: InWords = english,
) -> tuple[Setting, ...]:
    """What the inverters of a series need at a gateway with a line, or on a serial line."""
    if isinstance(unit, SerialLine):
        return tuple(_on_line(plant, unit, series, catalog, in_words))
    return series.settings


def value_of(setting: Setting, drive: PlantDrive | DeviceNetDrive) -> float | None:
    """What a parameter is set to at one drive; None where the machine decides."""
    if setting.plant == "inv_no" and isinstance(drive, PlantDrive):
        return drive.inv_no
    return drive.max_frequency_hz if setting.plant == "max_frequency_hz" else setting.value


def _on_line(
    plant: Plant, line: SerialLine, series: Drive, catalog: Catalog, in_words: InWords
) -> Iterator[Setting]:
    port = port_of(line, series)
    assert port is not None, "checked when the plant was read"
    as_line = in_words(
        "as the line; takes effect after power off until the display is dark",
        "wie die Linie; wirkt, wenn die Versorgung aus war, bis die Anzeige dunkel war",
    )
    as_polled = in_words(
        "longer than the line takes to ask all drives; a shorter one trips them",
        "länger, als die Linie braucht, alle Antriebe zu fragen; eine kürzere schaltet sie ab",
    )
    doubtful = in_words(
        "; which value stands for it is unverified: look at what it means",
        "; welcher Wert dafür steht, ist unbelegt: nach der Bedeutung gehen",
    )

    def set_to(name: str, value: float, why: str) -> Setting:
        said = f"{why}{doubtful}" if _is_doubtful(series, name, value) else why
        return Setting.model_construct(comno=name, value=value, why=said, source=port.source)

    heard = serial_times(plant, line, catalog).drive_timeout_s
    own = [
        set_to(port.baud_rate, _code(series.baud_rates(port), line.baud), as_line),
        set_to(port.parity, _code(series.parities(port), line.parity), as_line),
        _number(port, series, in_words),
        set_to(port.timeout, float(heard), as_polled),
    ]
    if port.protocol is not None:
        own.append(set_to(port.protocol, _code(dict(port.protocols), line.family), as_line))
    if port.timeout_action is not None:
        own.append(_timeout_action(port.timeout_action, series, in_words))
    own.append(_highest(series, in_words))
    yield from own
    done = {setting.comno for setting in own} | {"baud_rate", "parity", series.link.timeout}
    yield from (setting for setting in series.settings if setting.comno not in done)


def _number(port: SerialPort, series: Drive, in_words: InWords) -> Setting:
    """In the words of the series where it has some."""
    return series.setting(port.inv_no) or Setting.model_construct(
        comno=port.inv_no,
        plant="inv_no",
        why=in_words(
            "INV-NO of the plant file, once on each line",
            "INV-NO der Anlagendatei, auf jeder Linie nur einmal",
        ),
        source=port.source,
    )


def _highest(series: Drive, in_words: InWords) -> Setting:
    return series.setting(series.link.maximum_frequency) or Setting.model_construct(
        comno=series.link.maximum_frequency,
        plant="max_frequency_hz",
        why=in_words(
            "max_frequency_hz of the plant file, the limit of every set-point from the PLC",
            "max_frequency_hz der Anlagendatei, die Grenze jedes Sollwerts der SPS",
        ),
        source="TOSPBDP001 manual v1.1, 8 F",
    )


def _timeout_action(name: str, series: Drive, in_words: InWords) -> Setting:
    why = in_words(
        "free, but the time-out of this port must trip (Err5) or stop the drive: with 'nothing' or "
        "'alarm' it runs on when the line or the PLC fails. The codes are in the manual of the "
        "series",
        "frei, muss aber bei Zeitüberschreitung dieses Anschlusses auslösen (Err5) oder anhalten: "
        "mit 'nichts' oder 'Alarm' läuft der Antrieb weiter, wenn Linie oder SPS ausfällt. Die "
        "Werte stehen im Handbuch der Baureihe",
    )
    return Setting.model_construct(comno=name, why=why, source=series.comno(name).source)


def _is_doubtful(series: Drive, name: str, value: float) -> bool:
    """Whether no document says that this value stands for what it is to mean."""
    comno, known = series.comno(name), series.setting(name)
    if known is not None and known.value == value:
        return False
    return bool(comno.values) and (comno.status == "unverified" or "values" in comno.unverified)


def _code(values: Mapping[int, object], wanted: object) -> float:
    return float(next(code for code, value in values.items() if value == wanted))
