"""Every example of the DEV003Z-1 manual, byte for byte, over polled I/O."""

from typing import Any

import pytest

from tests.unit.devicenet.bench import C203, GATEWAY, bench, words
from tests.vectors.reading import entries

ENTRIES = entries("dev003z_words")
WAIT_MS = 300


def rows(entry: dict[str, Any], side: str) -> dict[int, int]:
    """The printed words of a side, by the offset of their low byte."""
    return {
        int(row["bytes"].split()[1]): int(row["word"], 16)
        for row in entry.get(side, {}).get("rows", ())
        if row.get("word")
    }


def data(length: int, printed: dict[int, int]) -> bytes:
    found = bytearray(length)
    for offset, word in printed.items():
        found[offset : offset + 2] = word.to_bytes(2, "little")
    return bytes(found)


@pytest.mark.fact("dev.example.speed")
@pytest.mark.parametrize(
    ("name", "given"),
    [
        ("20_70.stop", {}),
        ("20_70.forward", {}),
        ("21_71.forward", {0: 0x0061}),
        ("21_71.reverse", {}),
        ("100_150.run", {}),
    ],
)
def test_an_example_runs_as_it_is_printed(name: str, given: dict[int, int]) -> None:
    """`given` is what is cut off of the output; the forward example of 21 by that in reverse."""
    entry = ENTRIES[f"dev.example.{name}"]
    made = bench(C203[entry["output"]["instance"]])
    made.connect()
    if entry["output"]["instance"] == 20:
        # It has neither Net Ctrl nor Net Ref: they are attributes.
        assert made.set(0x29, 1, 5, b"\x01") == 0
        assert made.set(0x2A, 1, 4, b"\x01") == 0
    answer = made.keep_polling(data(4, {**rows(entry, "output"), **given}), WAIT_MS)
    printed = rows(entry, "input")
    assert {offset: int.from_bytes(answer[offset : offset + 2], "little") for offset in printed} \
        == printed  # fmt: skip
    if name == "20_70.forward":
        assert answer == words(0x0004, 0x0708), "input cut off: CIP's instance 70"
        assert entry["input"]["rows"][0]["bits"].startswith("000")


def test_the_preset_example_runs_at_preset_speed_1() -> None:
    entry = ENTRIES["dev.example.100_150.preset"]
    (row,) = entry["output"]["rows"]
    word = int(row["bits"].replace("?", "1"), 2)
    assert word == 0x8401, "of the bit that is cut off the heading says that it is preset speed 1"
    made = bench(C203[100], drive={"0018": 25.0})
    made.connect()
    answer = made.keep_polling(words(word, 0x1770), WAIT_MS)
    assert answer[2:] == words(2500)


@pytest.mark.fact("dev.example.channel")
def test_reading_f268_in_101_is_answered_as_printed() -> None:
    entry = ENTRIES["dev.example.101_151.read"]
    made = bench(C203[101], drive={"0268": 60.0})
    made.connect()
    answer = made.poll(data(8, rows(entry, "output")))
    assert answer is not None
    assert answer[4:] == words(0x0268, 0x1770)
    assert rows(entry, "input") == {4: 0x0268, 6: 0x1770}


@pytest.mark.fact("dev.example.channel")
def test_writing_sr1_in_101_writes_it() -> None:
    entry = ENTRIES["dev.example.101_151.write"]
    made = bench(C203[101])
    made.connect()
    answer = made.poll(data(8, {**rows(entry, "output"), 6: 0x1770}))
    assert made.drive.read_parameter("0018") == 60.0
    assert answer is not None
    assert answer[4:] == words(0x0018, 0x1770)


@pytest.mark.fact("dev.example.channel")
def test_reading_f268_in_105_is_answered_as_printed() -> None:
    entry = ENTRIES["dev.example.105_155.read"]
    made = bench(C203[105], drive={"0268": 60.0})
    made.connect()
    answer = made.poll(data(18, rows(entry, "output")))
    assert answer is not None
    printed = rows(entry, "input")
    assert answer[:6] == words(printed[0], printed[2], printed[4])


@pytest.mark.fact("dev.map")
def test_c001_carries_its_word_to_fa06_and_c021_brings_fd03() -> None:
    entry = ENTRIES["dev.example.c001"]
    made = bench(C203[102], parameters={"command_1": 1, "command_2": 3, "monitor_1": 3})
    made.connect()
    sent = bytes(int(row["value"], 16) for row in entry["bytes"])
    hz = ENTRIES["dev.scaling.frequency"]
    sent += bytes.fromhex(hz["word"])[::-1]
    answer = made.keep_polling(sent + bytes(8), WAIT_MS)
    assert made.drive.registers.ram[0xFA06] == int(entry["word"], 16)
    assert made.drive.registers.ram[0xFA07] == hz["decimal"]
    assert made.drive.frequency_hz == hz["value"]
    current = made.drive.read_word("FD03")
    assert current > 0
    assert answer[:2] == words(current)


@pytest.mark.fact("dev.map")
@pytest.mark.parametrize("first", range(7))
def test_every_command_can_be_chosen_for_every_word(first: int) -> None:
    """What the inverter does not take changes nothing."""
    codes = [(first + place) % 7 for place in range(6)]
    parameters = {f"command_{place}": code for place, code in enumerate(codes, start=1)}
    made = bench(C203[102], parameters=parameters)
    made.connect()
    before = dict(made.drive.registers.ram)
    assert made.poll(words(*range(1, 7))) is not None
    numbers = {item.code: item.comno for item in GATEWAY.commands}
    wanted = {
        numbers[code]: word
        for word, code in enumerate(codes, start=1)
        if code in numbers and made.drive.writable(numbers[code])
    }
    after = made.drive.registers.ram
    assert {number: after[number] for number in wanted} == wanted
    assert {number for number in after if after[number] != before[number]} <= set(wanted)


@pytest.mark.fact("dev.map")
@pytest.mark.parametrize("first", range(27))
def test_every_monitor_can_be_chosen_for_every_word(first: int) -> None:
    """One that the inverter lacks, and a code that none has, read 0."""
    codes = [(first + place) % 27 for place in range(6)]
    parameters = {f"monitor_{place}": code for place, code in enumerate(codes, start=1)}
    made = bench(C203[102], parameters=parameters)
    made.connect()
    answer = made.poll(bytes(12))
    assert answer is not None
    numbers = {item.code: item.comno for item in GATEWAY.monitors}
    wanted = [made.drive.read(numbers[code]) or 0 if code in numbers else 0 for code in codes]
    assert answer == words(*wanted)


@pytest.mark.parametrize("series", ["vf-s15", "vf-mb1"])
def test_both_series_run_behind_the_option(series: str) -> None:
    made = bench(C203[21], series=series)
    made.connect()
    assert made.keep_polling(words(0x0061, 0x0708), WAIT_MS) == words(0x04F4, 0x0708)
