"""The table of cases of a scenario file: `${name}` is filled in before the file is validated.

So a value is checked as what it stands for: the number of a row is a number where `${hz}` stands
alone, and a piece of the text where it stands inside of one. What is wrong in one row only is told
with the name of that row.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from fbgen.catalog import validate
from fbgen.catalog.yaml_nodes import (
    Document,
    YamlFloat,
    YamlInt,
    YamlMapping,
    YamlSequence,
)
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note
from fbgen.nearest import nearest
from fbgen.source import Span
from harness.scenario.model import Scenario

_PLACE = re.compile(r"\$\{([^}]*)\}")
_TABLE = "cases"


def filled_in(document: Document) -> tuple[tuple[str, Scenario], ...]:
    """The scenario of a file once for each row of its table, with the row's name.

    Raises one DiagnosticError with everything that is wrong in any of them, FB8015 to FB8017 for
    the table.
    """
    data = document.data
    table = data.get(_TABLE) if isinstance(data, YamlMapping) else None
    rows = dict(table) if isinstance(table, YamlMapping) else {}
    columns = _columns(rows)
    scenarios: list[tuple[str, Scenario]] = []
    found: list[list[Diagnostic]] = []
    used: set[str] = set()
    for name, row in rows.items() or (("", None),):
        filling = _Filling(row if isinstance(row, YamlMapping) else None, columns)
        filled = replace(document, data=filling.node(data, document.span))
        used |= filling.used
        try:
            scenarios.append((name, validate(filled, Scenario)))
            found.append(filling.found)
        except DiagnosticError as wrong:
            found.append([*filling.found, *filling.without_gaps(wrong.diagnostics)])
    told = [*_each_once(list(rows), found), *_table_problems(rows, columns, used)]
    if told:
        raise DiagnosticError(told)
    return tuple(scenarios)


class _Filling:
    """Fills in one row; notes which columns it has used and which it has missed."""

    def __init__(self, row: YamlMapping | None, columns: Mapping[str, Span]) -> None:
        self.used: set[str] = set()
        self.found: list[Diagnostic] = []
        self._row = row
        self._columns = columns
        self._gaps: set[Span] = set()
        self._texts = {name: _spelled(value) for name, value in (row or {}).items()}

    def node(self, value: object, span: Span) -> object:
        """A value of the file with everything filled in; the table itself is left as it is."""
        if isinstance(value, YamlMapping):
            filled = YamlMapping(value.span)
            for key, item in value.items():
                place = value.value_spans[key]
                name = self._text(key, value.key_spans[key])
                is_table = key == _TABLE and span == value.span
                filled[name] = item if is_table else self.node(item, place)
                filled.key_spans[name] = value.key_spans[key]
                filled.value_spans[name] = place
            return filled
        if isinstance(value, YamlSequence):
            items = YamlSequence(value.span)
            items.item_spans = value.item_spans
            items += [
                self.node(item, place) for item, place in zip(value, value.item_spans, strict=True)
            ]
            return items
        if not isinstance(value, str):
            return value
        alone = _PLACE.fullmatch(value)
        if alone is not None and self._row is not None and alone[1] in self._row:
            self.used.add(alone[1])
            return self._row[alone[1]]
        return self._text(value, span)

    def without_gaps(self, found: Sequence[Diagnostic]) -> Iterator[Diagnostic]:
        """Findings but for those of values that could not be filled in."""
        return (item for item in found if item.span not in self._gaps)

    def _text(self, text: str, span: Span) -> str:
        return _PLACE.sub(lambda place: self._column(place, span), text) if "${" in text else text

    def _column(self, place: re.Match[str], span: Span) -> str:
        name = place[1]
        if name in self._texts:
            self.used.add(name)
            return self._texts[name]
        self._gaps.add(span)
        if name in self._columns:
            self.used.add(name)
            return place[0]
        message = f"there is no column '{name}' to fill in"
        if self._row is None:
            advice = f"write a table cases: with rows that give {name}, or leave out the ${{ }}"
        else:
            advice = nearest(name, self._texts)
        self.found.append(Diagnostic("FB8015", message, span, advice))
        return place[0]


def _spelled(value: object) -> str:
    if isinstance(value, bool):
        return str(value).lower()
    return value.text if isinstance(value, YamlInt | YamlFloat) else str(value)


def _each_once(rows: list[str], found: list[list[Diagnostic]]) -> Iterator[Diagnostic]:
    """What is wrong whatever the row is told once, else with the rows that it belongs to."""
    everything = dict.fromkeys(item for each in found for item in each)
    for item in everything:
        names = [name for name, each in zip(rows, found, strict=False) if item in each]
        if len(names) == len(rows):
            yield item
        else:
            what = f"with the case {', '.join(names)}"
            yield replace(item, notes=(*item.notes, Note(what)))


def _columns(rows: Mapping[str, object]) -> dict[str, Span]:
    """The columns of all rows, with the place where each is named first."""
    tables = [row for row in rows.values() if isinstance(row, YamlMapping)]
    return {column: place for row in reversed(tables) for column, place in row.key_spans.items()}


def _table_problems(
    rows: Mapping[str, object], columns: Mapping[str, Span], used: set[str]
) -> Iterator[Diagnostic]:
    """FB8016: a row lacks a column that others have. FB8017: a column is used nowhere."""
    for name, row in rows.items():
        if not isinstance(row, YamlMapping):
            continue
        if missing := [column for column in columns if column not in row]:
            message = f"the case '{name}' has no {', '.join(missing)}"
            yield Diagnostic("FB8016", message, row.span, "every row gives a value to each column")
    for column, place in columns.items():
        if column not in used:
            message = f"the column '{column}' is used nowhere"
            advice = f"write ${{{column}}} where its value belongs, or leave the column out"
            yield Diagnostic("FB8017", message, place, advice)
