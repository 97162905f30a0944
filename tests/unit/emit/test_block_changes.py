"""Which blocks were renamed and which are gone when a plant is generated again."""

from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.emit.generator import generate
from fbgen.emit.writing import CHANGED_BLOCKS, write_set
from fbgen.plant import read_plant
from fbgen.source import Source

EXAMPLE = Path(__file__).parents[3] / "examples" / "five_drives" / "plant.yaml"
TEXT = EXAMPLE.read_text("utf-8")
CATALOG = load_catalog()


def write(text: str, folder: Path) -> tuple[tuple[tuple[str, str], ...], tuple[str, ...]]:
    """What became of the blocks of the folder."""
    found = write_set(generate(read_plant(Source("p.yaml", text), CATALOG), CATALOG), folder)
    return found.blocks.renamed, found.blocks.removed


def test_the_same_plant_changes_no_block(tmp_path: Path) -> None:
    assert write(TEXT, tmp_path) == ((), ())
    assert write(TEXT, tmp_path) == ((), ())
    assert not (tmp_path / CHANGED_BLOCKS).exists()


def test_another_prefix_renames_all_blocks(tmp_path: Path) -> None:
    write(TEXT, tmp_path)
    renamed, removed = write(f"{TEXT}prefix: HALL_\n", tmp_path)
    assert removed == ()
    assert ("TOS_Main", "HALL_Main") in renamed
    assert ("typeTosDrive", "typeHallDrive") in renamed
    assert len(renamed) == len(generate(read_plant(Source("p", TEXT), CATALOG), CATALOG).blocks)


def test_another_name_of_the_gateway_renames_its_blocks(tmp_path: Path) -> None:
    write(TEXT, tmp_path)
    assert "name: gw1" in TEXT
    renamed, removed = write(TEXT.replace("name: gw1", "name: hall"), tmp_path)
    assert removed == ()
    assert ("TOS_ConsistentIo_gw1", "TOS_ConsistentIo_hall") in renamed
    assert all("gw1" in old and "hall" in new for old, new in renamed)


@pytest.mark.parametrize("sequence", ["stop", "read_current"])
def test_a_sequence_that_is_not_wanted_any_more_removes_its_block(
    sequence: str, tmp_path: Path
) -> None:
    write(TEXT, tmp_path)
    without = TEXT.replace(f"  - {sequence}\n", "")
    assert without != TEXT
    renamed, removed = write(without, tmp_path)
    assert renamed == ()
    assert set(removed) == {f"typeTos_{sequence}", f"TOS_Seq_{sequence}"}
    assert not (tmp_path / f"TOS_Seq_{sequence}.scl").exists()


def test_the_folder_tells_every_change_newest_last(tmp_path: Path) -> None:
    write(TEXT, tmp_path)
    write(f"{TEXT}prefix: HALL_\n", tmp_path)
    write(f"{TEXT}prefix: ACME_\n", tmp_path)
    told = (tmp_path / CHANGED_BLOCKS).read_text("ascii")
    first = told.index("renamed  TOS_Main -> HALL_Main")
    assert told.index("renamed  HALL_Main -> ACME_Main") > first
    assert told.count("\ninputs ") == 2
