"""The JSON Schema against scenario files, judged by a validator of others."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from fbgen.catalog import load_yaml
from fbgen.catalog.catalog import read_source
from fbgen.source import Source
from harness.scenario import find_scenarios
from tests.unit.scenario.scenario_files import ROOT

VALIDATOR = Draft202012Validator(json.loads((ROOT / "schemas/scenario.schema.json").read_text()))
FILES = find_scenarios([ROOT / "tests" / "scenarios", ROOT / "examples"])
PAGE = (ROOT / "docs" / "reference" / "scenario-files.md").read_text("utf-8")
EXAMPLES = re.findall(r"^```yaml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
HEAD = "version: 1\ntitle: T\nplant: p\n"


def complaints(source: Source) -> list[str]:
    """What the validator has to say of a file."""
    data: Any = json.loads(json.dumps(load_yaml(source).data))
    return [f"{found.json_path}: {found.message}" for found in VALIDATOR.iter_errors(data)]


def test_the_schema_is_one() -> None:
    Draft202012Validator.check_schema(VALIDATOR.schema)


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.name.partition(".")[0])
def test_every_scenario_of_the_project_is_as_the_schema_says(path: Path) -> None:
    assert complaints(read_source(path, path.name)) == []


@pytest.mark.parametrize("text", EXAMPLES, ids=lambda text: text.partition("title: ")[2][:30])
def test_every_example_of_the_page_is_as_the_schema_says(text: str) -> None:
    assert complaints(Source("example", text)) == []


@pytest.mark.parametrize(
    "text",
    [
        "steps: []\n",
        "stps: [{wait: 1 s}]\n",
        "steps: [{wait: 1}]\n",
        "steps: [{wait: 1 s, expect: {cpu.mode: RUN}}]\n",
        "steps: [{wait_until: {cpu.mode: RUN}}]\n",
        "steps: [{call: many}]\n",
        "steps: [{inject: line_brocken, on: gw1}]\n",
        "steps: [{inject: line_noise, on: gw1, settings: {bit_error_rate: high}}]\n",
        "steps: [{wait: 1 s}]\nproperties: [{never: {}}]\n",
        "steps: [{wait: 1 s}]\nproperties: [{at_most: 1, of: {cpu.mode: RUN}}]\n",
        "steps: [{wait: 1 s}]\nseeds: 0\n",
        "steps: [{wait: 1 s}]\ncases: {a: 1}\n",
    ],
)
def test_mistakes_are_found_while_one_types(text: str) -> None:
    assert complaints(Source("wrong", HEAD + text)) != []


@pytest.mark.parametrize(
    "step",
    [
        "{wait: '${time}'}",
        "{expect: {drive.pump.frequency: {equals: '${hz}', tolerance: '${off}'}}}",
        "{call: '${count}'}",
        "{inject: line_noise, on: '${gateway}', settings: {bit_error_rate: '${rate}'}}",
    ],
)
def test_a_column_may_stand_for_any_value(step: str) -> None:
    assert complaints(Source("right", f"{HEAD}steps: [{step}]\n")) == []
