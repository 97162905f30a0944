"""An example for each key of each file, from the files that come with fbgen."""

import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

import yaml

Schema = Mapping[str, object]
Examples = dict[tuple[str, str], str]
"""Title of a part and key: how a value is written."""

_ROOT = Path(__file__).resolve().parents[2]
_LOADER = getattr(yaml, "CBaseLoader", yaml.BaseLoader)
_LONGEST = 48
_YAML = re.compile(r"^```yaml\n(.*?)^```$", re.MULTILINE | re.DOTALL)
FILES = {
    "plant": ("examples/*/plant.yaml",),
    "catalog-drive": ("catalog/drives/vf-s11.yaml", "catalog/drives/*.yaml"),
    "catalog-gateway": ("catalog/gateways/tospbdp001.yaml", "catalog/gateways/*.yaml"),
    "catalog-protocol": ("catalog/protocols/*.yaml",),
    "catalog-manual": ("catalog/manuals/*.yaml",),
    "catalog-sequence": ("catalog/sequences/*.yaml",),
    "scenario": ("docs/reference/scenario-files.md", "examples/*/*.scenario.yaml"),
}
"""Where there are files of a kind, the best first."""


def examples(kind: str, schema: Schema, more: Iterable[str] = ()) -> Examples:
    """What the files of a kind, and further texts, say for the keys of this schema."""
    found: Examples = {}
    for text in (*more, *_texts(kind)):
        data = yaml.load(text, _LOADER)
        if isinstance(data, dict):
            _collect(schema, schema, data, found)
    return found


def _texts(kind: str) -> Iterator[str]:
    seen = set()
    for pattern in FILES[kind]:
        for path in sorted(_ROOT.glob(pattern)):
            if path not in seen:
                seen.add(path)
                text = path.read_text(encoding="utf-8")
                yield from _YAML.findall(text) if path.suffix == ".md" else [text]


def resolved(schema: object, whole: Schema) -> Schema:
    """A schema without a reference at its top."""
    assert isinstance(schema, dict)
    if "$ref" in schema:
        name = str(schema["$ref"]).rpartition("/")[2]
        definitions = whole["$defs"]
        assert isinstance(definitions, dict)
        return resolved(definitions[name], whole)
    return schema


def _collect(schema: Schema, whole: Schema, data: object, found: Examples) -> None:
    """Note the values of an entry and of what is in it."""
    schema = resolved(schema, whole)
    for choice in ("anyOf", "oneOf", "allOf"):
        options = schema.get(choice)
        for option in options if isinstance(options, list) else ():
            if _fits(resolved(option, whole), data):
                _collect(option, whole, data, found)
    if isinstance(data, list):
        for item in data:
            if "items" in schema:
                _collect(_of(schema, "items"), whole, item, found)
    elif isinstance(data, dict):
        properties = _of(schema, "properties")
        for key, value in data.items():
            if key in properties:
                place = (str(schema["title"]), key)
                if not found.get(place):
                    found[place] = _written(value)
                _collect(_of(properties, key), whole, value, found)
            elif isinstance(schema.get("additionalProperties"), dict):
                _collect(_of(schema, "additionalProperties"), whole, value, found)


def _of(schema: Schema, key: str) -> Schema:
    part = schema.get(key, {})
    return part if isinstance(part, dict) else {}


def _fits(schema: Schema, data: object) -> bool:
    if not isinstance(data, dict):
        return "properties" not in schema
    properties = _of(schema, "properties")
    required = schema.get("required", ())
    assert isinstance(required, list | tuple)
    return set(data) <= set(properties) and set(required) <= set(data) if properties else True


def _written(value: object) -> str:
    """A value as it stands in a file; of long ones as much from the beginning as has room."""
    if isinstance(value, list):
        return f"[{_row(map(_written, value))}]"
    if isinstance(value, dict):
        return f"{{{_row(f'{key}: {_written(item)}' for key, item in value.items())}}}"
    text = " ".join(str(value).split())
    if len(text) > 2 * _LONGEST:
        text = text[: 2 * _LONGEST].rpartition(" ")[0] + " ..."
    is_number = re.fullmatch(r"\d+(_\d+)+", text)  # for YAML; here it is a name
    is_plain = text and not is_number and not set(text) & set(",[]{}#&*!|>%@`") and ": " not in text
    return text if is_plain else f'"{text}"'


def _row(items: Iterable[str]) -> str:
    """The first item, and as many more as have room."""
    row = ""
    for item in items:
        if row and len(row) + len(item) > _LONGEST:
            break
        row = f"{row}, {item}" if row else item
    return row
