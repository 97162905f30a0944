"""What MATIEC would refuse in a text of dialect `iec`, as far as its grammar says.

MATIEC (iec2c, the compiler of OpenPLC and Beremiz) is no package and is not run here; these are the
limits of its scanner `stage1_2/iec_flex.ll` and of IEC 61131-3, second edition, which its grammar
follows: which words are reserved in every state, how identifiers, literals, texts and comments are
written, that every block needs a section of variables, which sections take initial values, that
END_IF and its like end with a semicolon. 64-bit types are refused although they are in the grammar:
conversions from and to them are missing in parts of its library.

It shares nothing with our own parser: it reads the text word by word.
"""

import re
from collections.abc import Iterator
from itertools import pairwise


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


RESERVED = _words(
    """
    EN ENO TRUE FALSE TIME TIME_OF_DAY TOD DATE DATE_AND_TIME DT
    BOOL BYTE WORD DWORD LWORD SINT INT DINT LINT USINT UINT UDINT ULINT REAL LREAL WSTRING STRING
    ANY ANY_DERIVED ANY_ELEMENTARY ANY_MAGNITUDE ANY_NUM ANY_REAL ANY_INT ANY_BIT ANY_STRING
    ANY_DATE
    TYPE END_TYPE ARRAY OF STRUCT END_STRUCT
    VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_EXTERNAL VAR_GLOBAL VAR_TEMP VAR_CONFIG VAR_ACCESS
    VAR END_VAR
    RETAIN NON_RETAIN CONSTANT R_EDGE F_EDGE AT
    FUNCTION END_FUNCTION FUNCTION_BLOCK END_FUNCTION_BLOCK PROGRAM END_PROGRAM
    ACTION END_ACTION TRANSITION END_TRANSITION FROM TO INITIAL_STEP STEP END_STEP
    CONFIGURATION END_CONFIGURATION TASK RESOURCE ON END_RESOURCE WITH READ_WRITE READ_ONLY
    AND OR XOR NOT MOD RETURN IF THEN ELSIF ELSE END_IF CASE END_CASE FOR BY DO END_FOR
    WHILE END_WHILE REPEAT UNTIL END_REPEAT EXIT
    """
)
ELEMENTARY = _words("BOOL BYTE WORD DWORD SINT INT DINT USINT UINT UDINT REAL TIME STRING")
FUNCTIONS = _words(
    """
    ABS SQRT LN LOG EXP SIN COS TAN ASIN ACOS ATAN ADD MUL SUB DIV EXPT MOVE SHL SHR ROR ROL
    SEL MAX MIN LIMIT MUX GT GE EQ LE LT NE LEN LEFT RIGHT MID CONCAT INSERT DELETE REPLACE FIND
    TRUNC
    """
) | {f"{one}_TO_{other}" for one in ELEMENTARY for other in ELEMENTARY if one != other}
BLOCKS = _words("SR RS R_TRIG F_TRIG CTU CTD CTUD TP TON TOF")
ENDS = _words("END_IF END_CASE END_FOR END_WHILE END_REPEAT")
SECTIONS = _words("VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_EXTERNAL VAR_GLOBAL VAR_TEMP VAR")
WITHOUT_INITIALS = _words("VAR_TEMP VAR_IN_OUT VAR_EXTERNAL")
UNITS = ("FUNCTION_BLOCK", "FUNCTION", "PROGRAM")

_TOKEN = re.compile(
    r"""
      (?P<comment>\(\*.*?\*\))
    | (?P<space>\s+)
    | (?P<text>'(?:[\x20\x21\x23\x25\x26\x28-\x7E]|\$[LNPRTlnprt$']|\$[0-9A-Fa-f]{2}|")*')
    | (?P<duration>(?:T|TIME)\#-?(?:\d+d_?)?(?:\d+h_?)?(?:\d+m_?)?(?:\d+s_?)?
        (?:\d+(?:\.\d+)?ms)?(?![\w.]))
    | (?P<direct>%[IQM][XBWDL]?\d+(?:\.\d+)*)
    | (?P<based>(?:2\#[01]+|8\#[0-7]+|16\#[0-9A-F]+)(?:_[0-9A-F]+)*(?![\w.]))
    | (?P<real>\d+\.\d+(?:[Ee][+-]?\d+)?(?![\w.]))
    | (?P<whole>\d+(?:_\d+)*(?![\w]))
    | (?P<name>[A-Za-z_]\w*)
    | (?P<sign>:=|=>|<>|>=|<=|\.\.|\*\*|[-+*/&=<>()\[\],;:.])
    """,
    re.VERBOSE | re.DOTALL,
)
_IDENTIFIER = re.compile(r"(?:[A-Za-z]|_[A-Za-z0-9])(?:_?[A-Za-z0-9])*")

