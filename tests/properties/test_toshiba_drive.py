"""The simulated inverter under any telegrams whatever: it never fails, and a seed repeats it."""

from hypothesis import given, settings
from hypothesis import strategies as st

from fbgen.catalog import Drive, load_catalog
from fbgen.wire import modbus
from fbgen.wire.toshiba import Command, Request
from fbgen.wire.toshiba_binary import encode_request
from fbgen.wire.toshiba_block import BlockRequest
from fbgen.wire.toshiba_block import encode_request as encode_block
from harness.drives import Inverter, InverterSettings, Load, set_for_line
from harness.kernel import NS_PER_MS, Kernel
from harness.line import GATEWAY_FORMAT, Line, Reception, Role, Topology

CATALOG = load_catalog()
NUMBERS = [comno.number for comno in CATALOG.drive("vf-as1").comnos]
chosen = st.tuples(
    st.sampled_from([CATALOG.drive(name) for name in ("vf-s11", "vf-s15", "vf-as1")]),
    st.booleans(),
)
"""A series, and whether it speaks MODBUS."""

requests = st.builds(
    lambda address, command, com_no, data: encode_request(Request(address, command, com_no, data)),
    st.sampled_from([None, 0, 1, 2, 0xFF]),
    st.sampled_from(Command),
    st.one_of(st.sampled_from(NUMBERS), st.integers(0, 0xFFFF)),
    st.one_of(st.integers(0, 0xFFFF), st.sampled_from([0xC400, 0xC600, 5000, 0])),
)
blocks = st.builds(
    lambda words, reads: encode_block(BlockRequest(1, tuple(words), reads)),
    st.lists(st.sampled_from([0xC400, 0xC600, 5000, 0]), max_size=2),
    st.integers(0, 5),
)
modbus_frames = st.builds(
    lambda address, function, rest: modbus.seal(bytes((address, function)) + rest),
    st.integers(0, 2),
    st.sampled_from([3, 6, 0x10, 0x17, 0x2B]),
    st.binary(min_size=2, max_size=12),
)
modbus_writes = st.builds(
    lambda address, com_no, word: modbus.seal(
        bytes((address, 6)) + com_no.to_bytes(2, "big") + word.to_bytes(2, "big")
    ),
    st.integers(0, 2),
    st.sampled_from(NUMBERS),
    st.integers(0, 0xFFFF),
)
frames = st.one_of(
    requests, blocks, modbus_frames, modbus_writes, st.binary(min_size=1, max_size=20)
)
gaps_ms = st.sampled_from([0, 1, 10, 40, 700, 2500])
plans = st.lists(st.tuples(frames, gaps_ms), max_size=12)


class Recorder:
    """A master that writes down what it hears."""

    def __init__(self) -> None:
        self.trace: list[tuple[int, bytes, bytes | None]] = []

    def receive(self, reception: Reception) -> None:
        self.trace.append((reception.end_ns, reception.data, reception.marks))


def play(
    plan: list[tuple[bytes, int]], seed: int, topology: Topology, of: tuple[Drive, bool]
) -> tuple[list[Inverter], Recorder]:
    series, speaks_modbus = of
    assert series.communication is not None
    facts = series.communication.ports[0]
    assert facts.protocol is not None
    basis = set_for_line(series, None, 19_200, "even") | {facts.protocol: float(speaks_modbus)}
    kernel = Kernel(seed)
    line = Line(kernel, topology)
    line.master_pair.interference.bit_errors.probability = 0.001
    recorder = Recorder()
    port = line.attach(recorder, Role.MASTER, GATEWAY_FORMAT)
    drives = [
        Inverter(
            kernel,
            line,
            series,
            InverterSettings(
                parameters=basis | {"inverter_number": number, "communication_timeout": 1},
                load=Load(50.0, inertia_percent_s=2.0),
            ),
        )
        for number in (0, 1, 2)
    ]
    for frame, gap_ms in plan:
        port.transmit(frame)
        kernel.run_for(gap_ms * NS_PER_MS)
    kernel.run_for(100 * NS_PER_MS)
    return drives, recorder


@settings(max_examples=60)
@given(plans, st.integers(0, 3), st.sampled_from(Topology), chosen)
def test_inverter_stays_within_its_ranges_whatever_it_hears(
    plan: list[tuple[bytes, int]], seed: int, topology: Topology, of: tuple[Drive, bool]
) -> None:
    for drive in play(plan, seed, topology, of)[0]:
        for comno in drive.series.comnos:
            word = drive.read_word(comno.number)
            assert 0 <= word <= 0xFFFF
            if "w" in comno.access:
                assert comno.minimum_word <= word <= comno.maximum_word
        assert drive.frequency_hz <= 500.0
        assert drive.running or drive.frequency_hz == 0.0
        assert not (drive.tripped and drive.running)


@settings(max_examples=30)
@given(plans, st.integers(0, 3), st.sampled_from(Topology), chosen)
def test_same_seed_gives_the_same_trace_and_state(
    plan: list[tuple[bytes, int]], seed: int, topology: Topology, of: tuple[Drive, bool]
) -> None:
    first, second = play(plan, seed, topology, of), play(plan, seed, topology, of)
    assert first[1].trace == second[1].trace
    for one, other in zip(first[0], second[0], strict=True):
        assert one.registers.ram == other.registers.ram
        assert one.registers.eeprom == other.registers.eeprom
        assert one.trips.past == other.trips.past
        assert one.operation.ramp == other.operation.ramp
