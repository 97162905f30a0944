"""`fbgen catalog list` and `fbgen catalog show`."""

import json
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen


def test_list_shows_kind_id_and_title(fbgen: Fbgen) -> None:
    run = fbgen("catalog", "list", "drives")
    assert run.status == 0
    rows = [line.split(maxsplit=2) for line in run.out.splitlines()[2:]]
    assert ["drives", "vf-s11", "Toshiba VF-S11 inverter"] in rows
    assert rows == sorted(rows)


def test_list_names_every_entry_once(fbgen: Fbgen) -> None:
    rows = json.loads(fbgen("catalog", "list", "--json").out)
    names = [(row["kind"], row["id"]) for row in rows]
    assert len(names) == len(set(names))
    assert {("gateways", "tospbdp001"), ("protocols", "toshiba"), ("sequences", "stop")} <= set(
        names
    )


def test_every_listed_name_can_be_shown(fbgen: Fbgen) -> None:
    for row in json.loads(fbgen("catalog", "list", "--json").out):
        run = fbgen("catalog", "show", row["id"])
        assert (run.status, run.err) == (0, ""), row
        assert row["title"] in run.out
        assert "Sources:\n[1] " in run.out


def test_every_listed_name_can_be_shown_as_json(fbgen: Fbgen) -> None:
    for row in json.loads(fbgen("catalog", "list", "--json").out):
        run = fbgen("catalog", "show", row["id"], "--json")
        assert (run.status, run.err) == (0, ""), row
        assert json.loads(run.out)["title"] == row["title"]


def test_show_gives_identifiers_as_the_manual_prints_them(fbgen: Fbgen) -> None:
    assert "30 30 20 30 30 70 20 70" in fbgen("catalog", "show", "tospbdp001").out


def test_show_gives_the_telegrams_of_the_manuals_example(fbgen: Fbgen) -> None:
    out = fbgen("catalog", "show", "manual_example").out
    assert "0B 50 FA 00 C4 00" in out


def test_show_finds_a_comno_by_number_and_by_name(fbgen: Fbgen) -> None:
    by_number = fbgen("catalog", "show", "vf-s11.FA01").out
    assert "0.01 Hz a count" in by_number
    assert fbgen("catalog", "show", "vf-s11.frequency_setpoint").out == by_number


@pytest.mark.parametrize("name", ["vfs11", "vf-s11.runn"])
def test_an_unknown_entry_is_fb9005_with_the_nearest_names(fbgen: Fbgen, name: str) -> None:
    run = fbgen("catalog", "show", name)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9005]: the catalogue has no ")
    assert "vf-s11" in run.err


def test_an_own_catalogue_lies_over_the_shipped_one(fbgen: Fbgen, tmp_path: Path) -> None:
    shipped = Path("catalog/sequences/stop.yaml").read_text(encoding="utf-8")
    folder = tmp_path / "sequences"
    folder.mkdir()
    title = "Stop along the deceleration ramp"
    own = shipped.replace(title, "Our own stop")
    (folder / "stop.yaml").write_text(own, encoding="utf-8")
    out = fbgen("catalog", "list", "sequences", "--catalog", str(tmp_path)).out
    assert "Our own stop" in out
    assert title not in out


def test_a_kind_that_does_not_exist_is_wrong_usage(fbgen: Fbgen) -> None:
    run = fbgen("catalog", "list", "motors")
    assert (run.status, run.out) == (2, "")
    assert "Usage: fbgen catalog list" in run.err


def test_show_gives_what_is_set_by_hand_at_inverter_and_gateway(fbgen: Fbgen) -> None:
    drive = fbgen("catalog", "show", "vf-s11").out
    assert "\nF803  1 " in drive
    assert "\nF802  inv_no " in drive
    assert "\nSW5 " in drive
    assert "ones of the address" in fbgen("catalog", "show", "tospbdp001").out


def test_show_gives_the_checks_of_a_sequence(fbgen: Fbgen) -> None:
    assert (
        "check everything that the parameter sheet says"
        in fbgen("catalog", "show", "check_parameters").out
    )


def test_show_says_of_layouts_and_words_what_no_document_confirms(fbgen: Fbgen) -> None:
    lines = fbgen("catalog", "show", "pbdp110").out.splitlines()
    told = {line.split()[0]: line for line in lines if line.strip()}
    assert "unverified: identifiers" in told["module2"]
    assert "unverified: request" in told["pbdp110.action"]
    assert "unverified" not in told["pbdp110.response"]


def test_show_gives_the_diagnosis_bits_of_the_channels_with_their_source(fbgen: Fbgen) -> None:
    out = fbgen("catalog", "show", "pbdp110").out
    table = out[out.index("channel  diagnosis bit") :].splitlines()
    assert table[2].split()[:3] == ["a", "0", "yes"]
    assert table[3].split()[:3] == ["b", "4", "no"]
    assert "other copies of the manual have them" in out.replace("\n", " ")


def test_show_gives_assemblies_parameters_and_objects_of_a_devicenet_adapter(fbgen: Fbgen) -> None:
    out = fbgen("catalog", "show", "dev003z").out
    lines = [" ".join(line.split()) for line in out.splitlines()]
    wanted = (
        "toshiba_parameter 3 101 4..5 index index_request",
        "c102 C102 timeout_preset 0..15 0",
        "14 FD18",
        "object 4B allocate service",
        "those that begin with F number - 8000, attribute 3",
        "duplicate_check 1000 ms",
        "product vf-mb1: 3000, vf-s15: 3001",
    )
    for start in wanted:
        assert [line for line in lines if line.startswith(start)], start
    (heartbeat,) = [line for line in lines if " heartbeat_interval " in line]
    assert heartbeat.endswith("it does not here.")


def test_words_of_a_devicenet_adapter_are_decoded_and_encoded(fbgen: Fbgen) -> None:
    assert "Enabled" in fbgen("decode", "dev003z.extended_status", "04F4").out
    out = fbgen("encode", "dev003z.extended_control", *["run_reverse", "net_control"]).out
    assert "dev003z.extended_control = 0022" in out


def test_an_eds_file_is_printed(fbgen: Fbgen) -> None:
    run = fbgen("catalog", "eds", "dev003z", "--series", "vf-mb1")
    assert run.status == 0
    assert "ProdCode = 3000;" in run.out
    assert run.out.isascii()
    assert max(map(len, run.out.splitlines())) <= 100


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["pbdp110"], "FB1206"),
        (["dev003y"], "FB1205"),
        (["dev003z", "--series", "vf-s11"], "FB7106"),
    ],
)
def test_what_has_no_eds_file(fbgen: Fbgen, arguments: list[str], code: str) -> None:
    run = fbgen("catalog", "eds", *arguments)
    assert (run.status, run.out) == (1, "")
    assert code in run.err
