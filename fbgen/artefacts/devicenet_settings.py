"""What has to be set at an inverter with a DeviceNet option, and at the option."""

from collections.abc import Iterator
from typing import NamedTuple

from fbgen.artefacts.view import PlantLists
from fbgen.blocks.dev_assemblies import has_links, pair_of
from fbgen.catalog import Drive, Setting
from fbgen.catalog.devicenet_gateways import AdapterParameter
from fbgen.plant import DeviceNetDrive

OF_THE_OPTION = "communication option"
"""What the values of CMOd and FMOd are called in the catalogue that leave it to the option."""


class OptionSetting(NamedTuple):
    """A parameter of the option, what it is set to, and why."""

    parameter: AdapterParameter
    value: int
    why: str


def option_settings(lists: PlantLists, drive: DeviceNetDrive) -> Iterator[OptionSetting]:
    """Those of the option: which assemblies it has, and what the plant file gives it."""
    entry = lists.catalog.devicenet_gateway(drive.type)
    chosen = lists.in_words(
        f"assemblies {drive.assemblies}; takes effect after power off",
        f"Assemblies {drive.assemblies}; wirkt nach Aus- und Einschalten",
    )
    yield OptionSetting(
        entry.parameter(entry.assembly_parameter), pair_of(drive, entry).setting, chosen
    )
    as_planned = lists.in_words("as the plant file says", "wie in der Anlagendatei")
    for name, value in drive.settings.items():
        yield OptionSetting(entry.parameter(name), value, as_planned)


def inverter_settings(lists: PlantLists, drive: DeviceNetDrive, series: Drive) -> Iterator[Setting]:
    """Those of the inverter."""
    yield Setting.model_construct(
        comno=series.link.maximum_frequency,
        value=drive.max_frequency_hz,
        why=lists.in_words("highest set-point of the blocks", "höchster Sollwert der Bausteine"),
    )
    entry = lists.catalog.devicenet_gateway(drive.type)
    if has_links(pair_of(drive, entry)):
        return
    why = lists.in_words(
        "these assemblies have no bits that take the command",
        "diese Assemblies haben keine Bits, die den Befehl holen",
    )
    for name in ("command_mode", "frequency_mode"):
        values = series.comno(name).values
        code = next(code for code, text in values.items() if text == OF_THE_OPTION)
        yield Setting.model_construct(comno=name, value=float(code), why=why)
