"""An inverter under random telegrams against a model of what it must remember and answer.

The model knows nothing of the simulation: which of two protocols is spoken, which words lie in RAM
and EEPROM, whether the inverter has tripped, and from when on it listens.
"""

import pytest
from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from fbgen.catalog import load_catalog
from fbgen.wire import modbus_rtu, toshiba_binary
from fbgen.wire.modbus import ExceptionReply, ReadReply, ReadRequest, WriteReply, WriteRequest
from fbgen.wire.toshiba import Command, ErrorReply, Reply, Request
from harness.drives import Inverter, InverterSettings, set_for_line
from harness.kernel import NS_PER_MS, NS_PER_S, Kernel
from harness.line import GATEWAY_FORMAT, Line, Reception, Role, Topology

CATALOG = load_catalog()
NUMBER = 11
WORDS = {0x0880: (0, 0xFFFF), 0x0009: (0, 32_000), 0x0010: (0, 32_000), 0xFA01: (0, 8_000)}
"""Cells that do not act on the line, with their ranges."""
IN_RAM_ONLY = (0xFA01,)
PROTOCOL = 0x0829
RESTART_NS = 3 * NS_PER_S
KEPT_BY_MODBUS = {"vf-s11": False, "vf-s15": True}

words = st.one_of(st.sampled_from([0, 50, 8_000, 0xFFFF]), st.integers(0, 0xFFFF))
cells = st.sampled_from(sorted(WORDS))


class InverterMachine(RuleBasedStateMachine):
    """Sends telegrams, switches the supply, lets trips come; keeps the model beside."""

    @initialize(series=st.sampled_from(sorted(KEPT_BY_MODBUS)), topology=st.sampled_from(Topology))
    def switch_on(self, series: str, topology: Topology) -> None:
        self.kernel = Kernel(1)
        line = Line(self.kernel, topology)
        self.port = line.attach(self, Role.MASTER, GATEWAY_FORMAT)
        self.heard: list[bytes] = []
        known = CATALOG.drive(series)
        parameters = set_for_line(known, None, 19_200, "even") | {"inverter_number": NUMBER}
        self.drive = Inverter(self.kernel, line, known, InverterSettings(parameters=parameters))
        self.ram = {number: known.comno(number).default_word for number in WORDS}
        self.eeprom = {
            number: word for number, word in self.ram.items() if number not in IN_RAM_ONLY
        }
        self.modbus = self.modbus_next = False
        self.tripped = False
        self.kept_by_modbus = KEPT_BY_MODBUS[series]

    def receive(self, reception: Reception) -> None:
        self.heard.append(reception.data)

    def _ask(self, frame: bytes) -> list[bytes]:
        self.heard.clear()
        self.port.transmit(frame)
        self.kernel.run_for(60 * NS_PER_MS)
        return self.heard

    def _write(self, number: int, word: int, kept: bool, low: int, high: int) -> None:
        taken = low <= word <= high
        if self.modbus:
            kept = self.kept_by_modbus
            (answer,) = self._ask(modbus_rtu.encode_request(WriteRequest(NUMBER, number, word)))
            said = modbus_rtu.parse_reply(answer)
            expected = WriteReply(NUMBER, number, word) if taken else ExceptionReply(NUMBER, 6, 3)
            assert said == expected
        else:
            command = Command.W if kept else Command.P
            (answer,) = self._ask(
                toshiba_binary.encode_request(Request(NUMBER, command, number, word))
            )
            reply = toshiba_binary.parse_reply(answer)
            assert reply is not None
            assert reply.tripped is self.tripped
            if taken:
                assert isinstance(reply, Reply)
                assert (reply.command, reply.com_no, reply.data) == (command, number, word)
            else:
                assert isinstance(reply, ErrorReply)
                assert reply.error == 1
        if taken and number in self.ram:
            self.ram[number] = word
            if kept and number in self.eeprom:
                self.eeprom[number] = word
        if taken and number == PROTOCOL and kept:
            self.modbus_next = bool(word)

    @rule(number=cells, word=words, kept=st.booleans())
    def write(self, number: int, word: int, kept: bool) -> None:
        low, high = WORDS[number]
        self._write(number, word, kept, low, high)

    @rule(word=st.integers(0, 2))
    def choose_protocol(self, word: int) -> None:
        self._write(PROTOCOL, word, True, 0, 1)

    @rule(number=cells)
    def read(self, number: int) -> None:
        if self.modbus:
            (answer,) = self._ask(modbus_rtu.encode_request(ReadRequest(NUMBER, number)))
            assert modbus_rtu.parse_reply(answer) == ReadReply(NUMBER, (self.ram[number],))
            return
        (answer,) = self._ask(toshiba_binary.encode_request(Request(NUMBER, Command.G, number)))
        reply = toshiba_binary.parse_reply(answer)
        assert reply == Reply(NUMBER, Command.G, number, self.ram[number], self.tripped)

    @rule(frame=st.binary(min_size=1, max_size=24))
    def hear_rubbish(self, frame: bytes) -> None:
        said = toshiba_binary.parse_request(frame) or modbus_rtu.parse_request(frame)
        if said is None and b"(" not in frame and b"/" not in frame:
            assert self._ask(frame) == []
            self.kernel.run_for(NS_PER_S)

    @rule(number=cells, word=words, other=st.sampled_from([1, 12, 47]))
    def write_to_another(self, number: int, word: int, other: int) -> None:
        if self.modbus:
            frame = modbus_rtu.encode_request(WriteRequest(other, number, word))
        else:
            frame = toshiba_binary.encode_request(Request(other, Command.W, number, word))
        assert self._ask(frame) == []

    @rule(number=cells, word=words)
    def speak_the_other_protocol(self, number: int, word: int) -> None:
        if self.modbus:
            frame = toshiba_binary.encode_request(Request(NUMBER, Command.W, number, word))
        else:
            frame = modbus_rtu.encode_request(WriteRequest(NUMBER, number, word))
        assert self._ask(frame) == []
        self.kernel.run_for(NS_PER_S)

    @precondition(lambda self: not self.tripped)
    @rule()
    def trip(self) -> None:
        self.drive.trip("OC1")
        self.tripped = True

    def _restarted(self) -> None:
        self.kernel.run_for(RESTART_NS)
        fresh = dict.fromkeys(IN_RAM_ONLY, 0)
        self.ram = {**fresh, **self.eeprom}
        self.modbus, self.tripped = self.modbus_next, False

    @rule()
    def reset_over_the_line(self) -> None:
        if self.modbus:
            frame = modbus_rtu.encode_request(WriteRequest(NUMBER, 0xFA00, 0x2000))
        else:
            frame = toshiba_binary.encode_request(Request(NUMBER, Command.P, 0xFA00, 0x2000))
        assert self._ask(frame) == []
        self._restarted()

    @rule()
    def switch_off_and_on(self) -> None:
        self.drive.power_off()
        assert self._ask(b"(11RFC90)\r") == []
        self.drive.power_on()
        self._restarted()

    @invariant()
    def tells_no_more_than_the_model(self) -> None:
        if not hasattr(self, "drive"):
            return
        assert {number: self.drive.read_word(number) for number in WORDS} == self.ram
        assert self.drive.tripped is self.tripped
        assert self.drive.communication.protocol == ("modbus" if self.modbus else "toshiba")


InverterMachine.TestCase.settings = settings(max_examples=25, stateful_step_count=30)
test_inverter_remembers_and_answers_as_the_model = pytest.mark.filterwarnings("error")(
    InverterMachine.TestCase
)
