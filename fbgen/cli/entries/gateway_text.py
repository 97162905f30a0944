"""Gateways as text for a person, for `fbgen catalog show`; options and switches of drives, too."""

from collections.abc import Iterable, Sequence

from fbgen.catalog import (
    DeviceNetGateway,
    Gateway,
    ProcessDataGateway,
    ProfibusGateway,
    Switch,
    TelegramGateway,
    Word,
)
from fbgen.catalog.options import Option
from fbgen.cli.entries.devicenet_text import devicenet_text
from fbgen.cli.entries.word_tables import Sources
from fbgen.cli.table import table


def gateway_text(gateway: Gateway, sources: Sources) -> list[str]:
    """The tables of a gateway of whatever kind."""
    words = [
        [f"{gateway.id}.{word.name}", _with_doubts(sources.of(word), _doubtful(word)), word.title]
        for word in gateway.words
    ]
    lamps = [
        [
            str(led.number),
            led.name,
            state.light + ("*" if state.normal else ""),
            sources.of(state),
            state.meaning,
        ]
        for led in gateway.leds
        for state in led.states
    ]
    return [
        f"Inverter series: {', '.join(gateway.series)}",
        *(_layouts(gateway, sources) if isinstance(gateway, ProfibusGateway) else ()),
        table(["word", "source", "title"], words),
        *_of_the_kind(gateway, sources),
        table(["LED", "name", "light (* normal)", "source", "meaning"], lamps),
        *_connectors(gateway, sources),
        *switches_text(gateway.switches, sources),
        *options_text(gateway.options, sources),
    ]


def _layouts(gateway: ProfibusGateway, sources: Sources) -> list[str]:
    layouts = [
        [
            item.name + (" (default)" if item.name == gateway.default_layout else ""),
            item.identifiers.hex(" ").upper(),
            str(item.output_length),
            str(item.input_length),
            " ".join(item.access_ways),
            _with_doubts(sources.of(item), item.unverified),
            item.title,
        ]
        for item in gateway.layouts
    ]
    headings = ["layout", "identifiers", "out", "in", "access ways", "source", "title"]
    return [table(headings, layouts)]


def _doubtful(word: Word) -> list[str]:
    """The bits whose places or meanings no document confirms."""
    return [field.name for field in word.bits if field.status == "unverified"]


def _with_doubts(source: str, unverified: Iterable[str]) -> str:
    """A source, and what of its entry is not confirmed by it."""
    named = " ".join(unverified)
    return f"{source} unverified: {named}" if named else source


def _of_the_kind(gateway: Gateway, sources: Sources) -> list[str]:
    """What only one kind of gateway has."""
    match gateway:
        case TelegramGateway():
            codes = [
                [f"{item.code:02X}", sources.of(item), item.title] for item in gateway.status_codes
            ]
            return [table(["status code", "source", "title"], codes)]
        case ProcessDataGateway():
            return _process_data(gateway, sources)
        case DeviceNetGateway():
            return devicenet_text(gateway, sources)
        case _:
            return []


def _process_data(gateway: ProcessDataGateway, sources: Sources) -> list[str]:
    access, scan = gateway.parameter_channel, gateway.autoscan
    channels = [
        [
            item.name,
            str(item.diagnosis_bit),
            "yes" if item.powers_gateway else "no",
            sources.of(item),
            item.title,
        ]
        for item in gateway.channels
    ]
    rates = " ".join(map(str, scan.baud_rates))
    autoscan = [[rates, " ".join(scan.parities), sources.of(scan)]]
    cyclic = [
        [way, item.field, f"{item.comno:04X}", sources.of(item), item.title]
        for way, items in (("out", gateway.outputs), ("in", gateway.inputs))
        for item in items
    ]
    codes = [
        [kind, f"{item.code:02b}", item.name, sources.of(item), item.title]
        for kind, items in (("request", access.requests), ("response", access.responses))
        for item in items
    ]
    errors = [
        [f"{item.code:04X}", item.name, sources.of(item), item.title] for item in access.errors
    ]
    local = [
        [f"{item.number:04X}", item.name, sources.of(item), item.title] for item in access.local
    ]
    times = [
        [name, f"{time.ms:g} ms", sources.of(time)]
        for name, time in ((name, getattr(gateway.times, name)) for name in _PROCESS_DATA_TIMES)
    ]
    return [
        table(["channel", "diagnosis bit", "powers the gateway", "source", "title"], channels),
        table(["way", "field of each channel", "ComNo", "source", "title"], cyclic),
        table(["parameter channel", "code", "name", "source", "title"], codes),
        table(["access error", "name", "source", "title"], errors),
        table(["local parameter", "name", "source", "title"], local),
        table(["drives are searched at", "parity", "source"], autoscan),
        table(["time", "value", "source"], times),
    ]


_PROCESS_DATA_TIMES = (
    *("processing", "reply_timeout", "parameter_min", "parameter_max", "heartbeat"),
)


def _connectors(gateway: Gateway, sources: Sources) -> list[str]:
    """The connectors in one table, pin by pin."""
    rows = [
        [connector.name, item.pin, item.wire or "", sources.of(connector), item.signal]
        for connector in gateway.connectors
        for item in connector.pins
    ]
    return [table(["connector", "pin", "wire", "source", "signal"], rows)] if rows else []


def switches_text(switches: tuple[Switch, ...], sources: Sources) -> list[str]:
    """The switches of a device in a table, if it has any."""
    rows = [[item.name, item.where, _position(item), sources.of(item)] for item in switches]
    return [table(["switch", "where", "position", "source"], rows)] if rows else []


def _position(switch: Switch) -> str:
    if switch.adds is not None:
        return f"ON adds {switch.adds} to the address"
    return switch.stands or f"{switch.shows} of the address"


def options_text(options: Sequence[Option], sources: Sources) -> list[str]:
    """The options of a device in a table, if it has any."""
    rows = [
        [
            item.id,
            str(item.default).lower() if isinstance(item.default, bool) else str(item.default),
            item.applies_to,
            sources.of(item),
            "; ".join([item.title, *(f"{key}: {text}" for key, text in item.choices.items())]),
        ]
        for item in options
    ]
    return [table(["option", "default", "for", "source", "title"], rows)] if rows else []
