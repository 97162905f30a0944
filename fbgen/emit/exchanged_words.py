"""Texts that are alike but for digits in names: which words became which, and what that proves.

Two texts are alike if one becomes the other by an exchange of words. The exchanged words are names,
or direct addresses of inputs and outputs, and differ in digits alone: so lengths, and with them the
places where lines are broken, stay. No two words become one, none of them is reserved, and none
becomes a word that the text has anyway. What reads, checks or prints such a text cannot tell it
from the other one, as long as the names mean the same there: see `fbgen.emit.twins`.
"""

import re
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache

from fbgen.lang.dialects import DIALECTS
from fbgen.lang.dialects.words import STANDARD_NAMES

Pairs = set[tuple[str, str]]
"""Pieces of a text and what stands in their places, equal ones among them."""

_PIECE = re.compile(r"(%?\b(?:[0-9]\w*(?:#\w+)?|[A-Za-z_]+[0-9]\w*))")
"""Words with digits: numbers with their base, names, direct addresses. `split` keeps all else."""
_NAME = re.compile(r"[^\W0-9]\w*")
_ADDRESS = re.compile(r"%[IQ][BWDX][0-9]+")
_DIGIT = re.compile(r"[0-9]")
_OF_THE_USER = frozenset({"main", "ob1", "startup", "ob100"})
"""Blocks that an import rule knows by their names."""


def pieces_of(text: str) -> list[str]:
    """The text in pieces: every second one is a word with digits."""
    return _PIECE.split(text)


def words_of(text: str) -> set[str]:
    """The words with digits in lower case, as names count; addresses without their `%`."""
    return {word.casefold().lstrip("%") for word in _PIECE.findall(text)}


def is_address(word: str) -> bool:
    """Whether it is the address of an input or an output."""
    return _ADDRESS.fullmatch(word) is not None


def exchange(pairs: Pairs) -> dict[str, str] | None:
    """What each word becomes that does not stay; None if that is no exchange as it should be."""
    words = {before: after for before, after in pairs if before != after}
    stay = {before for before, after in pairs if before == after}
    if len(words) + len(stay) != len(pairs) or not stay.isdisjoint(words):
        return None
    return words if all(_differ_in_digits(*pair) for pair in words.items()) else None


def exchanged(pieces: Sequence[str], words: Mapping[str, str]) -> str:
    """The text of these pieces with the words exchanged."""
    return "".join([words.get(piece, piece) for piece in pieces])


def is_one_to_one(words: Mapping[str, str], in_text: Iterable[str]) -> bool:
    """Whether no two words become one, whatever their case, and none means something anyway.

    `in_text` are all words of the text before, in lower case.
    """
    before = {word.casefold().lstrip("%") for word in words}
    after = {word.casefold().lstrip("%") for word in words.values()}
    return (
        len(before) == len(after) == len(words)
        and after.isdisjoint(set(in_text) - before)
        and not any(_is_reserved(word) for word in before | after)
    )


def _differ_in_digits(before: str, after: str) -> bool:
    may_be = _NAME.fullmatch(before) is not None or is_address(before)
    return may_be and _DIGIT.sub("0", before) == _DIGIT.sub("0", after)


@lru_cache(10_000)
def _is_reserved(word: str) -> bool:
    known = (STANDARD_NAMES, *(dialect.reserved for dialect in DIALECTS.values()))
    return word in _OF_THE_USER or any(word.upper() in words for words in known)
