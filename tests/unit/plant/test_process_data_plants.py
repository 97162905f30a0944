"""Plants with a PBDP-110: how its drives are connected, its module, what means nothing there."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant, layout_of, load_plant, read_plant
from fbgen.resources import shipped
from fbgen.source import Source

CATALOG = load_catalog()
EXAMPLE = shipped("examples") / "pbdp110" / "plant.yaml"
ADDRESSES = ("hardware_identifier: 270", "input_address: 256\n    output_address: 256")
S7_300 = ("plc: s7-1500", "plc: s7-300")


def plant(*changes: tuple[str, str]) -> Plant:
    text = EXAMPLE.read_text("utf-8")
    for old, new in changes:
        assert old in text, old
        text = text.replace(old, new)
    return read_plant(Source("plant.yaml", text))


def messages(*changes: tuple[str, str]) -> list[tuple[str, str]]:
    with pytest.raises(DiagnosticError) as failure:
        plant(*changes)
    return [(item.code, item.message) for item in failure.value.diagnostics]


def test_the_example_has_a_drive_at_each_channel() -> None:
    (gateway,) = load_plant(EXAMPLE).gateways
    assert [(drive.name, drive.channel) for drive in gateway.drives] == [
        ("pump", "A"),
        ("fan", "B"),
    ]
    layout = layout_of(gateway, CATALOG.gateway(gateway.type))
    assert (layout.output_length, layout.input_length) == (32, 48)


@pytest.mark.parametrize(
    ("change", "code", "message"),
    [
        (("channel: B", "channel: A"), "FB2006", "channel A is given twice on this gateway"),
        (("channel: B, ", ""), "FB2024", "the drive 'fan' has no channel at its gateway"),
        (
            ("channel: B", "inv_no: 2"),
            "FB2024",
            "a pbdp110 does not know its drives by numbers",
        ),
        (
            ("layout: module2", "layout: module3"),
            "FB2024",
            "layout 'module3' has no channel B",
        ),
        (
            ("layout: module2", "layout: module2\n    identifiers: C0 C7 CB"),
            "FB2025",
            "the identifiers C0 C7 CB do not fit: they carry 16 bytes out and 24 in, "
            "layout 'module2' has 32 and 48",
        ),
        (
            ("layout: module2", "layout: module4\n    eeprom: true"),
            "FB2026",
            "eeprom means nothing with layout 'module4', which has no parameter channel",
        ),
        (
            ("channel: B", "channel: B, parameters: {error_pause_ms: 10}"),
            "FB2026",
            "error_pause_ms means nothing behind a pbdp110, which sends all the time",
        ),
    ],
    ids=["twice", "no channel", "number", "no such channel", "identifiers", "eeprom", "pause"],
)
def test_what_does_not_fit_the_gateway_is_told(
    change: tuple[str, str], code: str, message: str
) -> None:
    assert messages(change) == [(code, message)]


def test_a_gateway_with_a_line_has_neither_channels_nor_identifiers_of_its_own() -> None:
    text = (shipped("examples") / "manual_example" / "plant.yaml").read_text("utf-8")
    wrong = text.replace("inv_no: 11", "channel: A").replace(
        "layout: gsd10", "layout: gsd10\n    identifiers: C0 89 87\n    eeprom: false"
    )
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", wrong))
    assert [(item.code, item.message) for item in failure.value.diagnostics] == [
        ("FB2026", "identifiers means nothing for a tospbdp001"),
        ("FB2026", "eeprom means nothing for a tospbdp001"),
        ("FB2024", "a tospbdp001 has no channels"),
    ]


def test_a_drive_on_a_line_needs_its_number() -> None:
    text = (shipped("examples") / "manual_example" / "plant.yaml").read_text("utf-8")
    assert "        inv_no: 11\n" in text
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", text.replace("        inv_no: 11\n", "")))
    (found,) = failure.value.diagnostics
    assert (found.code, found.help) == (
        "FB2024",
        "add inv_no: as parameter F802 of the drive has it",
    )


def test_sequences_are_telegrams_and_need_a_line() -> None:
    with pytest.raises(DiagnosticError) as failure:
        plant(("gateways:", "sequences: [stop]\ngateways:"))
    (found,) = failure.value.diagnostics
    assert found.code == "FB2011"
    assert found.help == "sequences are telegrams, and no gateway of this plant sends telegrams"


def test_the_identifiers_of_the_plant_file_decide_how_the_data_are_reached() -> None:
    by_words = ("layout: module2", "layout: module2\n    identifiers: 6F 5F 57")
    assert [code for code, _ in messages(by_words, ADDRESSES)] == ["FB2005"]
    found = plant(by_words, ADDRESSES, ("access: dpxx_dat", "access: per_identifier"))
    (gateway,) = found.gateways
    assert layout_of(gateway, CATALOG.gateway("pbdp110")).identifiers == bytes.fromhex("6F5F57")


def test_what_is_consistent_as_a_whole_is_not_reached_word_by_word() -> None:
    whole = ("layout: module2", "layout: module2\n    identifiers: EF DF D7")
    by_words = ("access: dpxx_dat", "access: per_identifier")
    assert messages(whole, ADDRESSES, by_words, S7_300) == [
        (
            "FB2005",
            "32 bytes of layout 'module2' are consistent as a whole, and no single access moves so "
            "many",
        )
    ]
