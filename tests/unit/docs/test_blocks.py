"""Pages of blocks: what they say is what stands in the blocks."""

import re

import pytest

from fbgen.blocks.status_codes import STATUS_CODES
from fbgen.docs.blocks.calls import DIALECTS, callable_blocks
from fbgen.docs.blocks.reading import read_block
from fbgen.docs.blocks.states import StateMachine, state_machine
from fbgen.docs.document import Page, Paragraph, Sample, Table, plain
from fbgen.docs.site import Site
from fbgen.docs.subject import Subject
from fbgen.resources import shipped

KNOWN = {code for item in STATUS_CODES for code in item.codes}


def machine_of(subject: Subject, name: str) -> StateMachine | None:
    for program in subject.programs:
        checked = program.canonical.program
        for unit in callable_blocks(program.canonical.units):
            if unit.name.name == name:
                block = checked.blocks[name.casefold()]
                text = read_block(unit)
                return state_machine(block, checked.bodies[block], (*text.kept, *text.parameters))
    raise AssertionError(name)


def page(site: Site, block: str) -> Page:
    return next(page for page in site.pages if page.id == f"block-{block}")


def table(page: Page, anchor: str) -> list[list[str]]:
    section = next(one for one in page.sections if one.anchor == anchor)
    rows = next(block for block in section.blocks if isinstance(block, Table)).rows
    return [[plain(cell) for cell in row.cells] for row in rows]


def test_every_block_that_is_generated_has_a_page(site: Site, subject: Subject) -> None:
    pages = {page.id for page in site.pages}
    for program in subject.programs:
        for unit in callable_blocks(program.canonical.units):
            assert f"block-{unit.name.name}" in pages


def test_the_interface_has_names_types_defaults_and_comments(site: Site) -> None:
    rows = {row[1]: row for row in table(page(site, "TOS_Telegram"), "interface")}
    meaning = "FALSE for 53/73, resets, broadcasts without drive 0"
    assert rows["replyExpected"] == ["in", "replyExpected", "Bool", "TRUE", meaning]
    assert rows["frameOut"][0] == "in and out"
    assert "statState" not in rows


def test_a_comment_that_goes_on_in_the_next_line_is_read_whole(subject: Subject) -> None:
    machine = machine_of(subject, "TOS_Telegram")
    assert machine is not None
    assert machine.names[7] == "wait for the read that went out first"
    assert machine.names[50] == "line left alone after a job without reply"


def test_the_states_of_a_telegram_follow_each_other_as_in_its_code(subject: Subject) -> None:
    machine = machine_of(subject, "TOS_Telegram")
    assert machine is not None
    ways = {(source, one.target) for one in machine.transitions for source in one.sources}
    assert {(0, 7), (0, 10), (0, 30), (10, 20), (30, 40), (30, 50), (20, 30)} <= ways
    assert not {(0, 20), (0, 40), (10, 30), (40, 7)} & ways
    expired = next(one for one in machine.transitions if one.sources == (5,))
    assert (expired.target, expired.condition) == (0, "statExpired")


def test_states_asked_for_by_case_are_found(subject: Subject) -> None:
    machine = machine_of(subject, "PBDP_Parameter")
    assert machine is not None
    assert machine.variable == "statStep"
    ways = {(one.sources, one.target) for one in machine.transitions}
    assert ((2,), 3) in ways


def test_a_block_without_states_has_no_machine(subject: Subject) -> None:
    assert machine_of(subject, "TOS_HzToWord") is None


def test_every_status_that_a_template_sets_is_in_the_list_and_the_other_way_round() -> None:
    found = set()
    for template in (shipped("templates") / "blocks").iterdir():
        code = "\n".join(line.partition("//")[0] for line in template.read_text().splitlines())
        written = re.findall(r"(?:[sS]tatus|Refuse|Outcome) := 16#([78][0-9A-F]{3})", code)
        found |= {int(one, 16) for one in written} - {0x8500}
    passed_on = {code for code in KNOWN if code >> 8 == 0x85 or code >> 4 in (0x841, 0x842)}
    assert found >= {0x7000, 0x7001, 0x7002, 0x8401, 0x8406}
    assert found | passed_on | {0} == KNOWN


def test_codes_of_a_block_have_cause_and_remedy(site: Site) -> None:
    rows = {row[0]: row for row in table(page(site, "TOS_Telegram"), "status-codes")}
    assert set(rows) == {
        *("7000, 7001, 7002", "8201", "8401", "8402", "8403", "8404", "8405"),
    }
    assert all(row[1] and (row[2] or code.startswith("7")) for code, row in rows.items())


@pytest.mark.parametrize("block", ["TOS_Drive", "TOS_HzToWord", "PBDP_Parameter"])
def test_an_example_call_names_every_parameter_in_every_dialect(site: Site, block: str) -> None:
    shown = page(site, block)
    section = next(one for one in shown.sections if one.anchor == "call")
    titles = "; ".join(plain(one.phrase) for one in section.blocks if isinstance(one, Paragraph))
    assert set(titles.split("; ")) == set(DIALECTS.values())
    names = [row[1] for row in table(shown, "interface")]
    for sample in (one for one in section.blocks if isinstance(one, Sample)):
        for name in names:
            assert re.search(rf"\b{name}\b", sample.text), (name, sample.text)
