"""Tag tables as the engineering systems export them.

* TIA Portal, export of a tag table: `<Tagtable><Tag type='Bool' addr='%I0.0'>Start</Tag>` and
  `<Constant type='Int' value='8'>MAX</Constant>`.
* TIA Portal Openness: `SW.Tags.PlcTag` and `SW.Tags.PlcUserConstant` with an AttributeList.
* STEP 7 V5, symbol table `.sdf`: one line for each symbol, `"Start","E 0.0","BOOL","comment"`.

Timers, counters and blocks in a table are no variables and are left out. Sources: published
exports of these systems; STEP 7 help, "File formats for importing/exporting a symbol table".
"""

import csv
import re
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from fbgen.diagnostics import error
from fbgen.lang import ast
from fbgen.lang.encoding import read_source
from fbgen.lang.tags import ConstantValue, Tag, TagConstant, as_file, constants_of
from fbgen.source import Source, Span

if TYPE_CHECKING:
    from fbgen.lang.containers.xml_tree import Element

_VARIABLE = re.compile(r"%?((P?[EIAQ]|M)[BWDX]?\s*[0-9]+(\.[0-9]+)?|[TCZ]\s*[0-9]+)", re.IGNORECASE)
_TAGS = ("Tag", "SW.Tags.PlcTag")
_CONSTANTS = ("Constant", "SW.Tags.PlcUserConstant")
_ENTITIES = {"&lt;": "<", "&gt;": ">", "&quot;": '"', "&apos;": "'", "&amp;": "&"}
"""The entities of XML, the ampersand last: what it gives is no entity."""


def global_file(
    dialect: str,
    constants: Mapping[str, ConstantValue],
    tags: Iterable[str | Path | Source | Tag],
) -> ast.File:
    """User constants and PLC tags as a further source; `tags` are tags, or files with tables."""
    known: list[Tag] = []
    more = constants_of(constants)
    for one in tags:
        if isinstance(one, Tag):
            known.append(one)
            continue
        found, also = read_tags(one if isinstance(one, Source) else read_source(Path(one)))
        known += found
        more += also
    return as_file(known, more, dialect)


def read_tags(source: Source) -> tuple[list[Tag], list[TagConstant]]:
    """The tags and constants of an exported table.

    Raises DiagnosticError FB3016 for broken XML, FB3060 for what is no tag table.
    """
    if source.text.lstrip("\ufeff \r\n\t").startswith("<"):
        from fbgen.lang.containers.xml_tree import read_xml  # noqa: PLC0415 - only for XML

        return _from_xml(read_xml(source))
    return _from_sdf(source), []


def _from_xml(root: "Element") -> tuple[list[Tag], list[TagConstant]]:
    tags, constants = [], []
    found = False
    for element in _every(root):
        found = found or element.tag in (*_TAGS, *_CONSTANTS, "Tagtable", "SW.Tags.PlcTagTable")
        if element.tag in _TAGS:
            name, kind, address = _tag(element)
            if not address or _VARIABLE.fullmatch(address):
                tags.append(Tag(name, kind, address, element.place))
        elif element.tag in _CONSTANTS:
            constants.append(_user_constant(element))
    if not found:
        raise error(
            "FB3060",
            "this XML file holds no PLC tags",
            root.place,
            "export the tag table itself: Tagtable or SW.Tags.PlcTagTable",
        )
    return tags, constants


def _every(root: "Element") -> Iterator["Element"]:
    waiting = [root]
    while waiting:
        element = waiting.pop()
        yield element
        waiting += reversed(element.children)


def _tag(element: "Element") -> tuple[str, str, str]:
    if element.tag == "Tag":
        return _text(element.raw), element.get("type"), element.get("addr")
    return _part(element, "Name"), _part(element, "DataTypeName"), _part(element, "LogicalAddress")


def _user_constant(element: "Element") -> TagConstant:
    if element.tag == "Constant":
        name, value, kind = _text(element.raw), element.get("value"), element.get("type")
    else:
        name, value = _part(element, "Name"), _part(element, "Value")
        kind = _part(element, "DataTypeName")
    return TagConstant(name, value, kind, element.place)


def _part(element: "Element", name: str) -> str:
    attributes = element.child("AttributeList")
    part = attributes.child(name) if attributes is not None else None
    return "" if part is None else _text(part.raw)


def _text(raw: str) -> str:
    for entity, character in _ENTITIES.items():
        raw = raw.replace(entity, character)
    return raw.strip()


def _from_sdf(source: Source) -> list[Tag]:
    tags = []
    start = 0
    for line in source.text.splitlines(keepends=True):
        text = line.strip()
        span = Span(source, start, start + len(line.rstrip()))
        start += len(line)
        if not text:
            continue
        fields = [field.strip() for field in next(csv.reader([text]))]
        if len(fields) < 3:
            raise error(
                "FB3060",
                "this line of the symbol table has no name, address and type",
                span,
                'lines look like "Start","E 0.0","BOOL","comment"',
            )
        name, address, kind = fields[:3]
        if _VARIABLE.fullmatch(address):
            tags.append(Tag(name, kind, re.sub(r"\s+", "", address), span))
    return tags
