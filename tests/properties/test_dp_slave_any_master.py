"""A DP slave under any master: legal and illegal services in any order, telegrams broken between.

The model here knows the slave's states by itself and shares no code with it. After every step the
slave is in a state that the specification has, its diagnosis says which, and it has answered as the
model says. At the end a master that starts over gets into data exchange.
"""

from hypothesis import settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, precondition, rule

from fbgen.wire.fdl import DataTelegram, ShortAcknowledgement, Telegram, encode
from harness.fieldbus import SlaveState
from tests.unit.fieldbus.wire_bench import ADDRESS, CONFIGURATION, WireBench

FREE = 255
RIGHT = bytes.fromhex("88 01 0A 0B 12 34 01")
"""Set_Prm: lock, watchdog 1 x 10 x 10 ms, ident 1234, group 1."""
WRONG_PRM = (
    bytes.fromhex("88 01 0A 0B 12 35 01"),  # ident
    bytes.fromhex("88 00 0A 0B 12 34 01"),  # watchdog factor 0
    bytes.fromhex("88 01 0A 0B 12 34 01 00"),  # user data
    bytes.fromhex("88 01 0A 0B 12 34"),  # too short
    b"",
)
UNLOCKS = (bytes.fromhex("40 01 01 0B 12 34 01"), bytes.fromhex("C0 01 01 0B 12 34 01"))
NEITHER = bytes.fromhex("00 01 01 00 12 34 01")
SRD, FIRST, COUNTED = 0x4D, 0x6D, (0x5D, 0x7D)
WATCHDOG_MS = 100
masters = st.sampled_from([1, 3])
ACKNOWLEDGED = "acknowledged"
REFUSED = "refused"


