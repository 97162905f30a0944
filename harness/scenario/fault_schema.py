"""What editors learn of faults: their names, their places and their settings.

Only for JSON Schemas. What a scenario may really do is checked with the plant at hand.
"""

from typing import Any

from pydantic import GetJsonSchemaHandler
from pydantic.json_schema import JsonSchemaValue
from pydantic_core import CoreSchema

from harness.faults import FAULTS, FaultType, Target
from harness.scenario.schema_places import FILLED

_NAMES = sorted(FAULTS)


class FaultNameSchema:
    """The name of a fault. Titles are looked up when somebody wants the schema."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> JsonSchemaValue:
        return {"enum": _NAMES, "enumDescriptions": [FAULTS[name].title for name in _NAMES]}


def with_places_and_settings(schema: JsonSchemaValue) -> None:
    """Say in the schema of a step that injects which place and settings each fault has."""
    schema["allOf"] = [
        {
            "if": {"properties": {"inject": {"const": name}}, "required": ["inject"]},
            "then": _of_fault(FAULTS[name]),
        }
        for name in _NAMES
    ]


def _of_fault(kind: FaultType[Any]) -> JsonSchemaValue:
    settings = kind.settings.model_json_schema().get("properties", {})
    for name, value in settings.items():
        if "enum" in value:
            settings[name] = {"anyOf": [value, FILLED]}
    wanted: JsonSchemaValue = {
        "properties": {
            "settings": {
                "properties": settings,
                "additionalProperties": False,
            }
        }
    }
    if kind.target is Target.WHOLE:
        wanted["properties"]["on"] = False
    else:
        wanted["required"] = ["on"]
    return wanted
