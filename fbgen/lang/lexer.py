"""Text to tokens. One regular expression cuts the text; each distinct piece is looked at once.

`Pattern.split` gives white space and tokens by turns, so the places follow from adding up
lengths, and a table from piece to kind does the rest: almost all the work is done in C. Comments,
pragmas and blank lines leave the token lists and come back as `Extra`s with the number of the token
behind them.

Kinds of tokens: an upper-case keyword; an operator as it is written (`&` is AND); and `name` (x),
`#` (#x), `"` ("x"), `#"` (#"x"), `literal`, `address` (%MW4; where the dialect has them also MW4
and the M0 of M0.1), `unterminated`, `character` for what nothing begins with, and `end` behind the
last one.

Source: IEC 61131-3, lexical elements; TIA Portal help, "SCL", and published sources for raw REGION
and TITLE lines and for comments in comments.
"""

import re
from bisect import bisect_left
from functools import cache
from itertools import accumulate, compress
from typing import NamedTuple

from fbgen.dataclass import dataclass
from fbgen.diagnostics import Diagnostic
from fbgen.lang.ast import Trivia, TriviaKind
from fbgen.lang.dialects.dialect import Dialect, Feature
from fbgen.lang.dialects.words import words
from fbgen.source import Source, Span

_KEYWORDS = words(
    "IF THEN ELSIF ELSE END_IF CASE OF END_CASE FOR TO BY DO END_FOR WHILE END_WHILE REPEAT UNTIL "
    "END_REPEAT EXIT CONTINUE RETURN GOTO END_REGION AND OR XOR NOT MOD "
    "FUNCTION_BLOCK END_FUNCTION_BLOCK FUNCTION END_FUNCTION ORGANIZATION_BLOCK "
    "END_ORGANIZATION_BLOCK PROGRAM END_PROGRAM DATA_BLOCK END_DATA_BLOCK TYPE END_TYPE "
    "CONFIGURATION END_CONFIGURATION RESOURCE END_RESOURCE BEGIN STRUCT END_STRUCT ARRAY "
    "VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_GLOBAL VAR_EXTERNAL END_VAR "
    "VAR_STAT VAR_INST METHOD END_METHOD PROPERTY END_PROPERTY END_GET END_SET ACTION END_ACTION "
    "INTERFACE END_INTERFACE NAMESPACE END_NAMESPACE CLASS END_CLASS USING END_UNION JMP"
)
_FEATURE_KEYWORDS = {
    Feature.DIV_OPERATOR: words("DIV"),
    Feature.SHORT_CIRCUIT: words("AND_THEN OR_ELSE"),
    Feature.CONST_SECTIONS: words("CONST END_CONST"),
    Feature.LABEL_SECTIONS: words("LABEL END_LABEL"),
    Feature.OBJECTS: words("VAR_GENERIC VAR_CONFIG"),
    Feature.EXCEPTIONS: words("__TRY __CATCH __FINALLY __ENDTRY"),
}
"""Keywords of the dialects that have the feature; elsewhere these words are names."""

