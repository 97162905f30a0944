"""What README shows works as it stands there."""

import re
import shlex
import shutil
from pathlib import Path

import pytest

from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
GROUPS = {"catalog", "sim"}
"""Commands with commands below them."""
ENDLESS = "sim"
"""What serves until Ctrl-C; tests/unit/serial starts it as it stands in README."""


def commands() -> list[list[str]]:
    """The console lines of README that begin with `fbgen`, without their comments."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    console = "".join(re.findall(r"^```console\n(.+?)^```$", text, re.M | re.S))
    lines = re.findall(r"^fbgen .+$", console, re.M)
    return [shlex.split(line, comments=True)[1:] for line in lines]


def test_every_command_of_the_readme_succeeds_in_its_order(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for folder in ("examples", "tests/scenarios"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    monkeypatch.chdir(tmp_path)
    assert {"init", "generate", "check", "test"} <= {command[0] for command in commands()}
    for command in commands():
        if command[0] == ENDLESS:
            continue
        run = fbgen(*command)
        assert run.status == 0, f"fbgen {shlex.join(command)}\n{run.out}{run.err}"


def shown_commands() -> list[tuple[str, list[str]]]:
    """Page and words of each command line that a page or a workflow file in it shows."""
    pages = [ROOT / "README.md", *sorted((ROOT / "docs" / "how-to").glob("*.md"))]
    found: list[tuple[str, list[str]]] = []
    for page in pages:
        fenced = re.findall(
            r"^```(?:console|sh|yaml)\n(.+?)^```$", page.read_text("utf-8"), re.M | re.S
        )
        for line in re.findall(r"^(?:\s*- (?:run: )?)?fbgen (.+)$", "".join(fenced), re.M):
            found.append((page.name, shlex.split(line, comments=True)))
    return found


def test_every_option_that_a_page_shows_exists(fbgen: Fbgen) -> None:
    shown = shown_commands()
    assert {"README.md", "check-in-ci.md", "check-your-own-blocks.md"} <= {
        page for page, _ in shown
    }
    for page, words in shown:
        name = words[:2] if words[0] in GROUPS else words[:1]
        known = fbgen(*name, "--help").out
        for word in words:
            option = word.partition("=")[0]
            if option.startswith("-"):
                assert re.search(rf"(?<![\w-]){option}(?![\w-])", known), f"{page}: {words}"


def test_every_make_target_of_the_pages_exists() -> None:
    targets = set(re.findall(r"^([a-z]+):", (ROOT / "Makefile").read_text("utf-8"), re.M))
    for page in ("README.md", "CONTRIBUTING.md"):
        named = re.findall(
            r"^\W*make ([a-z]+)|`make ([a-z]+)", (ROOT / page).read_text("utf-8"), re.M
        )
        used = {first or second for first, second in named}
        assert used
        assert used <= targets, page


def test_every_link_of_the_pages_leads_somewhere() -> None:
    for page in (ROOT / "README.md", ROOT / "CONTRIBUTING.md", ROOT / "docs/decisions/README.md"):
        for target in re.findall(r"\]\(([^)#:]+)\)", page.read_text(encoding="utf-8")):
            assert (page.parent / target).exists(), f"{page.name}: {target}"
