"""The `iec` text read by a parser that we did not write: blark, for TwinCAT's Structured Text.

It has no CONFIGURATION, which TwinCAT keeps outside of its text; all else must be read whole.
"""

import re
from pathlib import Path

import pytest
from blark.parse import parse_source_code

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.plant import load_plant

EXAMPLES = Path(__file__).parents[3] / "examples"
UNIT = re.compile(r"^(?=(?:TYPE|FUNCTION|FUNCTION_BLOCK|PROGRAM|CONFIGURATION)\b)", re.MULTILINE)


def units(example: str) -> list[str]:
    catalog = load_catalog()
    plant = load_plant(EXAMPLES / example / "plant.yaml", catalog)
    gateways = tuple(item.model_copy(update={"access": "process_image"}) for item in plant.gateways)
    changed = plant.model_copy(update={"dialect": "iec", "plc": "iec", "gateways": gateways})
    (file,) = generate(changed, catalog).files
    return [text for text in UNIT.split(file.text) if UNIT.match(text)]


@pytest.mark.parametrize(
    "example", ["manual_example", pytest.param("five_drives", marks=pytest.mark.slow)]
)
def test_a_parser_of_others_reads_every_unit(example: str) -> None:
    found = units(example)
    assert len(found) > 15
    assert sum(text.startswith("FUNCTION_BLOCK") for text in found) >= 10
    for text in found:
        if not text.startswith("CONFIGURATION"):
            assert parse_source_code(text).exception is None, text[:200]


def test_the_parser_of_others_refuses_a_broken_unit() -> None:
    (block, *_) = [text for text in units("manual_example") if "TOS_Handshake\n" in text]
    assert parse_source_code(block.replace("END_IF;", "END_FI;", 1)).exception is not None
