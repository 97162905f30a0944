"""Looks on at a gateway for process data: its words, parameter channels and diagnosis.

Everything is told by what the master sends and gets, so what the gateway has only for itself does
not count. The items go by channel: the same bit at the place of another drive is another one.
"""

from collections.abc import Iterator
from typing import NamedTuple

from fbgen.catalog import Layout, ProcessDataGateway, Word
from harness.fieldbus import Station, Transfer
from harness.gateways.pbdp110 import Pbdp110
from harness.verify.coverage.catalogue import (
    DIAGNOSIS,
    GATEWAY_WORDS,
    PARAMETER_ERRORS,
    READ,
    CatalogueCoverage,
)
from harness.verify.coverage.word_items import values_in, values_of


class _Place(NamedTuple):
    """A word in the cyclic data; `name` is that of its items."""

    name: str
    word: Word
    is_output: bool
    offset: int


class _Access(NamedTuple):
    """Where the answers of a parameter channel lie in the inputs."""

    response: int
    number: int
    data: int


class InterfaceWatch:
    """One gateway. Functions of the master's `taps` get each transfer; so does `transferred`."""

    __slots__ = (
        "_accesses", "_coverage", "_device", "_diagnosis", "_known", "_last", "_places", "_station",
    )  # fmt: skip

    def __init__(
        self,
        coverage: CatalogueCoverage,
        known: ProcessDataGateway,
        layout: Layout,
        device: Pbdp110,
        station: Station,
    ) -> None:
        self._coverage = coverage
        self._known = known
        self._device = device
        self._station = station
        self._last = b"", b""
        self._diagnosis = 0
        self._places = tuple(_places(known, layout))
        self._accesses = tuple(_accesses(known, layout))
        for place in self._places:
            coverage.know(GATEWAY_WORDS, values_of(place.name, place.word))
        for channel in known.channels_of(layout):
            coverage.know(DIAGNOSIS, (_diagnosis(known, channel.name, bit) for bit in (1, 0)))
        if self._accesses:
            coverage.know(PARAMETER_ERRORS, self._errors().values())
            coverage.know(READ, self._local().values())

    def transferred(self, transfer: Transfer) -> None:
        """Note what a transfer carries."""
        if transfer.station is not self._station:
            return
        self._look_at_diagnosis()
        data = transfer.outputs, transfer.inputs
        if data == self._last:
            return
        self._last = data
        for place in self._places:
            value = _word(data[0] if place.is_output else data[1], place.offset)
            for item in values_in(place.name, place.word, value):
                self._coverage.see(GATEWAY_WORDS, item)
        for access in self._accesses:
            self._look_at_response(transfer.inputs, access)

    def _look_at_response(self, inputs: bytes, access: _Access) -> None:
        known = self._known.parameter_channel
        field = self._known.word(known.response_word).field(known.response)
        response = (_word(inputs, access.response) & field.mask) >> field.low
        if response == known.response_code("error"):
            error = self._errors().get(_word(inputs, access.data), "")
            self._coverage.see(PARAMETER_ERRORS, error)
        elif response == known.response_code("read"):
            self._coverage.see(READ, self._local().get(_word(inputs, access.number), ""))

    def _look_at_diagnosis(self) -> None:
        """A bit counts as 1 when it is told, and as 0 when it is told that it is over."""
        now, before = self._device.diagnosis, self._diagnosis
        self._diagnosis = now
        for channel in self._known.channels:
            mask = 1 << channel.diagnosis_bit
            if (now ^ before) & mask:
                bit = int(bool(now & mask))
                self._coverage.see(DIAGNOSIS, _diagnosis(self._known, channel.name, bit))

    def _errors(self) -> dict[int, str]:
        known = self._known
        return {
            item.code: f"{known.id} {item.code:04X} {item.name}"
            for item in known.parameter_channel.errors
        }

    def _local(self) -> dict[int, str]:
        known = self._known
        return {
            item.number: f"{known.id} {item.number:04X} {item.name}"
            for item in known.parameter_channel.local
        }


def _places(known: ProcessDataGateway, layout: Layout) -> Iterator[_Place]:
    words = {item.name: item for item in known.words}
    for channel in known.channels_of(layout):
        for fields, is_output in ((layout.output, True), (layout.input, False)):
            for field in fields:
                name = field.name.removeprefix(f"{channel.name}_")
                if name != field.name and name in words:
                    item = f"{known.id}.{channel.name}.{name}"
                    yield _Place(item, words[name], is_output, field.offset)


def _accesses(known: ProcessDataGateway, layout: Layout) -> Iterator[_Access]:
    offsets = {field.name: field.offset for field in layout.input}
    access = known.parameter_channel
    for channel in known.channels_of(layout):
        names = (access.response_word, access.number, access.data)
        found = [offsets.get(f"{channel.name}_{name}") for name in names]
        if None not in found:
            yield _Access(*(at for at in found if at is not None))


def _diagnosis(known: ProcessDataGateway, channel: str, bit: int) -> str:
    return f"{known.id}.{channel}.diagnosis = {bit}"


def _word(data: bytes, at: int) -> int:
    return data[at] << 8 | data[at + 1]
