"""JSON Schemas of the YAML files, for editors that check and complete while one types."""

import json

from pydantic import BaseModel


def schema_text(model: type[BaseModel]) -> str:
    """The JSON Schema of a model, the same bytes for the same model."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    schema |= model.model_json_schema(mode="validation")
    return json.dumps(schema, indent=2, ensure_ascii=True) + "\n"
