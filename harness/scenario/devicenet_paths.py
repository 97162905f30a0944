"""What scenarios see of a drive on DeviceNet: `devicenet.pump.input.status` and others.

online             whether its option is on the network
exchanging         whether the scanner exchanges data with it
network            how far the node has got
scanner            its state in the scan list
connection.NAME    the state of a connection: explicit, polled, change_of_state
state              of the Control Supervisor
outputs, inputs    all bytes: as the option took them last, as they came to the scanner last
output.FIELD, input.FIELD    a field of the assemblies by its name in the catalogue
led.LAMP           a lamp of the option

Of a network, by its name: `mode`, what the scanner does.
"""

from collections.abc import Callable
from enum import Enum

from fbgen.catalog.devicenet_gateways import AssemblyField
from fbgen.source import Span
from harness.fieldbus.devicenet import ConnectionState, Network, SlaveState
from harness.fieldbus.devicenet.connection import CONNECTIONS
from harness.gateways.dev003z import Dev003z, State
from harness.installation.devicenet import DeviceNet
from harness.scenario.kinds import FLAG, choice_kind, octets_kind, word_kind
from harness.scenario.named_things import Readable, one_of

_STATE = choice_kind(tuple(state.name.lower() for state in State))
_NETWORK = choice_kind(tuple(state.name.lower() for state in Network))
_SCANNED = choice_kind(tuple(state.name.lower() for state in SlaveState))
_CONNECTION = choice_kind(tuple(state.name.lower() for state in ConnectionState))
_MODE = choice_kind(("OFF", "IDLE", "RUN"))
DEVICENET_ITEMS = ("online", "exchanging", "network", "scanner", "state", "outputs", "inputs")
"""What a drive on DeviceNet has, beside fields and lamps."""


def devicenet_item(network: DeviceNet, drive: str, item: str, span: Span | None) -> Readable:
    """What an item of a drive gives. Raises DiagnosticError FB8003."""
    option = network.options[drive]
    slave = network.scanner.slaves[option.node.settings.mac]
    pair = option.assemblies.chosen
    what, _, rest = item.partition(".")
    if what == "led":
        return _lamp(option, rest, span)
    if what == "connection":
        return _connection(option, rest, span)
    if what == "output":
        fields = {field.name: field for field in pair.output.fields}
        one_of(rest, fields, "output field of the option", span)
        return _field(option, fields[rest], lambda: option.assemblies.outputs(pair))
    if what == "input":
        fields = {field.name: field for field in pair.input.fields}
        one_of(rest, fields, "input field of the option", span)
        return _field(option, fields[rest], lambda: slave.inputs)
    items = (*DEVICENET_ITEMS, "connection", "output", "input", "led")
    one_of(item, items, "property of a drive on DeviceNet", span)
    if item == "outputs":
        kind = octets_kind(pair.output.length)
        return Readable(kind, lambda: option.assemblies.outputs(pair))
    if item == "inputs":
        return Readable(octets_kind(pair.input.length), lambda: slave.inputs)
    if item == "state":
        return Readable(_STATE, lambda: _name(option.state))
    if item == "network":
        return Readable(_NETWORK, lambda: _name(option.node.network))
    if item == "scanner":
        return Readable(_SCANNED, lambda: _name(slave.state))
    if item == "online":
        return Readable(FLAG, lambda: option.node.network is Network.ONLINE)
    return Readable(FLAG, lambda: slave.exchanging)


def network_item(network: DeviceNet, item: str, span: Span | None) -> Readable:
    """What an item of a network gives. Raises DiagnosticError FB8003."""
    one_of(item, ("mode",), "property of a DeviceNet network", span)
    return Readable(_MODE, lambda: network.scanner.mode)


def _connection(option: Dev003z, name: str, span: Span | None) -> Readable:
    one_of(name, CONNECTIONS, "connection of the option", span)
    instance = CONNECTIONS[name]

    def state() -> str:
        found = option.node.connections.get(instance)
        return _name(ConnectionState.NON_EXISTENT if found is None else found.state)

    return Readable(_CONNECTION, state)


def _name(state: Enum) -> str:
    return state.name.lower()


def _field(option: Dev003z, field: AssemblyField, data: Callable[[], bytes]) -> Readable:
    words = {word.name: word for word in option.gateway.words}
    begin, end = field.offset, field.offset + field.length
    kind = word_kind(words.get(field.word or ""))
    return Readable(kind, lambda: int.from_bytes(data()[begin:end], "little"))


def _lamp(option: Dev003z, lamp: str, span: Span | None) -> Readable:
    lamps = {entry.name: entry for entry in option.gateway.leds}
    one_of(lamp, lamps, "lamp of the option", span)
    lights = {state.name: state.light for state in lamps[lamp].states}

    def light() -> str:
        state = next(one.state for one in option.lights if one.lamp == lamp)
        return str(lights[state])

    return Readable(choice_kind(tuple(map(str, lights.values()))), light)
