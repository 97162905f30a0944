"""The `iec` text read by a parser that we did not write: blark, for TwinCAT's Structured Text.

It has no CONFIGURATION, which TwinCAT keeps outside of its text; all else must be read whole. The
parser takes half a minute for a plant, and most units are those of dialect `twincat` word for word:
these are read there (`test_xml_elsewhere`), and here only what differs.
"""

import re

import pytest
from blark.parse import parse_source_code

from tests.unit.emit.examples import generated

UNIT = re.compile(r"^(?=(?:TYPE|FUNCTION|FUNCTION_BLOCK|PROGRAM|CONFIGURATION)\b)", re.MULTILINE)
COMMENT = re.compile(r"\(\*.*?\*\)|//[^\n]*", re.DOTALL)
CODE = re.compile(r"<!\[CDATA\[(.*?)\]\]>", re.DOTALL)
END = re.compile(r"END_(?:FUNCTION|FUNCTION_BLOCK|PROGRAM)")


def units(example: str) -> list[str]:
    (file,) = generated(example, "iec")
    return [text for text in UNIT.split(file.text) if UNIT.match(text)]


def words(code: str) -> tuple[str, ...]:
    """The code without comments and blanks, and without the end, which is none of an object's."""
    found = re.findall(r"\w+|[^\w\s]", COMMENT.sub(" ", code))
    return tuple(found[:-1] if END.fullmatch(found[-1]) else found)


def words_of_objects(example: str) -> set[tuple[str, ...]]:
    return {
        words("\n".join(CODE.findall(file.text)))
        for file in generated(example, "twincat")
        if CODE.search(file.text)
    }


@pytest.mark.parametrize(
    "example", ["manual_example", pytest.param("five_drives", marks=pytest.mark.slow)]
)
def test_a_parser_of_others_reads_every_unit(example: str) -> None:
    read_there = words_of_objects(example)
    found = units(example)
    own = [text for text in found if words(text) not in read_there]
    assert len(found) - len(own) > 15
    assert {"TYPE", "FUNCTION_BLOCK", "PROGRAM"} <= {text.split()[0] for text in own}
    for text in own:
        if not text.startswith("CONFIGURATION"):
            assert parse_source_code(text).exception is None, text[:200]


def test_the_parser_of_others_reads_comments_of_the_iec_text() -> None:
    for text in units("manual_example"):
        for comment in COMMENT.findall(text):
            assert re.fullmatch(r"\(\*(?:(?!\(\*|\*\)|//).)*\*\)", comment), comment
    (handshake,) = [text for text in units("manual_example") if "TOS_Handshake\n" in text]
    assert handshake.count("(*") > 10
    assert parse_source_code(handshake).exception is None


def test_the_parser_of_others_refuses_a_broken_unit() -> None:
    (block, *_) = [text for text in units("manual_example") if "TOS_Handshake\n" in text]
    assert parse_source_code(block.replace("END_IF;", "END_FI;", 1)).exception is not None
