"""What editors learn of `${column}`: it may stand for any value but the version and the table.

What comes out when the table is filled in is checked when the scenario is read.
"""

from typing import Any

_PLACE = r"\$\{"
FILLED: dict[str, Any] = {"type": "string", "pattern": _PLACE}
_ABOUT = ("default", "description", "title")
_AS_THEY_ARE = ("version", "cases")
_NO_TEXTS = ("boolean", "integer", "number")


def with_places(schema: dict[str, Any]) -> dict[str, Any]:
    """The schema of a scenario file with texts that have `${` where a value belongs."""
    parts = {name: _allowed(part) for name, part in schema.get("$defs", {}).items()}
    keys = {
        name: part if name in _AS_THEY_ARE else _allowed(part)
        for name, part in schema.get("properties", {}).items()
    }
    return {**schema, "$defs": parts, "properties": keys}


def _allowed(node: Any) -> Any:
    if isinstance(node, list):
        return [_allowed(item) for item in node]
    if not isinstance(node, dict):
        return node
    if any(choice == {"type": "string"} for choice in node.get("anyOf", ())):
        return node
    if node.get("type") == "string" and "pattern" in node:
        return {**node, "pattern": f"{node['pattern']}|{_PLACE}"}
    if node.get("type") in _NO_TEXTS:
        about = {key: node[key] for key in _ABOUT if key in node}
        value = {key: item for key, item in node.items() if key not in about}
        return {**about, "anyOf": [value, FILLED]}
    return {key: _allowed(item) for key, item in node.items()}
