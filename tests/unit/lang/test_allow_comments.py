"""Comments that allow a warning in one place."""

import pytest
from checking import findings_of

_WARNED = "#y := #y;"


def block(statements: str, before: str = "") -> list[str]:
    text = (
        f"{before}FUNCTION_BLOCK b\nVAR_OUTPUT y : INT; END_VAR\nBEGIN\n{statements}\n"
        "END_FUNCTION_BLOCK\n"
    )
    return [one.code for one in findings_of(text, "tia")]


def test_without_a_comment_there_is_the_warning() -> None:
    assert block(_WARNED) == ["FB4233"]


@pytest.mark.parametrize(
    "statements",
    [
        f"{_WARNED} // fbgen: allow FB4233",
        f"{_WARNED} (* fbgen: allow FB4233 *)",
        f"{_WARNED} // FBGEN: Allow fb4233, with a reason",
        f"// fbgen: allow FB4233\n{_WARNED}",
        f"(* fbgen: allow FB4233: it is a test *)\n\n{_WARNED}",
        f"// fbgen: allow FB4233\n// another comment\n{_WARNED}",
        f"// fbgen: allow FB4211, FB4233\nIF TRUE THEN\n  {_WARNED}\nEND_IF;",
    ],
)
def test_a_comment_allows_it(statements: str) -> None:
    assert block(statements) == []


def test_above_a_block_it_is_allowed_in_the_whole_block() -> None:
    assert block(f"{_WARNED}\n{_WARNED}", "// fbgen: allow FB4233\n") == []


def test_only_the_next_statement_is_meant() -> None:
    assert block(f"// fbgen: allow FB4233\n{_WARNED}\n{_WARNED}") == ["FB4233"]


def test_a_declaration_may_be_meant() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR_INPUT\n// fbgen: allow FB4201 kept for old callers\nx : INT;\n"
        "z : INT;\nEND_VAR\nVAR_OUTPUT y : INT; END_VAR\nBEGIN\n#y := 1;\nEND_FUNCTION_BLOCK\n"
    )
    found = findings_of(text, "tia")
    assert [(one.code, one.span and one.span.line) for one in found] == [("FB4201", 5)]


def test_a_text_is_no_comment() -> None:
    text = (
        "FUNCTION_BLOCK b\nVAR_OUTPUT s : STRING; END_VAR\nBEGIN\n"
        "#s := 'fbgen: allow FB4999';\nEND_FUNCTION_BLOCK\n"
    )
    assert findings_of(text, "tia") == []


def test_an_allowed_code_that_nothing_gives_is_reported() -> None:
    assert block("#y := 1; // fbgen: allow FB4233") == ["FB4291"]


def test_a_code_that_does_not_exist_is_reported() -> None:
    assert block("#y := 1; // fbgen: allow FB4999") == ["FB4290"]
    assert block("#y := 1; // fbgen: allow everything") == ["FB4290"]


def test_an_error_stays_an_error() -> None:
    assert block("#y := TRUE; // fbgen: allow FB4011") == ["FB4011", "FB4292"]
