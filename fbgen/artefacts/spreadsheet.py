"""Workbooks (.xlsx) with nothing but texts, the same bytes for the same content on every machine.

TIA Portal's own exports hold every value as a text, numbers as well. A workbook is a zip archive of
XML parts; here the parts are stored without compression, because what a compressor makes of them
depends on the zlib that Python was built with, and all have the first date that a zip can say.
Source: ECMA-376, part 1 (SpreadsheetML: 18.2 workbook, 18.3 worksheets, 18.4 shared strings), part
2 (packages).
"""

from collections.abc import Iterator, Mapping, Sequence
from html import escape
from io import BytesIO
from zipfile import ZIP_STORED, ZipFile, ZipInfo

from fbgen.dataclass import dataclass

_FIRST_DATE = (1980, 1, 1, 0, 0, 0)
_HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
_MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
_OF_DOCUMENT = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_OF_PACKAGE = "http://schemas.openxmlformats.org/package/2006"
_CONTENT = "application/vnd.openxmlformats-officedocument.spreadsheetml."
_ROW = "\0"
"""Stands for the number of a row in the pattern of its cells."""
_TEXT_FORMAT = 49
"""The built-in number format `@`: a text, whatever it looks like."""


@dataclass(frozen=True, slots=True)
class Sheet:
    """A sheet: its name and its rows, the first of which has the names of the columns."""

    name: str
    rows: Sequence[Sequence[str]]


def workbook(sheets: Sequence[Sheet]) -> bytes:
    """The bytes of a workbook with these sheets."""
    indices: dict[str, int] = {}
    worksheets = [_worksheet(sheet, indices) for sheet in sheets]
    parts = {
        "[Content_Types].xml": _content_types(len(sheets)),
        "_rels/.rels": _relations([("officeDocument", "xl/workbook.xml")]),
        "xl/workbook.xml": _workbook(sheets),
        "xl/_rels/workbook.xml.rels": _relations(
            [
                *(("worksheet", f"worksheets/sheet{n}.xml") for n in range(1, len(sheets) + 1)),
                ("styles", "styles.xml"),
                ("sharedStrings", "sharedStrings.xml"),
            ]
        ),
        "xl/styles.xml": _styles(),
        "xl/sharedStrings.xml": _shared_strings(indices),
    }
    parts |= {f"xl/worksheets/sheet{n}.xml": text for n, text in enumerate(worksheets, start=1)}
    target = BytesIO()
    with ZipFile(target, "w", ZIP_STORED) as archive:
        for name, text in parts.items():
            entry = ZipInfo(name, _FIRST_DATE)
            entry.create_system = 0
            archive.writestr(entry, (_HEAD + text).encode("utf-8"))
    return target.getvalue()