class AnyMaster(RuleBasedStateMachine):
    """The slave behind its cable, and what the specification says about it."""

    @initialize(inputs=st.binary(min_size=3, max_size=3))
    def begin(self, inputs: bytes) -> None:
        self.bench = WireBench()
        self.bench.slave.set_inputs(inputs)
        self.inputs = inputs
        self.state, self.owner, self.online = "prm", FREE, False
        self.prm_fault = self.cfg_fault = False
        self.silent_ms = 0
        self.repeatable: tuple[int, int, Telegram | None] | None = None

    # --- the model --------------------------------------------------------------------------

    def to_wait_prm(self, *, prm_fault: bool = False, cfg_fault: bool = False) -> None:
        self.state, self.owner, self.online = "prm", FREE, False
        self.prm_fault, self.cfg_fault = prm_fault, cfg_fault

    def heard(self, master: int) -> None:
        if master == self.owner:
            self.silent_ms = 0

    def ask(self, sap: int | None, data: bytes, master: int, control: int = SRD) -> str | bytes:
        answer = self.bench.ask(sap, data, master, control)
        counted = control in (FIRST, *COUNTED)
        self.repeatable = (master, control, answer) if counted else None
        if isinstance(answer, ShortAcknowledgement):
            return ACKNOWLEDGED
        assert isinstance(answer, DataTelegram)
        assert (answer.destination, answer.source) == (master, ADDRESS)
        if answer.function == 0x3:
            assert answer.unit == b""
            return REFUSED
        assert answer.function == 0x8
        return answer.data

    # --- services ---------------------------------------------------------------------------

    @rule(master=masters)
    def set_prm(self, master: int) -> None:
        may = self.owner in (FREE, master)
        assert self.ask(61, RIGHT, master) == (ACKNOWLEDGED if may else REFUSED)
        if may:
            self.to_wait_prm()
            self.state, self.owner = "cfg", master
        self.heard(master)

    @rule(master=masters, data=st.sampled_from([*WRONG_PRM, *UNLOCKS, NEITHER]))
    def set_prm_that_gives_no_parameters(self, master: int, data: bytes) -> None:
        may = self.owner in (FREE, master)
        assert self.ask(61, data, master) == (ACKNOWLEDGED if may else REFUSED)
        if may and data != NEITHER:
            self.to_wait_prm(prm_fault=data in WRONG_PRM)
        self.heard(master)

    @rule(master=masters)
    def chk_cfg(self, master: int) -> None:
        may = self.state != "prm" and self.owner == master
        assert self.ask(62, CONFIGURATION, master) == (ACKNOWLEDGED if may else REFUSED)
        if may:
            self.state = "dx"
        self.heard(master)

    @rule(master=masters, data=st.binary(max_size=6).filter(lambda data: data != CONFIGURATION))
    def wrong_chk_cfg(self, master: int, data: bytes) -> None:
        may = self.state != "prm" and self.owner == master
        assert self.ask(62, data, master) == (ACKNOWLEDGED if may else REFUSED)
        if may:
            self.to_wait_prm(cfg_fault=True)
        self.heard(master)

    @rule(master=masters)
    def get_going(self, master: int) -> None:
        """As masters do it; else random steps would rarely come as far as data exchange."""
        self.set_prm(master)
        self.chk_cfg(master)
        self.data_exchange(master, bytes(5), SRD)

    @rule(
        master=masters,
        outputs=st.sampled_from([bytes(5), b"\x01\x02\x03\x04\x05", b"", bytes(4), bytes(6)]),
        control=st.sampled_from([SRD, FIRST]),
    )
    def data_exchange(self, master: int, outputs: bytes, control: int) -> None:
        may = self.state == "dx" and self.owner == master
        right = may and len(outputs) == 5
        frozen = self.bench.slave.freeze
        answer = self.ask(None, outputs, master, control)
        assert answer == REFUSED if not right else frozen or answer == self.inputs
        if right:
            self.online = True
        elif may:
            self.to_wait_prm()
        self.heard(master)

    @rule(master=masters, sap=st.sampled_from([56, 57, 59, 60]))
    def read(self, master: int, sap: int) -> None:
        answer = self.ask(sap, b"", master)
        if sap in (56, 57):
            assert (answer == REFUSED) is (self.state != "dx")
        elif sap == 59:
            assert answer == CONFIGURATION
        else:
            assert isinstance(answer, bytes)
            assert len(answer) == 6
        self.heard(master)

    @rule(
        master=masters,
        sap=st.integers(0, 63).filter(lambda sap: sap not in (56, 57, 59, 60, 61, 62)),
        data=st.binary(max_size=8),
    )
    def service_that_is_not_there(self, master: int, sap: int, data: bytes) -> None:
        assert self.ask(sap, data, master) == REFUSED
        self.heard(master)

    @rule(master=masters, command=st.integers(0, 255), groups=st.integers(0, 255))
    def global_control(self, master: int, command: int, groups: int) -> None:
        slave = self.bench.slave
        before = (slave.sync, slave.freeze, slave.outputs)
        self.bench.global_control(command, groups, master)
        meant = self.state == "dx" and self.owner == master and (not groups or groups & 1)
        if not meant:
            assert (slave.sync, slave.freeze, slave.outputs) == before
        elif command & 0x02:
            assert slave.outputs == bytes(5)

    @rule(master=masters)
    def status(self, master: int) -> None:
        answer = self.bench.telegram(DataTelegram(ADDRESS, master, 0x49))
        assert answer == DataTelegram(master, ADDRESS, 0)

    # --- disturbances -------------------------------------------------------------------------

    @precondition(lambda self: self.repeatable is not None and self.repeatable[1] == FIRST)
    @rule(outputs=st.binary(min_size=5, max_size=5))
    def repeat_as_the_slave_sees_it(self, outputs: bytes) -> None:
        """Bit and sender as in the latest request: what was meant does not matter."""
        assert self.repeatable is not None
        master, _, answer = self.repeatable
        told = len(self.bench.device.told)
        assert self.bench.ask(None, outputs, master, 0x7D) == answer
        assert len(self.bench.device.told) == told
        self.heard(master)

    @rule(data=st.binary(max_size=30))
    def garbage(self, data: bytes) -> None:
        # A whole telegram by chance is not what is meant here: nothing that ends like one.
        self.bench.octets(data.replace(b"\x16", b"\x17"))
        self.bench.segment.silence()

    @rule(
        master=masters,
        sap=st.sampled_from([None, 56, 57, 58, 59, 60, 61, 62]),
        bit=st.integers(0, 300),
        cut=st.booleans(),
    )
    def broken_telegram(self, master: int, sap: int | None, bit: int, cut: bool) -> None:
        contents = {61: UNLOCKS[0], 62: b"\x00", None: bytes(5)}.get(sap, b"")
        source_sap = None if sap is None else 62
        whole = bytearray(encode(DataTelegram(ADDRESS, master, SRD, contents, sap, source_sap)))
        if cut:
            del whole[bit % len(whole) :]
        else:
            whole[bit // 8 % len(whole)] ^= 1 << bit % 8
        assert self.bench.octets(bytes(whole)) == b""
        assert self.bench.segment.silence() == b""

    @rule(milliseconds=st.sampled_from([1, 40, 99, 100, 101, 1000]))
    def time_passes(self, milliseconds: int) -> None:
        self.bench.run_ms(milliseconds)
        self.silent_ms += milliseconds
        if self.owner != FREE and self.silent_ms >= WATCHDOG_MS:
            self.to_wait_prm()

    @rule(inputs=st.binary(min_size=3, max_size=3))
    def device_has_new_inputs(self, inputs: bytes) -> None:
        self.bench.slave.set_inputs(inputs)
        self.inputs = inputs

    @rule()
    def supply_is_gone_for_a_moment(self) -> None:
        self.bench.slave.power_off()
        assert self.bench.telegram(DataTelegram(ADDRESS, 1, 0x49)) is None
        self.bench.slave.power_on(ADDRESS)
        self.to_wait_prm()
        self.repeatable = None

    # --- what holds always --------------------------------------------------------------------

    @invariant()
    def the_slave_is_where_the_specification_says(self) -> None:
        slave = self.bench.slave
        states = {
            "prm": SlaveState.WAIT_PRM,
            "cfg": SlaveState.WAIT_CFG,
            "dx": SlaveState.DATA_EXCHANGE,
        }
        assert slave.state is states[self.state]
        assert (slave.master_address, slave.online) == (self.owner, self.online)
        assert (slave.parameters is None) is (self.state == "prm")
        if self.state != "dx":
            assert not slave.sync
            assert not slave.freeze
            assert slave.outputs == bytes(5)

    @invariant()
    def the_diagnosis_says_so(self) -> None:
        told = self.bench.slave.slave_diag()
        first = 0x02 * (self.state != "dx") | 0x04 * self.cfg_fault | 0x40 * self.prm_fault
        assert told[0] == first
        assert told[1] & 0x0F == 0x04 | 0x08 * (self.state != "prm") | (self.state == "prm")
        assert told[2:] == bytes((0, self.owner, 0x12, 0x34))

    @invariant()
    def the_device_was_told_in_order(self) -> None:
        marks = [what for what in self.bench.device.told if what in ("started", "lost")]
        assert marks == (["started", "lost"] * len(marks))[: len(marks)]
        assert (len(marks) % 2 == 1) is self.online

    def teardown(self) -> None:
        """A master that starts over gets there: the slave's own, or any if it has none."""
        if not hasattr(self, "bench"):
            return
        master = 1 if self.owner == FREE else self.owner
        self.ask(60, b"", master)
        assert self.ask(61, RIGHT, master) == ACKNOWLEDGED
        assert self.ask(62, CONFIGURATION, master) == ACKNOWLEDGED
        assert self.ask(60, b"", master)[:4] == bytes((0, 0x0C, 0, master))
        assert self.ask(None, bytes(5), master) == self.inputs


TestAnyMaster = AnyMaster.TestCase
TestAnyMaster.settings = settings(max_examples=25, stateful_step_count=40)
