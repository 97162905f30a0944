"""One broken file per code: the code and the place of what is wrong."""

import re
import shutil
from pathlib import Path

import pytest

import fbgen.blocks
import fbgen.catalog
import fbgen.plant
import fbgen.wire.gsd
from fbgen.catalog import (
    ComNo,
    Drive,
    Layout,
    Located,
    ModbusAccess,
    Option,
    SerialPort,
    Word,
    load_catalog,
    load_yaml,
    validate,
)
from fbgen.catalog.catalog import read_source
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import load_plant
from fbgen.resources import shipped

BAD = Path(__file__).parents[1] / "bad"

ENTRIES: list[tuple[str, type[Located], int, int]] = [
    ("FB1101_overlapping_bits", Word, 8, 11),
    ("FB1104_value_too_large", Word, 7, 55),
    ("FB1106_layout_length", Layout, 5, 1),
    ("FB1108_range", ComNo, 7, 10),
    ("FB1109_option_default", Option, 4, 10),
    ("FB1113_code_without_meaning", Drive, 23, 14),
    ("FB1114_more_words_than_read", ModbusAccess, 1, 1),
    ("FB1115_two_protocols", SerialPort, 10, 12),
]
SEQUENCES = [
    ("FB1102_name_twice", 10, 12),
    ("FB1103_no_source", 1, 1),
    ("FB1105_unknown_reference", 14, 48),
    ("FB1107_literal_without_note", 14, 14),
    ("FB1111_file_name", 2, 5),
]
PLANTS = [
    ("FB1001_open_bracket", 4, 8),
    ("FB1002_alias_expansion", 6, 5),
    ("FB1003_tag", 2, 7),
    ("FB1004_duplicate_key", 4, 1),
    ("FB1005_unknown_key", 11, 5),
    ("FB1006_missing_key", 1, 1),
    ("FB1007_wrong_type", 14, 18),
    ("FB1008_not_utf8", 3, 8),
    ("FB2001_unknown_gateway", 8, 11),
    ("FB2002_unknown_layout", 9, 13),
    ("FB2003_option", 14, 30),
    ("FB2004_profibus_address", 10, 23),
    ("FB2004_reserved_address", 10, 23),
    ("FB2005_access", 11, 13),
    ("FB2006_inv_no_twice", 16, 33),
    ("FB2007_inv_no_range", 16, 33),
    ("FB2009_unknown_series", 16, 44),
    ("FB2010_max_frequency", 15, 69),
    ("FB2011_sequence", 5, 13),
    ("FB2012_name", 15, 16),
    ("FB2013_name_twice", 16, 16),
    ("FB2014_dialect", 3, 10),
    ("FB2015_profibus_twice", 20, 23),
    ("FB2016_address_overlap", 23, 21),
    ("FB2017_no_address", 11, 13),
    ("FB2018_address_range", 12, 20),
    ("FB2019_hardware_identifier", 21, 26),
    ("FB2021_prefix", 5, 9),
    ("FB2023_cpu", 5, 6),
    ("FB2024_channel", 13, 30),
    ("FB2025_identifiers", 12, 18),
    ("FB2026_retries", 12, 27),
    ("FB2022_files", 5, 8),
    ("FB2040_modules_without_gsd", 9, 14),
    ("FB2041_other_device", 8, 10),
    ("FB2042_lengths", 8, 13),
    ("FB2050_nothing", 1, 1),
    ("FB2051_module", 8, 13),
    ("FB2052_rate", 8, 11),
    ("FB2053_assemblies", 13, 21),
    ("FB2055_no_line", 5, 16),
    ("FB2055_no_master", 5, 16),
]


def places(failure: pytest.ExceptionInfo[DiagnosticError]) -> list[tuple[str, int, int]]:
    return [
        (item.code, item.span.line if item.span else 0, item.span.column if item.span else 0)
        for item in failure.value.diagnostics
    ]


@pytest.mark.parametrize(("name", "model", "line", "column"), ENTRIES)
def test_a_broken_part_of_an_entry_is_reported_at_its_place(
    name: str, model: type[Located], line: int, column: int
) -> None:
    source = read_source(BAD / f"{name}.yaml", name)
    with pytest.raises(DiagnosticError) as failure:
        validate(load_yaml(source), model)
    assert places(failure) == [(name[:6], line, column)]


@pytest.mark.parametrize(("name", "line", "column"), SEQUENCES)
def test_a_broken_sequence_of_the_users_own_is_reported_at_its_place(
    name: str, line: int, column: int, tmp_path: Path
) -> None:
    (tmp_path / "sequences").mkdir()
    shutil.copy(BAD / f"{name}.yaml", tmp_path / "sequences" / "slow_start.yaml")
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert places(failure) == [(name[:6], line, column)]


@pytest.mark.parametrize(("name", "line", "column"), PLANTS)
def test_a_broken_plant_file_is_reported_at_its_place(name: str, line: int, column: int) -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_plant(BAD / f"{name}.yaml")
    assert places(failure) == [(name[:6], line, column)]


def test_every_broken_file_is_tried() -> None:
    tried = {row[0] for row in (*ENTRIES, *SEQUENCES, *PLANTS)}
    translations = {"FB1112_translation"}  # read by the generator, tried with its texts
    assert {path.stem for path in BAD.glob("FB[12]*.yaml")} == tried | translations


def test_every_code_has_a_page_with_a_failing_and_a_fixed_example() -> None:
    packages = (fbgen.catalog, fbgen.plant, fbgen.blocks, fbgen.wire.gsd)
    folders = [Path(str(package.__file__)).parent for package in packages]
    text = "\n".join(path.read_text("utf-8") for folder in folders for path in folder.glob("*.py"))
    codes = set(re.findall(r'"(FB[12]\d{3})"', text))
    assert len(codes) > 40
    for code in codes:
        page = (shipped("diagnostics") / f"{code}.md").read_text("utf-8")
        assert page.startswith(f"# {code}: ")
        assert "## Fails\n\n```" in page
        assert "## Fixed\n\n```" in page
    pages = {path.stem for path in shipped("diagnostics").glob("FB[12]*.md")}
    assert pages == codes
