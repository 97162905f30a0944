"""MODBUS masters that others wrote ask simulated inverters: pymodbus and minimalmodbus.

Their serial port is one that lets the virtual clock run while they write, so all bytes and silences
are there, and nothing waits. Both are imported when a test asks for them: they take their time.
"""

from importlib import import_module
from typing import Any

import pytest
from drive_bench import Bench

from harness.drives import Inverter, InverterSettings, set_for_line

MODBUS = {"protocol_selection": 1.0, "inverter_number": 7.0}
CHOSEN = {"block_write_1": 1.0, "block_write_2": 3.0, "block_read_1": 1.0, "block_read_2": 2.0}
OPTION = frozenset({"modbus_block_reads"})


class VirtualSerial:
    """What a serial port of pyserial is to them, with the simulated line behind it."""

    port = "virtual"
    baudrate = 19_200
    timeout: float | None = 0.001
    is_open = True

    def __init__(self, bench: Bench) -> None:
        self._bench = bench
        self._heard = b""

    @property
    def in_waiting(self) -> int:
        return len(self._heard)

    def write(self, data: bytes) -> int:
        self._bench.send(bytes(data))
        self._bench.wait(0.06)
        self._heard = b"".join(reception.data for reception in self._bench.heard)
        return len(data)

    def read(self, size: int | None) -> bytes:
        taken, self._heard = self._heard[:size], self._heard[size or len(self._heard) :]
        return taken

    def reset_input_buffer(self) -> None:
        self._heard = b""

    def reset_output_buffer(self) -> None: ...
    def flush(self) -> None: ...
    def open(self) -> None: ...
    def close(self) -> None: ...


def _plant(series: str) -> tuple[VirtualSerial, Inverter]:
    bench = Bench(series=series)
    parameters = set_for_line(bench.series, None, 19_200, "even") | MODBUS | CHOSEN
    settings = InverterSettings(parameters=parameters, options=OPTION)
    return VirtualSerial(bench), bench.add(settings=settings)


@pytest.fixture(params=["vf-s11", "vf-s15"])
def plant(request: pytest.FixtureRequest) -> tuple[VirtualSerial, Inverter]:
    return _plant(request.param)


def _minimal(port: VirtualSerial, address: int = 7) -> Any:
    return import_module("minimalmodbus").Instrument(port, address)


def _pymodbus(port: VirtualSerial, patience_s: float = 5.0) -> Any:
    client = import_module("pymodbus.client").ModbusSerialClient(
        port.port, baudrate=port.baudrate, timeout=patience_s, retries=0
    )
    client.socket = port
    return client


def test_minimalmodbus_writes_reads_and_is_refused(plant: tuple[VirtualSerial, Inverter]) -> None:
    port, drive = plant
    master = _minimal(port)
    theirs = import_module("minimalmodbus")
    master.write_register(0xFA01, 5000, functioncode=6)
    assert drive.read_parameter("FA01") == 50.0
    assert master.read_register(0xFA01) == 5000
    with pytest.raises(theirs.IllegalRequestError, match="illegal data address"):
        master.read_register(0x1234)
    with pytest.raises(theirs.IllegalRequestError, match="illegal data value"):
        master.write_register(0x0011, 0xFFFF, functioncode=6)
    with pytest.raises(theirs.IllegalRequestError, match="illegal function"):
        master.write_bit(0, 1)
    with pytest.raises(theirs.SlaveReportedException, match="device failure"):
        master.write_register(0xFD00, 0, functioncode=6)
    with pytest.raises(theirs.NoResponseError):
        _minimal(port, 8).read_register(0xFA01)
    _minimal(port, 0).write_register(0xFA01, 4000, functioncode=6)
    assert drive.read_parameter("FA01") == 40.0


def test_minimalmodbus_writes_several_words_to_a_vf_s15_only() -> None:
    port, drive = _plant("vf-s15")
    _minimal(port).write_registers(0x1870, [0xC400, 3000])
    assert (drive.read_word("FA00"), drive.read_parameter("FA01")) == (0xC400, 30.0)
    assert _minimal(port).read_registers(0x1875, 2)[0] == 0x6400
    port, _ = _plant("vf-s11")
    with pytest.raises(import_module("minimalmodbus").IllegalRequestError, match="function"):
        _minimal(port).write_registers(0x1870, [0xC400, 3000])


def test_pymodbus_writes_reads_and_is_refused(plant: tuple[VirtualSerial, Inverter]) -> None:
    port, drive = plant
    client = _pymodbus(port)
    assert client.write_register(0xFA01, 5000, device_id=7).registers == [5000]
    assert client.read_holding_registers(0xFA01, count=1, device_id=7).registers == [5000]
    assert drive.read_parameter("FA01") == 50.0
    for reply, code in (
        (client.read_holding_registers(0x1234, count=1, device_id=7), 2),
        (client.write_register(0x0011, 0xFFFF, device_id=7), 3),
        (client.write_register(0xFD00, 0, device_id=7), 4),
        (client.read_input_registers(0xFA01, count=1, device_id=7), 1),
    ):
        assert reply.isError()
        assert reply.exception_code == code
    with pytest.raises(import_module("pymodbus").ModbusException):
        _pymodbus(port, 0.01).read_holding_registers(0xFA01, count=1, device_id=8)


def test_pymodbus_uses_every_function_of_a_vf_s15() -> None:
    port, drive = _plant("vf-s15")
    client = _pymodbus(port)
    assert client.write_registers(0xFA01, [4000], device_id=7).count == 1
    both = client.readwrite_registers(
        read_address=0x1875, read_count=2, write_address=0x1870, values=[0xC400, 3000], device_id=7
    )
    assert both.registers == [drive.read_word("FE01"), 0]
    assert drive.set_point_hz == 30.0
    assert client.read_holding_registers(0x0008, count=3, device_id=7).registers[0] == 0x8000
    told = client.read_device_information(read_code=1, object_id=0, device_id=7)
    assert told.information == {0: b"TOSHIBA", 1: b"VFS15-2037PM", 2: b"0100"}
    refused = client.read_device_information(read_code=4, object_id=1, device_id=7)
    assert refused.exception_code == 3
