"""A bus cycle that is simulated only when something is new moves the same data as every cycle.

The oracle polls in every single cycle and knows nothing of the master's queue.
"""

from hypothesis import given
from hypothesis import strategies as st

from harness.fieldbus import (
    CycleTimes,
    DpMaster,
    DpSlave,
    Parameters,
    SlaveType,
    StationSettings,
)
from harness.kernel import NS_PER_MS, NS_PER_US, Kernel

CONFIGURATION = bytes.fromhex("B1")
START_NS = 20 * NS_PER_MS
END_NS = 60 * NS_PER_MS

changes = st.lists(
    st.tuples(
        st.integers(START_NS // 100_000, END_NS // 100_000 - 30).map(lambda step: step * 100_000),
        st.booleans(),
        st.integers(0, 1),
        st.integers(0, 3),
    ),
    max_size=12,
)


class NotedDevice:
    def __init__(self, kernel: Kernel) -> None:
        self.kernel = kernel
        self.received: list[tuple[int, bytes]] = []

    def exchange_started(self) -> None:
        pass

    def exchange_lost(self) -> None:
        raise AssertionError("nothing disturbs this bus")

    def outputs_received(self, outputs: bytes) -> None:
        self.received.append((self.kernel.now_ns, outputs))


@given(changes, st.integers(0, 1_900))
def test_outputs_and_inputs_arrive_as_if_every_cycle_were_carried_out(changes, phase_us):
    times = CycleTimes(2 * NS_PER_MS, phase_us * NS_PER_US)
    kernel = Kernel()
    device = NotedDevice(kernel)
    slave = DpSlave(kernel, device, SlaveType(1, CONFIGURATION), 5, (2, 2))
    master = DpMaster(kernel, times)
    settings = StationSettings("x", 5, CONFIGURATION, Parameters(1, (1, 1)))
    station = master.add(settings, slave)
    slave.power_on(5)
    master.start()
    master.operate()
    kernel.run_until(START_NS - 1)
    device.received.clear()
    seen: list[tuple[int, bytes]] = []
    master.taps.append(lambda transfer: seen.append((transfer.time_ns, transfer.inputs)))

    outputs, inputs = bytearray(2), bytearray(2)
    wanted_outputs: list[tuple[int, bytes]] = []
    wanted_inputs: list[tuple[int, bytes]] = []
    sent, fetched = bytes(2), bytes(2)
    pending = sorted(changes, key=lambda change: change[0])
    for change_ns, is_output, place, value in pending:

        def apply(is_output=is_output, place=place, value=value) -> None:
            if is_output:
                station.write(place, bytes([value]))
            else:
                data = bytearray(slave.inputs)
                data[place] = value
                slave.set_inputs(bytes(data))

        kernel.at(change_ns, apply)
    for cycle_ns in range(times.phase_ns, END_NS, times.period_ns):
        while pending and pending[0][0] < cycle_ns:
            _, is_output, place, value = pending.pop(0)
            (outputs if is_output else inputs)[place] = value
        if cycle_ns >= START_NS and bytes(outputs) != sent:
            sent = bytes(outputs)
            wanted_outputs.append((cycle_ns, sent))
        if cycle_ns >= START_NS and bytes(inputs) != fetched:
            fetched = bytes(inputs)
            wanted_inputs.append((cycle_ns, fetched))
    kernel.run_until(END_NS - 1)
    assert device.received == wanted_outputs
    new = [
        item
        for item, before in zip(seen, [(0, bytes(2)), *seen], strict=False)
        if item[1] != before[1]
    ]
    assert new == wanted_inputs
