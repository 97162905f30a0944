"""The checked-in JSON Schemas are those of the models."""

import json

import pytest
from pydantic import BaseModel

from fbgen.catalog import Drive, Sequence
from fbgen.catalog.file_models import GatewayFile, ProtocolFile
from fbgen.catalog.schema import schema_text
from fbgen.plant import Plant
from fbgen.resources import shipped

SCHEMAS: dict[str, type[BaseModel]] = {
    "catalog-drive": Drive,
    "catalog-gateway": GatewayFile,
    "catalog-protocol": ProtocolFile,
    "catalog-sequence": Sequence,
    "plant": Plant,
}


@pytest.mark.parametrize("name", list(SCHEMAS))
def test_the_checked_in_schema_is_current(name: str) -> None:
    text = (shipped("schemas") / f"{name}.schema.json").read_text("utf-8")
    assert text == schema_text(SCHEMAS[name])


@pytest.mark.parametrize("name", list(SCHEMAS))
def test_a_schema_refuses_unknown_keys_as_the_loader_does(name: str) -> None:
    schema = json.loads(schema_text(SCHEMAS[name]))
    objects = [item for item in (schema, *schema["$defs"].values()) if "properties" in item]
    assert all(item["additionalProperties"] is False for item in objects)


def test_shipped_files_name_a_schema_that_is_there() -> None:
    files = [*shipped("catalog").rglob("*.yaml"), *shipped("examples").rglob("plant.yaml")]
    for path in files:
        first = path.read_text("utf-8").splitlines()[0]
        assert first.startswith("# yaml-language-server: $schema=")
        assert (path.parent / first.partition("=")[2]).resolve().is_file()
