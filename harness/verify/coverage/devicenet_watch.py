"""Looks on at DeviceNet: words of assemblies, lamps, codes of refusals, what c101 has done.

Words are told by the data as the option took them and as they came to the scanner. The items go by
the option's type and the instance of the assembly: a bit of instance 21 is another than that of
101, though the word is one.
"""

from collections.abc import Iterator
from typing import NamedTuple

from fbgen.catalog import DeviceNetGateway, Word
from fbgen.plant import DeviceNetDrive
from fbgen.wire.devicenet import Frame, Service, Status
from fbgen.wire.devicenet_ids import Group2, group_2
from fbgen.wire.devicenet_messages import RESPONSE, ErrorResponse, MessageError, parse_response
from fbgen.wire.toshiba import ErrorCode
from harness.fieldbus.devicenet import CanPort
from harness.gateways.dev003z import Dev003z
from harness.installation import Installation
from harness.installation.devicenet import DeviceNet
from harness.verify.coverage.catalogue import (
    GATEWAY_WORDS,
    GENERAL_STATUS,
    LAMPS,
    PARAMETER_ERRORS,
    TIMEOUT_ACTIONS,
    CatalogueCoverage,
)
from harness.verify.coverage.left_out import NEVER_ANSWERED, NEVER_LIT, NEVER_SHOWN
from harness.verify.coverage.word_items import values_in, values_of

_STATUS = {
    int(one): f"{one:02X} {one.name.lower().replace('_', ' ')}"
    for one in Status
    if one not in NEVER_ANSWERED
}


class _Place(NamedTuple):
    """A word in the data of an assembly; `name` is that of its items."""

    name: str
    word: Word
    is_output: bool
    offset: int


def watch_devicenet(plant: Installation, coverage: CatalogueCoverage) -> None:
    """Look on at all networks of a plant from now on."""
    for network in plant.networks.values():
        coverage.know(GENERAL_STATUS, _STATUS.values())
        for entry in network.entry.drives:
            _OptionWatch(plant, coverage, network, entry)


class _OptionWatch:
    """One option, and what goes over the network from and to it."""

    def __init__(
        self,
        plant: Installation,
        coverage: CatalogueCoverage,
        network: DeviceNet,
        entry: DeviceNetDrive,
    ) -> None:
        self._coverage = coverage
        option = self._option = network.options[entry.name]
        known = option.gateway
        self._slave = network.scanner.slaves[entry.mac]
        self._pair = option.assemblies.chosen
        self._last = b"", b""
        self._refusal = bytes([RESPONSE | Service.ERROR_RESPONSE])
        self._response = group_2(Group2.EXPLICIT_RESPONSE, entry.mac)
        self._places = tuple(_places(option))
        for place in self._places:
            items = values_of(place.name, place.word)
            coverage.know(GATEWAY_WORDS, (item for item in items if item not in NEVER_SHOWN))
        self._know_lamps(known)
        coverage.know(TIMEOUT_ACTIONS, _actions(known).values())
        self._channel = next(
            (item for item in known.register_channels if item.assemblies == self._pair.name), None
        )
        if self._channel is not None:
            coverage.know(PARAMETER_ERRORS, _errors(known).values())
        option.on_loss.append(self._lost)
        option.node.observers.append(self._look_at_lamps)
        plant.drives[entry.name].observers.append(self._look_at_lamps)
        network.bus.taps.append(self._passed)
        self._look_at_lamps()

    def _know_lamps(self, known: DeviceNetGateway) -> None:
        for lamp in known.leds:
            items = (f"{known.id}.{lamp.name} = {state.light}" for state in lamp.states)
            self._coverage.know(LAMPS, (item for item in items if item not in NEVER_LIT))

    def _look_at_lamps(self) -> None:
        known = self._option.gateway
        lights = {
            (lamp.name, state.name): state.light for lamp in known.leds for state in lamp.states
        }
        for light in self._option.lights:
            shown = lights[light.lamp, light.state]
            self._coverage.see(LAMPS, f"{known.id}.{light.lamp} = {shown}")

    def _lost(self, action: int) -> None:
        self._coverage.see(TIMEOUT_ACTIONS, _actions(self._option.gateway).get(action, ""))

    def _passed(self, _: int, frame: Frame, __: CanPort) -> None:
        if frame.identifier == self._response and frame.data[1:2] == self._refusal:
            self._refused(frame.data[1:])
        option = self._option
        if option.assemblies.chosen is not self._pair:
            return
        data = option.assemblies.outputs(self._pair), self._slave.inputs
        if data == self._last:
            return
        self._last = data
        for place in self._places:
            value = _word(data[0] if place.is_output else data[1], place.offset)
            for item in values_in(place.name, place.word, value):
                self._coverage.see(GATEWAY_WORDS, item)
        self._look_at_channel(data[1])

    def _refused(self, body: bytes) -> None:
        try:
            response = parse_response(body)
        except MessageError:
            return
        if isinstance(response, ErrorResponse):
            self._coverage.see(GENERAL_STATUS, _STATUS.get(response.status, ""))

    def _look_at_channel(self, inputs: bytes) -> None:
        if self._channel is None:
            return
        known, assembly = self._option.gateway, self._pair.input
        field = assembly.field(self._channel.response)
        mask = known.word(field.word or "").field("error").mask
        if _word(inputs, field.offset) & mask:
            code = _word(inputs, assembly.field(self._channel.data).offset)
            self._coverage.see(PARAMETER_ERRORS, _errors(known).get(code, ""))


def _places(option: Dev003z) -> Iterator[_Place]:
    known, pair = option.gateway, option.assemblies.chosen
    words = {word.name: word for word in known.words}
    for assembly, is_output in ((pair.output, True), (pair.input, False)):
        for field in assembly.fields:
            if field.word is not None:
                name = f"{known.id}.{assembly.instance}.{field.word}"
                yield _Place(name, words[field.word], is_output, field.offset)


def _actions(known: DeviceNetGateway) -> dict[int, str]:
    parameter = known.parameter("timeout_action")
    return {
        value: f"{known.id} {parameter.display} = {value}: {title}"
        for value, title in parameter.values.items()
    }


def _errors(known: DeviceNetGateway) -> dict[int, str]:
    """The data that come with the error bit: the codes of the inverter's own protocol."""
    return {
        int(one): f"{known.id} {one:04X} {one.name.lower()}"
        for one in (ErrorCode.CANNOT_EXECUTE, ErrorCode.DATA, ErrorCode.COM_NO)
    }


def _word(data: bytes, at: int) -> int:
    return int.from_bytes(data[at : at + 2], "little")
