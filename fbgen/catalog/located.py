"""The base of all models that are read from YAML: frozen, strict about keys, aware of places.

A model class derives from `Located`, names its fields, and may override `problems()` to report
what the field types alone cannot say, or `problems_against(known)` where that needs something that
has been read before, such as the catalogue. `validate` turns a YAML document into a model or raises
one DiagnosticError with everything that is wrong in the document: a finding inside one entry hides
none in its neighbours or in the whole.
"""

import marshal
import re
from collections.abc import Collection, Hashable, Iterable, Mapping
from dataclasses import field
from typing import NamedTuple, Self, TypeVar

from pydantic import (
    BaseModel,
    ConfigDict,
    ModelWrapValidatorHandler,
    PrivateAttr,
    ValidationError,
    ValidationInfo,
    model_validator,
)
from pydantic_core import ErrorDetails, PydanticCustomError

from fbgen.catalog.yaml_nodes import Document, YamlFloat, YamlInt, YamlMapping, YamlSequence, locate
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError
from fbgen.nearest import near_names, nearest
from fbgen.source import Origin, Source, Span

Key = TypeVar("Key", bound=Hashable)


class _Spans(NamedTuple):
    """Of a model, of the values of its fields, of their names, and of items inside of fields."""

    own: Span | None
    fields: Mapping[str, Span]
    keys: Mapping[str, Span]
    items: Mapping[str, Mapping[int | str, Span]]


class _Place:
    """Where a model stands. Two models with equal fields are equal wherever they stand.

    A kept catalogue has thousands of spans, and few are asked for: the spans of a model are plain
    numbers with their sources until somebody asks for one.
    """

    __slots__ = ("_kept", "_spans")

    def __init__(
        self, spans: _Spans | None = None, kept: tuple[bytes, tuple[Source, ...]] | None = None
    ) -> None:
        self._spans = spans or (None if kept else _Spans(None, {}, {}, {}))
        self._kept = kept

    def __eq__(self, other: object) -> bool:
        return isinstance(other, _Place)

    def __hash__(self) -> int:
        return 0

    @property
    def spans(self) -> _Spans:
        """The spans themselves."""
        if self._spans is None:
            assert self._kept is not None, "one of both is there"
            own, fields, keys, items = marshal.loads(self._kept[0])
            self._spans = _Spans(
                None if own is None else self._span(own),
                self._all(fields),
                self._all(keys),
                {name: self._all(inside) for name, inside in items.items()},
            )
        return self._spans

    def _span(self, found: tuple[int, int, int]) -> Span:
        assert self._kept is not None, "only kept spans are numbers"
        return Span(self._kept[1][found[0]], found[1], found[2])

    def _all(self, found: Mapping[Key, tuple[int, int, int]]) -> dict[Key, Span]:
        return {key: self._span(one) for key, one in found.items()}

    def __reduce__(self) -> tuple[type, tuple[object, ...]]:
        own, fields, keys, items = self.spans
        sources: dict[Source, int] = {}

        def number(span: Span) -> tuple[int, int, int]:
            return sources.setdefault(span.source, len(sources)), span.start, span.end

        def numbers(spans: Mapping[Key, Span]) -> dict[Key, tuple[int, int, int]]:
            return {key: number(span) for key, span in spans.items()}

        inside = {name: numbers(spans) for name, spans in items.items()}
        content = own and number(own), numbers(fields), numbers(keys), inside
        return _Place, (None, (marshal.dumps(content), tuple(sources)))


@dataclass(slots=True)
class _Reading:
    """What accompanies the validation of one document.

    `misspelt` holds keys that are missing in the mapping at a place only because they are spelled
    wrongly there: the unknown key is reported, the missing one need not be.
    """

    known: object
    findings: list[Diagnostic] = field(default_factory=list)
    misspelt: set[tuple[Span, str]] = field(default_factory=set)

    def unknown_keys(self, data: YamlMapping, fields: Iterable[str]) -> None:
        """FB1005 for every key that is no field."""
        for key, span in data.key_spans.items():
            if key not in fields:
                message = f"the key '{key}' is not known here"
                self.findings.append(Diagnostic("FB1005", message, span, nearest(key, fields)))
                self.misspelt |= {(data.span, name) for name in near_names(key, fields)[:1]}


