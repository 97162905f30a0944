"""The recorder gives each telegram its own frames and its own reply, whatever comes between.

The PLC program is left out: the test writes the outputs of the station itself, as the manual of the
TOSPBDP001 prints them (control word, trigger, INV-NO, command, ComNo, data).
"""

import pytest

from fbgen.catalog import load_catalog
from fbgen.plant import load_plant
from fbgen.source import Source
from fbgen.wire.toshiba import ASCII_START
from harness.installation import DriveConditions, Installation, PlantSetup, build_plant
from harness.kernel import NS_PER_MS
from harness.trace.telegrams import TelegramRecorder
from tests.unit.scenario.scenario_files import PLANT

IDLE = 'ORGANIZATION_BLOCK "Main"\nVERSION : 0.1\nBEGIN\n  ;\nEND_ORGANIZATION_BLOCK\n'
READ_CURRENT = "0B 47 FE 03 00 00"
READ_TRIP = "0B 47 FC 90 00 00"
OTHER_DRIVE = "0C 47 FC 90 00 00"
REPLY_MS = 15


class Bench:
    """One gateway with drive 11 (reply after 15 ms), written to byte by byte."""

    def __init__(self) -> None:
        catalog = load_catalog()
        setup = PlantSetup(
            sources=[Source("idle.scl", IDLE)],
            drives={"pump": DriveConditions(reply_time_ns=REPLY_MS * NS_PER_MS)},
        )
        self.plant: Installation = build_plant(load_plant(PLANT, catalog), catalog, setup)
        self.recorder: TelegramRecorder = self.plant.record_telegrams()["gw1"]
        self.plant.start()
        self.wait(100)

    def wait(self, ms: int) -> None:
        self.plant.run_for(ms * NS_PER_MS)

    def send(self, trigger: int, telegram: str) -> None:
        """Control word E000 and a telegram, with the padding byte of the printed GSD."""
        data = bytes.fromhex(telegram)
        output = bytes((0xE0, 0, trigger)) + data
        layout = self.plant.gateways["gw1"].settings.layout
        padded = output[:7] + bytes(layout.output_length - len(output)) + output[7:]
        assert self.recorder.without_padding(padded) == output
        self.plant.stations["gw1"].write(0, padded)

    @property
    def frames(self) -> list[list[str]]:
        """Per telegram what was on the line for it, > towards the drives and < from them."""
        return [
            [("> " if frame.to_drives else "< ") + frame.data.hex(" ").upper() for frame in frames]
            for frames in (record.frames for record in self.recorder.records)
        ]


@pytest.fixture
def bench() -> Bench:
    return Bench()


def test_a_telegram_has_its_bytes_its_frames_and_its_times(bench: Bench) -> None:
    bench.send(1, READ_TRIP)
    bench.wait(100)
    (record,) = bench.recorder.records
    assert record.output.hex(" ").upper() == f"E0 00 01 {READ_TRIP}"
    assert bench.frames == [["> 2F 0B 47 FC 90 00 00 0D", "< 2F 0B 47 FC 90 00 00 0D"]]
    request, reply = record.frames
    assert record.sent_ns + 5 * NS_PER_MS == request.start_ns
    assert reply.start_ns == request.end_ns + REPLY_MS * NS_PER_MS
    assert record.input is not None
    assert record.input[2:].hex(" ").upper() == READ_TRIP
    assert record.received_ns is not None
    late_ns = record.received_ns - reply.end_ns - 5 * NS_PER_MS
    assert 0 <= late_ns <= 2 * NS_PER_MS, "the gateway works 5 ms, then comes the next bus cycle"


def test_an_equal_reply_has_arrived_when_the_gateway_has_it(bench: Bench) -> None:
    for trigger in (1, 2, 3):
        bench.send(trigger, READ_TRIP)
        bench.wait(100)
    first, second, third = bench.recorder.records
    assert first.input is not None
    assert (second.input or b"")[2:] == (third.input or b"")[2:] == first.input[2:]
    for record in (second, third):
        assert record.received_ns == record.frames[1].end_ns + 5 * NS_PER_MS


def test_the_heartbeat_belongs_to_no_telegram(bench: Bench) -> None:
    heard: list[bytes] = []
    bench.plant.lines["gw1"].taps.append(lambda sent: heard.append(sent.data))
    bench.send(1, READ_TRIP)
    bench.wait(2000)
    assert [data[0] for data in heard].count(ASCII_START) >= 3
    assert len(bench.frames[0]) == 2


def test_without_a_reply_there_is_none(bench: Bench) -> None:
    bench.send(1, OTHER_DRIVE)
    bench.wait(500)
    (record,) = bench.recorder.records
    assert (record.input, record.received_ns) == (None, None)
    assert bench.frames == [["> 2F 0C 47 FC 90 00 00 0E"]]


def test_an_old_reply_is_not_taken_for_a_new_one(bench: Bench) -> None:
    bench.send(1, READ_TRIP)
    bench.wait(100)
    bench.plant.drives["pump"].power_off()
    bench.send(2, READ_TRIP)
    bench.wait(500)
    assert bench.recorder.records[1].input is None


def test_a_reply_that_comes_behind_the_next_trigger_belongs_to_its_own_request(
    bench: Bench,
) -> None:
    bench.send(1, READ_CURRENT)
    bench.wait(20)  # the request is through, the drive has not answered yet
    bench.send(2, READ_TRIP)
    bench.wait(200)
    first, second = bench.recorder.records
    assert bench.frames[0][0] == "> 2F 0B 47 FE 03 00 00 82"
    assert bench.frames[0][1].startswith("< 2F 0B 47 FE 03")
    assert first.input is not None
    assert first.input[2:6].hex(" ").upper() == "0B 47 FE 03"
    assert first.received_ns is not None
    assert first.received_ns > second.sent_ns
    assert bench.frames[1][0] == "> 2F 0B 47 FC 90 00 00 0D"


def test_an_overwritten_telegram_has_no_frames(bench: Bench) -> None:
    bench.send(1, READ_CURRENT)
    bench.wait(2)
    bench.send(2, READ_TRIP)
    bench.wait(200)
    assert bench.plant.gateways["gw1"].overwritten == 1
    assert bench.frames == [[], ["> 2F 0B 47 FC 90 00 00 0D", "< 2F 0B 47 FC 90 00 00 0D"]]
    assert bench.recorder.records[0].input is None


def test_an_overwritten_telegram_of_the_same_bytes_has_no_frames_either(bench: Bench) -> None:
    bench.send(1, READ_TRIP)
    bench.wait(2)
    bench.send(2, READ_TRIP)
    bench.wait(200)
    assert [len(frames) for frames in bench.frames] == [0, 2]


def test_what_a_gateway_sends_again_after_it_was_off_is_a_telegram_of_its_own(
    bench: Bench,
) -> None:
    bench.send(1, READ_TRIP)
    bench.wait(200)
    gateway = bench.plant.gateways["gw1"]
    gateway.power_off()
    bench.wait(300)  # F803 makes the drive trip after 1 s without telegrams
    gateway.power_on()
    bench.wait(500)
    first, again = bench.recorder.records
    assert again.output == first.output
    assert len(again.frames) == 2
    assert again.sent_ns > first.sent_ns
    assert (again.input or b"")[2:] == (first.input or b"")[2:]


def test_an_answer_with_an_error_is_a_frame_and_no_reply(bench: Bench) -> None:
    bench.send(1, "0B 50 FE 03 00 01")  # FE03 can only be read
    bench.wait(200)
    (record,) = bench.recorder.records
    assert bench.frames[0][1].startswith("< 2F 0B 4E")
    assert record.input is None
