"""The decoder of a word as a person uses it, and against `fbgen decode` and `fbgen encode`."""

from collections.abc import Callable

import pytest
from playwright.sync_api import Page, expect

from fbgen.catalog import load_catalog, parse_word
from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.telegram_reading import telegram_kind, written_telegram
from fbgen.diagnostics import DiagnosticError
from fbgen.wire import toshiba_binary
from fbgen.wire.toshiba import Command, Form, Request

CATALOG = load_catalog()
Shown = Callable[..., Page]


def rows(page: Page) -> list[list[str]]:
    """The table of the decoder."""
    return page.eval_on_selector_all(
        ".tool .fields tbody tr",
        "rows => rows.map(row => [...row.cells].map(cell => cell.textContent))",
    )


def test_the_bytes_of_the_manuals_example(shown: Shown) -> None:
    page = shown("vf-s11.command", fragment="#v=C400&n=11&c=E000")
    expect(page.locator("[data-frame=ram]")).to_have_text("2F 0B 50 FA 00 C4 00 48")
    expect(page.locator("[data-frame=tospbdp001]")).to_have_text("E0 00 01 0B 50 FA 00 00 C4 00")


@pytest.mark.parametrize("name", ["vf-s11.command", "tospbdp001.status", "pbdp110.response"])
def test_the_page_decodes_as_the_command_line_does(shown: Shown, name: str) -> None:
    word = CATALOG.word(name)
    page = shown(name)
    for value in (0, 0xFFFF, 0xC400, 0x9F00, 0x1234, 0x8001):
        page.get_by_label("Value").fill(f"{value:04X}")
        found = {row[1]: (row[2], row[3]) for row in rows(page)}
        for item in word.decode(value):
            shown_value, meaning = found[item.field.name]
            assert int(shown_value, 16) == item.value
            assert meaning == (
                f"{item.field.title}: {item.meaning}" if item.meaning else item.field.title
            )


def test_frames_are_those_of_the_codec(shown: Shown) -> None:
    page = shown("vf-s11.command")
    for number, value in ((0, 0xC400), (63, 0xFFFF), (11, 0x2F2F)):
        page.locator("[data-part=number]").fill(str(number))
        page.get_by_label("Value").fill(f"{value:04X}")
        for name, command in (("ram", Command.P), ("eeprom", Command.W)):
            request = Request(number, command, 0xFA00, value, Form.BINARY)
            frame = toshiba_binary.encode_request(request).hex(" ").upper()
            expect(page.locator(f"[data-frame={name}]")).to_have_text(frame)


def test_values_are_read_as_the_command_line_reads_them(shown: Shown) -> None:
    page = shown("vf-s11.command")
    texts = [
        *("9F00", "9f00", "16#9F00", "0x9F00", "9F00h", "2#1001_1111_0000_0000", "10#40704"),
        *("40704", "0b10", "0b101", "$FF", "70000", "10#70000", "xyz", "", "1_2"),
        *("12345", "16#12345"),
    ]
    for text in texts:
        page.get_by_label("Value").fill(text)
        try:
            value = parse_word(text)
        except DiagnosticError:
            expect(page.locator(".tool .wrong")).to_contain_text("no 16-bit number")
            continue
        expect(page.locator(".tool .wrong")).to_have_text("")
        assert page.locator(".tool .spellings").inner_text().startswith(f"16#{value:04X}"), text


def test_bits_are_switched_by_mouse_and_by_keyboard(shown: Shown) -> None:
    page = shown("vf-s11.command")
    run = page.get_by_role("button", name="bit 10 run")
    run.click()
    expect(page.get_by_label("Value")).to_have_value("0400")
    expect(run).to_have_attribute("aria-pressed", "true")
    run.focus()
    page.keyboard.press("Space")
    expect(page.get_by_label("Value")).to_have_value("0000")


def test_a_link_keeps_the_state(shown: Shown) -> None:
    page = shown("vf-s11.command", fragment="#v=C400&n=12")
    expect(page.get_by_label("Value")).to_have_value("C400")
    page.get_by_role("button", name="bit 9 reverse").click()
    assert page.evaluate("location.hash") == "#v=C600&n=12"


def test_the_converter_goes_both_ways(shown: Shown) -> None:
    page = shown("vf-s11-comnos")
    word, value = page.get_by_label("Word", exact=True), page.get_by_label("Value in")
    expect(word).to_have_value("1388")
    word.fill("159E")
    expect(value).to_have_value("55.34")
    value.fill("600")
    expect(page.locator(".tool .wrong")).to_contain_text("0 to 500 Hz")
    page.locator(".tool select").select_option("0009")
    value.fill("12,5")
    expect(word).to_have_value("007D")


def test_an_example_of_the_manual_is_put_into_the_decoder(shown: Shown) -> None:
    page = shown("vf-as1.command")
    page.get_by_role("link", name="8600").click()
    expect(page.get_by_label("Value")).to_have_value("8600")
    expect(page.get_by_role("button", name="bit 9 reverse")).to_have_attribute(
        "aria-pressed", "true"
    )


def test_cyclic_data_are_those_of_the_command_line(shown: Shown) -> None:
    kind = telegram_kind(CATALOG, "tospbdp001.output")
    assert kind is not None
    page = shown("vf-s11.command")
    for number, trigger, value in ((0, 1, 0xC400), (63, 0xFF, 0x2F2F)):
        page.locator("[data-part=number]").fill(str(number))
        page.locator("[data-part=trigger]").fill(f"{trigger:02X}")
        page.get_by_label("Value").fill(f"{value:04X}")
        fields = (f"inv_no={number}", f"trigger={trigger:02X}", f"data={value:04X}")
        written = written_telegram(kind, ("cmd=P", "comno=FA00", *fields), CellTexts())
        text = written.frame.hex(" ").upper()
        expect(page.locator("[data-frame=tospbdp001]")).to_have_text(text)