_PATTERN = (
    r"(\s*+)("
    # raw lines come before names, they may hold anything
    r"{raw}"
    # names, and literals that begin with a type: T#5s, WORD#16#FF, D#2024-02-29, STRING#'x'
    r"(?:[A-Za-z_][A-Za-z0-9_]*+\w*+|[^\W\d]\w*+)(?:#(?:'(?:[^'$\r\n]|\$(?:>\s*+\$<|[^\r\n]))*+'"
    # ... and P#DB1.DBX0.0 BYTE 10, and B#(1, 2)
    r"|(?<=\b[Pp]\#)(?:[Dd][BbIi][0-9]++\.)?[A-Za-z]*+[ \t]*+[0-9]++\.[0-7]"
    r"(?:[ \t]++[A-Za-z_]++[ \t]++[0-9]++)?+"
    r"|(?<=\b[BbWw]\#)\([0-9,# \t]*+\)|(?<=\b[Dd][Ww]\#)\([0-9,# \t]*+\)"
    r"|{short_years}[0-9]{{4}}-[0-9]{{1,2}}-[0-9]{{1,2}}(?:-[0-9:]++(?:\.[0-9_]++)?)?"
    r"|[0-9]{{1,2}}:[0-9][0-9:]*+(?:\.[0-9_]++)?"
    r"|[+-]?[0-9][0-9_]*+[eE][+-][0-9]++"
    r"|[+-]?\w++(?:\#\w++)?(?:\.[0-9]\w*+(?:(?<=[eE])[+-][0-9]++)?)?))?+"
    # operators and signs, with comments where they begin alike; no end means the end of the text
    r"|[;,)\]\[&^]|:=?|=>?|\.\.?|<[=>]?|>=?|\+=?|-=?|\*[*=]?|\?=?"
    r"|\((?:\*[^*]*+(?:\*(?!\))[^*]*+)*+(?:\*\))?+|/\*[^*]*+(?:\*(?!/\))[^*]*+)*+(?:\*/\))?+)?+"
    r"|/(?:/[^\r\n]*+|\*[^*]*+(?:\*(?!/)[^*]*+)*+(?:\*/)?+|=)?+"
    # local names, numbers with whatever letters are glued to them
    r"|\#(?:[^\W\d]\w*+|\"[^\"\r\n]*+\")?+"
    r"|[0-9][0-9_]*+(?:\#\w*+|(?:\.[0-9][0-9_]*+)?(?:[eE][+-]?[0-9]++)?\w*+)"
    # quoted names and strings end in their line, or in the next one where that is clear
    r"|\"{quoted}*+\"?+"
    r"|'(?:[^'$\r\n]|\$(?:>\s*+\$<|[^\r\n]))*+(?:'{next_line})?+"
    # absolute addresses and slices; pragmas
    r"|%(?:[A-Za-z]++(?:\*|[0-9]*+(?:\.\w++)*+(?::[Pp]\b)?))?+"
    r"|\{{\{{(?:[^}}]++|\}}(?!\}}))*+(?:\}}\}})?+"  # code in C of OpenPLC and Beremiz
    r"|\{{(?:[^}}']++|'[^'\r\n]*+'|')*+\}}?+"
    # anything else
    r"|\S)"
)
_NEXT_LINE = r"|\r?\n[^'\r\n]*+'(?=[ \t]*+[;,)])"
_SHORT_YEARS = r"(?<=\b[Dd][Tt]\#)[0-9]{2}(?:-[0-9]{1,2}){2}-[0-9:]++(?:\.[0-9_]++)?|"
"""`DT#90-1-1-0:0:0.000`, as the sources have it that STEP 7 V5 writes."""
_RAW_LINES = (
    r"[Rr](?<!\..)(?i:EGION)(?!\w)(?![ \t]*+(?::=|[:;,)\]]))[^\r\n]*+"
    r"|[Ee](?<!\..)(?i:ND_REGION)(?!\w)[^\r\n]*+|"
)
PLAIN_ADDRESS = re.compile(
    r"(?:(?P<area>P?[IEQA]|M)(?P<size>[XBWD]?)|(?P<count>[TCZ]))(?P<number>[0-9]{1,9})\Z"
)
"""The spelling of `MW4`, `PEB256`, `T5` in upper case, and of the `M0` of `M0.1`."""

_RAW_WORD = re.compile(r"(?:END_)?REGION\b")
_BLANK_LINE = re.compile(r"\n[^\S\n]*+\n")

_TRIVIA = {
    "//": TriviaKind.LINE_COMMENT,
    "(*": TriviaKind.BLOCK_COMMENT,
    "{": TriviaKind.PRAGMA,
}
_COMMENT_ENDS = {"(*": "*)", "(/": "*/)", "/*": "*/"}
_COMMENT_MARK = re.compile(r"\(\*|\*\)")


class Extra(NamedTuple):
    """Trivia in front of the token number `token`; `same_line` if it ends the line before."""

    token: int
    same_line: bool
    trivia: Trivia


@dataclass(frozen=True, slots=True)
class Tokens:
    """The tokens as lists of equal length (the last one has kind `end`), trivia in order apart."""

    source: Source
    kinds: list[str]
    texts: list[str]
    starts: list[int]
    ends: list[int]
    extras: list[Extra]
    diagnostics: list[Diagnostic]


