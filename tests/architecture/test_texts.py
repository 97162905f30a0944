"""What no committed text holds: unfinished places, and paths of the machine it was written on."""

import re

import pytest

from tests.architecture.sources import ROOT, files

TEXTS = (".py", ".md", ".yaml", ".yml", ".toml", ".json", ".txt", ".jinja", ".j2", ".scl", ".st")
UNFINISHED = re.compile(r"\b(?:TO" + r"DO|FIX" + r"ME|XX" + r"X:|NotImplemented" + r"Error)\b")
LOCAL_PATH = re.compile(r"(?<![\w.])/(?:work|root|home|Users|tmp)/[A-Za-z]|\.\./" + r"shared\b")


def offences(pattern: re.Pattern[str], *suffixes: str) -> list[str]:
    """`file:line: text` of each line that the pattern is found in."""
    return [
        f"{path.relative_to(ROOT)}:{number}: {line.strip()}"
        for path in files(*suffixes)
        for number, line in enumerate(path.read_text("utf-8", "replace").splitlines(), start=1)
        if pattern.search(line)
    ]


def test_nothing_is_left_to_be_done() -> None:
    assert offences(UNFINISHED, ".py", ".yaml", ".jinja", ".j2", ".scl", ".st") == []


def test_no_text_names_a_path_of_one_machine() -> None:
    assert offences(LOCAL_PATH, *TEXTS) == []


@pytest.mark.parametrize("line", ["raise NotImplemented" + "Error", "# TO" + "DO: later"])
def test_unfinished_places_are_seen(line: str) -> None:
    assert UNFINISHED.search(line)


@pytest.mark.parametrize("line", ["cd /ho" + "me/me/x", "see ../sha" + "red/facts", "/wo" + "rk/x"])
def test_local_paths_are_seen(line: str) -> None:
    assert LOCAL_PATH.search(line)


@pytest.mark.parametrize("line", ["shared/work/home", "https://example.com/home/x"])
def test_other_paths_are_left_alone(line: str) -> None:
    assert not LOCAL_PATH.search(line)