Token = tuple[str, str, int]
"""Kind, text (names in upper case), line."""


def refused(text: str) -> list[str]:
    """Everything that MATIEC would not take, with its line."""
    tokens, found = _tokens(text)
    return [*found, *_declarations(tokens), *_statements(tokens)]


def _tokens(text: str) -> tuple[list[Token], list[str]]:
    tokens: list[Token] = []
    found: list[str] = []
    at, line = 0, 1
    while at < len(text):
        match = _TOKEN.match(text, at)
        if match is None:
            found.append(f"{line}: no token begins with {text[at : at + 12]!r}")
            at = len(text) if "\n" not in text[at:] else text.index("\n", at)
            continue
        kind, value = str(match.lastgroup), match.group()
        if kind == "comment" and "(*" in value[2:]:
            found.append(f"{line}: a comment in a comment")
        if kind == "name" and _IDENTIFIER.fullmatch(value) is None:
            found.append(f"{line}: {value} has an underscore at its end, or two in a row")
        if kind not in ("comment", "space"):
            tokens.append((kind, value.upper() if kind == "name" else value, line))
        line += value.count("\n")
        at = match.end()
    return tokens, found


def _declarations(tokens: list[Token]) -> Iterator[str]:
    """Names, types that are there before they are used, sections and their initial values."""
    known = set(BLOCKS | ELEMENTARY)
    section = unit = ""
    sections = 0
    for index, (kind, text, line) in enumerate(tokens):
        before = tokens[index - 1][1] if index else ""
        behind = tokens[index + 1][1] if index + 1 < len(tokens) else ""
        if kind == "direct" and (before != "AT" or section != "VAR_GLOBAL"):
            yield f"{line}: {text} is no located global variable"
        if kind != "name":
            if text == ":=" and section in WITHOUT_INITIALS:
                yield f"{line}: {section} takes no initial values"
            continue
        if text in UNITS:
            unit, sections = text, 0
            known.add(behind)
            yield from _wrong_name(behind, line)
        elif text in SECTIONS:
            section, sections = text, sections + 1
            if text == "VAR_TEMP" and unit == "FUNCTION":
                yield f"{line}: a FUNCTION has no VAR_TEMP"
        elif text == "END_VAR":
            section = ""
        elif text.startswith("END_") and text[4:] in UNITS:
            if not sections:
                yield f"{line}: the {unit} has no section of variables"
            unit = ""
        elif text == "STRUCT" and before == ":":
            section = "STRUCT"
            known.add(tokens[index - 2][1])
        elif text == "END_STRUCT":
            section = ""
        elif section and behind in (":", "AT") and before != ".":
            yield from _wrong_name(text, line)
        elif section and before in (":", "OF") and text not in known | {"ARRAY", "STRUCT"}:
            yield f"{line}: the type {text} is not there yet"


def _wrong_name(name: str, line: int) -> Iterator[str]:
    if name in RESERVED or name in FUNCTIONS or name in BLOCKS:
        yield f"{line}: the name {name} is taken"


def _statements(tokens: list[Token]) -> Iterator[str]:
    """What is called, how compound statements end, that none is empty."""
    units = {tokens[index + 1][1] for index, token in enumerate(tokens[:-1]) if token[1] in UNITS}
    instances = {
        tokens[index][1]
        for index in range(len(tokens) - 2)
        if tokens[index + 1][1] == ":" and tokens[index + 2][1] in units | BLOCKS
    }
    instances |= {
        tokens[index + 1][1] for index, token in enumerate(tokens[:-1]) if token[1] == "TASK"
    }
    callable_names = units | instances | FUNCTIONS | {"NOT", "AND", "OR", "XOR", "MOD", "STRING"}
    for (kind, text, line), (_, behind, _) in pairwise(tokens):
        if kind == "name" and text in ENDS and behind != ";":
            yield f"{line}: {text} without a semicolon"
        if text in ("+", "-", "*", "/") and behind in ("=", "/"):
            yield f"{line}: {text}{behind} is no operator"
        if text in ("THEN", "ELSE", "DO") and behind in ENDS | {"ELSE", "ELSIF"}:
            yield f"{line}: nothing stands behind {text}"
        if kind == "name" and behind == "(" and text not in RESERVED | callable_names:
            yield f"{line}: {text} is no function that is there"
