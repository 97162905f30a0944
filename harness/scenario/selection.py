"""`fbgen test -k EXPR`: which scenarios to run, as `start and not reverse`.

A word stands for all scenarios whose title, file name, variation or tags contain it, whatever the
case; a text in quotes does the same with blanks in it. `and`, `or`, `not` and parentheses combine
them as in Python: `not` before `and` before `or`.
"""

import re
from collections.abc import Callable, Sequence
from typing import TypeAlias

from fbgen.diagnostics import DiagnosticError, error
from fbgen.source import Source, Span

Selection: TypeAlias = Callable[[Sequence[str]], bool]
"""Whether a scenario with these names is chosen."""

_TOKEN = re.compile(r"\s*(?:(?P<mark>[()])|(?P<text>\"[^\"]*\"|'[^']*')|(?P<word>[^\s()\"']+))")
_OPERATORS = ("and", "or", "not")
_DEEPEST = 50


def parse_selection(expression: str) -> Selection:
    """The meaning of an expression; an empty one chooses everything.

    Raises DiagnosticError FB8011 for what is no expression.
    """
    if not expression.strip():
        return lambda names: True
    reader = _Reader(expression)
    chosen = reader.either()
    if reader.token:
        raise reader.wrong(f"found '{reader.token}' where 'and' or 'or' belongs")
    return chosen


class _Reader:
    """Reads an expression by recursive descent; `token` is the next piece, "" at the end."""

    def __init__(self, expression: str) -> None:
        self._source = Source("-k", expression)
        self._position = self._start = 0
        self._depth = 0
        self.token = ""
        self._next()

    def _next(self) -> None:
        match = _TOKEN.match(self._source.text, self._position)
        self._start = self._position
        if match is None:
            rest = self._source.text[self._position :]
            self._start += len(rest) - len(rest.lstrip())
            self.token = ""
            if rest.strip():
                raise self.wrong("a quote is not closed")
            return
        self.token = match[match.lastgroup or 0]
        self._start = match.end() - len(self.token)
        self._position = match.end()

    def wrong(self, message: str) -> DiagnosticError:
        """FB8011 at the present piece."""
        end = min(self._start + max(len(self.token), 1), len(self._source.text))
        advice = "combine words with and, or, not and parentheses: 'start and not reverse'"
        return error("FB8011", message, Span(self._source, self._start, end), advice)

    def either(self) -> Selection:
        """a or b or c"""
        parts = [self._both()]
        while self.token == "or":
            self._next()
            parts.append(self._both())
        return parts[0] if len(parts) == 1 else lambda names: any(part(names) for part in parts)

    def _both(self) -> Selection:
        parts = [self._negated()]
        while self.token == "and":
            self._next()
            parts.append(self._negated())
        return parts[0] if len(parts) == 1 else lambda names: all(part(names) for part in parts)

    def _negated(self) -> Selection:
        negations = 0
        while self.token == "not":
            negations += 1
            self._next()
        operand = self._operand()
        return operand if negations % 2 == 0 else lambda names: not operand(names)

    def _operand(self) -> Selection:
        if self.token == "(":
            self._depth += 1
            if self._depth > _DEEPEST:
                raise self.wrong(f"more than {_DEEPEST} parentheses inside each other")
            self._next()
            inner = self.either()
            if self.token != ")":
                raise self.wrong("a parenthesis is not closed")
            self._depth -= 1
            self._next()
            return inner
        if not self.token or self.token == ")" or self.token in _OPERATORS:
            found = f"found '{self.token}'" if self.token else "the expression ends"
            raise self.wrong(f"{found} where a word belongs")
        quoted = self.token[0] in "\"'"
        wanted = (self.token[1:-1] if quoted else self.token).casefold()
        self._next()
        return lambda names: any(wanted in name.casefold() for name in names)
