"""The checked-in JSON Schemas are those of the models."""

import json
from pathlib import Path

import pytest

from fbgen.catalog.schema import SCHEMAS, schema_text, write_schemas
from fbgen.resources import shipped


@pytest.mark.parametrize("name", list(SCHEMAS))
def test_the_checked_in_schema_is_current(name: str) -> None:
    assert (shipped("schemas") / name).read_text("utf-8") == schema_text(SCHEMAS[name])


def test_no_schema_is_left_over() -> None:
    prefixes = ("catalog-", "plant.")
    found = {path.name for path in shipped("schemas").iterdir() if path.name.startswith(prefixes)}
    assert found == set(SCHEMAS)


def test_schemas_are_written_where_they_are_wanted(tmp_path: Path) -> None:
    written = write_schemas(tmp_path / "schemas")
    assert [path.name for path in written] == list(SCHEMAS)
    for path in written:
        assert json.loads(path.read_text("utf-8"))["additionalProperties"] is False


def test_shipped_files_name_a_schema_that_is_there() -> None:
    files = [*shipped("catalog").rglob("*.yaml"), *shipped("examples").rglob("plant.yaml")]
    for path in files:
        first = path.read_text("utf-8").splitlines()[0]
        assert first.startswith("# yaml-language-server: $schema=")
        assert (path.parent / first.partition("=")[2]).resolve().is_file()
