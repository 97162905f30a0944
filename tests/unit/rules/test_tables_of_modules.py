"""Faults and rules are found by their names, and what nobody asks for is not imported."""

import subprocess
import sys
from pathlib import Path

import pytest

from fbgen.named_modules import NamedModules
from harness.faults import FAULTS, FaultType
from harness.rules import RULES, Rule

ROOT = Path(__file__).parents[3]


@pytest.mark.parametrize(
    ("package", "mark", "table"), [("faults", "\nFAULT = ", FAULTS), ("rules", "\nRULE = ", RULES)]
)
def test_the_table_has_each_file_of_the_folder_under_its_own_name(
    package: str, mark: str, table: NamedModules[FaultType] | NamedModules[Rule]
) -> None:
    files = (ROOT / "harness" / package).glob("*.py")
    assert set(table) == {path.stem for path in files if mark in path.read_text("utf-8")}
    assert [one.name for one in table.values()] == list(table)


def test_an_unknown_name_is_no_entry() -> None:
    assert "fault" not in FAULTS
    assert FAULTS.get("fault") is None


def test_a_scenario_imports_only_what_it_needs() -> None:
    """The second time neither YAML is read, nor Python written, nor a model prepared."""
    script = (
        "import sys\n"
        "from fbgen.cli import main\n"
        "main(['test', 'tests/scenarios/ram_writes_spare_the_eeprom.scenario.yaml'])\n"
        "heavy = ('yaml', 'jinja2', 'fbgen.emit', 'fbgen.lang.parser', 'fbgen.wire.gsd',\n"
        "    'harness.engine.compiled.procedure', 'harness.trace.recorder')\n"
        "print([name for name in heavy if name in sys.modules])\n"
        "print([name for name in sys.modules if name.startswith('harness.rules.no_')])\n"
        "from pydantic import BaseModel\n"
        "def all_of(kind):\n"
        "    return [kind, *(one for sub in kind.__subclasses__() for one in all_of(sub))]\n"
        "print([one.__name__ for one in all_of(BaseModel)[1:] if one.__pydantic_complete__])\n"
    )
    for _ in range(2):
        shown = subprocess.run(
            [sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT, check=True
        )
    assert shown.stdout.splitlines()[-3:] == ["[]", "[]", "[]"]
