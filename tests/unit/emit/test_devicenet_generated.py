"""Blocks for DeviceNet: what is generated, in which dialects, and what is refused."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.emit.generator import generate
from fbgen.plant import Plant, in_dialect, load_plant, read_plant
from fbgen.source import Source

ROOT = Path(__file__).parents[3]
BAD = ROOT / "tests" / "unit" / "bad"
PLANT = ROOT / "tests" / "scenarios" / "devicenet" / "all_assemblies.yaml"
CATALOG = load_catalog()


def text_of(plant: Plant) -> str:
    files = generate(plant, CATALOG).files
    return "\n".join(file.text for file in files if file.is_program)


@pytest.fixture(scope="module")
def plant() -> Plant:
    return load_plant(PLANT, CATALOG)


@pytest.mark.parametrize("dialect", ["tia", "step7", "iec", "twincat", "plcopen"])
def test_every_dialect_gets_a_block_for_the_network(plant: Plant, dialect: str) -> None:
    text = text_of(in_dialect(plant, dialect, CATALOG))
    assert "DEV_Network_net1" in text
    assert "inst_basic" in text


def test_low_bytes_come_first_and_chosen_words_where_they_were_chosen(plant: Plant) -> None:
    block = next(
        file for file in generate(plant, CATALOG).files if file.name == "DEV_Network_net1.scl"
    )
    lines = [line.strip() for line in block.text.splitlines()]
    at = lines.index("#tempLow := %IB120;")
    assert lines[at + 1] == "#tempHigh := %IB121;"
    assert lines[at + 2].startswith("#in_words.status :=")
    # c022 of drive both chooses FD01, c021 nothing: words 2 and 1 behind the parameter channel
    assert lines[lines.index("#tempLow := %IB168;") + 2].startswith("#in_both.status :=")
    first = "#drives.both.state.words[1] :="
    assert lines[lines.index("#tempLow := %IB166;") + 2].startswith(first)
    assert "#tempLow := WORD_TO_BYTE(#drives.chosen.control.words[5] AND 16#00FF);" in lines


@pytest.mark.parametrize(
    ("name", "code", "words"),
    [
        ("FB5018_no_table", "FB5018", "could not see that a drive is lost"),
        ("FB5019_not_chosen", "FB5019", "carries FA07"),
    ],
)
def test_what_blocks_could_not_do_is_refused(name: str, code: str, words: str) -> None:
    with pytest.raises(DiagnosticError) as failure:
        generate(load_plant(BAD / f"{name}.yaml", CATALOG), CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == code
    assert words in found.message
    assert found.span is not None


def test_a_word_that_would_undo_another_is_told() -> None:
    text = PLANT.read_text("utf-8").replace("command_5: 5", "command_5: 1")
    with pytest.raises(DiagnosticError) as failure:
        generate(read_plant(Source("plant.yaml", text), CATALOG), CATALOG)
    (found,) = failure.value.diagnostics
    assert found.code == "FB5019"
    assert "two words of assembly 102 of 'chosen' carry FA06" in found.message
    assert "command_1 chooses it already" in (found.help or "")


def test_a_lowest_set_point_above_the_highest_is_told() -> None:
    text = PLANT.read_text("utf-8").replace("speed_unit: rpm", "min_frequency_hz: 61")
    with pytest.raises(DiagnosticError) as failure:
        read_plant(Source("plant.yaml", text), CATALOG)
    (found,) = failure.value.diagnostics
    assert (found.code, "61 Hz, lies above" in found.message) == ("FB2010", True)
