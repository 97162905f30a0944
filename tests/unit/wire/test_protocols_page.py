"""`docs/reference/protocols.md`: its frames are the vectors, its commands print what it shows."""

import re
import shlex
from pathlib import Path

import pytest

from fbgen.cli import main
from tests.frames import TOSHIBA_BINARY
from tests.unit.wire.collisions import table
from tests.vectors.reading import entries

_ROOT = Path(__file__).parents[3]
PAGE = (_ROOT / "docs" / "reference" / "protocols.md").read_text(encoding="utf-8")
ENTRIES = entries("toshiba_frames")
EXAMPLES = re.findall(r"^\|.+\| `([^`]+)` \| `([a-z_0-9A-Z.]+)` \|$", PAGE, re.MULTILINE)
COMMANDS = re.findall(r"^```console\n\$ fbgen (.+)\n((?:.*\n)+?)```$", PAGE, re.MULTILINE)


def test_the_page_has_examples_of_all_forms() -> None:
    modes = {ENTRIES[name]["mode"] for _, name in EXAMPLES}
    assert modes == {"binary", "ascii", "modbus_rtu"}
    assert len(EXAMPLES) > 20


@pytest.mark.parametrize(("frame", "name"), EXAMPLES)
def test_example_of_the_page_is_the_vector(frame: str, name: str) -> None:
    entry = ENTRIES[name]
    assert frame == entry.get("bytes", entry.get("text", "").removesuffix("\\r").strip())


@pytest.mark.parametrize(("command", "output"), COMMANDS)
def test_command_of_the_page_prints_what_it_shows(
    command: str, output: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(shlex.split(command)) == 0
    assert capsys.readouterr().out == output


def test_the_page_has_commands() -> None:
    assert len(COMMANDS) == 4


def test_unnoticed_damage_is_counted_as_the_page_says() -> None:
    assert [row for row in table(TOSHIBA_BINARY) if row not in PAGE] == []
