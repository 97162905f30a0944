"""YAML as data with places: what is understood, what is refused, and where."""

from typing import Any

import pytest
import yaml

from fbgen.catalog import Located, load_yaml, validate
from fbgen.catalog.scalars import Flag, HexWord, Real, Whole
from fbgen.catalog.yaml_events import MAX_CHARACTERS, MAX_DEPTH
from fbgen.catalog.yaml_nodes import YamlInt
from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source


class Part(Located):
    """A part of a thing."""

    name: str


class Thing(Located):
    """A model with one field of each kind."""

    flag: Flag = False
    count: Whole = 0
    ratio: Real = 0.0
    text: str = ""
    word: HexWord = 0
    parts: tuple[Part, ...] = ()


def data(text: str) -> Any:
    return load_yaml(Source("t.yaml", text)).data


def thing(text: str) -> Thing:
    return validate(load_yaml(Source("t.yaml", text)), Thing)


def findings(text: str) -> list[tuple[str, int, int, str]]:
    with pytest.raises(DiagnosticError) as failure:
        thing(text)
    found = failure.value.diagnostics
    return [(i.code, i.span.line, i.span.column, i.help) for i in found if i.span is not None]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1388", 1388),
        ("-5", -5),
        ("0x1F", 31),
        ("0o17", 15),
        ("1.5", 1.5),
        ("-0.01", -0.01),
        ("2.0e3", 2000.0),
        ("true", True),
        ("False", False),
        ("null", None),
        ("~", None),
    ],
)
def test_numbers_and_constants_are_those_of_the_core_schema(text: str, value: object) -> None:
    assert data(f"a: {text}")["a"] == value


@pytest.mark.parametrize(
    "text",
    ["no", "on", "off", "yes", "017", "0009", "12:30", "1_000", "1E10", "2005-07-01", ".inf", "=",
     "99999999999999999999999999"],
)  # fmt: skip
def test_what_yaml_1_1_would_turn_into_something_else_stays_a_text(text: str) -> None:
    assert data(f"a: {text}")["a"] == text


@pytest.mark.parametrize("text", ["'1388'", '"true"', "'~'"])
def test_quoted_values_are_texts(text: str) -> None:
    assert data(f"a: {text}")["a"] == text[1:-1]


def test_keys_are_always_texts() -> None:
    assert list(data("1: a\ntrue: b\n0x10: c")) == ["1", "true", "0x10"]


@pytest.mark.parametrize("text", ["1388", "0x1388", "'1388'"])
def test_a_hexadecimal_field_reads_the_number_as_it_is_written(text: str) -> None:
    assert thing(f"word: {text}").word == 0x1388


def test_leading_zeros_of_a_communication_number_are_kept() -> None:
    assert thing("word: 0010").word == 0x10


def test_a_number_keeps_its_spelling() -> None:
    value = data("a: 0x0F")["a"]
    assert isinstance(value, YamlInt)
    assert value.text == "0x0F"


@pytest.mark.parametrize(
    ("text", "place", "hint"),
    [
        ("flag: no", (1, 7), "true or false"),
        ("count: 017", (1, 8), "octal"),
        ("count: 12:30", (1, 8), "one unit"),
        ("text: 12", (1, 7), '"12"'),
        ("text: true", (1, 7), '"true"'),
        ("count: true", (1, 8), ""),
        ("ratio: 1.0e999", (1, 8), ""),
        ("ratio: 1E3", (1, 8), "decimal point"),
        ("ratio: 50,5", (1, 8), "without a unit: 50.5"),
        ("ratio: 50 Hz", (1, 8), "without a unit: 50"),
        ("count: 10ms", (1, 8), "without a unit: 10"),
        ("count: 1E3", (1, 8), "digits"),
        ("word: FA001", (1, 7), ""),
        ("parts: {name: a}", (1, 8), ""),
        ("parts: [a]", (1, 9), ""),
        ("parts: [{name: 1}]", (1, 16), '"1"'),
    ],
)
def test_a_wrong_type_is_reported_at_the_value(
    text: str, place: tuple[int, int], hint: str
) -> None:
    ((code, line, column, help_text),) = findings(text)
    assert (code, line, column) == ("FB1007", *place)
    assert hint in help_text


