"""Plant files: the examples, the commented one, and what is checked against the catalogue."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import (
    FAMILIES,
    Plant,
    in_dialect,
    load_plant,
    read_plant,
    write_commented_plant,
)
from fbgen.resources import shipped
from fbgen.source import Source

CATALOG = load_catalog()
TEXT = write_commented_plant()


def plant(*changes: tuple[str, str]) -> Plant:
    text = TEXT
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return read_plant(Source("plant.yaml", text))


def findings(*changes: tuple[str, str]) -> list[tuple[str, str]]:
    with pytest.raises(DiagnosticError) as failure:
        plant(*changes)
    return [(item.code, item.help) for item in failure.value.diagnostics]


def codes(*changes: tuple[str, str]) -> list[str]:
    return [code for code, _ in findings(*changes)]


def test_the_manuals_example_has_drive_11_on_one_gateway() -> None:
    example = load_plant(shipped("examples") / "manual_example" / "plant.yaml")
    assert (example.dialect, example.plc, example.sequences) == (
        "tia",
        "s7-1500",
        ("manual_example",),
    )
    (gateway,) = example.gateways
    assert (gateway.name, gateway.layout, gateway.access) == ("gw1", "gsd10", "per_identifier")
    assert not gateway.status_poll
    (drive,) = gateway.drives
    assert (drive.name, drive.inv_no, drive.max_frequency_hz) == ("drive11", 11, 50.0)


def test_the_larger_example_has_five_polled_drives() -> None:
    example = load_plant(shipped("examples") / "five_drives" / "plant.yaml")
    assert [drive.inv_no for drive in example.drives] == [0, 1, 2, 3, 4]
    assert all(gateway.status_poll for gateway in example.gateways)


def test_the_commented_plant_is_valid_and_names_every_key() -> None:
    commented = plant()
    (gateway,) = commented.gateways
    for model in (commented, gateway, gateway.drives[0]):
        for key in type(model).model_fields:
            assert f"{key}:" in TEXT


def test_the_commented_plant_shows_every_option_with_its_default() -> None:
    (gateway,) = plant().gateways
    options = CATALOG.gateway("tospbdp001").options
    assert gateway.options == {option.id: option.default for option in options}
    drive_options = CATALOG.drive("vf-s11").options
    assert gateway.drives[1].options == {option.id: option.default for option in drive_options}


def test_the_commented_plant_names_every_layout_family_and_dialect() -> None:
    for name in (*FAMILIES, *(layout.name for layout in CATALOG.gateway("tospbdp001").layouts)):
        assert name in TEXT


def test_everything_wrong_in_a_plant_is_reported_together() -> None:
    found = codes(
        ("name: infeed", "name: IF"),
        ("inv_no: 2", "inv_no: 1"),
        ("profibus_address: 2", "profibus_address: 100"),
        ("- read_status", "- read_stats"),
        ("status_poll: true", "status_pol: true"),
        ("error_counter: restart", "error_counter: never"),
    )
    assert found == ["FB2011", "FB2004", "FB1005", "FB2003", "FB2012", "FB2006"]


@pytest.mark.parametrize(
    "name",
    ["2nd", "a-b", "a b", "a__b", "a_", "_a", "VAR", "while", "Program", "Förderer", "a" * 33,
     "TOS_Main", "typeTosDrive", "x;y", '"x"', "../x", ""],
)  # fmt: skip
def test_a_name_that_could_not_stand_in_a_plc_program_is_refused(name: str) -> None:
    quoted = "'" + name + "'"
    assert codes(("name: infeed", f"name: {quoted}")) == ["FB2012"]
    assert codes(("name: my_plant", f"name: {quoted}")) == ["FB2012"]
    assert codes(("name: gw1", f"name: {quoted}")) == ["FB2012"]


def test_a_name_with_umlauts_is_shown_in_plain_letters() -> None:
    ((_, help_text),) = findings(("name: infeed", "name: Förderer_süd"))
    assert help_text.endswith(" Foerderer_sued")


@pytest.mark.parametrize("address", [0, 126])
def test_an_address_that_no_slave_in_use_may_have_is_refused(address: int) -> None:
    text = (shipped("examples") / "pbdp110" / "plant.yaml").read_text("utf-8")
    changed = text.replace("profibus_address: 3", f"profibus_address: {address}")
    assert changed != text
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", changed))
    (found,) = failure.value.diagnostics
    assert (found.code, found.help) == ("FB2004", "use 1 to 125")


def test_a_drive_may_not_be_called_as_a_gateway() -> None:
    assert codes(("name: infeed", "name: GW1")) == ["FB2013"]


@pytest.mark.parametrize(
    ("plc", "dialect"), [("s7-1200", "tia"), ("s7-1500", "tia"), ("s7-300", "tia"),
                         ("s7-400", "tia"), ("s7-300", "step7"), ("s7-400", "step7"),
                         ("iec", "iec"), ("iec", "plcopen"), ("twincat", "twincat"),
                         ("twincat", "plcopen")],
)  # fmt: skip
def test_every_family_reads_its_dialects(plc: str, dialect: str) -> None:
    changed = plant(("plc: s7-1500", f"plc: {plc}"), ("dialect: tia", f"dialect: {dialect}"), IMAGE)
    assert changed.family is FAMILIES[changed.plc]
    assert dialect in changed.family.dialects


@pytest.mark.parametrize(
    ("dialect", "plc", "language"),
    [
        ("tia", "s7-1500", "tia"),
        ("step7", "s7-300", "step7"),
        ("iec", "iec", "iec"),
        ("twincat", "twincat", "twincat"),
        ("plcopen", "iec", "iec"),
    ],
)
def test_a_plant_in_another_dialect_gets_a_plc_that_reads_it(
    dialect: str, plc: str, language: str
) -> None:
    changed = in_dialect(plant(IMAGE), dialect, CATALOG)
    assert (changed.dialect, changed.plc, changed.code_dialect) == (dialect, plc, language)


def test_a_plc_that_reads_the_other_dialect_stays() -> None:
    changed = in_dialect(plant(("plc: s7-1500", "plc: s7-400")), "step7", CATALOG)
    assert changed.plc == "s7-400"


def test_the_other_dialect_is_refused() -> None:
    found = findings(("plc: s7-1500", "plc: iec"), IMAGE)
    assert found == [
        ("FB2014", "write dialect: iec or plcopen, or plc: s7-1200 or s7-1500 or s7-300 or s7-400")
    ]


WHOLE = ("layout: gsd10", "layout: whole10")
WHOLE_FRAME = ("access: per_identifier", "access: dpxx_dat")
IMAGE = ("access: per_identifier", "access: process_image")
WITH_IDENTIFIER = ("# hardware_identifier: 270", "hardware_identifier: 270")


def test_a_whole_frame_needs_one_consistent_identifier_and_the_message_says_which_way_does() -> (
    None
):
    ((code, help_text),) = findings(WHOLE_FRAME, WITH_IDENTIFIER)
    assert code == "FB2005"
    assert help_text == "use per_identifier or process_image, or the layout whole10"


def test_one_identifier_over_the_whole_frame_is_not_reached_piece_by_piece() -> None:
    ((code, help_text),) = findings(WHOLE)
    assert code == "FB2005"
    assert help_text == "use dpxx_dat or process_image, or the layout gsd10 or doc9"


def test_a_whole_frame_on_s7_1500_needs_the_hardware_identifier() -> None:
    assert codes(WHOLE, WHOLE_FRAME) == ["FB2017"]
    assert plant(WHOLE, WHOLE_FRAME, WITH_IDENTIFIER).gateways[0].hardware_identifier == 270


def test_a_whole_frame_on_s7_300_is_reached_by_its_addresses() -> None:
    assert plant(WHOLE, WHOLE_FRAME, ("plc: s7-1500", "plc: s7-300"))
    without = ("    input_address: 256\n    output_address: 256\n", "")
    assert codes(WHOLE, WHOLE_FRAME, ("plc: s7-1500", "plc: s7-300"), without) == [
        "FB2017",
        "FB2017",
    ]


def test_a_plc_without_such_calls_cannot_move_a_whole_frame() -> None:
    iec = (("plc: s7-1500", "plc: iec"), ("dialect: tia", "dialect: iec"))
    assert codes(WHOLE, WHOLE_FRAME, *iec) == ["FB2005"]


def test_the_process_image_of_s7_300_cannot_hold_a_consistent_frame() -> None:
    assert plant(WHOLE, IMAGE)
    assert codes(WHOLE, IMAGE, ("plc: s7-1500", "plc: s7-400")) == ["FB2005"]


@pytest.mark.parametrize(
    ("plc", "last"), [("s7-1200", 1023), ("s7-1500", 32767), ("s7-300", 8191), ("s7-400", 16383)]
)
def test_the_data_must_lie_inside_the_area_of_the_plc(plc: str, last: int) -> None:
    family = ("plc: s7-1500", f"plc: {plc}")
    assert plant(family, ("output_address: 256", f"output_address: {last - 9}"))
    assert codes(family, ("output_address: 256", f"output_address: {last - 8}")) == ["FB2018"]
    assert codes(family, ("input_address: 256", "input_address: -1")) == ["FB2018"]


@pytest.mark.parametrize(
    ("number", "found"), [(0, []), (63, []), (64, ["FB2007"]), (255, ["FB2007"]), (-1, ["FB2007"])]
)
def test_inverter_numbers_are_those_of_the_binary_protocol(number: int, found: list[str]) -> None:
    change = ("inv_no: 2", f"inv_no: {number}")
    assert (codes(change) if found else [] if plant(change) else ["?"]) == found


def test_a_series_that_the_gateway_does_not_serve_is_refused(tmp_path: Path) -> None:
    text = (shipped("catalog") / "drives" / "vf-s11.yaml").read_text("utf-8")
    (tmp_path / "drives").mkdir()
    path = tmp_path / "drives" / "my-drive.yaml"
    path.write_text(text.replace("id: vf-s11", "id: my-drive"), "utf-8")
    changed = TEXT.replace(
        "inv_no: 2\n        series: vf-s11", "inv_no: 2\n        series: my-drive"
    )
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", changed), load_catalog([tmp_path]))
    assert [item.code for item in failure.value.diagnostics] == ["FB2008"]


def test_a_sequence_that_stands_twice_or_fits_no_drive_is_refused(tmp_path: Path) -> None:
    assert codes(("- read_status", "- read_current")) == ["FB2011"]
    for kind, name, change in (
        ("drives", "vf-s11", ("id: vf-s11", "id: my-drive")),
        ("sequences", "stop", ("series: [vf-s11]", "series: [my-drive]")),
    ):
        text = (shipped("catalog") / kind / f"{name}.yaml").read_text("utf-8")
        (tmp_path / kind).mkdir()
        target = "my-drive" if kind == "drives" else name
        (tmp_path / kind / f"{target}.yaml").write_text(text.replace(*change), "utf-8")
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", TEXT), load_catalog([tmp_path]))
    assert [item.code for item in failure.value.diagnostics] == ["FB2011"]


def test_a_wrong_series_says_nothing_about_the_sequences() -> None:
    assert {
        (code, help_text.startswith("did you mean ") and "'vf-s11'" in help_text)
        for code, help_text in findings(("series: vf-s11", "series: vf-s12"))
    } == {("FB2009", True)}


def test_unknown_options_of_gateways_and_drives_suggest_the_nearest() -> None:
    assert findings(("trigger_poll: false", "triger_poll: false")) == [
        ("FB2003", "did you mean 'trigger_poll'?")
    ]
    assert findings(("broadcast_reads: false", "broadcast_read: false")) == [
        ("FB2003", "did you mean 'broadcast_reads'?")
    ]


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("offline_timeout_ms: 0", "offline_timeout_ms: 60001"),
        ("offline_timeout_ms: 0", "offline_timeout_ms: true"),
        ("offline_timeout_ms: 0", "offline_timeout_ms: '5'"),
        ("trigger_poll: false", "trigger_poll: 1"),
        ('heartbeat_frame: "(**P08800001)"', "heartbeat_frame: 5"),
        ("error_counter: restart", "error_counter: 1"),
    ],
)
def test_option_values_of_a_wrong_kind_are_refused(old: str, new: str) -> None:
    assert codes((old, new)) == ["FB2003"]


def test_a_missing_file_is_a_diagnostic(tmp_path: Path) -> None:
    for path in (tmp_path / "none.yaml", tmp_path):
        with pytest.raises(DiagnosticError) as failure:
            load_plant(path)
        assert [item.code for item in failure.value.diagnostics] == ["FB1008"]


@pytest.mark.parametrize("encoding", ["utf-16-le", "utf-16-be"])
def test_a_file_in_utf_16_is_called_so(tmp_path: Path, encoding: str) -> None:
    path = tmp_path / "plant.yaml"
    path.write_bytes(("\ufeff" + TEXT).encode(encoding))
    with pytest.raises(DiagnosticError) as failure:
        load_plant(path)
    (found,) = failure.value.diagnostics
    assert (found.code, found.help) == ("FB1008", "save it as UTF-8")
    assert "UTF-16" in found.message


def test_a_byte_order_mark_is_no_error(tmp_path: Path) -> None:
    path = tmp_path / "plant.yaml"
    path.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    assert load_plant(path).name == "my_plant"


def test_the_lowest_set_point_lies_below_the_highest() -> None:
    assert findings(("min_frequency_hz: 0 ", "min_frequency_hz: 51 ")) == [
        ("FB2010", "exchange the two, or take min_frequency_hz out")
    ]


@pytest.mark.parametrize("name", ["left", "Move", "TON"])
def test_a_drive_is_not_called_like_a_standard_function_or_block(name: str) -> None:
    assert findings(("name: infeed", f"name: {name}")) == [
        ("FB2012", f"choose another name, such as {name}_1")
    ]
