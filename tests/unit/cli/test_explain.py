"""`fbgen explain`."""

from tests.unit.cli.running import Fbgen


def test_explain_prints_the_page_of_a_code(fbgen: Fbgen) -> None:
    run = fbgen("explain", "fb9003")
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith("# FB9003: there is no message with this code\n")
    assert "\n## Fails\n" in run.out
    assert "\n## Fixed\n" in run.out


def test_an_unknown_code_is_fb9003_with_the_nearest_codes(fbgen: Fbgen) -> None:
    run = fbgen("explain", "FB900")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9003]: there is no message with the code 'FB900'")
    assert "did you mean 'FB90" in run.err
