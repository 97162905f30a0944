"""Cutting a text into tokens."""

import pytest

from fbgen.lang.ast import TriviaKind
from fbgen.lang.dialects import DIALECTS
from fbgen.lang.lexer import Tokens, tokenize
from fbgen.source import Source


def tokens_of(text: str, dialect: str = "tia") -> Tokens:
    return tokenize(Source("test", text), DIALECTS[dialect])


def cut(text: str, dialect: str = "tia") -> list[tuple[str, str]]:
    tokens = tokens_of(text, dialect)
    return list(zip(tokens.kinds, tokens.texts, strict=True))[:-1]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("speed", "name"),
        ("Größe", "name"),
        ("#speed", "#"),
        ('"DB 1"', '"'),
        ('#"odd name"', '#"'),
        ("iF", "IF"),
        ("&", "AND"),
        ("TRUE", "literal"),
        ("16#FF_FF", "literal"),
        ("1.5E-3", "literal"),
        ("T#1d_2h3m4s5ms", "literal"),
        ("TIME#-5s", "literal"),
        ("WORD#16#00FF", "literal"),
        ("INT#-5", "literal"),
        ("REAL#1.0E-3", "literal"),
        ("REAL#1E-3", "literal"),
        ("LREAL#-3e+38", "literal"),
        ("D#2024-02-29", "literal"),
        ("DT#2024-02-29-12:00:00.5", "literal"),
        ("TOD#23:59:59.999", "literal"),
        ("'it$'s'", "literal"),
        ("STRING#'it$'s'", "literal"),
        ("%IB256:P", "address"),
        ("%QX0.3", "address"),
        ("%DB100.DBX4.7", "address"),
        ("%X0", "address"),
        ("'open", "unterminated"),
        ('"open', "unterminated"),
        ("§", "character"),
        ("\ue000", "character"),
        ("\x00", "character"),
    ],
)
def test_one_piece_of_text_is_one_token(text: str, kind: str) -> None:
    assert cut(text) == [(kind, text)]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("a:=b", ["name", ":=", "name"]),
        ("1..5", ["literal", "..", "literal"]),
        ("a<>b>=c", ["name", "<>", "name", ">=", "name"]),
        ("x**-y", ["name", "**", "-", "name"]),
        ("x+=1", ["name", "+=", "literal"]),
        ("T#5s-x", ["literal", "-", "name"]),
        ("W#16#1E+5", ["literal", "+", "literal"]),
        ("#a.%X3", ["#", ".", "address"]),
        ("#a.#b", ["#", ".", "#"]),
        ("q=>", ["name", "=>"]),
        ("a(b)", ["name", "(", "name", ")"]),
        ("a/b", ["name", "/", "name"]),
    ],
)
def test_tokens_need_no_blanks_between_them(text: str, kinds: list[str]) -> None:
    assert [kind for kind, _ in cut(text)] == kinds


def test_double_quotes_are_a_string_in_iec_and_a_name_in_tia() -> None:
    assert cut('"a$"b"', "iec") == [("literal", '"a$"b"')]
    assert cut('"a$"', "tia") == [('"', '"a$"')]


def test_places_are_offsets_of_characters() -> None:
    tokens = tokens_of("  ab :=\r\n\tc ;")
    assert tokens.starts[:-1] == [2, 5, 10, 12]
    assert tokens.ends[:-1] == [4, 7, 11, 13]


@pytest.mark.parametrize(
    "comment",
    ["// to the end", "(* one *)", "(* two\nlines *)", "(/* shown *)  */)", "/* c */", "(**)"],
)
def test_comments_are_trivia(comment: str) -> None:
    tokens = tokens_of(f"a\n{comment}\nb")
    assert tokens.texts == ["a", "b", ""]
    assert [extra.trivia.text for extra in tokens.extras] == [comment]
    assert tokens.extras[0].token == 1


def test_comments_nest_where_they_balance() -> None:
    tokens = tokens_of("a (* x (* y *) z *) b")
    assert tokens.texts == ["a", "b", ""]
    assert [extra.trivia.text for extra in tokens.extras] == ["(* x (* y *) z *)"]


def test_a_comment_opened_twice_and_closed_once_ends_there() -> None:
    tokens = tokens_of("a (* x (* y *) b (* c *) d")
    assert tokens.texts == ["a", "b", "d", ""]
    assert not tokens.diagnostics


@pytest.mark.parametrize("text", ["a (* b", "a {b", "a (/* b *)", "a (*)", "a /* b"])
def test_a_comment_or_pragma_without_end_is_reported_at_its_start(text: str) -> None:
    (found,) = tokens_of(text).diagnostics
    assert found.code == "FB3003"
    assert found.span is not None
    assert found.span.column == 3


def test_a_comment_that_ends_its_line_belongs_to_the_token_before() -> None:
    tokens = tokens_of("a // one\n// two\nb (* three *) c")
    assert [(extra.token, extra.same_line) for extra in tokens.extras] == [
        (1, True),
        (1, False),
        (2, False),
    ]


def test_several_blank_lines_are_one() -> None:
    tokens = tokens_of("\n\na\n\n \n\nb\n\n")
    assert [(extra.token, extra.trivia.kind) for extra in tokens.extras] == [
        (1, TriviaKind.BLANK_LINE)
    ]


def test_crlf_in_a_comment_becomes_lf() -> None:
    (extra,) = tokens_of("(* a\r\nb *)\r\nc").extras
    assert extra.trivia.text == "(* a\nb *)"


@pytest.mark.parametrize(
    "line",
    [
        "REGION It's (* free { text",
        'Region "x',
        "REGION",
        "END_REGION // and 'more",
        "END_REGION;",
    ],
)
def test_region_lines_are_raw_text(line: str) -> None:
    assert cut(f"{line}\nx")[0] == (line.split(maxsplit=1)[0].rstrip(";").upper(), line)
    assert cut(f"{line}\nx")[1] == ("name", "x")


@pytest.mark.parametrize("text", ["#region", "a.region", "region := 1", "regions"])
def test_region_can_be_a_name(text: str) -> None:
    assert "raw" not in [kind for kind, _ in cut(text)]
    assert all(len(piece) <= 7 for _, piece in cut(text))


def test_time_for_comments_that_never_close_is_linear() -> None:
    tokens = tokens_of("(* (* *) " * 20_000)
    assert len(tokens.diagnostics) <= 1
