"""Keywords that are misspelt, read as what they must mean: nothing is reported behind them.

Only asked where a statement or a section could not be read. `ENDIF`, `END IF` and `ELSEIF` are
known; the first word of a head is told by the last one in its line: `FRO i := 0 TO 7 DO`.
"""

from collections.abc import Iterable, Sequence

from fbgen.dataclass import dataclass
from fbgen.lang.parser.slips import WORDS
from fbgen.nearest import near_names

_LOOPS = {"FOR", "WHILE", "CASE", "IF", "REPEAT"}
_LAST_WORDS = ("THEN", "DO", "OF")
_ALIKE = 0.8
CONSTANT_SECTIONS = ("VAR_CONST", "VAR_CONSTANT")
"""Words for VAR CONSTANT that no dialect has."""


@dataclass(frozen=True, slots=True)
class Meant:
    """The keyword that is meant, and how many tokens of it stand in front of the last one."""

    keyword: str
    before: int = 0


def meant_keyword(kinds: Sequence[str], texts: Sequence[str], line: Iterable[int]) -> Meant | None:
    """What a statement must begin with; `line` has the tokens in its line, from its first on."""
    numbers = list(line)
    first = numbers[0]
    word = texts[first].upper()
    if kinds[first] != "name":
        return None
    if word in WORDS:
        return Meant(WORDS[word])
    if word == "END" and kinds[first + 1] in _LOOPS:
        return Meant(f"END_{kinds[first + 1]}", 1)
    behind = [kinds[number] for number in numbers[1:]]
    last = next((kind for kind in behind if kind in _LAST_WORDS), "")
    if last == "THEN":
        return Meant("ELSIF" if word.startswith("E") else "IF")
    if last == "DO":
        return Meant("FOR" if "TO" in behind else "WHILE")
    return Meant("CASE") if last == "OF" else None


def meant_section(word: str, sections: Iterable[str]) -> str:
    """The section that a word begins which stands in front of a declaration; empty for none."""
    if word.upper() in CONSTANT_SECTIONS:
        return "VAR"
    near = near_names(word, sections, _ALIKE)
    return near[0] if near else ""
