"""Every diagnostic code has a page and a test, every page belongs to a code that is used."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

from tests.architecture.sources import ROOT, files, modules, tree

PAGES = ROOT / "docs" / "reference" / "diagnostics"
BAD_FILES = ROOT / "tests" / "unit" / "bad"
CODE = re.compile(r"FB[1-9][0-9]{3}")
SECTION = re.compile(r"^## (.+)$", re.MULTILINE)
BLOCK = re.compile(r"^```\w*\n.+?^```$", re.MULTILINE | re.DOTALL)


@cache
def codes_in_use() -> dict[str, str]:
    """Code -> first place in the product where it stands as a text of its own."""
    return {
        node.value: f"{name}:{node.lineno}"
        for name, path in reversed(modules().items())
        for node in ast.walk(tree(path))
        if isinstance(node, ast.Constant)
        and isinstance(node.value, str)
        and CODE.fullmatch(node.value)
    }


def pages() -> list[Path]:
    return sorted(PAGES.glob("*"))


def test_every_code_has_a_page() -> None:
    missing = [
        f"{code} ({place})"
        for code, place in sorted(codes_in_use().items())
        if not (PAGES / f"{code}.md").is_file()
    ]
    assert not missing, f"no page in docs/reference/diagnostics: {', '.join(missing)}"


def test_every_page_belongs_to_a_code_in_use() -> None:
    assert [page.name for page in pages() if page.stem not in codes_in_use()] == []


def test_every_code_is_named_by_a_test() -> None:
    named = {
        code
        for path in files(".py", ".yaml")
        if path.is_relative_to(ROOT / "tests")
        for code in CODE.findall(path.read_text("utf-8", "replace"))
    } | {path.name[:6] for path in BAD_FILES.iterdir()}
    unnamed = sorted(set(codes_in_use()) - named)
    assert not unnamed, f"no test names: {', '.join(unnamed)}"


def test_every_broken_input_is_named_after_a_code_in_use() -> None:
    names = [path.name for path in BAD_FILES.iterdir()]
    wrong = [name for name in names if name[:6] not in codes_in_use() or name[6] != "_"]
    assert wrong == []


@pytest.mark.parametrize("page", pages(), ids=lambda page: page.stem)
def test_a_page_says_what_it_means_what_fails_and_what_is_right(page: Path) -> None:
    text = page.read_text(encoding="utf-8")
    title, _, rest = text.partition("\n")
    assert re.fullmatch(rf"# {page.stem}: \S.+[^.]", title)
    meaning, *sections = SECTION.split(rest)
    assert meaning.startswith("\n")
    assert len(meaning.split()) >= 5, "a paragraph says what it means and why it matters"
    assert sections[::2] == ["Fails", "Fixed"]
    for section in sections[1::2]:
        assert BLOCK.search(section), "a code block shows it"
