"""The symbol table of dialect step7: every symbol once, each with an address of its own."""

import csv
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.emit.generated import GeneratedFile
from fbgen.emit.generator import generate
from fbgen.lang import ast
from fbgen.lang.parser import parse
from fbgen.plant import in_dialect, load_plant
from fbgen.source import Source

EXAMPLES = Path(__file__).parents[3] / "examples"


def generated(example: str) -> tuple[GeneratedFile, tuple[GeneratedFile, ...]]:
    """Symbol table and sources of an example, without the error blocks, which need no symbol."""
    catalog = load_catalog()
    plant = in_dialect(load_plant(EXAMPLES / example / "plant.yaml", catalog), "step7", catalog)
    table, *sources, _ = generate(plant, catalog).files
    return table, tuple(sources)


@pytest.mark.parametrize("example", ["manual_example", "five_drives"])
def test_every_unit_of_the_source_has_one_line(example: str) -> None:
    table, sources = generated(example)
    named = [
        unit.name.name
        for source in sources
        for unit in parse(Source(source.name, source.text), "step7").units
        if isinstance(unit, ast.Block | ast.DataBlock | ast.TypeDeclaration)
    ]
    rows = list(csv.reader(table.text.splitlines()))
    assert [row[0].rstrip() for row in rows] == named
    assert len({row[1] for row in rows}) == len(rows)


def test_lines_are_as_step7_exports_them() -> None:
    table, _ = generated("manual_example")
    assert table.data.endswith(b"\r\n")
    for line in table.data.split(b"\r\n")[:-1]:
        widths = [len(field) for field in next(csv.reader([line.decode("ascii")]))]
        assert widths == [24, 12, 10, 80]


def test_an_instance_is_of_its_function_block_and_other_symbols_of_themselves() -> None:
    table, _ = generated("manual_example")
    rows = {row[0].rstrip(): row[1:3] for row in csv.reader(table.text.splitlines())}
    block = rows["TOS_Gateway_gw1"][0].strip()
    assert rows["TOS_Gateway_gw1_DB"] == ["DB    201   ", f"{block} "]
    assert rows["TOS_Plant"] == ["DB    200   ", "DB    200 "]
    number = [row[0] for row in rows.values() if row[0].startswith("FC")].index(rows["TOS_Main"][0])
    assert rows["TOS_Main"] == [f"FC    {200 + number}   ", f"FC    {200 + number} "]
    assert rows["typeTosInput"] == ["UDT   200   ", "UDT   200 "]
