"""Entries of which there are kinds: the model that a file's `kind` asks for."""

from collections.abc import Mapping
from typing import TypeVar

from fbgen.catalog.sourced import Sourced
from fbgen.catalog.yaml_nodes import Document, YamlMapping
from fbgen.diagnostics import error
from fbgen.nearest import nearest

Kind = TypeVar("Kind", bound=Sourced)


def kind_of(document: Document, kinds: Mapping[str, type[Kind]]) -> type[Kind]:
    """The model for a file; the first of `kinds` where the file says none. Raises FB1007."""
    data = document.data
    if not isinstance(data, YamlMapping) or "kind" not in data:
        return next(iter(kinds.values()))
    kind = data["kind"]
    if isinstance(kind, str) and kind in kinds:
        return kinds[kind]
    raise error(
        "FB1007",
        f"found '{kind}', expected one of: {', '.join(kinds)}",
        data.value_spans["kind"],
        help=nearest(str(kind), kinds),
    )
