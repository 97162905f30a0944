"""An inverter that speaks MODBUS-RTU: functions by series, refusals, silence, change of protocol.

The frames of the VF-S15 manual are in tests/vectors; here they go to the simulated inverter.
"""

import pytest
from drive_bench import CATALOG, Bench

from fbgen.wire import modbus
from harness.drives import Inverter
from harness.drives.modbus_names import EXCEPTIONS, FUNCTIONS
from harness.drives.settings import InverterSettings
from harness.line import Disturbance
from tests.vectors.reading import entries

FRAMES = entries("toshiba_frames")
MODBUS = {"protocol_selection": 1.0}
CHOSEN = {"block_write_1": 1.0, "block_write_2": 3.0}
RUN_AT_60_HZ = {"maximum_frequency": 80.0, "acceleration_time": 0.1}


def _bench(series: str = "vf-s15", **parameters: float) -> tuple[Bench, Inverter]:
    bench = Bench(series=series)
    return bench, bench.add(1, MODBUS | parameters)


def _frame(name: str) -> bytes:
    return bytes.fromhex(str(FRAMES[name]["bytes"]))


def test_names_of_functions_and_exceptions_are_those_of_the_protocol() -> None:
    protocol = CATALOG.modbus_protocol("modbus")
    assert {item.name: item.code for item in protocol.functions} == FUNCTIONS
    assert {item.name: item.code for item in protocol.exceptions} == EXCEPTIONS


@pytest.mark.parametrize(
    ("request_name", "reply_name", "chosen"),
    [
        ("modbus.read_two", "modbus.read_two.reply", {}),
        ("modbus.write_multiple", "modbus.write_multiple.reply", {}),
        ("modbus.block", "modbus.block.reply", CHOSEN),
        ("modbus.block", "modbus.block.refused", {}),
        ("modbus.block.bad_address", "modbus.block.bad_address.reply", CHOSEN),
        ("modbus.block.bad_count", "modbus.block.bad_count.reply", CHOSEN),
        ("modbus.identify", "modbus.identify.reply", {}),
    ],
)
@pytest.mark.fact("mb.s15.fn")
@pytest.mark.fact("mb.frame")
def test_vf_s15_answers_the_frames_of_its_manual(
    request_name: str, reply_name: str, chosen: dict[str, float]
) -> None:
    bench, _ = _bench(**RUN_AT_60_HZ, **chosen)
    assert bench.send(_frame(request_name)) == [_frame(reply_name)]


def test_vf_s15_tells_60_hz_in_the_bytes_of_its_manual() -> None:
    bench, drive = _bench(**RUN_AT_60_HZ, **CHOSEN)
    assert bench.send(_frame("modbus.block")) == [_frame("modbus.block.reply")]
    bench.wait(1)
    assert drive.frequency_hz == 60.0
    assert bench.send(_frame("modbus.read")) == [_frame("modbus.read.reply")]


@pytest.mark.fact("mb.s11.fn")
def test_vf_s11_reads_and_writes_one_word() -> None:
    bench, drive = _bench("vf-s11")
    assert bench.ask_modbus("01 06 00 09 00 32") == "01 06 00 09 00 32"
    assert drive.read_word("0009") == 0x32
    assert bench.ask_modbus("01 03 00 09 00 01") == "01 03 02 00 32"
    assert bench.ask_modbus("01 03 00 09 00 02") == "01 83 03"


@pytest.mark.parametrize(
    "request_", ["10 00 09 00 01 02 00 32", "10 00 09 00 01 00", "2B 0E 01 00"]
)
def test_vf_s11_has_no_other_function(request_: str) -> None:
    bench, _ = _bench("vf-s11")
    function = int(request_[:2], 16)
    assert bench.ask_modbus(f"01 {request_}") == f"01 {function | 0x80:02X} 01"


@pytest.mark.parametrize(
    ("request_", "reply"),
    [
        ("01 03 12 34 00 01", "01 83 02"),  # no such ComNo
        ("01 06 12 34 00 00", "01 86 02"),
        ("01 03 FD 00 00 00", "01 83 03"),  # no word at all
        ("01 06 00 11 FF FF", "01 86 03"),  # FH outside of its range
        ("01 06 FD 00 00 00", "01 86 04"),  # a monitor cannot be written
        ("01 05 00 00 FF 00", "01 85 01"),  # coils: no such function
        ("01 17 18 75 00 02 FA 01 00 02 04 00 00 00 00", "01 97 03"),
    ],
)
@pytest.mark.fact("mb.exc")
def test_what_cannot_be_served_is_refused_with_its_exception(request_: str, reply: str) -> None:
    bench, _ = _bench()
    assert bench.ask_modbus(request_) == reply


def test_a_running_inverter_refuses_what_wants_it_at_rest() -> None:
    bench, _ = _bench("vf-s11")
    bench.ask_modbus("01 06 FA 00 84 00")
    assert bench.ask_modbus("01 06 00 11 13 88") == "01 86 04"


@pytest.mark.parametrize(("series", "kept"), [("vf-s11", False), ("vf-s15", True)])
@pytest.mark.fact("mb.ram")
def test_where_a_write_stays_is_as_the_series_has_it(series: str, kept: bool) -> None:
    bench, drive = _bench(series)
    bench.ask_modbus("01 06 00 09 00 32")
    drive.power_off()
    drive.power_on()
    assert (drive.read_word("0009") == 0x32) is kept


