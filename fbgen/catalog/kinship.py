"""Series of inverters that are like another: what they take over of its file.

A series with `like: vf-s9` has the words, ComNos, trips, terminal functions and options of the
VF-S9 beside its own, and those parts of its communication that it does not have itself. What it
takes over is `unverified`, with the source of the other as what the guess rests on: that two series
are alike is no fact about either. `confirmed` names the ComNos and parts of the communication of
which a document says that this series has them, too.
"""

from collections.abc import Iterator, Mapping

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


def with_relative(document: Document, known: Mapping[str, Document]) -> Document:
    """The file of a series with what it takes over; the same document if it is like no other.

    `known` are the files of all series by their ids. Raises DiagnosticError FB1105 for a series
    that is not there or leads back to this one, and for what is confirmed and not taken over.
    """
    return _merged(document, known, ())


def _merged(document: Document, known: Mapping[str, Document], seen: tuple[str, ...]) -> Document:
    data = document.data
    if not isinstance(data, YamlMapping) or not isinstance(data.get("like"), str):
        return document
    like, place = str(data["like"]), data.value_spans["like"]
    if like not in known:
        message = f"there is no drive series '{like}'"
        raise error("FB1105", message, place, nearest(like, known))
    if like in seen or known[like] is document:
        raise error("FB1105", f"the series is like '{like}', which is like it", place)
    base = _merged(known[like], known, (*seen, like)).data
    if not isinstance(base, YamlMapping):
        return document
    confirmed = {number: source for number, source, _ in _confirmed(data)}
    whole = _copy(data)
    for key, names in _SHARED.items():
        own = data.get(key)
        if own is not None and not isinstance(own, YamlSequence):
            continue  # a wrong type, which is reported when the model is made
        joined = YamlSequence(place)
        joined.extend(own or ())
        joined.item_spans = list(own.item_spans) if own is not None else []
        taken = {_key(item, name) for item, _ in _items(own) for name in names}
        for item, span in _items(base.get(key)):
            if not any(_key(item, name) in taken for name in names):
                joined.append(_taken_over(item, like, confirmed))
                joined.item_spans.append(span)
        whole[key] = joined
        whole.key_spans.setdefault(key, place)
        whole.value_spans.setdefault(key, place)
    _communicate(whole, base, like, place)
    _all_taken_over(data, base, like)
    return Document(document.source, whole, document.span)


def _communicate(whole: YamlMapping, base: YamlMapping, like: str, place: Span) -> None:
    """Give a series those parts of the other one's communication that it has not itself."""
    own, theirs = whole.get(_COMMUNICATION), base.get(_COMMUNICATION)
    if not isinstance(theirs, YamlMapping) or not isinstance(own, YamlMapping | None):
        return
    sources = {
        part: entry.get("source")
        for entry, _ in _items(whole.get("confirmed"))
        for part in _names(entry.get(_COMMUNICATION))
    }
    joined = YamlMapping(place) if own is None else _copy(own)
    for part, value in theirs.items():
        if part not in joined:
            joined[part] = _part(value, like, sources.get(part))
            joined.key_spans[part] = theirs.key_spans[part]
            joined.value_spans[part] = theirs.value_spans[part]
    whole[_COMMUNICATION] = joined
    whole.key_spans.setdefault(_COMMUNICATION, place)
    whole.value_spans.setdefault(_COMMUNICATION, place)


def _part(value: object, like: str, source: object) -> object:
    """A part of the communication: confirmed by a source, or unverified in all that it holds."""
    if isinstance(value, YamlSequence):
        items = YamlSequence(value.span)
        items.extend(_part(item, like, source) for item in value)
        items.item_spans = list(value.item_spans)
        return items
    if not isinstance(value, YamlMapping):
        return value
    copy = _copy(value)
    for key, item in value.items():
        copy[key] = _part(item, like, source)
    if source is not None and value.get("status") != "unverified":
        copy["source"] = source
    elif "source" in value or "status" in value:
        copy = _taken_over(copy, like, {})
    return copy


def _taken_over(item: YamlMapping, like: str, confirmed: Mapping[str, object]) -> YamlMapping:
    copy = _copy(item)
    source = confirmed.get(_key(item, "number"))
    if source is not None:
        copy["source"], copy["status"] = source, "verified"
        return copy
    rests_on = item.get("source")
    copy["source"] = f"as {like}" if rests_on is None else f"as {like}: {rests_on}"
    copy["status"] = "unverified"
    return copy


def _all_taken_over(data: YamlMapping, base: YamlMapping, like: str) -> None:
    """FB1105: a ComNo that is confirmed, and that the other series does not have."""
    there = {_key(item, "number") for item, _ in _items(base.get("comnos"))}
    wrong = [
        Diagnostic("FB1105", f"'{like}' has no ComNo '{number}'", span, nearest(number, there))
        for number, _, span in _confirmed(data)
        if number not in there
    ]
    if wrong:
        raise DiagnosticError(wrong)


def _confirmed(data: YamlMapping) -> Iterator[tuple[str, object, Span]]:
    """Number, source and place of everything that is confirmed."""
    for entry, _ in _items(data.get("confirmed")):
        numbers = entry.get("comnos")
        if isinstance(numbers, YamlSequence):
            for number, span in zip(numbers, numbers.item_spans, strict=True):
                yield _text(number), entry.get("source"), span


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


def _key(item: YamlMapping, name: str) -> str:
    return _text(item[name]) if name in item else ""


def _text(value: object) -> str:
    """Numbers as they are compared: four hexadecimal digits; names as they are."""
    text = value.text if isinstance(value, YamlInt) else str(value)
    return text.upper().removeprefix("0X").zfill(4)
