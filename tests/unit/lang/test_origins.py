"""Marks in rendered text become origins of lines in what is printed."""

from trees import found_in

from fbgen.lang.origins import mark, strip_marks
from fbgen.lang.parser import parse
from fbgen.lang.printer import print_file
from fbgen.source import TEMPLATE, Origin, Source

_LINE = [Origin(TEMPLATE, "pump.jinja", n) for n in range(1, 6)]
_VALUE = Origin("ComNo FA01", "vf-s11.yaml", 40, "manual, section 7")
_ORIGINS = {f"t{n}": line for n, line in enumerate(_LINE)} | {"5": _VALUE}


def test_marks_vanish_and_leave_offsets() -> None:
    text, places = strip_marks(f"{mark('t0')}ab{mark('5')}16{mark()}c", _ORIGINS)
    assert text == "ab16c"
    assert places == ((0, _LINE[0]), (2, _VALUE), (4, _LINE[0]))
    source = Source("x", text, places)
    assert [source.origin_at(at) for at in range(5)] == [_LINE[0]] * 2 + [_VALUE] * 2 + [_LINE[0]]


def test_of_two_marks_at_one_place_the_last_counts() -> None:
    _, places = strip_marks(f"{mark('t0')}{mark('5')}x", _ORIGINS)
    assert places == ((0, _VALUE),)


def test_a_mark_that_a_template_made_up_is_the_end_of_a_value() -> None:
    _, places = strip_marks(f"{mark('t1')}ab{mark('5')}16{mark('777')}c", _ORIGINS)
    assert places == ((0, _LINE[1]), (2, _VALUE), (4, _LINE[1]))


def test_no_mark_in_front_is_no_origin() -> None:
    assert strip_marks(f"ab{mark()}c{mark('t0')}d", _ORIGINS) == ("abcd", ((3, _LINE[0]),))


def test_a_mark_in_a_persons_file_is_an_ordinary_wrong_character() -> None:
    (found,) = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\nx := {mark()};\nEND_FUNCTION_BLOCK')
    assert (found.code, "U+E000" in found.message) == ("FB3002", True)


def test_each_printed_line_knows_where_it_came_from() -> None:
    rendered = (
        f'{mark("t0")}FUNCTION_BLOCK "B"\n'
        f"{mark('t1')}VAR a : Word; END_VAR\nBEGIN\n"
        f"{mark('t2')}IF TRUE THEN\n"
        f"{mark('t3')}   #a := {mark('5')}16#FA01{mark('t3')};\n"
        f"{mark('t4')}END_IF;\nEND_FUNCTION_BLOCK\n"
    )
    text, places = strip_marks(rendered, _ORIGINS)
    printed = print_file(parse(Source("B.scl", text, places), "tia"))
    origins = dict(zip(printed.text.splitlines(), printed.origins, strict=True))
    assert origins['FUNCTION_BLOCK "B"'] == (_LINE[0],)
    assert origins["      a : Word;"] == (_LINE[1],)
    assert origins["   IF TRUE THEN"] == (_LINE[2],)
    assert origins["      #a := 16#FA01;"] == (_LINE[3], _VALUE)
    assert origins["   END_IF;"] == (_LINE[4],)
