"""What scenarios see of an interface for process data: `gateway.gw1.input.a_status` and others.

powered, online, telegrams, diagnosis     the device
outputs, inputs                           all bytes
output.FIELD, input.FIELD                 a field by its name in the catalogue, as a_command
CHANNEL.online, CHANNEL.tripped           what it has found at a channel, as a.online
led.LAMP                                  a lamp
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from fbgen.catalog import Catalog, CyclicField, ProcessDataGateway
from fbgen.plant import PlantGateway, layout_of
from fbgen.source import Span
from harness.gateways.pbdp110 import Light, Pbdp110
from harness.scenario.kinds import (
    COUNT,
    FLAG,
    Found,
    ValueKind,
    choice_kind,
    octets_kind,
    word_kind,
)
from harness.scenario.named_things import Readable, one_of

_DEVICE: Mapping[str, tuple[ValueKind, Callable[[Pbdp110], Found]]] = MappingProxyType(
    {
        "powered": (FLAG, lambda device: device.powered),
        "online": (FLAG, lambda device: device.slave.online),
        "telegrams": (COUNT, lambda device: device.telegrams),
        "diagnosis": (COUNT, lambda device: device.diagnosis),
    }
)
_CHANNEL = ("online", "tripped")
_LIGHT = choice_kind(tuple(str(light.value) for light in Light))


def interface_item(
    device: Pbdp110, entry: PlantGateway, catalog: Catalog, item: str, span: Span | None
) -> Readable:
    """What an item of an interface gives. Raises DiagnosticError FB8003."""
    known = catalog.process_data_gateway(entry.type)
    layout = layout_of(entry, known)
    what, _, rest = item.partition(".")
    if what == "led":
        one_of(rest, device.leds._fields, "lamp of a gateway", span)
        return Readable(_LIGHT, lambda: str(getattr(device.leds, rest).value))
    if what in device.channels and rest:
        one_of(rest, _CHANNEL, "property of a channel", span)
        channel = device.channels[what]
        return Readable(FLAG, lambda: bool(getattr(channel, rest)))
    if what in ("input", "output"):
        fields = {field.name: field for field in getattr(layout, what) if not field.pad}
        one_of(rest, fields, f"{what} field of a gateway", span)
        return _field(device, known, fields[rest], what)
    items = (*_DEVICE, "outputs", "inputs", "input", "output", "led", *device.channels)
    one_of(item, items, "property of a gateway", span)
    if item == "outputs":
        return Readable(octets_kind(layout.output_length), lambda: device.slave.outputs)
    if item == "inputs":
        return Readable(octets_kind(layout.input_length), lambda: device.slave.inputs)
    one_of(item, _DEVICE, "property of a gateway", span)
    kind, read = _DEVICE[item]
    return Readable(kind, lambda: read(device))


def _field(device: Pbdp110, known: ProcessDataGateway, field: CyclicField, side: str) -> Readable:
    words = {word.name: word for word in known.words}
    name = field.name.partition("_")[2]

    def word() -> int:
        data = device.slave.inputs if side == "input" else device.slave.outputs
        return int.from_bytes(data[field.offset : field.end], "big")

    return Readable(word_kind(words.get(name)), word)
