"""`fbgen decode` and `fbgen encode`."""

import json

import pytest

from tests.unit.cli.running import Fbgen


def test_decode_shows_the_power_on_status_of_the_gateway(fbgen: Fbgen) -> None:
    run = fbgen("decode", "tospbdp001.status", "9F00")
    assert (run.status, run.err) == (0, "")
    lines = run.out.splitlines()
    assert lines[0] == "tospbdp001.status = 9F00   16#9F00, 2#1001_1111_0000_0000, 40704"
    changed = next(line for line in lines if "status_changed" in line)
    assert changed.split()[:3] == ["15", "status_changed", "1"]
    code = next(line for line in lines if "status_code" in line)
    assert code.split()[:3] == ["12..8", "status_code", "16#1F"]
    assert code.endswith("no error")
    assert "[1] TOSPBDP001 manual v1.1, 8 A" in lines


def test_encode_makes_the_word_that_starts_a_drive_forward(fbgen: Fbgen) -> None:
    run = fbgen("encode", "vf-s11.command", "run", "network_command", "network_frequency")
    assert run.status == 0
    assert run.out.startswith("vf-s11.command = C400 ")


def test_encode_takes_values_for_rows_of_bits(fbgen: Fbgen) -> None:
    run = fbgen("encode", "tospbdp001.status", "status_changed", "status_code=0x1F", "--json")
    assert json.loads(run.out)["hex"] == "9F00"


def test_decode_as_json_carries_every_field_with_its_source(fbgen: Fbgen) -> None:
    data = json.loads(fbgen("decode", "vf-s11.FA00", "C400", "--json").out)
    assert (data["word"], data["value"], data["undefined"]) == ("vf-s11.FA00", 0xC400, "0000")
    fields = {field["name"]: field for field in data["fields"]}
    assert len(fields) == 16
    assert {name for name, field in fields.items() if field["value"]} == {
        "network_command",
        "network_frequency",
        "run",
    }
    assert all(field["source"] for field in fields.values())


def test_decode_shows_set_bits_without_a_meaning_in_their_place(fbgen: Fbgen) -> None:
    rows = [line.split() for line in fbgen("decode", "vf-s11.status", "8408").out.splitlines()]
    bits = [row[0] for row in rows if row and row[0].partition(".")[0].isdigit()]
    assert bits == sorted(bits, key=int, reverse=True)
    assert ["15", "-", "1"] in [row[:3] for row in rows]
    assert ["3", "-", "1"] in [row[:3] for row in rows]


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("decode", "tospbdp001.statu", "9F00"), "FB1201"),
        (("decode", "tospbdp001.status", "9F00F"), "FB1204"),
        (("encode", "vf-s11.command", "runn"), "FB1202"),
        (("encode", "tospbdp001.status", "status_code=32"), "FB1203"),
        (("encode", "tospbdp001.status", "status_code=1F"), "FB9004"),
        (("encode", "vf-s11.command", "run", "run"), "FB9004"),
    ],
)
def test_a_wrong_name_or_value_is_a_diagnostic_on_standard_error(
    fbgen: Fbgen, arguments: tuple[str, ...], code: str
) -> None:
    run = fbgen(*arguments)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[{code}]: ")
    assert "= help: " in run.err


def test_all_wrong_bits_are_reported_together(fbgen: Fbgen) -> None:
    run = fbgen("encode", "tospbdp001.status", "status_code=x", "status_data=y")
    assert run.err.count("error[FB9004]") == 2
