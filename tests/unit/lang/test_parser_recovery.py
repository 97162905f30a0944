"""Several independent errors of a text are found in one go, and nothing follows from them."""

import re
from pathlib import Path

import pytest
from trees import found_in

from fbgen.diagnostics import DiagnosticError
from fbgen.lang.encoding import read_source
from fbgen.lang.lowering import lower
from fbgen.lang.parser import parse, parse_recovering
from fbgen.lang.parser.cursor import MOST_FINDINGS
from fbgen.lang.printer import print_generated
from fbgen.resources import shipped
from fbgen.source import Source

_BAD = Path(__file__).parent.parent / "bad"
_DIALECTS = {"scl": "tia", "st": "iec"}


def _all_findings(source: Source, dialect: str) -> list[tuple[str, int, int]]:
    try:
        print_generated(lower(parse(source, dialect), "iec"))
    except DiagnosticError as problem:
        found = problem.diagnostics
        return [(one.code, one.span.line, one.span.column) for one in found if one.span]
    return []


@pytest.mark.parametrize(
    ("name", "places"),
    [
        ("FB3001_unexpected.scl", [(6, 12), (9, 7), (10, 16)]),
        ("FB3002_character.scl", [(6, 12)]),
        ("FB3003_comment.scl", [(6, 4)]),
        ("FB3004_literal.scl", [(6, 10), (7, 10)]),
        ("FB3006_nesting.scl", [(6, 266)]),
        ("FB3007_no_end.scl", [(6, 4)]),
        ("FB3008_no_beginning.scl", [(7, 4)]),
        ("FB3009_feature.st", [(7, 5), (8, 7), (10, 5)]),
        ("FB3010_semicolon.scl", [(6, 10), (10, 9)]),
        ("FB3012_not_read.st", [(2, 5), (8, 5), (13, 1)]),
        ("FB3015_misplaced.st", [(2, 12), (14, 5)]),
        ("FB3040_degree.scl", [(3, 23)]),
        ("FB3050_names.scl", [(3, 7), (4, 7)]),
        ("FB3051_no_counterpart.scl", [(7, 10), (8, 4), (10, 4)]),
        ("FB3052_type.scl", [(3, 11), (4, 11)]),
        ("FB3053_global_data.scl", [(8, 10)]),
    ],
)
def test_a_broken_file_gives_its_code_at_each_place(
    name: str, places: list[tuple[int, int]]
) -> None:
    path = _BAD / name
    found = _all_findings(read_source(path), _DIALECTS[path.suffix[1:]])
    assert found == [(name[:6], line, column) for line, column in places]


_BLOCK = re.compile(r"```(scl|st)\n(.*?)```", re.DOTALL)
_PAGES = sorted(path.stem for path in shipped("diagnostics").glob("FB3*.md"))
_ABOUT_COMMANDS = (
    *("FB3011", "FB3013", "FB3014", "FB3040", "FB3041", "FB3054", "FB3055", "FB3056"),
)
_ABOUT_CONTAINERS = ("FB3016", "FB3017", "FB3018", "FB3019", "FB3060")
_ABOUT_TEXT = [code for code in _PAGES if code not in _ABOUT_COMMANDS + _ABOUT_CONTAINERS]


@pytest.mark.parametrize("code", _ABOUT_TEXT)
def test_the_page_of_a_code_shows_it_and_the_way_out(code: str) -> None:
    text = (shipped("diagnostics") / f"{code}.md").read_text(encoding="utf-8")
    (fails_in, fails), (fixed_in, fixed) = _BLOCK.findall(text)
    assert {found[0] for found in _all_findings(Source(code, fails), _DIALECTS[fails_in])} == {code}
    assert _all_findings(Source(code, fixed), _DIALECTS[fixed_in]) == []


def test_every_finding_says_what_to_do() -> None:
    for path in _BAD.glob("FB300*"):
        source = read_source(path)
        _, findings = parse_recovering(source, _DIALECTS[path.suffix[1:]])
        assert all(found.help for found in findings), path.name


def _codes(statements: str) -> list[tuple[str, int]]:
    found = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\n{statements}\nEND_FUNCTION_BLOCK')
    return [(one.code, one.span.line) for one in found if one.span]


def test_a_broken_condition_does_not_hide_its_statements() -> None:
    assert _codes("IF #a + THEN\n #x = 1;\nEND_IF;\n#y := ;") == [
        ("FB3001", 3),
        ("FB3001", 4),
        ("FB3001", 6),
    ]


def test_a_wrong_end_is_reported_once() -> None:
    assert _codes("IF #a THEN\n #x := 1;\nEND_WHILE;\nEND_IF;\n#y := 1;") == [("FB3008", 5)]


def test_a_missing_end_inside_is_reported_at_its_beginning() -> None:
    assert _codes("IF #a THEN\n FOR #i := 1 TO 2 DO\n  #x := 1;\nEND_IF;") == [("FB3007", 4)]


def test_a_broken_arm_of_a_case_does_not_hide_the_next() -> None:
    assert _codes("CASE #x OF\n 1 2: #y := 1;\n 3: #z = 1;\nEND_CASE;") == [
        ("FB3001", 4),
        ("FB3001", 5),
    ]


def test_errors_in_several_blocks_and_sections() -> None:
    found = found_in(
        'FUNCTION_BLOCK "A"\nVAR\n a Int;\n b : ;\n c : Int\n d : Int;\nEND_VAR\nBEGIN\n'
        '#x := ;\nEND_FUNCTION_BLOCK\nnonsense\nFUNCTION "F"\nBEGIN\nEND_FUNCTION\n'
        'FUNCTION "G" : Int\nBEGIN\n#y := );\nEND_FUNCTION'
    )
    places = [(one.code, one.span.line) for one in found if one.span]
    assert places == [
        ("FB3001", 3),
        ("FB3001", 4),
        ("FB3010", 5),
        ("FB3001", 9),
        ("FB3001", 11),
        ("FB3001", 13),
        ("FB3001", 17),
    ]


def test_an_assignment_written_as_a_comparison_gets_a_hint() -> None:
    (found,) = found_in('FUNCTION_BLOCK "B"\nBEGIN\n#x = 1;\nEND_FUNCTION_BLOCK')
    assert "':='" in found.help


def test_a_line_comment_is_read_in_iec() -> None:
    assert found_in("PROGRAM p\n// one\n// two\n;\nEND_PROGRAM", "iec") == []


def test_an_unknown_dialect_is_refused_by_name() -> None:
    with pytest.raises(DiagnosticError) as problem:
        parse(Source("x", ""), "klingon")
    assert [found.code for found in problem.value.diagnostics] == ["FB3011"]


def test_an_empty_text_is_an_empty_file() -> None:
    assert parse(Source("x", ""), "tia").units == ()
    assert parse(Source("x", "\n// only a comment"), "tia").closing[0].text == "// only a comment"


def test_no_text_gives_more_findings_than_anybody_reads() -> None:
    assert len(found_in("§\n" * 5000 + "IF\n" * 5000)) <= MOST_FINDINGS
    statements = "x := ;\n" * 5000
    found = found_in(f'FUNCTION_BLOCK "B"\nBEGIN\n{statements}END_FUNCTION_BLOCK')
    assert len(found) == MOST_FINDINGS
