"""Cyclic data of gateways by `fbgen decode` and `fbgen encode`, against the manuals' examples."""

import json

import pytest

from tests.unit.cli.running import Fbgen

EXAMPLES = [
    ("output", "E0 00 01 0B 50 FA 00 C4 00", "network_command, network_frequency, run"),
    ("input", "DF 00 0B 50 FA 00 C4 00", "network_command, network_frequency, run"),
    ("output", "A0 00 02 0B 50 FA 01 13 88", "50.00 Hz"),
    ("input", "DF 00 0B 47 FE 03 10 E8", "43.28 %"),
]


def fields(fbgen: Fbgen, *arguments: str) -> dict[str, tuple[str, str]]:
    run = fbgen(*arguments, "--series", "vf-s11", "--json")
    assert (run.status, run.err) == (0, "")
    return {one["name"]: (one["bytes"], one["meaning"]) for one in json.loads(run.out)["fields"]}


@pytest.mark.parametrize(("way", "data", "meaning"), EXAMPLES)
def test_telegrams_of_the_manual_are_read(fbgen: Fbgen, way: str, data: str, meaning: str) -> None:
    found = fields(fbgen, "decode", f"tospbdp001.{way}", data)
    assert found["inv_no"] == ("0B", "inverter 11")
    assert found["data"][1].endswith(meaning)
    assert " ".join(part for part, _ in found.values()) == data


def test_a_telegram_that_is_written_is_read_back(fbgen: Fbgen) -> None:
    given = ("control=E000", "trigger=1", "inv_no=11", "cmd=P", "comno=FA00", "data=C400")
    run = fbgen("encode", "tospbdp001.output", "layout=doc9", *given)
    assert run.out.splitlines()[0] == "E0 00 01 0B 50 FA 00 C4 00"
    padded = fbgen("encode", "tospbdp001.output", *given)
    assert padded.out.splitlines()[0] == "E0 00 01 0B 50 FA 00 00 C4 00"


def test_values_have_units_and_names(fbgen: Fbgen) -> None:
    arguments = ("encode", "tospbdp001.output", "comno=frequency_setpoint", "value=50")
    assert fields(fbgen, *arguments)["data"][0] == "13 88"


def test_process_data_of_the_pbdp_110_are_read(fbgen: Fbgen) -> None:
    found = fields(fbgen, "decode", "pbdp110.output", "C4 00 15 9E 10 00 FC 90 00 00")
    assert found["a_command"] == ("C4 00", "network_command, network_frequency, run")
    assert found["a_action"] == ("10 00", "request=1")


def test_bytes_that_fit_no_layout_and_wrong_fields_are_told(fbgen: Fbgen) -> None:
    run = fbgen("decode", "tospbdp001.output", "E0 00")
    assert (run.status, "FB9041" in run.err, "9, 10 bytes" in run.err) == (1, True, True)
    run = fbgen("encode", "tospbdp001.output", "data=XYZ", "nothing=1")
    assert run.status == 1
    assert "FB9042" in run.err
    assert "FB9043" in run.err


def test_a_frame_of_either_direction_is_judged(fbgen: Fbgen) -> None:
    right = fbgen("decode", "toshiba.frame", "2F 0B 50 FA 00 C4 00 48")
    assert "right" in right.out
    wrong = fbgen("decode", "toshiba.frame", "2F 0B 50 FA 00 C4 00 49")
    assert "wrong: 48 is right" in wrong.out
