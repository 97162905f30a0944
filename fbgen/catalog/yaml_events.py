"""How a YAML text becomes nodes with their places (`fbgen.catalog.yaml_nodes`).

Built on PyYAML's event stream and an explicit stack rather than on its constructors: no object is
ever made from a tag, nesting cannot exhaust Python's stack, and every place is known.

Plain scalars follow the YAML 1.2 core schema, not YAML 1.1: only `true` and `false` are booleans
(`no`, `on`, `off` stay texts), `12:30` and dates stay texts, `0x1F` is a number and `017` is not
(1.1 reads it as octal, 1.2 as decimal, so we ask). A float needs a decimal point: `1E10` could be
a communication number. Keys are always texts. Numbers keep their spelling, so that a field which
means a hexadecimal number can read `0009` or `1388` as written.
"""

import re
from dataclasses import field

import yaml

from fbgen.catalog.yaml_nodes import Document, YamlFloat, YamlInt, YamlMapping, YamlSequence
from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic, DiagnosticError, Note, error
from fbgen.source import Source, Span

MAX_CHARACTERS = 500_000
MAX_DEPTH = 40
MAX_NODES = 200_000

_INT = re.compile(r"[-+]?(0|[1-9][0-9]{0,18})|0x[0-9A-Fa-f]{1,16}|0o[0-7]{1,21}")
_FLOAT = re.compile(r"[-+]?[0-9]{1,300}\.[0-9]{0,300}([eE][-+]?[0-9]{1,3})?|[-+]?\.[0-9]{1,300}")
_CONSTANTS: dict[str, bool | None] = {
    "true": True,
    "True": True,
    "TRUE": True,
    "false": False,
    "False": False,
    "FALSE": False,
    "null": None,
    "Null": None,
    "NULL": None,
    "~": None,
    "": None,
}


_SYNTAX_HELP = {
    "expected ',' or '}'": "close the { that the note shows with a }, on its line",
    "expected ',' or ']'": "close the [ that the note shows with a ]",
    "mapping values are not allowed": (
        "keys that belong together begin in the same column; a text with a colon goes in quotes"
    ),
    "could not find expected ':'": "a key is followed by a colon and a blank: name: hall",
    "expected <block end>": "keys and dashes that belong together begin in the same column",
    "found unexpected end of stream": "a quote was not closed",
}
"""What to do about messages of the YAML parser, by a part of them."""


@dataclass(slots=True)
class _Open:
    """A mapping or sequence whose end has not come yet."""

    value: YamlMapping | YamlSequence
    anchor: str | None
    nodes_before: int
    key: str | None = None
    key_span: Span | None = None


@dataclass(slots=True)
class _Anchor:
    value: object
    nodes: int
    closed: bool


@dataclass(slots=True)
class _Builder:
    source: Source
    stack: list[_Open] = field(default_factory=list)
    anchors: dict[str, _Anchor] = field(default_factory=dict)
    findings: list[Diagnostic] = field(default_factory=list)
    nodes: int = 0
    root: tuple[object, Span] | None = None

    def span(self, event: yaml.Event) -> Span:
        assert event.start_mark is not None, "events of a text carry marks"
        assert event.end_mark is not None
        return Span(self.source, event.start_mark.index, event.end_mark.index)

    def report(self, code: str, message: str, span: Span, help: str = "") -> None:  # noqa: A002
        self.findings.append(Diagnostic(code, message, span, help))

    def take(self, event: yaml.Event) -> None:
        """One event of the stream; nearly all are scalars."""
        if isinstance(event, yaml.ScalarEvent):
            self._scalar(event)
        elif isinstance(event, yaml.AliasEvent):
            self._alias(event)
        elif isinstance(event, (yaml.MappingStartEvent, yaml.SequenceStartEvent)):
            self._open(event)
        elif isinstance(event, (yaml.MappingEndEvent, yaml.SequenceEndEvent)):
            self._close(event)
        elif isinstance(event, yaml.DocumentStartEvent) and self.root is not None:
            raise error(
                "FB1001",
                "a second YAML document begins here",
                self.span(event),
                "keep one document to a file: remove the line with ---",
            )

    def _count(self, nodes: int, span: Span) -> None:
        self.nodes += nodes
        if self.nodes > MAX_NODES:
            raise error(
                "FB1002",
                f"the file stands for more than {MAX_NODES} values",
                span,
                "split the file, or write less through anchors and aliases",
            )

    def _refuse_tag(self, event: yaml.ScalarEvent | yaml.CollectionStartEvent) -> None:
        if event.tag != "!":
            self.report(
                "FB1003",
                f"the tag {event.tag} is not allowed here",
                self.span(event),
                "write the value without a tag: what it is follows from its key",
            )

    def _alias(self, event: yaml.AliasEvent) -> None:
        span = self.span(event)
        anchor = self.anchors.get(event.anchor or "")
        if anchor is None:
            self.report("FB1003", f"there is no anchor &{event.anchor} before this alias", span)
            self._put(None, span)
        elif not anchor.closed:
            raise error("FB1003", f"*{event.anchor} stands inside itself", span)
        else:
            self._count(anchor.nodes, span)
            self._put(anchor.value, span)

    def _scalar(self, event: yaml.ScalarEvent) -> None:
        span = self.span(event)
        self._count(1, span)
        if event.tag is not None:
            self._refuse_tag(event)
        if self._expects_key():
            self._put(event.value, span)
            return
        plain = event.implicit[0] and event.tag is None
        value = _resolve(event.value) if plain else event.value
        if event.anchor is not None:
            self.anchors[event.anchor] = _Anchor(value, 1, closed=True)
        self._put(value, span)

    def _open(self, event: yaml.MappingStartEvent | yaml.SequenceStartEvent) -> None:
        span = self.span(event)
        self._count(1, span)
        if event.tag is not None:
            self._refuse_tag(event)
        if len(self.stack) >= MAX_DEPTH:
            raise error("FB1002", f"nested more than {MAX_DEPTH} deep", span)
        if self._expects_key():
            raise error(
                "FB1003",
                "a key must be a plain text",
                span,
                "a value that begins with { or [ needs quotes if it is meant as text",
            )
        mapping = isinstance(event, yaml.MappingStartEvent)
        value = YamlMapping(span) if mapping else YamlSequence(span)
        if event.anchor is not None:
            self.anchors[event.anchor] = _Anchor(value, 0, closed=False)
        self.stack.append(_Open(value, event.anchor, self.nodes))

    def _close(self, event: yaml.Event) -> None:
        opened = self.stack.pop()
        value = opened.value
        value.span = self._whole(value, event)
        if opened.anchor is not None:
            nodes = self.nodes - opened.nodes_before + 1
            self.anchors[opened.anchor] = _Anchor(value, nodes, closed=True)
        self._put(value, value.span)

    def _whole(self, value: YamlMapping | YamlSequence, event: yaml.Event) -> Span:
        """From the start to the end of the last child; block collections have no end mark."""
        mark = self.span(event)
        start, end = value.span.start, mark.end
        if mark.start == mark.end:
            inner = (
                list(value.value_spans.values())
                if isinstance(value, YamlMapping)
                else value.item_spans
            )
            end = max((span.end for span in inner), default=start)
        return Span(self.source, start, max(start, end))

    def _expects_key(self) -> bool:
        return bool(self.stack) and (
            isinstance(self.stack[-1].value, YamlMapping) and self.stack[-1].key is None
        )

    def _put(self, value: object, span: Span) -> None:
        if not self.stack:
            self.root = (value, span)
            return
        top = self.stack[-1]
        if isinstance(top.value, YamlSequence):
            top.value.append(value)
            top.value.item_spans.append(span)
        elif top.key is None:
            top.key, top.key_span = self._key(top.value, value, span), span
        else:
            assert top.key_span is not None
            top.value[top.key] = value
            top.value.key_spans[top.key] = top.key_span
            top.value.value_spans[top.key] = span
            top.key = None

    def _key(self, mapping: YamlMapping, value: object, span: Span) -> str:
        key = value if isinstance(value, str) else span.text
        if key in mapping:
            self.findings.append(
                Diagnostic(
                    "FB1004",
                    f"the key '{key}' stands twice",
                    span,
                    "keep one of the two",
                    (Note("first here", mapping.key_spans[key]),),
                )
            )
        return key