def tokenize(source: Source, dialect: Dialect) -> Tokens:
    """Cut a source into tokens. Never fails: what is no token has kind `character`."""
    pattern = _pattern(
        dialect.has(Feature.REGIONS),
        dialect.has(Feature.QUOTED_NAMES),
        dialect.has(Feature.LONG_TEXTS),
        dialect.has(Feature.PLAIN_ADDRESSES),
    )
    tokens = _cut(source, pattern.split(source.text), dialect)
    opened = source.text.count("(*") + source.text.count("/*")
    if opened > tokens.kinds.count("(*") and any(map(_may_nest, tokens.texts)):
        tokens = _cut(source, _split_nested(pattern, source.text), dialect)
    return _without_trivia(tokens)


def _cut(source: Source, parts: list[str], dialect: Dialect) -> Tokens:
    """Tokens from what `split` gives: nothing, white space, token, and so on by turns."""
    del parts[0::3]
    offsets = list(accumulate(map(len, parts)))
    starts, ends, texts = offsets[0::2], offsets[1::2], parts[1::2]
    kinds = list(map(_kinds(dialect).__getitem__, texts))
    length = len(source.text)
    starts.append(length)
    ends.append(length)
    texts.append("")
    kinds.append("end")
    return Tokens(source, kinds, texts, starts, ends, [], [])


@cache
def _pattern(
    raw_lines: bool, quoted_names: bool, long_texts: bool, short_years: bool
) -> re.Pattern[str]:
    body = _PATTERN.format(
        raw=_RAW_LINES if raw_lines else "",
        next_line=_NEXT_LINE if long_texts else "",
        short_years=_SHORT_YEARS if short_years else "",
        quoted=r"[^\"\r\n]" if quoted_names else r"(?:[^\"$\r\n]|\$[^\r\n])",
    )
    return re.compile(body)


_MOST_PIECES = 20_000
"""Distinct pieces that a table keeps from one text to the next: some megabytes."""


def _kinds(dialect: Dialect) -> "_Kinds":
    """The table of a dialect: texts of one program have most of their pieces in common."""
    known = _TABLES.get(dialect.features)
    if known is None or len(known) > _MOST_PIECES:
        known = _TABLES[dialect.features] = _Kinds(dialect)
    return known


class _Kinds(dict[str, str]):
    """From a piece of text to its kind, worked out once for each distinct piece."""

    def __init__(self, dialect: Dialect) -> None:
        super().__init__()
        self._keywords = _KEYWORDS.union(
            *(more for feature, more in _FEATURE_KEYWORDS.items() if dialect.has(feature))
        )
        self._plain_addresses = dialect.has(Feature.PLAIN_ADDRESSES)
        self._raw_lines = dialect.has(Feature.REGIONS)
        self._quote = '"' if dialect.has(Feature.QUOTED_NAMES) else "literal"

    def __missing__(self, text: str) -> str:
        kind = self[text] = self._kind(text)
        return kind

    def _kind(self, text: str) -> str:
        first = text[0]
        if first.isalpha() or first == "_":
            return self._word(text)
        if first in "0123456789":
            return "literal"
        if first == "#":
            return "character" if len(text) == 1 else text[:2] if text[1] == '"' else "#"
        if first in "'\"":
            if len(text) < 2 or text[-1] != first:
                return "unterminated"
            return self._quote if first == '"' else "literal"
        if text[:2] == "//":
            return "//"
        if text[:2] in _COMMENT_ENDS:
            return "(*"
        if first == "{":
            return "{"
        if first == "%":
            return "address" if len(text) > 1 else "character"
        if text == "&":
            return "AND"
        return text if first in "-+*/()[];:,.<>=^" or text == "?=" else "character"

    def _word(self, text: str) -> str:
        upper = text.upper()
        if upper in self._keywords:
            return upper
        if upper in ("TRUE", "FALSE"):
            return "literal"
        if self._raw_lines and (line := _RAW_WORD.match(upper)):
            return line[0]
        if "#" in text:
            return "literal"
        return "address" if self._plain_addresses and PLAIN_ADDRESS.match(upper) else "name"


