"""Lines of generated files know where they are from, in every dialect and container."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import LANGUAGES, in_dialect, load_plant
from fbgen.resources import shipped
from fbgen.source import Origin

PLANT = Path(__file__).parents[3] / "examples" / "manual_example" / "plant.yaml"
CATALOG = load_catalog()


def lines(dialect: str) -> list[tuple[str, Origin | None]]:
    """All lines of PLC text, each with its origin."""
    plant = load_plant(PLANT, CATALOG)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in plant.gateways)
    changed = in_dialect(plant.model_copy(update={"gateways": gateways}), dialect, CATALOG)
    found: list[tuple[str, Origin | None]] = []
    for file in generate(changed, CATALOG).files:
        if file.is_program:
            texts = file.text.splitlines()
            assert len(file.origins) == len(texts)
            values = (
                next((one for one in reversed(known)), None) if known else None
                for known in file.origins
            )
            found += zip(texts, values, strict=True)
    return found


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
