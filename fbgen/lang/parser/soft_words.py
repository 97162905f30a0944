"""Words that begin something only where a name follows, and are names everywhere else.

`METHOD Start : BOOL` begins a method, `Method := 3;` assigns to a variable, and older programs have
variables, types and members called Action, Class or Interface.
"""

from fbgen.lang.dialects.words import words

SOFT_WORDS = words("METHOD PROPERTY ACTION INTERFACE NAMESPACE CLASS USING JMP")
"""Read as keywords first; `settle_soft_words` makes names of those that are none."""

_NO_KEYWORD_BEHIND = words("FUNCTION_BLOCK FUNCTION PROGRAM ORGANIZATION_BLOCK CLASS INTERFACE") | {
    ".",
    ":=",
    ",",
    "(",
    "[",
    "=",
}


def settle_soft_words(kinds: list[str], texts: list[str]) -> None:
    """Give the kind `name` to each soft word that does not stand where its keyword can."""
    for word in SOFT_WORDS.intersection(kinds):
        at = -1
        for _ in range(kinds.count(word)):
            at = kinds.index(word, at + 1)
            is_type = kinds[at - 1] == ":" and word != "JMP"
            follows = kinds[at + 1] in ("name", '"') or kinds[at + 1] in SOFT_WORDS
            if not follows or is_type or (at and kinds[at - 1] in _NO_KEYWORD_BEHIND):
                kinds[at] = "name"
