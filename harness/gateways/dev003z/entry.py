"""What an entry of the catalogue must have so that an option can be simulated by it.

The simulated option finds words, bits, parameters and options by the names that `dev003z.yaml`
uses. A catalogue of one's own may have other entries; what they lack is told by name, all at once.
"""

from collections.abc import Callable, Iterator, Mapping

from fbgen.catalog import Assembly, AssemblyPair, DeviceNetGateway
from fbgen.catalog.devicenet_objects import Attribute, ObjectClass
from fbgen.diagnostics import error

_OPTIONS = ("motor_poles", "register_memory", "rated_torque", "revision", "serial_number")
_PARAMETERS = ("timeout_time", "timeout_action", "timeout_preset", "timeout_condition")
_COMMAND_BITS = (
    *("network_command", "network_frequency", "fault_reset", "run", "reverse", "coast_stop"),
    *("preset_speed_1", "preset_speed_2", "preset_speed_3", "preset_speed_4"),
)
_CONTROL_BITS = ("fault_reset", "run_forward")
_STATUS_BITS = (
    *("faulted", "warning", "running_forward", "running_reverse", "ready", "control_from_net"),
    *("reference_from_net", "at_reference", "drive_status"),
)
_LAMPS: Mapping[str, tuple[str, ...]] = {
    "module_status": ("no_power", "self_test", "minor_fault", "operational"),
    "network_status": ("link_failure", "not_online", "timed_out", "connected", "not_connected"),
}
_OUTPUTS = ("control", "speed", "command", "frequency")
_INPUTS = ("speed", "frequency")

Knows = Callable[[ObjectClass, Attribute], bool]


def check_complete(gateway: DeviceNetGateway) -> None:
    """FB7107 unless the entry has all names that the simulation stands on."""
    missing = [
        *_names("option", _OPTIONS, (item.id for item in gateway.options)),
        *_names("parameter", _PARAMETERS, (item.name for item in gateway.parameters)),
        *_bits(gateway, "command", _COMMAND_BITS),
        *_settings(gateway),
        *(line for pair in gateway.assemblies for line in _pair(gateway, pair)),
        *_channels(gateway),
        *_lamps(gateway),
    ]
    if not gateway.devicenet.product_name.isascii():
        missing.append("product_name of ASCII characters")
    _refuse(gateway, list(dict.fromkeys(missing)))


def check_attributes(gateway: DeviceNetGateway, knows: Knows) -> None:
    """FB7107 if an attribute has neither a value of the simulation nor one that it begins with."""
    _refuse(gateway, list(_attributes(gateway, knows)))


def _refuse(gateway: DeviceNetGateway, missing: list[str]) -> None:
    if missing:
        raise error(
            "FB7107",
            f"a {gateway.id} cannot be simulated: there is no {', no '.join(missing)}",
            gateway.span,
            "the names are those of dev003z.yaml, which fbgen catalog show dev003z lists",
        )


def _names(what: str, wanted: tuple[str, ...], there: Iterator[str]) -> Iterator[str]:
    found = set(there)
    yield from (f"{what} '{name}'" for name in wanted if name not in found)


def _bits(gateway: DeviceNetGateway, word: str, wanted: tuple[str, ...]) -> Iterator[str]:
    found = next((item for item in gateway.words if item.name == word), None)
    if found is None:
        yield f"word '{word}'"
    else:
        there = {bit.name for bit in found.bits}
        yield from (f"bit '{bit}' of '{word}'" for bit in wanted if bit not in there)


def _settings(gateway: DeviceNetGateway) -> Iterator[str]:
    """Every value of the parameter chooses assemblies."""
    chooser = gateway.parameter(gateway.assembly_parameter)
    settings = {pair.setting for pair in gateway.assemblies}
    for value in range(chooser.minimum, chooser.maximum + 1):
        if value not in settings:
            yield f"assemblies for {chooser.display} = {value}"


def _pair(gateway: DeviceNetGateway, pair: AssemblyPair) -> Iterator[str]:
    channel = {
        name
        for item in gateway.register_channels
        if item.assemblies == pair.name
        for name in (item.request, item.response, item.index, item.data)
    }
    yield from _fields(pair.output, (*_OUTPUTS, *channel))
    for field in pair.output.fields:
        if field.name == "control":
            yield from _bits(gateway, field.word or "", _CONTROL_BITS)
    read = [field for field in pair.input.fields if field.name not in channel]
    words = {word.name: word for word in gateway.words}
    for field in read:
        if field.parameter is not None or field.name in _INPUTS or field.word == "status":
            continue
        if field.word is None:
            yield f"value for the field '{field.name}' of instance {pair.input.instance}"
            continue
        for bit in words[field.word].bits:
            if bit.name not in _STATUS_BITS:
                yield f"value for the bit '{bit.name}' of '{field.word}'"


def _fields(data: Assembly, known: tuple[str, ...]) -> Iterator[str]:
    for field in data.fields:
        if field.parameter is None and field.name not in known:
            yield f"use for the field '{field.name}' of instance {data.instance}"


def _channels(gateway: DeviceNetGateway) -> Iterator[str]:
    for item in gateway.register_channels:
        pair = gateway.pair(item.assemblies)
        asked = pair.output.field(item.request).word or ""
        answered = pair.input.field(item.response).word or ""
        yield from _bits(
            gateway, asked, ("write", "index") if item.index == item.request else ("write",)
        )
        together = item.index == item.response
        yield from _bits(gateway, answered, ("error", "index" if together else "write"))


def _lamps(gateway: DeviceNetGateway) -> Iterator[str]:
    lamps = {lamp.name: {state.name for state in lamp.states} for lamp in gateway.leds}
    for lamp, states in _LAMPS.items():
        if lamp not in lamps:
            yield f"lamp '{lamp}'"
        else:
            lacks = [state for state in states if state not in lamps[lamp]]
            yield from (f"state '{state}' of the lamp '{lamp}'" for state in lacks)


def _attributes(gateway: DeviceNetGateway, knows: Knows) -> Iterator[str]:
    for item in gateway.objects:
        for one in item.class_attributes:
            if one.default is None:
                yield f"default: of the class attribute {one.id} of class {item.code:02X}"
        for one in item.attributes:
            if one.default is None and not knows(item, one):
                yield f"value, nor default:, of attribute {one.id} of class {item.code:02X}"
