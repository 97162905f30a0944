"""Lines of generated files know where they are from, in every dialect and container."""

from functools import cache

import pytest

from fbgen.plant import LANGUAGES
from fbgen.resources import shipped
from fbgen.source import Origin
from tests.unit.emit.examples import generated


@cache
def lines(dialect: str) -> tuple[tuple[str, Origin | None], ...]:
    """All lines of PLC text, each with its origin."""
    found: list[tuple[str, Origin | None]] = []
    for file in generated("manual_example", dialect):
        if file.is_program:
            texts = file.text.splitlines()
            assert len(file.origins) == len(texts)
            values = (
                next((one for one in reversed(known)), None) if known else None
                for known in file.origins
            )
            found += zip(texts, values, strict=True)
    return tuple(found)


def in_template(origin: Origin | None) -> str:
    """The line of the template."""
    assert origin is not None
    name = origin.file.removeprefix("templates/")
    return (shipped("templates") / name).read_text("utf-8").splitlines()[origin.line - 1]


@pytest.mark.parametrize("dialect", LANGUAGES)
@pytest.mark.parametrize(
    "code", ["statCount := statCount + 1;", "statAdvance := advance;", "statToggle := NOT "]
)
def test_a_statement_is_from_its_line_of_the_template(dialect: str, code: str) -> None:
    found = [one for text, one in lines(dialect) if code in text.replace("#", "")]
    assert found
    for origin in found:
        assert code in in_template(origin).replace("#", "")


@pytest.mark.parametrize("dialect", ["twincat", "plcopen"])
def test_a_located_variable_is_from_the_layout_of_the_catalogue(dialect: str) -> None:
    (found,) = [one for text, one in lines(dialect) if "%QB258" in text]
    assert found is not None
    assert found.file == "catalog/gateways/tospbdp001.yaml"
    assert found.what == "layout gsd10, trigger"


@pytest.mark.parametrize("dialect", LANGUAGES)
def test_nearly_every_line_of_code_has_an_origin(dialect: str) -> None:
    found = lines(dialect)
    without = [
        text for text, one in found if one is None and text.strip() and "Generated" not in text
    ]
    assert len(without) < len(found) / 8, without[:40]
