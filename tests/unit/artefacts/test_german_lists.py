"""The files beside German PLC text: no text of them is left in English.

Names, addresses, headings that TIA Portal wants in English and sources, which are cited as the
documents are called, stay.
"""

import csv
import re
from functools import cache
from io import BytesIO, StringIO

import pytest
from openpyxl import load_workbook

from fbgen.artefacts import with_artefacts
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import changed, in_dialect, read_plant
from fbgen.source import Source
from tests.unit.blocks.programs import FIVE_DRIVES, shipped_catalog

DIALECTS = ["tia", "step7", "iec", "twincat", "plcopen"]
ENGLISH = frozenset(
    {
        *("the", "of", "and", "is", "are", "by", "with", "only", "not", "from", "for", "which"),
        *("drive", "drives", "inverter", "switch", "fault", "read", "number", "frequency"),
        *("upper", "lower", "high", "low", "what", "where", "when", "without", "until"),
    }
)
"""Words that no German text has, and that an English sentence hardly does without."""


@cache
def generated(dialect: str, language: str) -> GeneratedSet:
    """A polled line with all sequences, its options and settings as shipped."""
    catalog = shipped_catalog()
    read = read_plant(Source("plant.yaml", FIVE_DRIVES), catalog)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in read.gateways)
    plant = in_dialect(read.model_copy(update={"gateways": gateways}), dialect, catalog)
    plant = changed(plant, catalog, language=language, sequences=tuple(sorted(catalog.sequences)))
    return with_artefacts(generate(plant, catalog), plant, catalog)


def texts(name: str, data: bytes) -> list[str]:
    """The lines of a text, the cells of a table or a workbook; sources are left out."""
    if name.endswith(".xlsx"):
        book = load_workbook(BytesIO(data))
        rows = [row for sheet in book for row in sheet.iter_rows(min_row=2, values_only=True)]
        return [str(cell) for row in rows for cell in row if cell is not None]
    found = data.decode("utf-8-sig")
    if name.endswith(".csv"):
        first, *others = csv.reader(StringIO(found))
        source = first.index("Quelle") if "Quelle" in first else len(first)
        return [cell for row in others for index, cell in enumerate(row) if index != source]
    found = re.sub(r"`[^`]*`|\([^)]*\.Import\)", "", found)
    lines = [
        line.rpartition("|")[0].rpartition("|")[0] if "manual" in line else line
        for line in found.splitlines()
    ]
    return [re.sub(r"^\| [A-Z_a-z0-9]+ \|", "", line) for line in lines]


def english_in(made: GeneratedSet) -> set[str]:
    """Every text beside the program that has an English word."""
    return {
        text
        for item in made.artefacts
        if not item.name.endswith((".xml", ".json"))
        for text in texts(item.name, item.data)
        if ENGLISH & set(re.findall(r"(?<![\w.])[a-z]+(?![\w.(])", text))
    }


@pytest.mark.parametrize("dialect", DIALECTS)
def test_no_text_of_the_lists_is_left_in_english(dialect: str) -> None:
    assert english_in(generated(dialect, "de")) == set()


def test_english_texts_are_seen() -> None:
    found = english_in(generated("tia", "en"))
    assert any("trips Err5 and stops the motor" in text for text in found)
    assert any("Start forward at a given frequency" in text for text in found)
    assert len(found) > 100
