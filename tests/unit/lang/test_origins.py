"""Marks in rendered text become origins of lines in what is printed."""

import pytest
from trees import found_in

from fbgen.lang.origins import mark, strip_marks
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import TEMPLATE, Origin, Source

_LINE = [Origin(TEMPLATE, "pump.jinja", n) for n in range(1, 6)]
_VALUE = Origin("ComNo FA01", "vf-s11.yaml", 40, "manual, section 7")


def test_marks_vanish_and_leave_offsets() -> None:
    text, places = strip_marks(f"{mark(0)}ab{mark(1)}16{mark(None)}c", [_LINE[0], _VALUE])
    assert text == "ab16c"
    assert places == ((0, _LINE[0]), (2, _VALUE), (4, None))
    source = Source("x", text, places)
    assert [source.origin_at(at) for at in range(5)] == [_LINE[0]] * 2 + [_VALUE] * 2 + [None]


def test_of_two_marks_at_one_place_the_last_counts() -> None:
    _, places = strip_marks(f"{mark(0)}{mark(1)}x", [_LINE[0], _VALUE])
    assert places == ((0, _VALUE),)


def test_a_mark_without_origin_is_our_own_mistake() -> None:
    with pytest.raises(ValueError, match="mark 7"):
        strip_marks(mark(7), [])


def test_a_mark_in_a_persons_file_is_an_ordinary_wrong_character() -> None:
    (found,) = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\nx := {mark(0)};\nEND_FUNCTION_BLOCK')
    assert (found.code, "U+E000" in found.message) == ("FB3002", True)


def test_each_printed_line_knows_where_it_came_from() -> None:
    rendered = (
        f'{mark(0)}FUNCTION_BLOCK "B"\n'
        f"{mark(1)}VAR a : Word; END_VAR\nBEGIN\n"
        f"{mark(2)}IF TRUE THEN\n"
        f"{mark(3)}   #a := {mark(5)}16#FA01{mark(3)};\n"
        f"{mark(4)}END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    text, places = strip_marks(rendered, [*_LINE, _VALUE])
    printed = print_file(parse(Source("B.scl", text, places), "tia"))
    origins = dict(zip(printed.text.splitlines(), printed.origins, strict=True))
    assert origins['FUNCTION_BLOCK "B"'] == (_LINE[0],)
    assert origins["      a : Word;"] == (_LINE[1],)
    assert origins["   IF TRUE THEN"] == (_LINE[2],)
    assert origins["      #a := 16#FA01;"] == (_LINE[3], _VALUE)
    assert origins["   END_IF;"] == (_LINE[4],)
