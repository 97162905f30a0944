"""Decisions have numbers of their own, and the list names each of them."""

import re

from tests.architecture.sources import ROOT

FOLDER = ROOT / "docs" / "decisions"


def test_decisions_are_numbered_one_after_the_other() -> None:
    names = sorted(path.name for path in FOLDER.glob("0*.md"))
    assert [int(name[:4]) for name in names] == list(range(1, len(names) + 1))


def test_each_decision_begins_with_its_number() -> None:
    for path in FOLDER.glob("0*.md"):
        assert path.read_text("utf-8").startswith(f"# {path.name[:4]}: "), path.name


def test_the_list_names_every_decision() -> None:
    rows = re.findall(r"\| \[(\d{4})\]\((\S+)\) \|", (FOLDER / "README.md").read_text("utf-8"))
    assert [name for _, name in rows] == sorted(path.name for path in FOLDER.glob("0*.md"))
    assert all(name.startswith(number) for number, name in rows)
