"""JSON Schemas of the YAML files, for editors that check and complete while one types.

They are made from the models and lie in `schemas/`; `write_schemas` brings them up to date.
"""

import json
from pathlib import Path

from pydantic import BaseModel

from fbgen.catalog.drives import Drive
from fbgen.catalog.gateways import Gateway
from fbgen.catalog.protocols import Protocol
from fbgen.catalog.sequences import Sequence
from fbgen.plant.plant import Plant

SCHEMAS: dict[str, type[BaseModel]] = {
    "catalog-drive.schema.json": Drive,
    "catalog-gateway.schema.json": Gateway,
    "catalog-protocol.schema.json": Protocol,
    "catalog-sequence.schema.json": Sequence,
    "plant.schema.json": Plant,
}
"""File name -> model."""


def schema_text(model: type[BaseModel]) -> str:
    """The JSON Schema of a model, the same bytes for the same model."""
    schema = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    schema |= model.model_json_schema(mode="validation")
    return json.dumps(schema, indent=2, ensure_ascii=True) + "\n"


def write_schemas(folder: Path) -> tuple[Path, ...]:
    """Write all schemas into a folder, which is made if it is not there; their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, model in SCHEMAS.items():
        path = folder / name
        path.write_text(schema_text(model), encoding="utf-8", newline="\n")
        written.append(path)
    return tuple(written)
