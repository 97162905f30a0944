"""The site as a person sees it: search, keyboard, a narrow screen, day and night, print."""

from collections.abc import Callable

from playwright.sync_api import Page, expect

Shown = Callable[..., Page]


def test_the_search_finds_a_bit_by_keyboard_alone(shown: Shown) -> None:
    page = shown("index")
    page.keyboard.press("/")
    page.keyboard.type("vf-s11 fault_reset")
    expect(page.get_by_role("option").first).to_contain_text("fault_reset")
    page.keyboard.press("ArrowDown")
    page.keyboard.press("Enter")
    page.wait_for_url("**/vf-s11.command.html#bit-fault_reset")


def test_the_search_finds_comnos_and_trips(shown: Shown) -> None:
    page = shown("index")
    for query, found in (("FE03", "FE03"), ("OC1", "OC1"), ("tospbdp001 1F", "1F")):
        page.get_by_role("combobox").fill(query)
        expect(page.get_by_role("option").first).to_contain_text(found)
    page.get_by_role("combobox").fill("xyzzy")
    expect(page.locator("#found")).to_contain_text("Nothing found")
    page.keyboard.press("Escape")
    expect(page.locator("#found")).to_be_hidden()


def test_nothing_is_wider_than_a_narrow_screen(shown: Shown) -> None:
    for name in ("index", "vf-s11.command", "vf-s11-comnos", "tospbdp001"):
        page = shown(name, width=380)
        assert page.evaluate("document.documentElement.scrollWidth") <= 380, name
    menu = page.get_by_role("button", name="Menu")
    menu.click()
    expect(page.get_by_role("navigation")).to_be_visible()
    expect(menu).to_have_attribute("aria-expanded", "true")


def test_day_becomes_night_and_stays_so(shown: Shown) -> None:
    page = shown("index")
    light = page.evaluate("getComputedStyle(document.body).backgroundColor")
    page.get_by_role("button", name="Day / night").click()
    dark = page.evaluate("getComputedStyle(document.body).backgroundColor")
    assert light != dark
    page.reload()
    assert page.evaluate("getComputedStyle(document.body).backgroundColor") == dark


def test_print_leaves_out_what_is_for_the_screen(shown: Shown) -> None:
    page = shown("vf-s11.command")
    page.emulate_media(media="print")
    for hidden in ("header.site", "nav", ".tool"):
        expect(page.locator(hidden).first).to_be_hidden()
    expect(page.get_by_role("heading", name="Bits")).to_be_visible()
