"""Words by name: decode and encode as the command line shows them."""

import pytest

from fbgen.catalog import load_catalog, parse_word
from fbgen.diagnostics import DiagnosticError

CATALOG = load_catalog()


def wrong(failure: pytest.ExceptionInfo[DiagnosticError]) -> list[tuple[str, str]]:
    return [(item.code, item.help) for item in failure.value.diagnostics]


@pytest.mark.parametrize(
    "path", ["vf-s11.command", "vf-s11.FA00", "VF-S11.fa00", "vf-s11.command_word"]
)
def test_a_word_is_found_by_name_and_by_communication_number(path: str) -> None:
    assert CATALOG.word(path).name == "command"


@pytest.mark.parametrize("path", ["vf-s11.FD01", "vf-s11.FE01", "vf-s11.status_held"])
def test_present_and_held_status_share_one_table(path: str) -> None:
    assert CATALOG.word(path).name == "status"


def test_decode_tells_every_field_from_the_highest_bit_down() -> None:
    fields = CATALOG.word("tospbdp001.status").decode(0x9F00)
    assert [(item.field.name, item.value, item.meaning) for item in fields] == [
        ("status_changed", 1, ""),
        ("command_done", 0, ""),
        ("data_valid", 0, ""),
        ("status_code", 0x1F, "no error"),
        ("status_data", 0, ""),
    ]


def test_encode_sets_the_named_bits() -> None:
    word = CATALOG.word("vf-s11.command")
    assert word.encode(["run", "network_command", "network_frequency"]) == 0xC400
    assert word.encode({"run": 1, "reverse": 0}) == 0x0400
    assert CATALOG.word("tospbdp001.status").encode({"status_code": 31, "status_changed": 1}) == (
        0x9F00
    )


def test_unknown_bits_and_values_that_do_not_fit_are_reported_together() -> None:
    with pytest.raises(DiagnosticError) as failure:
        CATALOG.word("vf-s11.command").encode({"runn": 1, "jog": 2, "revers": 1})
    assert wrong(failure) == [
        ("FB1202", "did you mean 'run'?"),
        ("FB1203", "use 0 to 1"),
        ("FB1202", "did you mean 'reverse'?"),
    ]


@pytest.mark.parametrize(
    ("path", "hint"),
    [
        ("vf-s11.comand", "vf-s11.command"),
        ("vfs11.command", "vf-s11.command"),
        ("tospbdp001.statsu", "tospbdp001.status"),
        ("command", ".command"),
    ],
)
def test_an_unknown_word_suggests_the_nearest(path: str, hint: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        CATALOG.word(path)
    ((code, help_text),) = wrong(failure)
    assert code == "FB1201"
    assert hint in help_text


def test_bits_without_a_meaning_are_told() -> None:
    word = CATALOG.word("vf-s11.status")
    assert word.undefined(0xFFFF) == 0x8008
    assert word.undefined(0x6400) == 0


def test_sources_of_bits_come_from_the_word_unless_they_have_their_own() -> None:
    word = CATALOG.word("tospbdp001.control")
    assert word.source_of(word.field("command_new")) == word.source
    assert "HMS" in word.source_of(word.field("control_code"))


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("9F00", 0x9F00),
        ("16#9F00", 0x9F00),
        ("16#9f_00", 0x9F00),
        ("0x9F00", 0x9F00),
        ("9F00h", 0x9F00),
        ("9F00H", 0x9F00),
        ("9F 00", 0x9F00),
        ("1388", 0x1388),
        ("0", 0),
        ("40704", 40704),
        ("10#5000", 5000),
        ("2#1001_1111_0000_0000", 0x9F00),
        ("0b101", 5),
        ("b101", 0xB101),
        ("0B10", 0x0B10),
        ("0D30", 0x0D30),
    ],
)
def test_values_are_read_as_people_write_them(text: str, value: int) -> None:
    assert parse_word(text) == value


@pytest.mark.parametrize("text", ["", "65536", "10000h", "G000", "-1", "2#2", "10#70000", "1.5"])
def test_what_is_no_16_bit_number_is_refused(text: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        parse_word(text)
    assert [code for code, _ in wrong(failure)] == ["FB1204"]


@pytest.mark.parametrize(
    ("look_up", "code"),
    [
        (lambda: CATALOG.drive("vf-s12"), "FB1205"),
        (lambda: CATALOG.gateway("tospbdp"), "FB1205"),
        (lambda: CATALOG.protocol("toshba"), "FB1205"),
        (lambda: CATALOG.sequence("start"), "FB1205"),
        (lambda: CATALOG.drive("vf-s11").comno("FA02"), "FB1105"),
        (lambda: CATALOG.drive("vf-s11").comno(0xFA02), "FB1105"),
        (lambda: CATALOG.drive("vf-s11").word("comand"), "FB1201"),
        (lambda: CATALOG.gateway("tospbdp001").layout("gsd"), "FB1105"),
    ],
)
def test_look_ups_of_unknown_names_suggest_the_nearest(look_up: object, code: str) -> None:
    assert callable(look_up)
    with pytest.raises(DiagnosticError) as failure:
        look_up()
    ((found, help_text),) = wrong(failure)
    assert found == code
    assert help_text.startswith("did you mean")
