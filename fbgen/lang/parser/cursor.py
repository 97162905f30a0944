"""Where the parser stands in the tokens: looking, expecting, trivia, findings, depth.

Recovery: a finding is reported and `Unexpected` raised; the loops over statements,
declarations and units catch it, skip to where something new can begin, and go on. A second finding
at the same token is dropped, as it follows from the first.
"""

from collections.abc import Iterable
from typing import NoReturn

from fbgen.diagnostics import Diagnostic, Note
from fbgen.lang.ast import Argument, HeaderItem, Trivia, TriviaKind, TriviaList
from fbgen.lang.depth import DEEPEST
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.lexer import Extra, tokenize
from fbgen.lang.parser.slips import help_for_slip
from fbgen.lang.parser.soft_words import settle_soft_words
from fbgen.source import Source, Span

MOST_FINDINGS = 500
"""Findings of one text that are reported; a text with more is hardly a PLC text."""

_NEVER = 1 << 60
_make = tuple.__new__


_FARTHEST_LOOK = 4
"""So many tokens are looked at or stepped over in one go: so many ends stand at the end."""


class Unexpected(Exception):  # noqa: N818 - never leaves the parser
    """Raised behind a finding, to get to the loop that recovers."""


class Cursor:
    """The tokens, the place in them and what was found wrong so far."""

    def __init__(self, source: Source, dialect: Dialect) -> None:
        tokens = tokenize(source, dialect)
        for column in (tokens.kinds, tokens.texts, tokens.starts, tokens.ends):
            column.extend(column[-1:] * _FARTHEST_LOOK)  # type: ignore[arg-type]
        settle_soft_words(tokens.kinds, tokens.texts)
        self.source = source
        self.dialect = dialect
        self.kinds = tokens.kinds
        self.texts = tokens.texts
        self.starts = tokens.starts
        self.ends = tokens.ends
        self.at = 0
        self.depth = 0
        self._extras = tokens.extras
        self._next_extra = 0
        self.extra_at = self._extras[0].token if self._extras else _NEVER
        self._findings = tokens.diagnostics
        self.is_cut_off = bool(self._findings)
        """Whether a comment without end has swallowed the rest of the text."""
        self._last_finding_at = -1
        self._missing_features: set[Feature] = set()
        self._missing_types: set[str] = set()

    # --- places -------------------------------------------------------------------------------

    def span(self, first: int) -> Span:
        """From token number `first` to the last one that was read."""
        return _make(Span, (self.source, self.starts[first], self.ends[self.at - 1]))

    def token_span(self, index: int) -> Span:
        """The place of one token."""
        return _make(Span, (self.source, self.starts[index], self.ends[index]))

    def starts_line(self, index: int) -> bool:
        """Whether a token is the first one in its line."""
        before = self.ends[index - 1] if index else 0
        return index == 0 or "\n" in self.source.text[before : self.starts[index]]

    # --- tokens -------------------------------------------------------------------------------

    def accept(self, kind: str) -> bool:
        """Step over a token of this kind, if it is the next one."""
        if self.kinds[self.at] == kind:
            self.at += 1
            return True
        return False

    def accept_word(self, word: str) -> bool:
        """Step over a word that is a keyword only here, whatever its case."""
        if self.kinds[self.at] in ("name", word) and self.texts[self.at].upper() == word:
            self.at += 1
            return True
        return False

    def expect(self, kind: str, what: str = "", hint: str = "") -> int:
        """Step over a token of this kind and return its number. Reports anything else."""
        at = self.at
        if self.kinds[at] != kind:
            raise self.failed(what or f"'{kind}'", hint)
        self.at = at + 1
        return at

    def word(self, at: int) -> bool:
        """Whether a token is a word, a keyword or not."""
        text = self.texts[at]
        return bool(text) and (text[0].isalpha() or text[0] == "_") and text.isidentifier()

    # --- findings -----------------------------------------------------------------------------

    def report(
        self, code: str, message: str, span: Span, hint: str = "", notes: tuple[Note, ...] = ()
    ) -> None:
        """Note an error and go on."""
        if len(self._findings) < MOST_FINDINGS:
            self._findings.append(Diagnostic(code, message, span, hint, notes))

    def findings(self) -> list[Diagnostic]:
        """All findings in the order of their places."""
        return sorted(self._findings, key=lambda found: found.span.start if found.span else 0)

    def failed(self, expected: str, hint: str = "") -> Unexpected:
        """Report the next token, which is not what was expected; raise the result to give up."""
        self.unexpected(expected, hint)
        return Unexpected()

    def unexpected(self, expected: str, hint: str = "") -> None:
        """Report the next token, unless something was reported there already."""
        at = self.at
        if at == self._last_finding_at:
            return
        self._last_finding_at = at
        kind, text = self.kinds[at], self.texts[at]
        span = self.token_span(at)
        before = self.texts[at - 1] if at else ""
        behind = self.texts[at + 1] if at + 1 < len(self.texts) else ""
        hint = help_for_slip(before, text, behind, expected) or hint
        if kind == "unterminated":
            what = "name" if text[0] == '"' and self.dialect.has(Feature.QUOTED_NAMES) else "string"
            self.report("FB3003", f"this {what} has no end", span, f"close it with {text[0]}")
        elif kind == "character":
            self.report(
                "FB3002",
                f"found the character {_shown(text[0])}, expected {expected}",
                span,
                hint or "nothing in this language begins with it; remove it",
            )
        else:
            found = "the end of the file" if kind == "end" else f"'{_shortened(text)}'"
            self.report("FB3001", f"found {found}, expected {expected}", span, hint)

    def missing_feature(self, feature: Feature, span: Span) -> None:
        """Report something that the dialect does not have, each thing once a file."""
        if feature not in self._missing_features:
            self._missing_features.add(feature)
            self.report(
                "FB3009",
                f"dialect {self.dialect.name} has no {feature.value}",
                span,
                self.dialect.advice.get(feature, ""),
            )

    def check_type(self, name: str, span: Span) -> None:
        """Report an elementary type that the dialect does not have, each once a file."""
        key = name.upper()
        if key in self.dialect.absent_types and key not in self._missing_types:
            self._missing_types.add(key)
            self.report(
                "FB3009",
                f"dialect {self.dialect.name} has no type {key}",
                span,
                self.dialect.absent_types[key],
            )

    def need(self, feature: Feature, first: int) -> None:
        """Report the tokens from `first` up to here if the dialect does not have the feature.

        If `first` is the next token, that one is reported.
        """
        if feature not in self.dialect.features:
            place = self.span(first) if first < self.at else self.token_span(first)
            self.missing_feature(feature, place)

    def unread(self, what: str, span: Span, hint: str) -> Unexpected:
        """Report something that is right but cannot be read yet; raise the result to give up."""
        if self.at != self._last_finding_at:
            self._last_finding_at = self.at
            self.report("FB3012", f"{what} cannot be read", span, hint)
        return Unexpected()

    def deeper(self) -> None:
        """Go one level down. `self.depth -= 1` comes back up."""
        self.depth += 1
        if self.depth > DEEPEST:
            self.too_deep()

    def too_deep(self) -> NoReturn:
        """Report that the next token is nested too deep, and give up."""
        if self._last_finding_at != self.at:
            self._last_finding_at = self.at
            self.report(
                "FB3006",
                f"nested deeper than {DEEPEST} levels",
                self.token_span(self.at),
                "split the expression, or move inner statements into a block of their own",
            )
        raise Unexpected

    # --- trivia -------------------------------------------------------------------------------

    def take_leading(self) -> TriviaList:
        """All trivia up to the next token that nobody has taken."""
        if self.extra_at > self.at:
            return ()
        taken: list[Trivia] = []
        while self.extra_at <= self.at:
            taken.append(self._extras[self._next_extra].trivia)
            self._step()
        return tuple(taken)

    def take_same_line(self) -> Trivia | None:
        """The comment behind the last token that was read, if it ends the line."""
        if self.extra_at == self.at:
            extra = self._extras[self._next_extra]
            if extra.same_line and extra.trivia.kind is not TriviaKind.PRAGMA:
                self._step()
                return extra.trivia
        return None

    def take_inline(self) -> Trivia | None:
        """The comment in front of the next token, wherever its line ends."""
        if self.extra_at == self.at:
            trivia = self._extras[self._next_extra].trivia
            if trivia.kind in (TriviaKind.LINE_COMMENT, TriviaKind.BLOCK_COMMENT):
                self._step()
                return trivia
        return None

    def settle(self, leading: TriviaList) -> tuple[TriviaList, Trivia | None]:
        """The trivia of something that has just ended: what stood inside goes to the front."""
        while self.extra_at < self.at:
            trivia = self._extras[self._next_extra].trivia
            if trivia.kind is not TriviaKind.BLANK_LINE:
                leading = (*leading, trivia)
            self._step()
        return leading, self.take_same_line()

    def put_back(self, arguments: Iterable[Argument]) -> None:
        """Give back the comments of arguments that turned out to be indices or values.

        Whoever settles next has them, as what stood inside of it.
        """
        for argument in arguments:
            found = (*argument.leading, *((argument.trailing,) if argument.trailing else ()))
            kept = [Extra(self.at, False, one) for one in found if one.text]
            self._extras[self._next_extra : self._next_extra] = kept
        self._look()

    def take_before(self, token: int) -> TriviaList:
        """The comments up to a token that has been read, without blank lines."""
        taken: list[Trivia] = []
        while self.extra_at <= token:
            trivia = self._extras[self._next_extra].trivia
            if trivia.kind is not TriviaKind.BLANK_LINE:
                taken.append(trivia)
            self._step()
        return tuple(taken)

    def drop_extras(self, start: int, end: int) -> None:
        """Drop the trivia that begin between two offsets, as they are part of a raw line."""
        first = self._next_extra
        while first < len(self._extras) and self._extras[first].trivia.span.start < start:
            first += 1
        last = first
        while last < len(self._extras) and self._extras[last].trivia.span.start < end:
            last += 1
        del self._extras[first:last]
        self._look()

    def take_pragma(self) -> HeaderItem | None:
        """A pragma in front of the next token, as attributes; comments before it stay."""
        position = self._next_extra
        while position < len(self._extras) and self._extras[position].token <= self.at:
            trivia = self._extras[position].trivia
            if trivia.kind is TriviaKind.PRAGMA:
                del self._extras[position]
                self._look()
                return HeaderItem(trivia.span, "{}", trivia.text)
            position += 1
        return None

    def pragma_text(self) -> str:
        """The text of a pragma in front of the next token, else ""."""
        if self.extra_at > self.at:
            return ""
        pragma = self.take_pragma()
        return pragma.text if pragma else ""

    def _step(self) -> None:
        self._next_extra += 1
        self._look()

    def _look(self) -> None:
        extras = self._extras
        self.extra_at = extras[self._next_extra].token if self._next_extra < len(extras) else _NEVER


def _shortened(text: str) -> str:
    text = text.strip()
    return text if len(text) <= 40 else text[:37] + "..."


def _shown(character: str) -> str:
    code = ord(character)
    return f"'{character}'" if character.isprintable() else f"U+{code:04X}"
