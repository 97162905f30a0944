"""Series of inverters that are like another: what they take over of it.

A series with `like: vf-s9` has the words, ComNos, trips, terminal functions and options of the
VF-S9 beside its own, and those parts of its communication that it does not have itself. What it
takes over is `unverified`, with the source of the other as what the guess rests on: that two series
are alike is no fact about either. `confirmed` names the ComNos and parts of the communication of
which a document says that this series has them, too.

What is taken over was checked with the series that it comes from, and is not checked again.
"""

from collections.abc import Iterator, Mapping

from fbgen.catalog.drives import Drive
from fbgen.catalog.sourced import Sourced
from fbgen.catalog.yaml_nodes import Document, YamlInt, YamlMapping, YamlSequence
from fbgen.diagnostics import Diagnostic, DiagnosticError, error
from fbgen.nearest import nearest
from fbgen.source import Span

_SHARED: Mapping[str, tuple[str, ...]] = {
    "words": ("name",),
    "comnos": ("number", "name"),
    "trips": ("code",),
    "terminal_functions": ("name",),
    "options": ("id",),
}
"""Lists that are taken over -> keys by which an own item replaces one of the other series."""
_COMMUNICATION = "communication"


def relative_of(document: Document, known: Mapping[str, Document]) -> str | None:
    """The series that a file says it is like; None if none.

    `known` are the files of all series by their ids. Raises DiagnosticError FB1105 for a series
    that is not there or leads back to this one.
    """
    like = _like(document)
    if like is None:
        return None
    name, place = like
    if name not in known:
        raise error("FB1105", f"there is no drive series '{name}'", place, nearest(name, known))
    seen, other = {name}, known[name]
    while other is not document:
        further = _like(other)
        if further is None or further[0] in seen or further[0] not in known:
            return name
        seen.add(further[0])
        other = known[further[0]]
    raise error("FB1105", f"the series is like '{name}', which is like it", place)


def with_relative(document: Document, base: Drive) -> Document:
    """The file of a series with what it takes over of the one it is like.

    Raises DiagnosticError FB1105 for what is confirmed and not taken over.
    """
    data, like = document.data, _like(document)
    if not isinstance(data, YamlMapping) or like is None:
        return document
    place = like[1]
    confirmed = {
        "comnos": {number: source for number, source, _ in _confirmed(data, "comnos")},
        "words": {name: source for name, source, _ in _confirmed(data, "words")},
    }
    whole = _copy(data)
    for key, names in _SHARED.items():
        own = data.get(key)
        if own is not None and not isinstance(own, YamlSequence):
            continue  # a wrong type, which is reported when the model is made
        joined = YamlSequence(place)
        joined.extend(own or ())
        joined.item_spans = list(own.item_spans) if own is not None else []
        taken = {_key(item, name) for item, _ in _items(own) for name in names}
        for entry in getattr(base, key):
            if taken.isdisjoint(_text(getattr(entry, name)) for name in names):
                source = confirmed.get(key, {}).get(_text(getattr(entry, names[0])))
                joined.append(_taken_over(entry, base.id, source))
                joined.item_spans.append(entry.span or place)
        _put(whole, key, joined, place)
    _communicate(whole, base, place)
    _all_taken_over(data, base)
    return Document(document.source, whole, document.span)


def _communicate(whole: YamlMapping, base: Drive, place: Span) -> None:
    """Give a series those parts of the other one's communication that it has not itself."""
    own, theirs = whole.get(_COMMUNICATION), base.communication
    if theirs is None or not isinstance(own, YamlMapping | None):
        return
    sources = {
        part: entry.get("source")
        for entry, _ in _items(whole.get("confirmed"))
        for part in _names(entry.get(_COMMUNICATION))
    }
    joined = YamlMapping(place) if own is None else _copy(own)
    for part in type(theirs).model_fields:
        if part not in joined:
            value = _part(getattr(theirs, part), base.id, sources.get(part))
            _put(joined, part, value, theirs.key_span_of(part) or place)
    _put(whole, _COMMUNICATION, joined, place)


def _part(value: object, like: str, source: object) -> object:
    """A part of the communication: confirmed by a source, or unverified in all that it holds."""
    if isinstance(value, tuple):
        return tuple(_part(item, like, source) for item in value)
    if not isinstance(value, Sourced):
        return value
    inner = {
        name: _part(item, like, source)
        for name in type(value).model_fields
        if isinstance(item := getattr(value, name), Sourced)
        or (isinstance(item, tuple) and any(isinstance(one, Sourced) for one in item))
    }
    if source is not None and value.status == "unverified":
        return value.model_copy(update=inner)
    return _taken_over(value.model_copy(update=inner), like, source)


def _taken_over(entry: Sourced, like: str, source: object) -> Sourced:
    if source is not None:
        return entry.model_copy(update={"source": source, "status": "verified"})
    rests_on = f"as {like}" if entry.source is None else f"as {like}: {entry.source}"
    return entry.model_copy(update={"source": rests_on, "status": "unverified"})


def _all_taken_over(data: YamlMapping, base: Drive) -> None:
    """FB1105: a ComNo or word that is confirmed, and that the other series does not have."""
    there = {
        "comnos": {comno.hex: comno.hex for comno in base.comnos},
        "words": {_text(word.name): word.name for word in base.words},
    }
    wrong = [
        Diagnostic(
            "FB1105", f"'{base.id}' has no {kind} '{span.text}'", span, nearest(span.text, known)
        )
        for key, kind in (("comnos", "ComNo"), ("words", "word"))
        for known in (there[key].values(),)
        for name, _, span in _confirmed(data, key)
        if name not in there[key]
    ]
    if wrong:
        raise DiagnosticError(wrong)


def _like(document: Document) -> tuple[str, Span] | None:
    """The series that a file names under `like`, and where."""
    data = document.data
    if isinstance(data, YamlMapping) and isinstance(data.get("like"), str):
        return str(data["like"]), data.value_spans["like"]
    return None


def _confirmed(data: YamlMapping, key: str) -> Iterator[tuple[str, object, Span]]:
    """Number or name, source and place of every ComNo, or every word, that is confirmed."""
    for entry, _ in _items(data.get("confirmed")):
        names = entry.get(key)
        if isinstance(names, YamlSequence):
            for name, span in zip(names, names.item_spans, strict=True):
                yield _text(name), entry.get("source"), span


def _names(value: object) -> list[str]:
    return [str(item) for item in value] if isinstance(value, YamlSequence) else []


def _items(value: object) -> Iterator[tuple[YamlMapping, Span]]:
    if isinstance(value, YamlSequence):
        for item, span in zip(value, value.item_spans, strict=True):
            if isinstance(item, YamlMapping):
                yield item, span


def _copy(mapping: YamlMapping) -> YamlMapping:
    copy = YamlMapping(mapping.span)
    copy.update(mapping)
    copy.key_spans, copy.value_spans = dict(mapping.key_spans), dict(mapping.value_spans)
    return copy


def _put(mapping: YamlMapping, key: str, value: object, place: Span) -> None:
    mapping[key] = value
    mapping.key_spans.setdefault(key, place)
    mapping.value_spans.setdefault(key, place)


def _key(item: YamlMapping, name: str) -> str:
    return _text(item[name]) if name in item else ""


def _text(value: object) -> str:
    """Numbers as they are compared: four hexadecimal digits; names as they are."""
    if type(value) is int:
        return f"{value:04X}"
    text = value.text if isinstance(value, YamlInt) else str(value)
    return text.upper().removeprefix("0X").zfill(4)
