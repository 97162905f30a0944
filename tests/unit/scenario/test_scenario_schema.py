"""The JSON Schema of scenario files: editors tell the kinds of steps apart by their key."""

from typing import Any

import pytest

from harness.faults import FAULTS, Target
from harness.scenario.model import Scenario

SCHEMA: dict[str, Any] = Scenario.model_json_schema()
KEYS = [
    "set",
    "wait",
    "wait_until",
    "call",
    "expect",
    "inject",
    "clear",
    "telegrams",
    "of_sequence",
]


def definition(reference: dict[str, str]) -> dict[str, Any]:
    """The part of the schema that a reference leads to."""
    found: dict[str, Any] = SCHEMA["$defs"][reference["$ref"].rpartition("/")[2]]
    return found


def steps() -> list[dict[str, Any]]:
    """The schemas of all kinds of steps."""
    return [definition(item) for item in SCHEMA["properties"]["steps"]["items"]["oneOf"]]


def test_each_kind_of_step_demands_its_own_key_and_allows_no_others() -> None:
    assert [step["required"][0] for step in steps()] == KEYS
    for step in steps():
        others = set(KEYS) - {step["required"][0]}
        assert not others & set(step["properties"])
        assert step["additionalProperties"] is False
        assert step["description"]


def test_every_key_has_a_description() -> None:
    for part in (SCHEMA, *SCHEMA["$defs"].values()):
        for name, key in part.get("properties", {}).items():
            assert "description" in key, f"{part['title']}.{name}"


@pytest.mark.parametrize("name", sorted(FAULTS))
def test_each_fault_has_its_own_settings_and_a_place_where_it_needs_one(name: str) -> None:
    inject = next(step for step in steps() if "inject" in step["properties"])
    assert name in inject["properties"]["inject"]["enum"]
    (rule,) = [
        item["then"]
        for item in inject["allOf"]
        if item["if"]["properties"]["inject"]["const"] == name
    ]
    kind = FAULTS[name]
    assert set(rule["properties"]["settings"]["properties"]) == set(kind.settings.model_fields)
    if kind.target is Target.WHOLE:
        assert rule["properties"]["on"] is False
    else:
        assert rule["required"] == ["on"]


@pytest.mark.parametrize("key", ["within", "stays_for"])
def test_a_time_is_a_text_with_a_unit(key: str) -> None:
    expect = next(step for step in steps() if "expect" in step["properties"])
    assert expect["properties"][key]["type"] == "string"
    assert expect["properties"][key]["default"] == "0 s"
