"""A page for each kind of YAML file, from the model that reads it: every key, type and default."""

import json
from collections.abc import Iterator

from fbgen.cli.schemas import schema_texts
from fbgen.plant.commented import write_commented_plant
from tools.pages.examples import Examples, Schema, examples, resolved
from tools.pages.meanings import meaning_of, some_value

_KINDS = {
    "plant": (
        "plant",
        "The plant file",
        "`fbgen init` writes one in which every key is explained.",
    ),
    "drive": (
        "catalog-drive",
        "The file of an inverter series",
        "`drives/ID.yaml` of a catalogue. [The catalogue](../catalogue.md) explains its parts.",
    ),
    "gateway": (
        "catalog-gateway",
        "The file of a gateway",
        "`gateways/ID.yaml` of a catalogue; `kind` says what kind of gateway it is.",
    ),
    "protocol": (
        "catalog-protocol",
        "The file of a protocol",
        "`protocols/ID.yaml` of a catalogue; `kind` says which protocol it is.",
    ),
    "sequence": (
        "catalog-sequence",
        "The file of a command sequence",
        "`sequences/ID.yaml` of a catalogue or beside a plant file. [Sequences](../sequences.md) "
        "explains the steps.",
    ),
    "manual": (
        "catalog-manual",
        "The file of a manual",
        "`manuals/ID.yaml` of a catalogue: what is wrong in it, and how it is read.",
    ),
    "scenario": (
        "scenario",
        "The scenario file",
        "`NAME.scenario.yaml`. [Scenario files](../scenario-files.md) explains steps and paths.",
    ),
}
"""Page: schema, title and what else to know."""
_HEAD = """\
# {title}

{about}

An editor completes and checks such a file by its schema:
[schemas/{schema}.schema.json](../../../schemas/{schema}.schema.json).

This page is made from the model that reads the file, by `make pages`. A key that is **required**
has to be there. Most examples come from files that ship with fbgen; long ones are cut.

"""


def file_pages() -> dict[str, str]:
    """The pages by their names."""
    texts = schema_texts()
    pages = {}
    for page, (name, title, about) in _KINDS.items():
        schema = json.loads(texts[f"{name}.schema.json"])
        more = [write_commented_plant()] if page == "plant" else []
        known = examples(name, schema, more)
        head = _HEAD.format(title=title, about=about, schema=name)
        parts = _parts(schema)
        index = _index(parts) if len(parts) > 1 else ""
        pages[page] = head + index + "\n".join(_section(part, schema, known) for part in parts)
    return pages


def _parts(whole: Schema) -> list[Schema]:
    """The file and its parts, in the order in which they are reached."""
    found: list[Schema] = []

    def reach(schema: object) -> None:
        if isinstance(schema, dict):
            if "$ref" in schema:
                reach(resolved(schema, whole))
            elif "properties" in schema:
                if schema not in found:
                    found.append(schema)
                    reach(list(schema["properties"].values()))
            else:
                reach([schema[key] for key in schema if key not in ("$defs", "default")])
        elif isinstance(schema, list):
            for item in schema:
                reach(item)

    reach({key: whole[key] for key in whole if key != "$defs"})
    return found


def _index(parts: list[Schema]) -> str:
    links = ", ".join(f"[{part['title']}](#{str(part['title']).lower()})" for part in parts)
    return f"Parts: {links}.\n\n"


def _section(part: Schema, whole: Schema, known: Examples) -> str:
    title = str(part["title"])
    rows = "".join(_rows(part, whole, known))
    about = _escaped(str(part.get("description", "")))
    if "\n* " not in about:  # what the further paragraphs say of keys stands in the table
        about = about.partition("\n\n")[0]
    head = "| key | type | default | example | meaning |\n|---|---|---|---|---|\n"
    return f"## {title}\n\n{about}\n\n{head}{rows}"


def _rows(part: Schema, whole: Schema, known: Examples) -> Iterator[str]:
    title, properties, required = str(part["title"]), part["properties"], part.get("required", [])
    assert isinstance(properties, dict)
    assert isinstance(required, list)
    for key, schema in properties.items():
        kind = _kind(schema, whole)
        default = "**required**" if key in required else _default(schema)
        from_files = known.get((title, key), "")
        example = some_value(title, key, from_files) or _some_value(schema, whole)
        shown = f"`{_escaped(example)}`" if example else ""
        meaning = _escaped(meaning_of(part, key, schema))
        yield f"| `{key}` | {kind} | {default} | {shown} | {meaning} |\n"


def _default(schema: Schema) -> str:
    value = schema.get("default")
    if value in (None, {}, [], ""):
        return ""
    return f"`{_escaped(json.dumps(value) if not isinstance(value, str) else value)}`"


def _some_value(schema: Schema, whole: Schema) -> str:
    """A value that a key may have where no file has it."""
    schema = resolved(schema, whole)
    for choice in ("anyOf", "oneOf"):
        options = schema.get(choice)
        for option in options if isinstance(options, list) else ():
            if value := _some_value(option, whole):
                return value
    values = schema.get("enum")
    if isinstance(values, list) and values:
        return str(values[-1])
    if schema.get("type") == "boolean":
        return "false" if schema.get("default") else "true"
    if schema.get("type") in ("integer", "number"):
        return str(schema.get("default") or max(1, _number(schema.get("minimum", 1))))
    return ""


def _kind(schema: Schema, whole: Schema) -> str:
    """A type in words."""
    if "$ref" in schema:
        target = resolved(schema, whole)
        if "properties" in target:
            return f"[{target['title']}](#{str(target['title']).lower()})"
        return _kind(target, whole)
    if "const" in schema:
        return f"`{schema['const']}`"
    if isinstance(values := schema.get("enum"), list):
        shown = [f"`{value}`" for value in values if value is not None]
        return ", ".join(shown) if len(shown) <= 12 else f"{', '.join(shown[:12])}, ..."
    for choice in ("anyOf", "oneOf"):
        if isinstance(options := schema.get(choice), list):
            kinds = [_kind(one, whole) for one in options if one.get("type") != "null"]
            return " or ".join(dict.fromkeys(kinds))
    match schema.get("type"):
        case "array":
            items = schema.get("items", {})
            assert isinstance(items, dict)
            return f"list of {_kind(items, whole)}" if items else "list"
        case "object":
            values = schema.get("additionalProperties")
            return (
                f"name: {_kind(values, whole)}" if isinstance(values, dict) and values else "names"
            )
        case "integer" | "number" as number:
            return _with_limits("whole number" if number == "integer" else "number", schema)
        case "boolean":
            return "`true`, `false`"
        case "string":
            return "text"
    return "as in the example"


def _with_limits(word: str, schema: Schema) -> str:
    low = schema.get("minimum", schema.get("exclusiveMinimum"))
    high = schema.get("maximum", schema.get("exclusiveMaximum"))
    is_wide = any(isinstance(end, int | float) and abs(end) >= 1e9 for end in (low, high))
    above = "above " if "exclusiveMinimum" in schema else ""
    if high is None or (is_wide and high is not None and abs(_number(high)) >= 1e9):
        return (
            word if low is None or abs(_number(low)) >= 1e9 else f"{word}, {above or 'from '}{low}"
        )
    if low is None or abs(_number(low)) >= 1e9:
        return (
            f"{word}, {above + str(schema['exclusiveMinimum']) + ' ' if above else ''}up to {high}"
        )
    return f"{word}, {above}{low} to {high}"


def _number(value: object) -> float:
    assert isinstance(value, int | float)
    return float(value)


def _escaped(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;")
