"""The examples on the pages of files are values that the models take."""

import json
import re
from functools import cache

import jsonschema
import yaml

from fbgen.cli.schemas import schema_texts
from tests.unit.documentation.fragments import Loader, without_required
from tests.unit.documentation.markdown import text_of
from tools.pages.meanings import MEANINGS, SOME

_ROW = re.compile(r"^\| `(\w+)` \| .*? \| [^|]*? \| `(.+?)` \| ", re.MULTILINE)
KINDS = {
    "plant": "plant",
    "drive": "catalog-drive",
    "gateway": "catalog-gateway",
    "protocol": "catalog-protocol",
    "sequence": "catalog-sequence",
    "scenario": "scenario",
    "manual": "catalog-manual",
}


@cache
def _definitions(kind: str) -> dict[str, dict[str, object]]:
    text = schema_texts()[f"{KINDS[kind]}.schema.json"]
    whole = json.loads(text, object_hook=without_required)
    definitions: dict[str, dict[str, object]] = whole.pop("$defs")
    return {**definitions, whole.get("title", kind): whole}


def test_every_meaning_is_of_a_key_that_there_is() -> None:
    keys: set[str] = set()
    for kind in KINDS:
        for title, schema in _definitions(kind).items():
            properties = schema.get("properties", {})
            assert isinstance(properties, dict)
            keys |= {*properties, *(f"{title}.{key}" for key in properties)}
    assert sorted({*MEANINGS, *SOME} - keys) == []


def test_every_example_is_one() -> None:
    wrong, tried = [], 0
    for kind in KINDS:
        page = text_of(f"docs/reference/files/{kind}.md")
        for section in page.split("\n## ")[1:]:
            title = section.partition("\n")[0]
            schema = _definitions(kind)[title]
            assert isinstance(schema["properties"], dict)
            for key, example in _ROW.findall(section):
                tried += 1
                value = yaml.load(example.replace("\\|", "|"), Loader)
                rule = {**schema["properties"][key], "$defs": _definitions(kind)}
                if not jsonschema.Draft202012Validator(rule).is_valid(value):
                    wrong.append(f"{kind}: {title}.{key}: {example}")
    assert wrong == []
    assert tried > 500