def test_block_of_the_vf_s15_writes_and_reads_what_its_parameters_choose() -> None:
    chosen = CHOSEN | {"block_read_1": 1.0, "block_read_2": 2.0, "block_read_4": 5.0}
    bench, drive = _bench(**RUN_AT_60_HZ, **chosen)
    written = "01 17 18 75 00 04 18 70 00 02 04 C4 00 17 70"
    assert bench.ask_modbus(written).startswith("01 17 08 64 00 00")
    bench.wait(1)
    assert bench.ask_modbus("01 03 18 75 00 04") == "01 03 08 64 00 17 70 80 00 00 00"
    assert drive.running


def test_the_place_of_the_block_is_no_comno_of_its_own() -> None:
    bench, _ = _bench(block_read_1=3.0)
    assert bench.ask_modbus("01 03 18 75 00 01") == "01 83 02"
    assert bench.ask_modbus("01 03 08 75 00 01") == "01 03 02 00 03"


@pytest.mark.fact("mb.s15.gap")
def test_direct_block_of_the_vf_s15_is_there_by_its_option_and_shows_gaps() -> None:
    bench = Bench(series="vf-s15")
    parameters = MODBUS | {"inverter_number": 1}
    option = frozenset({"modbus_block_reads"})
    bench.add(settings=InverterSettings(parameters=parameters, options=option))
    assert bench.ask_modbus("01 03 00 08 00 04") == "01 03 08 80 00 00 64 80 00 80 00"
    assert bench.ask_modbus("01 03 00 08 00 01") == "01 83 02"
    assert bench.ask_modbus("01 03 00 08 00 09") == "01 83 03"


def test_identification_begins_at_the_object_asked_for_and_knows_no_single_one() -> None:
    bench, _ = _bench()
    assert bench.ask_modbus("01 2B 0E 01 02") == "01 2B 0E 01 01 00 00 01 02 04 30 31 30 30"
    assert bench.ask_modbus("01 2B 0E 03 07").startswith("01 2B 0E 03 01 00 00 03 00 07")
    assert bench.ask_modbus("01 2B 0E 04 01") == "01 AB 03"
    assert bench.ask_modbus("01 2B 0E 05 00") == "01 AB 03"


def test_broadcast_is_obeyed_by_all_and_answered_by_nobody() -> None:
    bench = Bench(series="vf-s15")
    drives = [bench.add(number, MODBUS) for number in (0, 1, 2)]
    assert bench.ask_modbus("00 06 00 09 00 32") == ""
    assert [drive.read_word("0009") for drive in drives] == [0x32] * 3
    assert bench.ask_modbus("00 03 00 09 00 01") == ""
    assert bench.ask_modbus("00 06 12 34 00 01") == ""


def test_reset_restarts_the_inverter_and_is_not_answered() -> None:
    bench, drive = _bench()
    drive.trip("OC1")
    assert bench.ask_modbus("01 06 FA 00 20 00") == ""
    assert not drive.tripped


@pytest.mark.fact("mb.mute")
def test_another_number_a_wrong_crc_and_a_damaged_character_are_met_with_silence() -> None:
    bench, _ = _bench()
    read = "01 03 FC 90 00 01"
    assert bench.ask_modbus("02" + read[2:]) == ""
    frame = modbus.seal(bytes.fromhex(read))
    assert bench.send(frame[:-1] + bytes((frame[-1] ^ 1,))) == []
    bench.line.master_pair.interference.disturb_next(Disturbance(mark={4: 1}))
    assert bench.send(frame) == []
    assert bench.ask_modbus(read) == "01 03 02 00 00"


def test_time_out_of_f803_counts_modbus_requests() -> None:
    bench, drive = _bench(communication_timeout=1.0)
    bench.ask_modbus("01 03 FC 90 00 01")
    bench.wait(0.9)
    bench.ask_modbus("01 03 FC 90 00 01")
    bench.wait(0.9)
    assert not drive.tripped
    # one for another, and one to all that nobody carries out
    bench.ask_modbus("02 03 FC 90 00 01")
    bench.ask_modbus("00 03 FC 90 00 01")
    bench.wait(0.1)
    assert drive.trip_display == "Err5"


def test_protocol_changes_when_the_inverter_starts_anew() -> None:
    bench = Bench(series="vf-s11")
    drive = bench.add(1)
    assert bench.ask("01 57 08 29 00 01") == "01 57 08 29 00 01"
    assert bench.ask("01 47 FC 90 00 00") == "01 47 FC 90 00 00"
    assert bench.ask_modbus("01 03 FC 90 00 01") == ""
    assert bench.ask("01 50 FA 00 20 00") == ""
    bench.wait(2)
    assert bench.ask("01 47 FC 90 00 00") == ""
    assert bench.ask_modbus("01 03 FC 90 00 01") == "01 03 02 00 00"
    assert drive.communication.protocol == "modbus"
    assert bench.ask_modbus("01 06 08 29 00 00") == "01 06 08 29 00 00"
    drive.power_off()
    drive.power_on()
    bench.wait(2)
    assert bench.ask_modbus("01 03 FC 90 00 01") == "01 03 02 00 00", "06 writes to RAM only"
