"""Masters that others wrote, pymodbus and minimalmodbus, at simulated inverters in real time.

Every function that a series has, and every exception. A pseudo terminal keeps no parity, so there
is none; what a drive does with it is tried on the simulated line.
"""

import sys
from collections.abc import Iterator
from time import monotonic

import minimalmodbus
import pytest
from pymodbus.client import ModbusSerialClient

from harness.line import Parity
from harness.serial import LineSetting
from tests.unit.cli.served_drives import Serving, serving

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="only Linux makes pseudo terminals")

SETTING = LineSetting("modbus", 19_200, Parity.NONE)
STATUS, FREQUENCY, COMMAND = 0xFD01, 0xFA01, 0xFA00
BLOCK_WRITE, BLOCK_READ = 0x1870, 0x1875
NO_SUCH_COMNO = 0x1234
PATIENCE_S = 20.0


@pytest.fixture(scope="module")
def s15() -> Iterator[Serving]:
    with serving(SETTING, "vf-s15") as line:
        for drive in line.drives.values():
            for number, choice in enumerate((1, 3), start=1):
                drive.set_parameter(f"block_write_{number}", choice)
            for number in (1, 2):
                drive.set_parameter(f"block_read_{number}", number)
        yield line


@pytest.fixture
def pymodbus(s15: Serving) -> Iterator[ModbusSerialClient]:
    client = ModbusSerialClient(s15.port, baudrate=19_200, parity="N", timeout=1, retries=0)
    assert client.connect()
    yield client
    client.close()


@pytest.fixture
def instrument(s15: Serving) -> Iterator[minimalmodbus.Instrument]:
    device = minimalmodbus.Instrument(s15.port, 2, close_port_after_each_call=True)
    device.serial.baudrate, device.serial.timeout = 19_200, 1
    yield device
    device.serial.close()


def test_pymodbus_reads_and_writes_with_every_function(
    pymodbus: ModbusSerialClient, s15: Serving
) -> None:
    drive = s15.drives["vf2"]
    assert pymodbus.write_register(FREQUENCY, 2500, device_id=2).registers == [2500]
    assert drive.read_parameter("frequency_setpoint") == 25.0
    assert pymodbus.write_registers(FREQUENCY, [3000], device_id=2).count == 1
    assert pymodbus.read_holding_registers(FREQUENCY, count=1, device_id=2).registers == [3000]
    assert pymodbus.write_registers(BLOCK_WRITE, [0x8000, 3500], device_id=2).count == 2
    assert drive.read_parameter("frequency_setpoint") == 35.0
    both = pymodbus.readwrite_registers(
        read_address=BLOCK_READ,
        read_count=2,
        write_address=BLOCK_WRITE,
        values=[0x8000, 4000],
        device_id=2,
    )
    assert both.registers == [drive.read_word(STATUS), 0]
    assert drive.read_parameter("frequency_setpoint") == 40.0
    chosen = pymodbus.read_holding_registers(BLOCK_READ, count=2, device_id=2)
    assert chosen.registers == [drive.read_word(STATUS), 0]
    told = pymodbus.read_device_information(read_code=1, device_id=2)
    assert told.information == {0: b"TOSHIBA", 1: b"VFS15-2037PM", 2: b"0100"}


def test_pymodbus_is_refused_with_every_exception(
    pymodbus: ModbusSerialClient, s15: Serving
) -> None:
    assert pymodbus.read_coils(0, count=1, device_id=2).exception_code == 1
    refused = pymodbus.read_holding_registers(NO_SUCH_COMNO, count=1, device_id=2)
    assert refused.exception_code == 2
    assert pymodbus.write_register(FREQUENCY, 65_000, device_id=2).exception_code == 3
    drive = s15.drives["vf3"]
    drive.registers.locked = True
    locked = pymodbus.write_register(0x0803, 5, device_id=3)
    drive.registers.locked = False
    assert locked.exception_code == 4


def test_pymodbus_writes_to_all(pymodbus: ModbusSerialClient, s15: Serving) -> None:
    pymodbus.write_register(FREQUENCY, 1234, device_id=0, no_response_expected=True)
    end_s = monotonic() + PATIENCE_S
    while s15.drives["vf3"].read_word(FREQUENCY) != 1234 and monotonic() < end_s:
        pass
    read = [
        pymodbus.read_holding_registers(FREQUENCY, count=1, device_id=number).registers
        for number in (1, 2, 3)
    ]
    assert read == [[1234]] * 3


def test_minimalmodbus_reads_and_writes_with_every_function_that_it_has(
    instrument: minimalmodbus.Instrument, s15: Serving
) -> None:
    drive = s15.drives["vf2"]
    instrument.write_register(FREQUENCY, 12.5, 2, functioncode=6)
    assert drive.read_parameter("frequency_setpoint") == 12.5
    instrument.write_register(FREQUENCY, 13.5, 2, functioncode=16)
    assert instrument.read_register(FREQUENCY, 2) == 13.5
    instrument.write_registers(BLOCK_WRITE, [0x8000, 1450])
    assert instrument.read_register(FREQUENCY, 2) == 14.5
    assert instrument.read_registers(BLOCK_READ, 2) == [drive.read_word(STATUS), 0]


def test_minimalmodbus_is_refused_with_the_exception_and_misses_who_is_not_there(
    instrument: minimalmodbus.Instrument,
) -> None:
    with pytest.raises(minimalmodbus.IllegalRequestError, match="illegal data address"):
        instrument.read_register(NO_SUCH_COMNO)
    with pytest.raises(minimalmodbus.IllegalRequestError, match="illegal data value"):
        instrument.write_register(FREQUENCY, 65_000, functioncode=6)
    with pytest.raises(minimalmodbus.IllegalRequestError, match="illegal function"):
        instrument.read_bit(0, 1)
    instrument.address = 9
    instrument.serial.timeout = 0.1
    with pytest.raises(minimalmodbus.NoResponseError):
        instrument.read_register(STATUS)


def test_both_run_a_vf_s11_with_the_two_functions_that_it_has() -> None:
    with serving(SETTING) as line:
        drive = line.drives["vf1"]
        client = ModbusSerialClient(line.port, baudrate=19_200, parity="N", timeout=1, retries=0)
        assert client.connect()
        assert client.write_register(FREQUENCY, 5000, device_id=1).registers == [5000]
        assert client.write_register(COMMAND, 0xC400, device_id=1).registers == [0xC400]
        assert drive.running
        assert client.write_registers(FREQUENCY, [5000], device_id=1).exception_code == 1
        client.close()
        device = minimalmodbus.Instrument(line.port, 1)
        device.serial.baudrate, device.serial.timeout = 19_200, 1
        assert device.read_register(FREQUENCY, 2) == 50.0
        device.serial.close()
