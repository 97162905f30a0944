"""Pages judged by axe-core, the accessibility engine: labels, roles, contrast, headings, landmarks.

It comes from npm (`.ci/run` gets it): `npm install --prefix build/npm axe-core`.
"""

from collections.abc import Callable
from pathlib import Path

import pytest
from playwright.sync_api import Page

AXE = Path(__file__).parents[3] / "build/npm/node_modules/axe-core/axe.min.js"
PAGES = (
    *("vf-s11.command", "block-TOS_Handshake", "tospbdp001-manual"),
    *(pytest.param(name, marks=pytest.mark.slow) for name in ("index", "tospbdp001", "usage")),
)
_RUN = """async () => (await axe.run(document, {resultTypes: ["violations"], preload: false}))
    .violations.map((one) => `${one.id}: ${one.nodes.length} x ${one.nodes[0].html}`)"""
_CONTRAST = _RUN.replace("{resultTypes", '{runOnly: ["color-contrast"], resultTypes')


def engine(page: Page) -> Page:
    if not AXE.is_file():
        pytest.skip("no axe-core in build/npm: pages are not judged by the accessibility engine")
    page.add_script_tag(path=AXE)
    return page


@pytest.mark.parametrize("name", PAGES)
def test_the_engine_finds_nothing(shown: Callable[..., Page], name: str) -> None:
    assert engine(shown(name)).evaluate(_RUN) == []


def test_texts_have_contrast_at_night(shown: Callable[..., Page]) -> None:
    assert engine(shown("tospbdp001.status", dark=True)).evaluate(_CONTRAST) == []


def test_the_engine_finds_what_is_wrong(shown: Callable[..., Page]) -> None:
    page = engine(shown("tospbdp001-manual"))
    page.evaluate("document.getElementById('search').removeAttribute('aria-label')")
    page.evaluate("document.getElementById('search').removeAttribute('placeholder')")
    assert any("label" in one for one in page.evaluate(_RUN))