_TABLES: dict[frozenset[Feature], _Kinds] = {}


def _may_nest(piece: str) -> bool:
    return piece.startswith("(*") and "(*" in piece[2:]


def _split_nested(pattern: re.Pattern[str], text: str) -> list[str]:
    """As `pattern.split`, with comments in comments where they balance.

    A comment that is opened twice and closed once is read to its first end, and from there on
    nothing nests: so the time stays linear whatever the text is.
    """
    parts: list[str] = []
    position, nesting = 0, True
    while match := pattern.match(text, position):
        start, end = match.span(2)
        piece = match[2]
        if nesting and _may_nest(piece):
            balanced = _balanced_end(text, start)
            nesting = balanced is not None
            end = balanced or end
        parts += ("", match[1], text[start:end])
        position = end
    parts.append(text[position:])
    return parts


def _balanced_end(text: str, start: int) -> int | None:
    depth = 0
    for mark in _COMMENT_MARK.finditer(text, start):
        depth += 1 if mark[0] == "(*" else -1
        if depth == 0:
            return mark.end()
    return None


def _without_trivia(tokens: Tokens) -> Tokens:
    """Move comments, pragmas and blank lines from the lists to the extras."""
    kinds, texts, starts, ends = tokens.kinds, tokens.texts, tokens.starts, tokens.ends
    source = tokens.source
    found = _trivia_places(kinds) + _blank_line_places(source.text, starts, ends)
    if not found:
        return tokens
    found.sort()
    keep = [True] * len(kinds)
    removed = 0
    for k, is_trivia in found:
        if not is_trivia:
            place = Span(source, ends[k - 1], starts[k])
            blank = Trivia(place, TriviaKind.BLANK_LINE, "")
            tokens.extras.append(Extra(k - removed, False, blank))
            continue
        place = Span(source, starts[k], ends[k])
        text = texts[k]
        _check_closed(text, place, tokens.diagnostics)
        trivia = Trivia(place, _TRIVIA[kinds[k]], text.replace("\r\n", "\n"))
        same_line = k > 0 and "\n" not in source.text[ends[k - 1] : starts[k]]
        if same_line and kinds[k + 1] not in _TRIVIA and kinds[k + 1] != "end":
            same_line = "\n" in source.text[ends[k] : starts[k + 1]]
        tokens.extras.append(Extra(k - removed, same_line, trivia))
        keep[k] = False
        removed += 1
    if not removed:
        return tokens
    return Tokens(
        source,
        list(compress(kinds, keep)),
        list(compress(texts, keep)),
        list(compress(starts, keep)),
        list(compress(ends, keep)),
        tokens.extras,
        tokens.diagnostics,
    )


def _trivia_places(kinds: list[str]) -> list[tuple[int, bool]]:
    """The numbers of all tokens that are trivia, each with True."""
    return [(at, True) for at, kind in enumerate(kinds) if kind in _TRIVIA]


def _blank_line_places(text: str, starts: list[int], ends: list[int]) -> list[tuple[int, bool]]:
    """The numbers of all tokens with blank lines in front of them, each with False."""
    places: dict[int, bool] = {}
    for blank in _BLANK_LINE.finditer(text):
        k = bisect_left(starts, blank.end())
        if 0 < k < len(starts) - 1 and ends[k - 1] <= blank.start():
            places[k] = False
    return list(places.items())


def _check_closed(text: str, place: Span, diagnostics: list[Diagnostic]) -> None:
    """Report a comment or a pragma that reaches to the end of the text."""
    end = "}" if text[0] == "{" else _COMMENT_ENDS.get(text[:2], "")
    if end and not (text.endswith(end) and len(text) >= len(end) + 2 - (end == "}")):
        what = "pragma" if end == "}" else "comment"
        opening = Span(place.source, place.start, place.start + min(len(text), 2))
        diagnostics.append(
            Diagnostic("FB3003", f"this {what} has no end", opening, f"close it with {end}")
        )
