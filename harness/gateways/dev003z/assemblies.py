"""The data of the assemblies: what the master's bytes ask for, and the bytes that it gets.

Which field lies where, and which word has which bits, stands in the catalogue (E6581737, pages 16
to 25). Fields are known by their names there.
"""

from collections.abc import Mapping

from fbgen.catalog import Assembly, AssemblyPair, Word
from fbgen.catalog.devicenet_gateways import AssemblyField
from harness.gateways.dev003z.commands import COMMAND, FREQUENCY
from harness.gateways.dev003z.control_supervisor import State
from harness.gateways.dev003z.parts import Parts
from harness.gateways.dev003z.register_channel import RegisterChannel

OUTPUT_FREQUENCY, FREQUENCY_COMMAND, STATUS = 0xFD00, 0xFD02, 0xFD01


class Assemblies:
    """Takes and makes the data of any pair of assemblies; `chosen` is that of the connections."""

    __slots__ = (
        "_cells",
        "_channel",
        "_commands",
        "_gateway",
        "_host",
        "_own",
        "_speeds",
        "_taken",
        "_words",
        "chosen",
    )

    def __init__(self, parts: Parts) -> None:
        self._gateway = gateway = parts.gateway
        self._host = parts.host
        self._own = parts.own
        self._cells = parts.cells
        self._commands = parts.commands
        self._speeds = parts.speeds
        self._channel = RegisterChannel(parts.cells)
        self._words: Mapping[str, Word] = {word.name: word for word in gateway.words}
        self._taken: dict[int, bytes] = {}
        self.chosen = gateway.assemblies[0]
        self.restart()

    def restart(self) -> None:
        """As after power-on: c203 acts from now on."""
        self._channel.clear()
        self._taken.clear()
        setting = self._own[self._gateway.assembly_parameter]
        self.chosen = next(pair for pair in self._gateway.assemblies if pair.setting == setting)

    def forget_request(self) -> None:
        """What the register channel was asked for last does not count any more."""
        self._channel.clear()

    def find(self, instance: int) -> tuple[AssemblyPair, Assembly] | None:
        """An assembly by its instance, and the pair that it belongs to."""
        for pair in self._gateway.assemblies:
            for assembly in (pair.output, pair.input):
                if assembly.instance == instance:
                    return pair, assembly
        return None

    # From the master

    def take(self, pair: AssemblyPair, data: bytes, state: State) -> None:
        """Data of the master, of the right length, in a state of the Control Supervisor."""
        self._taken[pair.output.instance] = data
        values = {
            field.name: int.from_bytes(data[field.offset : field.offset + field.length], "little")
            for field in pair.output.fields
        }
        bits = self._control_bits(pair.output, values)
        if "speed" in values:
            self._commands.set_speed(_signed(values["speed"]))
        if bits is not None:
            self._take_control(bits, state)
        if "frequency" in values:
            self._commands.write_frequency(values["frequency"])
        if "command" in values:
            self._commands.write_command(values["command"])
        for field in pair.output.fields:
            if field.parameter is not None:
                self._take_chosen(field, values[field.name])
        self._take_request(pair, values)

    def _control_bits(
        self, output: Assembly, values: Mapping[str, int]
    ) -> Mapping[str, int] | None:
        if "control" not in values:
            return None
        word = self._words[output.field("control").word or ""]
        return {field.name: field.extract(values["control"]) for field in word.bits}

    def _take_control(self, bits: Mapping[str, int], state: State) -> None:
        """Bits of instance 20, 21 or 101. What 20 lacks is an attribute: Net Ctrl and Net Ref."""
        commands = self._commands
        commands.set_fault_reset(bool(bits["fault_reset"]))
        commands.set_links(
            control=bool(bits.get("net_control", commands.net_control)),
            reference=bool(bits.get("net_reference", commands.net_reference)),
        )
        commands.set_runs(bool(bits["run_forward"]), bool(bits.get("run_reverse", 0)), state)

    def _take_chosen(self, field: AssemblyField, word: int) -> None:
        chosen = self._own[field.parameter or ""]
        number = next((item.comno for item in self._gateway.commands if item.code == chosen), None)
        if number == COMMAND:
            self._commands.write_command(word)
        elif number == FREQUENCY:
            self._commands.write_frequency(word)
        elif number is not None and self._host.powered:
            self._host.write_ram(number, word)

    def _take_request(self, pair: AssemblyPair, values: Mapping[str, int]) -> None:
        found = next(
            (item for item in self._gateway.register_channels if item.assemblies == pair.name), None
        )
        if found is None:
            return
        word = self._words[pair.output.field(found.request).word or ""]
        write = bool(word.field("write").extract(values[found.request]))
        number = values[found.index]
        if found.index == found.request:
            # Fifteen bits: numbers from F000 on are written as instances of class 64 are.
            number = word.field("index").extract(number)
            number = number | 0x8000 if number >= 0x7000 else number
        self._channel.ask(write, number, values[found.data])

    # To the master

    def make(self, pair: AssemblyPair, status: Mapping[str, int]) -> bytes:
        """The data for the master; `status` are the bits of instances 70, 71 and 151."""
        data = bytearray(pair.input.length)
        channel = self._channel_values(pair)
        for field in pair.input.fields:
            value = channel.get(field.name)
            if value is None:
                value = self._value(field, status)
            data[field.offset : field.offset + field.length] = value.to_bytes(2, "little")
        return bytes(data)

    def outputs(self, pair: AssemblyPair) -> bytes:
        """What the master sent last as an output assembly."""
        return self._taken.get(pair.output.instance, bytes(pair.output.length))

    def _value(self, field: AssemblyField, status: Mapping[str, int]) -> int:
        if field.parameter is not None:
            chosen = self._own[field.parameter]
            found = (item.comno for item in self._gateway.monitors if item.code == chosen)
            number = next(found, None)
            return 0 if number is None else self._read(number)
        if field.name == "speed":
            return self._speeds.per_minute(self._read(OUTPUT_FREQUENCY))
        if field.name == "frequency":
            return self._read(OUTPUT_FREQUENCY)
        word = self._words[field.word or ""]
        if field.word == "status":
            return self._read(STATUS)
        return word.encode({bit.name: status[bit.name] for bit in word.bits})

    def _channel_values(self, pair: AssemblyPair) -> Mapping[str, int]:
        found = next(
            (item for item in self._gateway.register_channels if item.assemblies == pair.name), None
        )
        if found is None:
            return {}
        write, failed, number, data = self._channel.answer()
        word = self._words[pair.input.field(found.response).word or ""]
        error = word.field("error").mask if failed else 0
        if found.index == found.response:
            return {found.index: number & word.field("index").mask | error, found.data: data}
        function = word.encode({"write": int(write)}) | error
        return {found.response: function, found.index: number, found.data: data}

    def _read(self, number: int) -> int:
        return self._cells.read(number) or 0


def _signed(word: int) -> int:
    """A word as INT, which speeds are."""
    return word - 0x10000 if word & 0x8000 else word