class Located(BaseModel):
    """A frozen model that remembers the place it was read from.

    What pydantic needs to validate a model is made when the first one is validated: most models
    are only parts of others.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", ser_json_bytes="hex", defer_build=True)
    _place: _Place = PrivateAttr(default_factory=_Place)

    @model_validator(mode="wrap")
    @classmethod
    def _remember_place(
        cls, data: object, handler: ModelWrapValidatorHandler[Self], info: ValidationInfo
    ) -> Self:
        if isinstance(data, cls):
            return data  # made and checked before
        reading = info.context if isinstance(info.context, _Reading) else None
        if isinstance(data, YamlMapping) and reading is not None:
            fields = cls.model_fields
            reading.unknown_keys(data, fields)
            model = handler({key: value for key, value in data.items() if key in fields})
        else:
            model = handler(data)
        if isinstance(data, YamlMapping):
            items = {key: _item_spans(value) for key, value in data.items()}
            model._place = _Place(_Spans(data.span, data.value_spans, data.key_spans, items))
        found = tuple(model.problems())
        if reading is not None:
            reading.findings += found
            if reading.known is not None:
                reading.findings += model.problems_against(reading.known)
        elif found:
            raise PydanticCustomError("diagnostics", "{text}", {"text": found[0].message})
        return model

    def problems(self) -> Iterable[Diagnostic]:
        """What is wrong with this model although each field is right. Override to report it."""
        return ()

    def problems_against(self, known: object) -> Iterable[Diagnostic]:
        """What is wrong in the light of `known`, as it was given to `validate`. Override it."""
        return ()

    def in_place_of(self, other: "Located") -> Self:
        """The same model as if it stood where another does, which stands for it."""
        made = self.model_copy()
        made._place = other._place
        return made

    @property
    def span(self) -> Span | None:
        """Where the model stands; None for one that was made in Python."""
        return self._place.spans.own

    def span_of(self, name: str) -> Span | None:
        """Where the value of a field stands, or the model itself where the field is not written."""
        spans = self._place.spans
        return spans.fields.get(name, spans.own)

    def item_span_of(self, name: str, item: int | str) -> Span | None:
        """Where an item of a list (by index) or of a mapping (its value, by key) stands, or the
        whole list or mapping where items have no place."""
        return self._place.spans.items.get(name, {}).get(item, self.span_of(name))

    def key_span_of(self, name: str) -> Span | None:
        """Where the name of a field stands, or the model itself where the field is not written."""
        spans = self._place.spans
        return spans.keys.get(name, spans.own)


def _item_spans(value: object) -> dict[int | str, Span]:
    if isinstance(value, YamlSequence):
        return dict(enumerate(value.item_spans))
    if isinstance(value, YamlMapping):
        return {key: span for key, span in value.value_spans.items()}  # noqa: C416 widens the key
    return {}


def origin(
    what: str, model: Located, source: str = "", inputs: Iterable[Origin | None] = ()
) -> Origin | None:
    """The origin mark of a model: its name for a person, its file and line, its manual section.

    The section is the entry's own where none is given. `inputs` are the entries that a value was
    worked out from, too.
    """
    span = model.span
    if span is None:
        return None
    known = tuple(dict.fromkeys(item for item in inputs if item is not None))
    section = source or getattr(model, "source", None) or ""
    return Origin(what, span.source.name, span.line, section, known)


Model = TypeVar("Model", bound=Located)


def validate(document: Document, model: type[Model], known: object = None) -> Model:
    """The document as a model. Raises DiagnosticError with everything that is wrong.

    FB1005 unknown key, FB1006 missing key, FB1007 wrong type or value, and whatever `problems()`
    and `problems_against(known)` of the models report.
    """
    reading = _Reading(known)
    try:
        result = model.model_validate(document.data, context=reading)
    except ValidationError as failure:
        details = _first_hand(failure.errors(include_url=False))
        reading.findings += [
            found
            for item in details
            if (found := _translate(document, item, reading.misspelt)) is not None
        ]
        raise _all(reading.findings) from None
    if reading.findings:
        raise _all(reading.findings)
    return result


def _first_hand(details: list[ErrorDetails]) -> list[ErrorDetails]:
    """Without "too short" of lists that are short only because an item of theirs is wrong."""
    wrong_inside = {item["loc"][:length] for item in details for length in range(len(item["loc"]))}
    return [
        item for item in details if item["type"] != "too_short" or item["loc"] not in wrong_inside
    ]


def _all(found: list[Diagnostic]) -> DiagnosticError:
    """All findings in the order of their places; what an alias repeats is told once."""
    once = dict.fromkeys(found)
    return DiagnosticError(sorted(once, key=lambda item: item.span.start if item.span else 0))


def _translate(
    document: Document, details: ErrorDetails, misspelt: Collection[tuple[Span, str]]
) -> Diagnostic | None:
    kind, path = details["type"], details["loc"]
    span, value = locate(document, path)
    if kind != "missing":
        return Diagnostic("FB1007", *_wrong_value(details, value, span))
    wanted = str(path[-1])
    if (span, wanted) in misspelt:
        return None
    first = next(iter(value.key_spans.values()), span) if isinstance(value, YamlMapping) else span
    return Diagnostic("FB1006", f"the key '{wanted}' is missing here", first, f"add {wanted}:")


_EXPECTED = {
    "int_type": "a whole number",
    "int_parsing": "a whole number",
    "int_from_float": "a whole number",
    "float_type": "a number",
    "float_parsing": "a number",
    "string_type": "a text",
    "bool_type": "true or false",
    "bool_parsing": "true or false",
    "tuple_type": "a list",
    "list_type": "a list",
    "dict_type": "a mapping of keys to values",
    "mapping_type": "a mapping of keys to values",
    "model_type": "a mapping of keys to values",
    "model_attributes_type": "a mapping of keys to values",
    "union_tag_not_found": "a mapping with one of the keys that say what it is",
}
_BOOLEAN_WORDS = {"yes", "no", "on", "off", "y", "n"}


def _wrong_value(details: ErrorDetails, value: object, span: Span) -> tuple[str, Span, str]:
    kind, context = details["type"], details.get("ctx", {})
    found = f"found {describe(value)}"
    if kind in ("literal_error", "enum"):
        choices = [part.strip("'") for part in str(context["expected"]).split(", ")]
        choices = [part for item in choices for part in item.replace("' or '", "\0").split("\0")]
        return f"{found}, expected one of: {', '.join(choices)}", span, nearest(str(value), choices)
    if kind in _EXPECTED:
        return f"{found}, expected {_EXPECTED[kind]}", span, _type_help(kind, value)
    if kind == "too_short":
        return f"found an empty list, expected at least {context['min_length']} item", span, ""
    if kind == "value_error":
        return str(context["error"]), span, ""
    if kind == "string_pattern_mismatch":
        return f"{found}, which is not spelled as {context['pattern']} demands", span, ""
    limits = {
        "greater_than": ("gt", "more than"),
        "greater_than_equal": ("ge", "at least"),
        "less_than": ("lt", "less than"),
        "less_than_equal": ("le", "at most"),
    }
    if kind in limits:
        key, words = limits[kind]
        return f"{found}, expected {words} {context[key]}", span, ""
    return f"{found}: {details['msg'][:1].lower()}{details['msg'][1:]}", span, ""


def _type_help(kind: str, value: object) -> str:
    if kind.startswith("bool") and str(value).lower() in _BOOLEAN_WORDS:
        return f"'{value}' is a text: write true or false"
    if kind == "string_type" and isinstance(value, (YamlInt, YamlFloat)):
        return f'write it in quotes: "{value.text}"'
    if kind == "string_type" and isinstance(value, bool):
        return f'write it in quotes: "{str(value).lower()}"'
    if kind.startswith(("int", "float")) and isinstance(value, str):
        if value.startswith("0") and value.isdigit():
            plain = value.lstrip("0") or "0"
            return f"a leading 0 means octal to some readers: write {plain} (or 0o{plain})"
        if re.fullmatch(r"[-+]?[0-9]+[eE][-+]?[0-9]+", value):
            whole = "write the digits out"
            return whole if kind.startswith("int") else "write it with a decimal point"
        if number := re.match(r"([-+]?[0-9]+)([.,][0-9]+)?(?=\s*[^\W\d]|$)", value):
            plain = number[0].replace(",", ".") if kind.startswith("float") else number[1]
            return f"write the number alone, with a point and without a unit: {plain}"
        if ":" in value:
            return "a number with a colon is a text here: write it in one unit"
    return ""


def describe(value: object) -> str:
    """What stands in the file, for a message."""
    if isinstance(value, YamlMapping):
        return "a mapping"
    if isinstance(value, YamlSequence):
        return "a list"
    if value is None:
        return "nothing"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, (YamlInt, YamlFloat)):
        return value.text
    text = str(value)
    return f"'{text if len(text) <= 40 else text[:37] + '...'}'"
