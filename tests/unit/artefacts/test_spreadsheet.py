"""Workbooks, read back by openpyxl."""

from io import BytesIO
from zipfile import ZIP_STORED, ZipFile

import pytest
from openpyxl import load_workbook
from openpyxl.utils import get_column_letter

from fbgen.artefacts.spreadsheet import Sheet, column, workbook

ROWS = [
    ["Name", "A & B", "<No value>"],
    ["  two  blanks  ", 'quoted "text"', "line\nbreak"],
    ["0815", "=1+1", ""],
    ["Förderband", "True", "€"],
]


def test_every_value_comes_back_as_the_text_that_it_was() -> None:
    book = load_workbook(BytesIO(workbook([Sheet("First", ROWS), Sheet("Second", [["x"]])])))
    assert book.sheetnames == ["First", "Second"]
    values = [["" if cell is None else cell for cell in row] for row in book["First"].values]
    assert values == ROWS
    assert [list(row) for row in book["Second"].values] == [["x"]]


def test_cells_have_the_format_of_texts() -> None:
    sheet = load_workbook(BytesIO(workbook([Sheet("First", ROWS)])))["First"]
    assert {cell.number_format for row in sheet for cell in row if cell.value} == {"@"}
    assert {cell.data_type for row in sheet for cell in row if cell.value} <= {"s", "f"}


def test_a_text_that_looks_like_a_formula_is_stored_as_a_text() -> None:
    with ZipFile(BytesIO(workbook([Sheet("First", ROWS)]))) as archive:
        assert b"<f>" not in archive.read("xl/worksheets/sheet1.xml")


def test_nothing_in_it_depends_on_time_or_compressor() -> None:
    book = workbook([Sheet("First", ROWS)])
    assert book == workbook([Sheet("First", ROWS)])
    with ZipFile(BytesIO(book)) as archive:
        assert archive.testzip() is None
        entries = archive.infolist()
    assert {entry.date_time for entry in entries} == {(1980, 1, 1, 0, 0, 0)}
    assert {entry.compress_type for entry in entries} == {ZIP_STORED}
    assert {entry.create_system for entry in entries} == {0}


@pytest.mark.parametrize("index", [0, 25, 26, 51, 52, 701, 702, 16383])
def test_columns_have_the_letters_of_a_spreadsheet(index: int) -> None:
    assert column(index) == get_column_letter(index + 1)