def read(source: Source) -> Document:
    """The data of one YAML text. Raises DiagnosticError with everything found in the text.

    FB1001 syntax, FB1002 limits, FB1003 not plain YAML, FB1004 duplicate keys.
    """
    if len(source.text) > MAX_CHARACTERS:
        start = Span(source, 0, 1)
        raise error("FB1002", f"the file has more than {MAX_CHARACTERS} characters", start)
    builder = _built(source)
    if builder.findings:
        raise DiagnosticError(builder.findings)
    if builder.root is None:
        hint = "write something into it; fbgen init writes a plant file to start from"
        raise error("FB1001", "the file is empty", Span(source, 0, 0), hint)
    data, span = builder.root
    return Document(source, data, span)


def _built(source: Source) -> _Builder:
    """The text taken event by event, so that a limit stops the parser, too.

    Syntax errors always come from the parser written in Python, so that message and place are the
    same whether PyYAML was built with libyaml or not.
    """
    if yaml.__with_libyaml__:
        try:
            return _build(source, yaml.CSafeLoader)
        except (yaml.YAMLError, UnicodeEncodeError):
            pass
    try:
        return _build(source, yaml.SafeLoader)
    except yaml.reader.ReaderError as problem:
        place = Span(source, problem.position, problem.position + 1)
        raise error("FB1001", "there is a character that YAML does not allow", place) from None
    except yaml.MarkedYAMLError as problem:
        raise DiagnosticError([_syntax(source, problem)]) from None


def _build(source: Source, loader: type[yaml.SafeLoader] | type[yaml.CSafeLoader]) -> _Builder:
    builder = _Builder(source)
    events = loader(source.text)
    try:
        while (event := events.get_event()) and not isinstance(event, yaml.StreamEndEvent):
            builder.take(event)
    except DiagnosticError as stop:
        raise DiagnosticError([*builder.findings, *stop.diagnostics]) from None
    finally:
        events.dispose()
    return builder


def _syntax(source: Source, problem: yaml.MarkedYAMLError) -> Diagnostic:
    mark = problem.problem_mark or problem.context_mark
    start = min(mark.index, len(source.text)) if mark is not None else 0
    notes: tuple[Note, ...] = ()
    context = problem.context_mark
    if problem.context and context is not None and context.index != start:
        notes = (Note(problem.context, Span(source, context.index, context.index + 1)),)
    message = problem.problem or "this is not YAML"
    hint = "YAML does not allow tabs before a key: use blanks" if "\t" in source.text else ""
    hint = hint or next((text for part, text in _SYNTAX_HELP.items() if part in message), "")
    return Diagnostic("FB1001", message, Span(source, start, start + 1), hint, notes)


def _resolve(text: str) -> object:
    if text in _CONSTANTS:
        return _CONSTANTS[text]
    if _INT.fullmatch(text):
        number = YamlInt(text, 0) if text.startswith("0") else YamlInt(text)
        number.text = text
        return number
    if _FLOAT.fullmatch(text):
        decimal = YamlFloat(text)
        decimal.text = text
        return decimal
    return text
