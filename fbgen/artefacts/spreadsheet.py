"""Workbooks (.xlsx) with nothing but texts, the same bytes for the same content on every machine.

TIA Portal's own exports hold every value as a text, numbers as well. A workbook is a zip archive of
XML parts; here the parts are stored without compression, because what a compressor makes of them
depends on the zlib that Python was built with, and all have the first date that a zip can say.
Source: ECMA-376, part 1 (SpreadsheetML: 18.2 workbook, 18.3 worksheets, 18.4 shared strings), part
2 (packages).
"""

from collections.abc import Mapping, Sequence
from dataclasses import field
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
_CELL = '<c r="%s" t="s"><v>%s</v></c>'
_ROW = "\0"
"""Stands for the number of a row in the pattern of its cells."""
_TEXT_FORMAT = 49
"""The built-in number format `@`: a text, whatever it looks like."""


@dataclass(frozen=True, slots=True)
class Sheet:
    """A sheet: its name and its rows, the first of which has the names of the columns.

    `same` has columns with one text in all rows below, which these rows leave out.
    """

    name: str
    rows: Sequence[Sequence[str]]
    same: Mapping[int, str] = field(default_factory=dict)


def workbook(sheets: Sequence[Sheet]) -> bytes:
    """The bytes of a workbook with these sheets."""
    indices: dict[str, int] = {}
    worksheets = [_worksheet(sheet, indices) for sheet in sheets]
    texts = {
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
    parts = {name: (_HEAD + text).encode("utf-8") for name, text in texts.items()}
    parts |= {f"xl/worksheets/sheet{n}.xml": data for n, data in enumerate(worksheets, start=1)}
    target = BytesIO()
    with ZipFile(target, "w", ZIP_STORED) as archive:
        for name, data in parts.items():
            entry = ZipInfo(name, _FIRST_DATE)
            entry.create_system = 0
            archive.writestr(entry, data)
    return target.getvalue()


def column(index: int) -> str:
    """The letters of a column: 0 is A, 26 is AA."""
    letters = ""
    index += 1
    while index:
        index, rest = divmod(index - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters


def _worksheet(sheet: Sheet, indices: dict[str, int]) -> bytes:
    """Texts that are new get the next indices, row by row in the order of the columns."""
    written = [f'{_HEAD}<worksheet xmlns="{_MAIN}"><sheetData>'.encode()]
    for number, row in enumerate(sheet.rows, start=1):
        if number <= 2:
            written.append(_row(number, row if number == 1 else _whole(row, sheet.same), indices))
            pattern = _pattern(len(row), sheet.same, indices) if number == 2 else []
        elif len(row) == len(sheet.rows[1]) and "" not in row:
            places = [indices.setdefault(text, len(indices)) for text in row]
            written.append((b"%d" % number).join(pattern) % (number, *places))
        else:
            written.append(_row(number, _whole(row, sheet.same), indices))
    written.append(b"</sheetData></worksheet>")
    return b"".join(written)


def _row(number: int, row: Sequence[str], indices: dict[str, int]) -> bytes:
    cells = "".join(
        _CELL % (f"{column(index)}{number}", indices.setdefault(text, len(indices)))
        for index, text in enumerate(row)
        if text
    )
    return f'<row r="{number}">{cells}</row>'.encode()


def _whole(row: Sequence[str], same: Mapping[int, str]) -> list[str]:
    """The row with the texts that are the same in all."""
    rest = iter(row)
    return [same[index] if index in same else next(rest) for index in range(len(row) + len(same))]


def _pattern(cells: int, same: Mapping[int, str], indices: Mapping[str, int]) -> list[bytes]:
    """A row with so many cells of its own in pieces, between which its number stands."""
    pattern = "".join(
        _CELL % (f"{column(index)}{_ROW}", indices[same[index]] if index in same else "%d")
        for index in range(cells + len(same))
    )
    return f'<row r="%d">{pattern}</row>'.encode().split(_ROW.encode())


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
    """One format for all cells, which name none."""
    same = 'fontId="0" fillId="0" borderId="0"'
    return (
        f'<styleSheet xmlns="{_MAIN}">'
        '<fonts count="1"><font><sz val="11"/><name val="Calibri"/></font></fonts>'
        '<fills count="2"><fill><patternFill patternType="none"/></fill>'
        '<fill><patternFill patternType="gray125"/></fill></fills>'
        '<borders count="1"><border><left/><right/><top/><bottom/><diagonal/></border></borders>'
        f'<cellStyleXfs count="1"><xf numFmtId="0" {same}/></cellStyleXfs>'
        f'<cellXfs count="1"><xf numFmtId="{_TEXT_FORMAT}" {same} xfId="0" '
        'applyNumberFormat="1"/></cellXfs>'
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
