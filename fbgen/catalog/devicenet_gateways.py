"""A DeviceNet adapter inside an inverter: assemblies, objects, its own parameters, and selections.

It has no line to the inverter: it reads and writes its cells by itself. Data are little endian.
"""

from collections.abc import Iterable
from typing import Literal

from pydantic import Field

from fbgen.catalog.devicenet_objects import ObjectClass
from fbgen.catalog.gateways import Gateway, unknown_name
from fbgen.catalog.layouts import gaps
from fbgen.catalog.located import Located
from fbgen.catalog.named import named_in, no_duplicates, pick
from fbgen.catalog.scalars import Count, EntryId, HexByte, HexWord, Number, SnakeName, Text, Whole
from fbgen.catalog.sourced import Duration, Sourced, unknown_fields
from fbgen.diagnostics import Diagnostic

OF_F = 0xF000
"""The first communication number that begins with F."""


class DeviceNetPort(Sourced):
    """The adapter as a DeviceNet node. `baud_rates`: value of the attribute -> kbit/s.

    `product_codes` are those of the inverter series that it can be inside of. `explicit_bytes`: the
    longest explicit message; `body_format`: bits of class and instance in explicit requests.
    """

    minimum_mac: Count
    maximum_mac: Count
    baud_rates: dict[Number, Count]
    vendor_id: Count
    device_type: Count
    product_codes: dict[EntryId, Count]
    product_name: Text
    max_connections: Count
    explicit_bytes: Count
    body_format: Literal["8_8", "8_16", "16_16", "16_8"]
    unverified: tuple[SnakeName, ...] = ()

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1105 fields that are none; FB1108 a range that is none."""
        yield from super().problems()
        yield from unknown_fields(self, self.unverified)
        if not 0 <= self.minimum_mac <= self.maximum_mac <= 63:
            message = f"{self.minimum_mac} to {self.maximum_mac} is no range of MAC IDs"
            yield Diagnostic("FB1108", message, self.span_of("maximum_mac"), "they are 0 to 63")


class AssemblyField(Located):
    """A field of an assembly. `word` names the bits of one that has them.

    `parameter` names the parameter of the adapter that chooses what a field carries.
    """

    name: SnakeName
    offset: Count
    length: Literal[2]
    title: Text
    unit: Text | None = None
    word: SnakeName | None = None
    parameter: SnakeName | None = None


class Assembly(Sourced):
    """The data of one assembly instance, in bytes from 0."""

    instance: Count
    title: Text
    fields: tuple[AssemblyField, ...] = Field(min_length=1)
    unverified: tuple[SnakeName, ...] = ()

    @property
    def length(self) -> int:
        """Bytes in all."""
        return self.fields[-1].offset + self.fields[-1].length

    def field(self, name: str) -> AssemblyField:
        """The field of a name. Raises DiagnosticError FB1105 with the nearest names."""
        message = f"assembly {self.instance} has no field '{name}'"
        return pick(self.fields, name, "FB1105", message)

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1102 a field twice; FB1106 a gap or an overlap; FB1105 no field."""
        yield from super().problems()
        yield from no_duplicates(self.fields, "name", lambda item: item.name, "field")
        for name in self.unverified:
            names = [field.name for field in self.fields]
            yield from named_in(self, "unverified", name, names, "field")
        yield from gaps(self.fields)


class AssemblyPair(Located):
    """What is exchanged together: `setting` is the value of the choosing parameter."""

    name: EntryId
    title: Text
    setting: Count
    output: Assembly
    input: Assembly


class AdapterParameter(Sourced):
    """A parameter of the adapter, in counts of `resolution`. `display` is its name at the panel."""

    number: HexWord
    name: SnakeName
    display: Text
    title: Text
    minimum: Whole
    maximum: Whole
    default: Whole
    resolution: float = 1.0
    unit: str = ""
    values: dict[Number, Text] = Field(default_factory=dict)
    unverified: tuple[SnakeName, ...] = ()

    def problems(self) -> Iterable[Diagnostic]:
        """FB1103 no source; FB1105 no field; FB1108 a default or a value outside of the range."""
        yield from super().problems()
        yield from unknown_fields(self, self.unverified)
        for value in (self.default, *self.values):
            if not self.minimum <= value <= self.maximum:
                message = f"{value} is no value of {self.display}"
                help_ = f"the range is {self.minimum} to {self.maximum}"
                yield Diagnostic("FB1108", message, self.span_of("default"), help_)


class Selection(Sourced):
    """A value of a choosing parameter, and the cell of the inverter that it stands for."""

    code: Count
    comno: HexWord
    title: Text


class RegisterChannel(Sourced):
    """How parameters are read and written inside of an assembly.

    `request` and `response` are fields that say what is asked for and how it went, by the bits
    `write` and `error` or by codes; `index` and `data` are fields in both directions.
    """

    assemblies: EntryId
    request: SnakeName
    response: SnakeName
    index: SnakeName
    data: SnakeName