def column(index: int) -> str:
    """The letters of a column: 0 is A, 26 is AA."""
    letters = ""
    index += 1
    while index:
        index, rest = divmod(index - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters


def _worksheet(sheet: Sheet, indices: dict[str, int]) -> str:
    width = max((len(row) for row in sheet.rows), default=0)
    cells = [f'<c r="{column(index)}{_ROW}" s="1" t="s"><v>%d</v></c>' for index in range(width)]
    rows = [_row(number, row, cells, indices) for number, row in enumerate(sheet.rows[:2], start=1)]
    rows += _rows_below(sheet.rows[2:], cells, indices, _same_everywhere(sheet.rows[1:], width))
    return f'<worksheet xmlns="{_MAIN}"><sheetData>{"".join(rows)}</sheetData></worksheet>'


def _row(number: int, row: Sequence[str], cells: Sequence[str], indices: dict[str, int]) -> str:
    """A row of a sheet. Texts that are new get the next indices, in the order of the columns."""
    places = tuple([indices.setdefault(text, len(indices)) for text in row if text])
    pattern = "".join(cell for cell, text in zip(cells, row, strict=False) if text)
    inside = (pattern % places).replace(_ROW, str(number))
    return f'<row r="{number}">{inside}</row>'


def _same_everywhere(rows: Sequence[Sequence[str]], width: int) -> dict[int, str]:
    """The columns with one text in all rows, in which no column is empty."""
    if not rows or any(len(row) != width or "" in row for row in rows):
        return {}
    return {
        index: text for index, text in enumerate(rows[0]) if {row[index] for row in rows} == {text}
    }


def _rows_below(
    rows: Sequence[Sequence[str]],
    cells: Sequence[str],
    indices: dict[str, int],
    same: Mapping[int, str],
) -> Iterator[str]:
    """The rows behind the first one with content: what is the same in all is written only once."""
    if not same:
        yield from (_row(number, row, cells, indices) for number, row in enumerate(rows, start=3))
        return
    pattern = "".join(
        cell % indices[same[index]] if index in same else cell for index, cell in enumerate(cells)
    )
    others = [index for index in range(len(cells)) if index not in same]
    for number, row in enumerate(rows, start=3):
        places = tuple([indices.setdefault(row[index], len(indices)) for index in others])
        inside = (pattern % places).replace(_ROW, str(number))
        yield f'<row r="{number}">{inside}</row>'


def _shared_strings(indices: dict[str, int]) -> str:
    items = "".join(
        f'<si><t xml:space="preserve">{escape(text, quote=False)}</t></si>' for text in indices
    )
    return f'<sst xmlns="{_MAIN}" uniqueCount="{len(indices)}">{items}</sst>'


def _workbook(sheets: Sequence[Sheet]) -> str:
    listed = "".join(
        f'<sheet name="{escape(sheet.name, quote=False)}" sheetId="{n}" r:id="rId{n}"/>'
        for n, sheet in enumerate(sheets, start=1)
    )
    return (
        f'<workbook xmlns="{_MAIN}" xmlns:r="{_OF_DOCUMENT}"><sheets>{listed}</sheets></workbook>'
    )


def _styles() -> str:
    same = 'fontId="0" fillId="0" borderId="0"'
    return (
        f'<styleSheet xmlns="{_MAIN}">'
        '<fonts count="1"><font><sz val="11"/><name val="Calibri"/></font></fonts>'
        '<fills count="2"><fill><patternFill patternType="none"/></fill>'
        '<fill><patternFill patternType="gray125"/></fill></fills>'
        '<borders count="1"><border><left/><right/><top/><bottom/><diagonal/></border></borders>'
        f'<cellStyleXfs count="1"><xf numFmtId="0" {same}/></cellStyleXfs>'
        f'<cellXfs count="2"><xf numFmtId="0" {same} xfId="0"/>'
        f'<xf numFmtId="{_TEXT_FORMAT}" {same} xfId="0" applyNumberFormat="1"/></cellXfs>'
        '<cellStyles count="1"><cellStyle name="Normal" xfId="0" builtinId="0"/></cellStyles>'
        "</styleSheet>"
    )


def _relations(targets: Sequence[tuple[str, str]]) -> str:
    listed = "".join(
        f'<Relationship Id="rId{n}" Type="{_OF_DOCUMENT}/{kind}" Target="{target}"/>'
        for n, (kind, target) in enumerate(targets, start=1)
    )
    return f'<Relationships xmlns="{_OF_PACKAGE}/relationships">{listed}</Relationships>'


def _content_types(sheets: int) -> str:
    parts = {
        "/xl/workbook.xml": "sheet.main",
        "/xl/styles.xml": "styles",
        "/xl/sharedStrings.xml": "sharedStrings",
    }
    parts |= {f"/xl/worksheets/sheet{n}.xml": "worksheet" for n in range(1, sheets + 1)}
    listed = "".join(
        f'<Override PartName="{name}" ContentType="{_CONTENT}{kind}+xml"/>'
        for name, kind in parts.items()
    )
    return (
        f'<Types xmlns="{_OF_PACKAGE}/content-types"><Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Default Extension="xml" ContentType="application/xml"/>{listed}</Types>'
    )