def test_everything_wrong_is_reported_together_in_the_order_of_the_file() -> None:
    text = "count: x\nparts:\n  - {nam: a}\n  - {name: b, size: 2}\nflga: true\n"
    assert [(code, line) for code, line, _, _ in findings(text)] == [
        ("FB1007", 1),
        ("FB1005", 3),
        ("FB1005", 4),
        ("FB1005", 5),
    ]


def test_a_missing_key_beside_an_unrelated_unknown_one_is_reported_too() -> None:
    found = findings("parts: [{zzz: a}]")
    assert {code for code, _, _, _ in found} == {"FB1005", "FB1006"}


def test_every_model_knows_its_place() -> None:
    read = thing("text: a\nparts:\n  - name: b\n")
    assert str(read.parts[0].span) == "t.yaml:3:5"
    assert str(read.parts[0].span_of("name")) == "t.yaml:3:11"
    assert str(read.key_span_of("text")) == "t.yaml:1:1"
    assert str(read.item_span_of("parts", 0)) == "t.yaml:3:5"
    assert str(read.span_of("count")) == str(read.span)


def test_where_a_model_stands_is_no_part_of_what_it_is() -> None:
    assert thing("text: a") == thing("\n\ntext: a") == Thing(text="a")
    assert Thing(text="a").span is None


def test_an_alias_gives_the_same_value() -> None:
    read = thing("parts: [&p {name: a}, *p]")
    assert [part.name for part in read.parts] == ["a", "a"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("", "FB1001"),
        ("# only a comment\n", "FB1001"),
        ("a: 1\n---\nb: 2\n", "FB1001"),
        ("a:\t1\n\tb: 2", "FB1001"),
        ("a: \x00", "FB1001"),
        ("a: \ud800", "FB1001"),
        ("a: *x", "FB1003"),
        ("a: &x [*x]", "FB1003"),
        ("a: &x {b: *x}", "FB1003"),
        ("? [a, b]\n: c", "FB1003"),
        ("a: !!python/object/apply:os.system [ls]", "FB1003"),
        ("a: !!str 5", "FB1003"),
        ("a: !mine x", "FB1003"),
        ("!!map\na: 1", "FB1003"),
        ("a: 1\nb: {c: 1, c: 2}", "FB1004"),
        ("[" * (MAX_DEPTH + 1) + "]" * (MAX_DEPTH + 1), "FB1002"),
        ("[" * 50_000, "FB1002"),
        ("a: " * 2, "FB1001"),
    ],
)
def test_what_is_not_plain_yaml_is_refused(text: str, code: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_yaml(Source("t.yaml", text))
    assert [item.code for item in failure.value.diagnostics] == [code]


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        ("a: {b: 1\nc: {d: 2}\n", "close the {"),
        ("a: [b\nc: 1\n", "close the ["),
        ("a: 1\n b: 2\n", "same column"),
        ("a: 1\nb 2\nc: 3\n", "a colon and a blank"),
        ("a:\n  - b: 1\n    c: 2\n   d: 3\n", "same column"),
        ("a: 'b\n", "a quote"),
        ("# nothing\n", "fbgen init"),
    ],
)
def test_a_mistake_of_spelling_comes_with_a_way_out(text: str, hint: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_yaml(Source("t.yaml", text))
    (found,) = failure.value.diagnostics
    assert hint in found.help, found.message


def test_a_file_that_is_too_long_is_not_even_looked_at() -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_yaml(Source("t.yaml", "a: " + "x" * MAX_CHARACTERS))
    assert [item.code for item in failure.value.diagnostics] == ["FB1002"]


def test_duplicate_keys_are_all_reported_with_their_first_place() -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_yaml(Source("t.yaml", "a: 1\nb: 2\na: 3\nb: 4\n"))
    first = [item.notes[0].span for item in failure.value.diagnostics]
    assert [str(span) for span in first] == ["t.yaml:1:1", "t.yaml:2:1"]


def test_syntax_errors_have_one_place_with_and_without_libyaml(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    text = "a: [1, 2\nb: 3\n"
    seen = []
    for with_libyaml in (yaml.__with_libyaml__, False):
        monkeypatch.setattr(yaml, "__with_libyaml__", with_libyaml)
        with pytest.raises(DiagnosticError) as failure:
            load_yaml(Source("t.yaml", text))
        seen.append(str(failure.value))
    assert seen[0] == seen[1]