class ParameterObject(Sourced):
    """The class whose instances are the cells of the inverter.

    The instance is the communication number plus `offset`, of those that begin with F less
    `offset_of_f`, in 16 bits; the value is its attribute `attribute`.
    """

    code: HexByte
    attribute: Count
    offset: HexWord
    offset_of_f: HexWord

    def instance(self, number: int) -> int:
        """The instance of a communication number."""
        offset = -self.offset_of_f if number >= OF_F else self.offset
        return number + offset & 0xFFFF

    def number(self, instance: int) -> int:
        """The communication number of an instance."""
        above = instance + self.offset_of_f
        return above if OF_F <= above <= 0xFFFF else instance - self.offset & 0xFFFF


class DeviceNetTimes(Located):
    """The times of an adapter, in milliseconds.

    `self_test`: from power-on to its first message. `duplicate_check`: how long it waits for an
    answer to each of its duplicate MAC checks. `response`: from a request to its answer.
    `fragment_timeout`: how long it waits for an acknowledgement or the next fragment.
    `unused`: how long an I/O connection may wait for its first message at least. `sample`: how
    often it looks whether data changed that it sends by itself.
    """

    self_test: Duration
    duplicate_check: Duration
    response: Duration
    fragment_timeout: Duration
    unused: Duration
    sample: Duration


class DeviceNetGateway(Gateway):
    """An adapter for DeviceNet inside an inverter, predefined master/slave connections only."""

    kind: Literal["devicenet"]
    devicenet: DeviceNetPort
    assembly_parameter: SnakeName
    assemblies: tuple[AssemblyPair, ...] = Field(min_length=1)
    parameters: tuple[AdapterParameter, ...]
    commands: tuple[Selection, ...]
    monitors: tuple[Selection, ...]
    register_channels: tuple[RegisterChannel, ...]
    parameter_object: ParameterObject
    objects: tuple[ObjectClass, ...]
    times: DeviceNetTimes

    def pair(self, name: str) -> AssemblyPair:
        """The assemblies of a name. Raises DiagnosticError FB1105 with the nearest names."""
        message = f"'{self.id}' has no assemblies '{name}'"
        return pick(self.assemblies, name, "FB1105", message)

    def parameter(self, name: str) -> AdapterParameter:
        """The adapter's own parameter of a name. Raises DiagnosticError FB1105."""
        message = f"'{self.id}' has no parameter '{name}' of its own"
        return pick(self.parameters, name, "FB1105", message)

    def object(self, name: str) -> ObjectClass:
        """The class of a name. Raises DiagnosticError FB1105 with the nearest names."""
        return pick(self.objects, name, "FB1105", f"'{self.id}' has no class '{name}'")

    def problems(self) -> Iterable[Diagnostic]:
        """FB1102 something twice; FB1105 a name that is not there."""
        yield from super().problems()
        yield from no_duplicates(self.assemblies, "name", lambda item: item.name, "assemblies")
        yield from no_duplicates(
            self.assemblies, "setting", lambda item: str(item.setting), "setting"
        )
        yield from no_duplicates(self.objects, "code", lambda item: f"{item.code:02X}", "class")
        parameters = self.parameters
        yield from no_duplicates(parameters, "name", lambda item: item.name, "parameter")
        yield from no_duplicates(parameters, "number", lambda item: f"{item.number:04X}", "number")
        for selections in (self.commands, self.monitors):
            yield from no_duplicates(selections, "code", lambda item: str(item.code), "selection")
        yield from unknown_name(
            self, "assembly_parameter", self.assembly_parameter, self.parameters
        )
        for series in self.devicenet.product_codes:
            known = self.series
            yield from named_in(self.devicenet, "product_codes", series, known, "inverter series")
        for pair in self.assemblies:
            yield from self._named(pair.output)
            yield from self._named(pair.input)
        for channel in self.register_channels:
            yield from self._channel(channel)

    def _named(self, assembly: Assembly) -> Iterable[Diagnostic]:
        for field in assembly.fields:
            if field.word is not None:
                yield from unknown_name(field, "word", field.word, self.words)
            if field.parameter is not None:
                yield from unknown_name(field, "parameter", field.parameter, self.parameters)

    def _channel(self, channel: RegisterChannel) -> Iterable[Diagnostic]:
        pair = next((item for item in self.assemblies if item.name == channel.assemblies), None)
        if pair is None:
            yield from unknown_name(channel, "assemblies", channel.assemblies, self.assemblies)
            return
        for field in ("request", "index", "data"):
            yield from unknown_name(channel, field, getattr(channel, field), pair.output.fields)
        for field in ("response", "index", "data"):
            yield from unknown_name(channel, field, getattr(channel, field), pair.input.fields)
