"""Generated sets with everything beside them, and how the files are read back."""

import csv
from functools import cache
from io import BytesIO, StringIO

from openpyxl import load_workbook

from fbgen.artefacts import with_artefacts
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import in_dialect, read_plant
from fbgen.source import Source
from tests.unit.blocks.programs import FIVE_DRIVES, shipped_catalog

TWO_GATEWAYS = """\
version: 1
name: hall
dialect: tia
plc: s7-1500
sequences: [start_forward, read_current]
gateways:
  - name: north
    title: Hall north
    type: tospbdp001
    layout: gsd10
    profibus_address: 2
    access: process_image
    input_address: 0
    output_address: 4
    drives:
      - {name: infeed, title: "Infeed, belt <1>", inv_no: 1, series: vf-s11, max_frequency_hz: 50.0}
  - name: south
    type: tospbdp001
    layout: doc9
    profibus_address: 3
    access: process_image
    input_address: 20
    output_address: 20
    drives:
      - {name: pump, inv_no: 1, series: vf-s11, max_frequency_hz: 60.0}
      - {name: fan, inv_no: 2, series: vf-s11, max_frequency_hz: 50.0}
"""


def generated(text: str = TWO_GATEWAYS, dialect: str = "tia") -> GeneratedSet:
    """What is generated for a plant in a dialect, with all files beside the PLC text; made once."""
    return _kept(text, dialect)


def generated_anew(text: str, dialect: str) -> GeneratedSet:
    """The same, made now."""
    catalog = shipped_catalog()
    plant = in_dialect(read_plant(Source("plant.yaml", text), catalog), dialect, catalog)
    return with_artefacts(generate(plant, catalog), plant, catalog)


_kept = cache(generated_anew)


def data(name: str, text: str = TWO_GATEWAYS, dialect: str = "tia") -> bytes:
    """The bytes of the file with this name."""
    return generated(text, dialect).contents[name]


def sheets(book: bytes) -> dict[str, list[dict[str, str]]]:
    """The sheets of a workbook: each row by the names of its columns."""
    found = {}
    for sheet in load_workbook(BytesIO(book)):
        head, *rows = [["" if cell is None else cell for cell in row] for row in sheet.values]
        found[sheet.title] = [dict(zip(head, row, strict=True)) for row in rows]
    return found


def table(text: bytes) -> list[dict[str, str]]:
    """The rows of a CSV file by the names of the columns."""
    return list(csv.DictReader(StringIO(text.decode("utf-8-sig"), newline=""), strict=True))


__all__ = ["FIVE_DRIVES", "TWO_GATEWAYS", "data", "generated", "generated_anew", "sheets", "table"]
