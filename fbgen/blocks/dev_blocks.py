"""The blocks for DeviceNet: a drive with an option at a scanner of the PLC, and its network."""

from collections.abc import Iterator

from fbgen.blocks.alarms import that_can_come
from fbgen.blocks.dev_alarms import DEV_DRIVE_ALARMS, NETWORK_ALARMS
from fbgen.blocks.dev_networks import DevNetworkView, dev_network_view, network_problems
from fbgen.blocks.dev_parameters import parameter_context, trip_text_of
from fbgen.blocks.family import FamilyPlan
from fbgen.blocks.literals import SclText, one_line
from fbgen.blocks.specs import BlockSpec, block, data_block, data_type
from fbgen.blocks.texts import Texts
from fbgen.blocks.trips import trip_texts
from fbgen.blocks.words import WordView
from fbgen.catalog import Catalog, DeviceNetGateway, origin
from fbgen.diagnostics import Diagnostic
from fbgen.plant import Plant

_TYPES = (
    *("Input", "Output", "Control", "State", "Job", "Polled", "Drive"),
    *("Line", "DriveParam"),
)
_WORDS = (
    *("basic_control", "basic_status", "extended_control", "extended_status"),
    *("command", "status"),
)
"""The words of the catalogue by which drives are commanded and seen."""
_TEXTS = "drive_status"
"""The field of the catalogue whose values are states in words."""


def devicenet_problems(plant: Plant, catalog: Catalog) -> Iterator[Diagnostic]:
    """FB5009 options of several types, FB5018 no table of who is there, FB5019 missing words."""
    drives = plant.devicenet_drives
    for drive in drives[1:]:
        if drive.type != drives[0].type:
            yield Diagnostic(
                "FB5009",
                f"the option of '{drive.name}' is a {drive.type}, that of '{drives[0].name}' a "
                f"{drives[0].type}, and the blocks of one plant are made for one type of each kind",
                drive.span_of("type"),
                "make a plant file of its own for each type",
            )
    yield from network_problems(plant, catalog)


def devicenet_family(plant: Plant, catalog: Catalog, texts: Texts) -> FamilyPlan:
    """What the DeviceNet networks need; there is at least one.

    DEV_Drive writes `control` and `speed` of `out_DRIVE`, DEV_Parameter the words of the parameter
    channel.
    """
    units = tuple(dev_network_view(plant, item, catalog) for item in plant.devicenet)
    entry = catalog.devicenet_gateway(plant.devicenet_drives[0].type)
    types = [data_type(f"typeDev{name}") for name in _TYPES]
    types += [
        data_type(f"{name}_{item.name}", name, {"unit": item})
        for item in units
        for name in ("typeDevNetwork", "typeDevParam")
    ]
    return FamilyPlan(
        units=units,
        types=types,
        blocks=list(_blocks(units, catalog)),
        data=[
            data_block(f"DEV_Network_{item.name}_DB", "DEV_Network_DB", {"unit": item})
            for item in units
        ],
        context={
            "dev": {name: WordView(entry.word(name), entry.id) for name in _WORDS}
            | parameter_context(entry)
            | {"states": _states(entry, texts)},
            "dev_alarms": {
                "line": that_can_come(NETWORK_ALARMS, plant.devicenet),
                "drive": that_can_come(DEV_DRIVE_ALARMS, plant.devicenet),
            },
        },
    )


def _blocks(units: tuple[DevNetworkView, ...], catalog: Catalog) -> Iterator[BlockSpec]:
    yield block("DEV_StateText")
    yield block("DEV_Drive")
    with_channel = [drive for item in units for drive in item.drives if drive.channel]
    if with_channel:
        yield block("DEV_Parameter")
        yield block("DEV_Poll")
    for name in dict.fromkeys(drive.series for drive in with_channel):
        found = trip_texts(name, catalog)
        yield block(trip_text_of(name), "DEV_TripText", {"texts_of": found})
    yield block("DEV_Alarms")
    for item in units:
        yield block(f"DEV_Network_{item.name}", "DEV_Network", {"unit": item})


def _states(entry: DeviceNetGateway, texts: Texts) -> list[dict[str, SclText]]:
    """The states of the Control Supervisor in words."""
    word = entry.word("extended_status")
    field = word.field(_TEXTS)
    place = origin(f"{entry.id}.{word.name} {field.name}", field, word.source_of(field))
    return [
        {"code": SclText(str(code), place), "text": SclText(f"'{one_line(texts(text))}'", place)}
        for code, text in field.values.items()
        if int(code)
    ]
