"""The HTML report in a browser: what one sees, points at, presses and hears of it."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache

import pytest
from playwright.sync_api import Locator, Page, expect

from harness.results import ScenarioReport
from tests.unit.report.results import FAILED, PASSED
from tests.unit.report.traces import long_trace, network_trace, short_trace

Show = Callable[..., Page]
TRACED = replace(FAILED, observations=(short_trace(),))
REPORT = ScenarioReport((PASSED, TRACED))
TOTAL_MS = 100


@cache
def long_report() -> ScenarioReport:
    """A run with a hundred thousand events."""
    return ScenarioReport((replace(PASSED, observations=(long_trace(100_000),)),))


def stage(page: Page) -> Locator:
    return page.locator(".stage")


def whole(page: Page) -> None:
    """The whole run is in sight."""
    stage(page).press("0")
    expect(page.locator(".readout")).to_contain_text("100 ms in sight")


def point(page: Page, channel: str, at_ms: float) -> tuple[float, float]:
    """Where a channel is at a time while the whole run is in sight."""
    label = page.locator(f'.labels .label[title^="{channel}:"]')
    label.scroll_into_view_if_needed()
    row, area = label.bounding_box(), stage(page).bounding_box()
    assert row is not None
    assert area is not None
    return area["x"] + area["width"] * at_ms / TOTAL_MS, row["y"] + min(row["height"], 24) / 2


def hover(page: Page, channel: str, at_ms: float) -> Locator:
    page.mouse.move(*point(page, channel, at_ms))
    return page.locator(".tip")


# --- what is seen first ------------------------------------------------------------------------


def test_the_first_failure_is_open_in_sight_and_chosen(shown: Show) -> None:
    page = shown(REPORT)
    assert [
        item.get_attribute("open") is not None for item in page.locator("details.scenario").all()
    ] == [False, True]
    expect(page.locator(".readout")).to_contain_text("A 0.085")
    expect(page.locator(".inspector h4")).to_have_text("drive.pump.running")
    expect(page.locator(".label[aria-pressed=true] .name")).to_have_text("running")


def test_scenarios_are_filtered_by_text_and_by_failure(shown: Show) -> None:
    page = shown(REPORT)
    page.check("#only-failed")
    expect(page.locator("details.scenario:visible")).to_have_count(1)
    page.fill("#scenario-filter", "waits")
    expect(page.locator("details.scenario:visible")).to_have_count(0)
    expect(page.locator("#no-scenario")).to_be_visible()


# --- pointing ----------------------------------------------------------------------------------


def test_a_word_is_decoded_by_name_with_the_line_that_wrote_it(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    tip = hover(page, "gateway.gw1.status", 60)
    expect(tip.locator("h4")).to_have_text("gateway.gw1.status")
    expect(tip.locator(".value")).to_have_text("16#8301")
    rows = [row.all_inner_texts()[0].split("\t") for row in tip.locator("tr").all()]
    assert rows == [
        ["15", "1", "data_taken", "changed"],
        ["14", "0", "status_changed", ""],
        ["12..8", "3", "status_code", "no reply"],
        ["7..0", "1", "error_count", "changed"],
    ]
    expect(tip).to_contain_text("TOS_Line.scl:61 in TOS_Gateway_gw1_DB.line")
    expect(tip.locator("code")).to_have_text("#trigger := #next;")


def test_a_frame_says_what_it_means_and_what_happened_to_it(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    expect(hover(page, "line.gw1.to_drives", 24).locator(".value")).to_have_text("ask")
    tip = hover(page, "line.gw1.from_drives", 32)
    expect(tip.locator("h4")).to_have_text("reply from pump")
    expect(tip).to_contain_text("damaged, collided")


def test_serial_lines_and_networks_have_their_frames_under_a_heading_of_their_own(
    shown: Show,
) -> None:
    page = shown(ScenarioReport((replace(PASSED, observations=(network_trace(),)),)))
    whole(page)
    headings = page.locator(".labels .heading").all_inner_texts()
    assert headings[-3:] == ["Line line1", "DeviceNet net1", "DeviceNet infeed"], headings
    expect(hover(page, "line.line1.from_drives", 32)).to_contain_text("reply from pump")
    tip = hover(page, "line.net1.to_drives", 42)
    expect(tip.locator("h4")).to_have_text("output from net1")
    expect(tip).to_contain_text("42D")
    expect(tip.locator(".value")).to_have_text("infeed: command = C400")
    expect(hover(page, "devicenet.infeed.scanner", 70).locator(".value")).to_have_text('"lost"')


def test_marks_telegrams_and_faults_have_their_texts(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    check = hover(page, "check", 60)
    expect(check.locator("h4")).to_have_text("check: failed")
    expect(check).to_contain_text("start.scenario.yaml:5")
    expect(hover(page, "fault", 70)).to_contain_text("still there at the end")
    expect(hover(page, "telegrams.gw1", 30)).to_contain_text("drive 11: read FC90")


def test_values_that_are_no_numbers_and_numbers_of_64_bits_are_told_exactly(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    expect(hover(page, "drive.pump.frequency", 55).locator(".value")).to_have_text("12.5 Hz")
    expect(hover(page, "drive.pump.frequency", 65).locator(".value")).to_have_text("NaN Hz")
    page.select_option('select[aria-label="which channels"]', label="all")
    huge = hover(page, "plc.TOS_Plant.huge", 50).locator(".value")
    expect(huge).to_have_text("16#8000000000000001")


def test_two_clicks_measure_the_time_between_two_changes(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    page.mouse.click(*point(page, "drive.pump.running", 50.3))
    x, y = point(page, "drive.pump.running", 79.8)
    page.keyboard.down("Shift")
    page.mouse.click(x, y)
    page.keyboard.up("Shift")
    expect(page.locator(".readout")).to_contain_text("A 0.050")
    expect(page.locator(".readout")).to_contain_text("B\u2212A 30 ms")


# --- the time axis ------------------------------------------------------------------------------


def test_the_wheel_zooms_at_the_pointer_and_with_shift_moves(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    page.mouse.move(*point(page, "drive.pump.running", 50))
    page.mouse.wheel(0, -200)
    readout = page.locator(".readout")
    expect(readout).to_contain_text("54.88 ms in sight")
    expect(page.locator(".tip .facts")).to_contain_text("at0.0499")
    page.mouse.wheel(0, 300)
    expect(readout).to_contain_text("100 ms in sight")


def test_dragging_with_shift_zooms_to_a_range(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    page.mouse.move(*point(page, "drive.pump.running", 40))
    page.keyboard.down("Shift")
    page.mouse.down()
    page.mouse.move(*point(page, "drive.pump.running", 60), steps=4)
    page.mouse.up()
    page.keyboard.up("Shift")
    expect(page.locator(".readout")).to_contain_text("20 ms in sight")


def test_two_fingers_zoom(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    (left, y), (right, _) = (point(page, "drive.pump.running", at) for at in (40, 60))
    client = page.context.new_cdp_session(page)

    def touch(kind: str, *places: float) -> None:
        points = [{"x": x, "y": y, "id": number} for number, x in enumerate(places)]
        client.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    touch("touchStart", left, right)
    for step in range(1, 6):
        touch("touchMove", left - 20 * step, right + 20 * step)
    touch("touchEnd")
    expect(page.locator(".readout")).not_to_contain_text("100 ms in sight")


def test_buttons_do_what_the_keys_do(shown: Show) -> None:
    page = shown(REPORT)
    page.get_by_role("button", name="show the whole run").click()
    expect(page.locator(".readout")).to_contain_text("100 ms in sight")
    page.get_by_role("button", name="zoom in at cursor A").click()
    expect(page.locator(".readout")).to_contain_text("50 ms in sight")


# --- keyboard and screen reader -----------------------------------------------------------------


def test_keys_go_from_change_to_change_and_say_what_is_there(shown: Show) -> None:
    page = shown(REPORT)
    said = page.locator("[aria-live]")
    stage(page).press("ArrowLeft")
    expect(said).to_have_text("drive.pump.running at 0.08000 s: FALSE")
    stage(page).press("ArrowLeft")
    expect(said).to_contain_text("s: TRUE")
    stage(page).press("ArrowUp")
    expect(said).to_contain_text("drive.pump.frequency at")
    stage(page).press("-")
    stage(page).press("+")


def test_keys_go_through_marks_and_failures(shown: Show) -> None:
    page = shown(REPORT)
    stage(page).press("p")
    expect(page.locator("[aria-live]")).to_have_text("check: drive.pump.running: true failed")
    stage(page).press("p")
    expect(page.locator("[aria-live]")).to_contain_text("fault: line_broken")
    stage(page).press("f")
    expect(page.locator(".readout")).to_contain_text("A 0.085")


def test_everything_that_can_be_pressed_has_a_name_and_the_keys_are_listed(shown: Show) -> None:
    page = shown(REPORT)
    stage(page).press("?")
    dialog = page.get_by_role("dialog")
    expect(dialog).to_contain_text("zoom to a range")
    dialog.get_by_role("button", name="Close").click()
    nameless = """() => [...document.querySelectorAll("button, input, select, [role=application]")]
        .filter((item) => !(item.ariaLabel || item.textContent.trim() || item.labels?.length))"""
    assert page.evaluate(nameless) == []


def test_the_events_in_sight_are_a_table(shown: Show) -> None:
    page = shown(REPORT)
    whole(page)
    page.get_by_text("Events in sight as a table").click()
    page.fill('input[aria-label="filter channels"]', "gw1 status")
    rows = page.locator(".events tbody tr")
    expect(rows).to_have_count(2)
    cells = rows.nth(1).locator("td").all_inner_texts()
    assert cells == [
        "0.040000 s",
        "gateway.gw1.status",
        "16#8301",
        "data_taken, status_code (no reply), error_count=1",
        "TOS_Line.scl:61 in TOS_Gateway_gw1_DB.line: #trigger := #next;",
    ]


# --- which channels -----------------------------------------------------------------------------


def test_channels_are_chosen_by_text_by_group_and_by_how_much_one_wants(shown: Show) -> None:
    page = shown(REPORT)
    labels = page.locator(".labels .label")
    expect(page.locator('.label[title^="plc.TOS_Plant.huge:"]')).to_have_count(0)
    page.select_option('select[aria-label="which channels"]', label="all")
    expect(page.locator('.label[title^="plc.TOS_Plant.huge:"]')).to_have_count(1)
    page.fill('input[aria-label="filter channels"]', "pump frequency")
    expect(labels).to_have_count(1)
    page.fill('input[aria-label="filter channels"]', "")
    before = labels.count()
    page.get_by_role("button", name="Drive pump").click()
    expect(labels).to_have_count(before - 2)


# --- looks --------------------------------------------------------------------------------------


def looks(page: Page) -> tuple[str, bytes]:
    """The colour of the page, and a picture of the diagram."""
    page.wait_for_timeout(200)
    colour = str(page.evaluate("getComputedStyle(document.body).backgroundColor"))
    return colour, page.locator(".waves").screenshot()


@pytest.mark.parametrize("dark", [False, True])
def test_day_and_night_follow_the_system_and_the_switch(shown: Show, dark: bool) -> None:
    page = shown(REPORT, dark=dark)
    colour, picture = looks(page)
    assert colour == ("rgb(14, 18, 23)" if dark else "rgb(244, 245, 247)")
    page.get_by_role("button", name="Day / night").click()
    expect(page.locator("html")).to_have_attribute("data-theme", "light" if dark else "dark")
    other_colour, other_picture = looks(page)
    assert other_colour != colour
    assert other_picture != picture


def test_nothing_hangs_over_the_edge_of_a_narrow_screen(shown: Show) -> None:
    page = shown(REPORT, width=360)
    assert page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    expect(stage(page)).to_be_visible()


def test_paper_gets_the_diagram_in_the_colours_of_the_day(shown: Show) -> None:
    page = shown(REPORT, dark=True)
    page.emulate_media(media="print")
    page.evaluate("dispatchEvent(new Event('beforeprint'))")
    expect(page.locator(".toolbar input")).to_be_hidden()
    assert page.evaluate("document.documentElement.dataset.theme") == "light"
    waves, rows = page.locator(".waves").bounding_box(), page.locator(".labels").bounding_box()
    assert waves is not None
    assert rows is not None
    assert round(waves["height"]) == round(rows["height"])
    page.evaluate("dispatchEvent(new Event('afterprint'))")
    assert page.evaluate("document.documentElement.dataset.theme ?? null") is None
    assert page.pdf()[:5] == b"%PDF-"


# --- size ---------------------------------------------------------------------------------------


def draw_ms(page: Page) -> float:
    """How long the last picture took."""
    page.wait_for_timeout(150)
    return float(page.evaluate("performance.getEntriesByName('fbgen draw')[0].duration"))


def test_a_hundred_thousand_events_are_drawn_at_once(shown: Show) -> None:
    page = shown(long_report())
    expect(page.locator(".readout")).to_contain_text("100 s in sight")
    times = []
    for key in ("0", "+", "+", "+", "+", "+", "Shift+ArrowRight", "Shift+ArrowRight"):
        stage(page).press(key)
        times.append(draw_ms(page))
    assert sorted(times)[len(times) // 2] < 60, times


def test_what_cannot_be_told_apart_is_one_band_and_no_bar_code(shown: Show) -> None:
    page = shown(long_report())
    expect(page.locator(".readout")).to_contain_text("100 s in sight")
    row = page.locator('.label[title^="drive.pump.running:"]').bounding_box()
    top = page.locator(".waves").bounding_box()
    assert row is not None
    assert top is not None
    y = round(row["y"] - top["y"] + row["height"] / 2 + 4)
    script = """(y) => {
        const context = document.querySelector(".waves").getContext("2d");
        const { data } = context.getImageData(200, y, 400, 1);
        const dots = Array.from({ length: 400 }, (_, x) => data.slice(4 * x, 4 * x + 4).join());
        return new Set(dots).size;
    }"""
    colours = page.evaluate(script, y)
    assert colours <= 2
