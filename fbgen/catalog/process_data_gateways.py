"""A gateway whose cyclic data are process data: command, set-point, state, and a parameter channel.

It reads and writes the inverters by itself, each at a port of its own. The fields of one inverter
begin with the name of its channel: `a_command`, `b_status`.
"""

from collections.abc import Iterable
from typing import Annotated, Literal

from pydantic import Field

from fbgen.catalog.gateways import unknown_name
from fbgen.catalog.layouts import CyclicField, Layout
from fbgen.catalog.located import Located
from fbgen.catalog.named import no_duplicates, pick
from fbgen.catalog.profibus_gateways import ProfibusGateway
from fbgen.catalog.scalars import Count, Flag, HexWord, SnakeName, Text
from fbgen.catalog.sourced import Duration, Sourced
from fbgen.diagnostics import Diagnostic

Memory = Literal["ram", "eeprom"]


class Channel(Sourced):
    """A port for one inverter. `powers_gateway`: the gateway lives on the supply of this one.

    `diagnosis_bit` is set in the diagnosis byte while the inverter is tripped.
    """

    name: SnakeName
    title: Text
    powers_gateway: Flag
    diagnosis_bit: Annotated[Count, Field(le=7)]


class CyclicData(Sourced):
    """A field of every channel that is exchanged with the inverter all the time.

    `comno` is the cell of the inverter that an output is written to or an input is read from.
    """

    field: SnakeName
    comno: HexWord
    title: Text


class RequestCode(Sourced):
    """A value of the request bits. `memory`: where a write leaves the value, None for no write."""

    code: Annotated[Count, Field(le=3)]
    name: SnakeName
    title: Text
    memory: Memory | None = None


class ResponseCode(Sourced):
    """A value of the response bits."""

    code: Annotated[Count, Field(le=3)]
    name: SnakeName
    title: Text


class AccessError(Sourced):
    """What stands in the data word of an error response."""

    code: HexWord
    name: SnakeName
    title: Text


class LocalParameter(Sourced):
    """A number that the gateway answers by itself, at each channel alike. It can only be read."""

    number: HexWord
    name: SnakeName
    title: Text


class ParameterChannel(Sourced):
    """How parameters are read and written, by the names of fields and bits.

    `request` is the bit field in the word `action`, `response` the one in the word `response`.
    `number` and `data` are fields in both directions. Layouts without these fields have no
    parameter channel.
    """

    action: SnakeName
    request: SnakeName
    response_word: SnakeName
    response: SnakeName
    number: SnakeName
    data: SnakeName
    requests: tuple[RequestCode, ...]
    responses: tuple[ResponseCode, ...]
    errors: tuple[AccessError, ...]
    local: tuple[LocalParameter, ...] = ()

    def request_code(self, name: str) -> int:
        """The request of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.requests, name, "FB1105", f"there is no request '{name}'").code

    def response_code(self, name: str) -> int:
        """The response of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.responses, name, "FB1105", f"there is no response '{name}'").code

    def error(self, name: str) -> AccessError:
        """The error of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.errors, name, "FB1105", f"there is no access error '{name}'")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice."""
        yield from super().problems()
        yield from no_duplicates(self.requests, "code", lambda item: str(item.code), "request")
        yield from no_duplicates(self.responses, "code", lambda item: str(item.code), "response")
        yield from no_duplicates(self.errors, "code", lambda item: f"{item.code:04X}", "error")


class Autoscan(Sourced):
    """How the gateway finds an inverter: it tries these rates and parities until one answers."""

    baud_rates: tuple[Count, ...] = Field(min_length=1)
    parities: tuple[Literal["none", "even", "odd"], ...] = Field(min_length=1)


class ProcessDataTimes(Located):
    """The times of such a gateway, in milliseconds.

    `processing`: its own, from an answer to the next request. `reply_timeout`: without an answer
    for so long the inverter counts as gone. `parameter_min` and `parameter_max`: from a request
    in the parameter channel to its response. `heartbeat`: period of the lamp that shows life.
    """

    processing: Duration
    reply_timeout: Duration
    parameter_min: Duration
    parameter_max: Duration
    heartbeat: Duration


class ProcessDataGateway(ProfibusGateway):
    """A gateway for process data. Bit `online` of the word `status` is made by the gateway."""

    kind: Literal["process_data"]
    channels: tuple[Channel, ...] = Field(min_length=1)
    outputs: tuple[CyclicData, ...]
    inputs: tuple[CyclicData, ...]
    parameter_channel: ParameterChannel
    autoscan: Autoscan
    times: ProcessDataTimes

    def channel(self, name: str) -> Channel:
        """The channel of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.channels, name, "FB1105", f"'{self.id}' has no channel '{name}'")

    def channels_of(self, layout: Layout) -> tuple[Channel, ...]:
        """The channels that a layout has room for."""
        names = {field.name for field in layout.input}
        first = self.inputs[0].field
        return tuple(item for item in self.channels if f"{item.name}_{first}" in names)

    def has_parameter_channel(self, layout: Layout) -> bool:
        """Whether parameters can be reached with a layout."""
        wanted = f"{self.channels[0].name}_{self.parameter_channel.action}"
        return any(field.name == wanted for field in layout.output)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name that is not there."""
        yield from super().problems()
        yield from no_duplicates(self.channels, "name", lambda item: item.name, "channel")
        access = self.parameter_channel
        for word, bit in ((access.action, "request"), (access.response_word, "response")):
            found = next((item for item in self.words if item.name == word), None)
            bits = found.bits if found is not None else ()
            yield from unknown_name(access, bit, getattr(access, bit), bits)
        status = next((item for item in self.words if item.name == "status"), None)
        if status is None or "online" not in {bit.name for bit in status.bits}:
            yield Diagnostic(
                "FB1105",
                "a gateway for process data needs the bit 'online' in the word 'status'",
                self.key_span_of("words"),
            )
        known = {
            "output": {
                *(item.field for item in self.outputs),
                access.action, access.number, access.data,
            },
            "input": {
                *(item.field for item in self.inputs),
                access.response_word, access.number, access.data,
            },
        }  # fmt: skip
        for layout in self.layouts:
            for side, fields in (("output", layout.output), ("input", layout.input)):
                yield from self._fields(fields, known[side])

    def _fields(self, fields: Iterable[CyclicField], names: set[str]) -> Iterable[Diagnostic]:
        known = {f"{channel.name}_{name}" for channel in self.channels for name in names}
        for field in fields:
            if not field.pad and field.name not in known:
                yield Diagnostic(
                    "FB1105",
                    f"the field '{field.name}' is none that a channel of this gateway has",
                    field.span_of("name"),
                    "write the channel's name, _ and the name of the data; pad: true for the rest",
                )
