"""FA06 and FA07: commands of an option inside the inverter, beside those of the serial port."""

import pytest

from fbgen.catalog import load_catalog
from harness.drives import Inverter, InverterSettings, Panel
from harness.kernel import NS_PER_S, Kernel
from harness.line import Line

S15 = load_catalog().drive("vf-s15")
SERIAL, SERIAL_HZ, OPTION, OPTION_HZ = 0xFA00, 0xFA01, 0xFA06, 0xFA07


def inverter(**parameters: float) -> Inverter:
    kernel = Kernel()
    names = {f"{key[1:]}": value for key, value in parameters.items()}
    quick = {"0009": 0.1, "0010": 0.1, **names}
    made = Inverter(kernel, Line(kernel), S15, InverterSettings(parameters=quick))
    made.observers.append(lambda: None)
    return made


def settle(drive: Inverter) -> float:
    drive.operation._kernel.run_for(NS_PER_S)
    return drive.frequency_hz


def put(drive: Inverter, **words: int) -> None:
    numbers = {"serial": SERIAL, "serial_hz": SERIAL_HZ, "option": OPTION, "option_hz": OPTION_HZ}
    for name, word in words.items():
        assert drive.write_ram(numbers[name], word) is None


@pytest.mark.parametrize(
    ("words", "hz"),
    [
        ({"option": 0xC400, "option_hz": 3000}, 30.0),
        ({"option": 0x0400, "option_hz": 3000}, 0.0),
        ({"serial": 0xC400, "serial_hz": 2000, "option_hz": 3000}, 20.0),
        ({"serial": 0xC400, "serial_hz": 2000, "option": 0xC400, "option_hz": 3000}, 30.0),
        ({"serial": 0xC400, "serial_hz": 2000, "option": 0x4000, "option_hz": 3000}, 30.0),
        ({"serial": 0xC000, "serial_hz": 2000, "option": 0x8400, "option_hz": 3000}, 20.0),
        ({"serial": 0xC400, "serial_hz": 2000, "option": 0x8000}, 0.0),
    ],
)
def test_whoever_is_linked_commands_and_the_option_first(words: dict[str, int], hz: float) -> None:
    drive = inverter()
    put(drive, **words)
    assert settle(drive) == hz


def test_the_modes_give_the_option_command_and_frequency() -> None:
    drive = inverter(_0003=4, _0004=7)
    put(drive, option=0x0400, option_hz=3000)
    assert settle(drive) == 30.0
    assert drive.given_to_option
    assert not inverter(_0003=4).given_to_option


def test_coast_and_emergency_stop_of_the_option_act_without_its_link() -> None:
    drive = inverter()
    put(drive, serial=0xC400, serial_hz=2000)
    settle(drive)
    put(drive, option=0x0800)
    assert drive.frequency_hz == 0.0
    drive = inverter()
    drive.set_panel(Panel(run=True, frequency_hz=10.0))
    settle(drive)
    put(drive, option=0x0800)
    assert drive.frequency_hz == 0.0
    put(drive, option=0x1000)
    assert drive.trip_display == "E"


def test_a_restart_forgets_both_words() -> None:
    drive = inverter()
    put(drive, serial=0xC400, serial_hz=2000, option=0xC400, option_hz=3000)
    settle(drive)
    drive.trip("OC1")
    drive.reset()
    assert settle(drive) == 0.0
    assert not drive.network_command
    assert not drive.told_to_run
