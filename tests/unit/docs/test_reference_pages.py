"""What the pages of the reference say, whatever they are written as."""

import pytest

from fbgen.catalog import load_catalog
from fbgen.docs.document import Page, Row, Table, plain
from fbgen.docs.site import Site

CATALOG = load_catalog()


def page(site: Site, name: str) -> Page:
    return next(page for page in site.pages if page.id == name)


def row(page: Page, anchor: str) -> Row:
    tables = [
        block for section in page.sections for block in section.blocks if isinstance(block, Table)
    ]
    return next(row for table in tables for row in table.rows if row.anchor == anchor)


def test_no_link_leads_nowhere(site: Site) -> None:
    assert list(site.broken_links()) == []


def test_no_page_and_no_anchor_stands_twice(site: Site) -> None:
    names = [page.id for page in site.pages]
    assert len(names) == len(set(names))
    for page in site.pages:
        anchors = list(page.anchors())
        assert len(anchors) == len(set(anchors)), page.id


def test_every_bit_of_every_word_has_a_row(site: Site) -> None:
    for device in (*CATALOG.gateways.values(), *CATALOG.drives.values()):
        for word in device.words:
            shown = page(site, f"{device.id}.{word.name}")
            for field in word.bits:
                cells = row(shown, f"bit-{field.name}").cells
                assert plain(cells[0]) == str(field.bit)
                assert field.title in plain(cells[2])


def test_every_comno_and_every_trip_has_a_row(site: Site) -> None:
    for series in CATALOG.drives.values():
        comnos, trips = page(site, f"{series.id}-comnos"), page(site, f"{series.id}-trips")
        for cell in series.comnos:
            assert plain(row(comnos, cell.hex).cells[1]) == cell.name
        for trip in series.trips:
            assert plain(row(trips, f"trip-{trip.code:02X}").cells[1]) == trip.display


def test_a_range_says_unit_and_default(site: Site) -> None:
    cells = [plain(cell) for cell in row(page(site, "vf-s11-comnos"), "0011").cells]
    assert cells[1:3] == ["maximum_frequency", "FH"]
    assert cells[4:8] == ["Hz", "0.01 Hz", "30 to 500", "80"]


def test_what_rests_on_no_document_is_marked(site: Site) -> None:
    default = row(page(site, "vf-s11-comnos"), "0009").cells[7]
    assert plain(default) == "10 unverified"


@pytest.mark.parametrize("name", ["index", "tospbdp001", "pbdp110", "vf-as1", "protocol-modbus"])
def test_each_kind_of_page_is_there(site: Site, name: str) -> None:
    assert page(site, name).sections


def test_the_page_of_a_devicenet_adapter_has_assemblies_and_objects(site: Site) -> None:
    shown = page(site, "dev003z")
    assert {"assemblies-toshiba_parameter", "class-29", "selections"} <= set(shown.anchors())
    status = row(shown, "assembly-151-status").cells
    assert plain(status[1]) == "0 to 1"
    assert plain(row(shown, "parameter-c102").cells[3]) == "0"
    mode = row(shown, "class-2a-object-6").cells
    assert plain(mode[2]).startswith("Mode: 0 vendor specific, 1 open loop speed")
    assert (plain(mode[4]), plain(mode[5])) == ("get", "1")
    heartbeat = plain(row(shown, "class-01-object-10").cells[2])
    assert heartbeat.endswith("it does not here.")


def test_worked_examples_lead_into_the_decoder(site: Site) -> None:
    shown = page(site, "vf-s11.command")
    link = next(link for link in shown.links() if link.state == "v=C400")
    assert (link.page, link.anchor) == ("", "decoder")


def test_every_finding_in_a_manual_has_a_row_with_its_reason(site: Site) -> None:
    for manual in CATALOG.manuals.values():
        for finding in manual.findings:
            cells = [plain(cell) for cell in row(page(site, manual.id), finding.name).cells]
            assert cells[1:4] == [finding.says, finding.taken, finding.why]


def test_wiring_of_the_gateway_has_the_pins_of_its_manual(site: Site) -> None:
    section = next(one for one in page(site, "tospbdp001").sections if one.anchor == "wiring")
    tables = [block for block in section.blocks if isinstance(block, Table)]
    pins = {plain(row.cells[0]): plain(row.cells[1]) for row in tables[0].rows}
    assert (pins["3"], pins["8"]) == ("B-line (+)", "A-line (-)")
