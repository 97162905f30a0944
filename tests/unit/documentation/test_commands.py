"""Commands that a page shows exist, with their options; also where running them takes too long."""

import re
import shlex
import tomllib
from functools import cache

import pytest

from fbgen.cli import main
from tests.unit.documentation.markdown import ROOT, blocks_of, pages, text_of
from tests.unit.documentation.rehearsal import commands_of

GROUPS = {"catalog", "sim"}
"""Commands with commands below them."""


def shown_commands() -> list[tuple[str, list[str]]]:
    """Place and words of each command of fbgen that a page or a workflow file in it shows."""
    found = []
    for page in pages():
        for block in blocks_of(page):
            if block.language in {"console", "sh"}:
                found += [(one.place, one.words) for one in commands_of(block)]
            elif block.language == "yaml":
                lines = re.findall(r"^ *- (?:run: )?(fbgen .+)$", block.text, re.MULTILINE)
                found += [(block.place, shlex.split(line)) for line in lines]
    return [(place, words[1:]) for place, words in found if words[0] == "fbgen"]


def test_every_option_that_a_page_shows_exists(capsys: pytest.CaptureFixture[str]) -> None:
    @cache
    def help_of(*name: str) -> str:
        main([*name, "--help"])
        return capsys.readouterr().out

    unknown = []
    for place, words in shown_commands():
        depth = 2 if words[0] in GROUPS else 0 if words[0].startswith("-") else 1
        known = help_of(*words[:depth])
        for word in words:
            option = word.partition("=")[0]
            if option.startswith("-") and not re.search(rf"(?<![\w-]){option}(?![\w-])", known):
                unknown.append(f"{place}: {option}")
    assert unknown == []


def test_every_make_target_of_the_pages_exists() -> None:
    targets = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text("utf-8"), re.MULTILINE))
    for page in pages():
        named = re.findall(r"^\W*make ([a-z]+)|`make ([a-z]+)", text_of(page), re.MULTILINE)
        assert {first or second for first, second in named} <= targets, page


def test_every_extra_of_the_pages_exists() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    for page in pages():
        named = re.findall(r"fbgen\[([a-z,]+)\]", text_of(page))
        assert {one for names in named for one in names.split(",")} <= set(
            project["optional-dependencies"]
        ), page


def test_every_file_that_a_setting_up_command_names_is_there() -> None:
    for page in pages():
        for name in re.findall(r"^(?:\$ )?(?:py|python) (tools/\S+)", text_of(page), re.MULTILINE):
            assert (ROOT / name).is_file(), page
