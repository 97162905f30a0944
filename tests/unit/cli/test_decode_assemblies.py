"""`fbgen decode dev003z.71`: the data of assemblies, with the examples of the manual."""

import json
from typing import Any

import pytest

from tests.unit.cli.running import Fbgen
from tests.vectors.reading import entries

ENTRIES = entries("dev003z_words")


def data(entry: dict[str, Any], side: str, length: int) -> str:
    """The printed words of a side as bytes, low byte first; what is cut off is 0."""
    found = bytearray(length)
    for row in entry[side]["rows"]:
        if row.get("word"):
            at = int(row["bytes"].split()[1])
            found[at : at + 2] = int(row["word"], 16).to_bytes(2, "little")
    return found.hex(" ")


@pytest.mark.parametrize(
    ("name", "side", "length", "told"),
    [
        ("20_70.forward", "output", 4, ["run_forward", "1800 min-1"]),
        ("21_71.forward", "input", 4, ["running_forward", "Enabled", "1800 min-1"]),
        ("21_71.reverse", "output", 4, ["net_control", "run_reverse", "1800 min-1"]),
        ("100_150.run", "input", 4, ["standby", "running, reverse", "60 Hz"]),
        ("101_151.read", "input", 8, ["index=268", "1770, 6000"]),
        ("105_155.read", "input", 18, ["no bit set", "Parameter number: 0268, 616", "chooses"]),
    ],
)  # fmt: skip
def test_an_example_of_the_manual_says_what_it_is(
    fbgen: Fbgen, name: str, side: str, length: int, told: list[str]
) -> None:
    entry = ENTRIES[f"dev.example.{name}"]
    instance = entry[side]["instance"]
    run = fbgen("decode", f"dev003z.{instance}", data(entry, side, length))
    assert run.status == 0
    assert f"dev003z, instance {instance}, {side} of the PLC" in run.out
    assert [text for text in told if text not in run.out] == []


def test_the_same_as_json(fbgen: Fbgen) -> None:
    found = json.loads(fbgen("decode", "dev003z.71", "F4 04 08 07", "--json").out)
    assert [field["name"] for field in found["fields"]] == ["status", "speed"]
    assert found["fields"][1] == {"bytes": "08 07", "name": "speed", "meaning": "1800 min-1"}


@pytest.mark.parametrize(
    ("word", "value", "code"),
    [
        ("dev003z.71", "F4 04 08", "FB9041"),
        ("dev003z.71", "F4 04 08 07 00", "FB9041"),
        ("dev003z.72", "F4 04", "FB1201"),
        ("dev003y.71", "F4 04", "FB1201"),
    ],
)
def test_what_is_no_assembly_is_refused(fbgen: Fbgen, word: str, value: str, code: str) -> None:
    run = fbgen("decode", word, value)
    assert (run.status, run.out) == (1, "")
    assert code in run.err
