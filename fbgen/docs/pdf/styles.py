"""Fonts, sizes and colours of the handbook. The fonts are those that every reader has."""

from reportlab.lib.colors import HexColor
from reportlab.lib.pagesizes import A4, landscape
from reportlab.lib.styles import ParagraphStyle
from reportlab.platypus import TableStyle

from fbgen.docs.drawing import PRINTED

PAGE = landscape(A4)
MARGIN = 42.0
WIDTH = PAGE[0] - 2 * MARGIN
_INK, _MUTED, _LINE = (HexColor(PRINTED[name]) for name in ("ink", "muted", "line"))

BODY = ParagraphStyle("body", fontName="Helvetica", fontSize=9.5, leading=13, textColor=_INK)
BODY.spaceAfter = 5
LEAD = ParagraphStyle("lead", BODY, fontSize=10.5, leading=14.5, textColor=_MUTED, spaceAfter=8)
TITLE = ParagraphStyle("title", BODY, fontName="Helvetica-Bold", fontSize=30, leading=36)
CHAPTER = ParagraphStyle("chapter", BODY, fontName="Helvetica-Bold", fontSize=22, leading=28)
HEADING = ParagraphStyle(
    "heading", BODY, fontName="Helvetica-Bold", fontSize=15, leading=19, spaceBefore=12
)
SECTION = ParagraphStyle(
    "section", BODY, fontName="Helvetica-Bold", fontSize=11, leading=15, spaceBefore=8
)
CELL = ParagraphStyle("cell", BODY, fontSize=7.6, leading=9.6, spaceAfter=0)
HEAD = ParagraphStyle("head", CELL, fontName="Helvetica-Bold")
NOTICE = ParagraphStyle("notice", BODY, leftIndent=8, borderPadding=5, spaceBefore=5, spaceAfter=10)
NOTICE.backColor = HexColor(PRINTED["warning"])
BULLET = ParagraphStyle("bullet", BODY, leftIndent=14, bulletIndent=4, spaceAfter=2)
SAMPLE = ParagraphStyle("sample", BODY, fontName="Courier", fontSize=7.8, leading=9.8, spaceAfter=8)
CONTENTS = [
    ParagraphStyle("group", BODY, fontName="Helvetica-Bold", spaceBefore=6, spaceAfter=1),
    ParagraphStyle("page", BODY, leftIndent=14, spaceAfter=0, leading=12),
]

GRID = TableStyle(
    [
        ("VALIGN", (0, 0), (-1, -1), "TOP"),
        ("LINEBELOW", (0, 0), (-1, -1), 0.4, _LINE),
        ("BACKGROUND", (0, 0), (-1, 0), HexColor("#eef1f5")),
        ("LEFTPADDING", (0, 0), (-1, -1), 4),
        ("RIGHTPADDING", (0, 0), (-1, -1), 4),
        ("TOPPADDING", (0, 0), (-1, -1), 2),
        ("BOTTOMPADDING", (0, 0), (-1, -1), 2.5),
    ]
)
PLAIN = TableStyle(
    [
        ("VALIGN", (0, 0), (-1, -1), "TOP"),
        ("LEFTPADDING", (0, 0), (-1, -1), 0),
        ("TOPPADDING", (0, 0), (-1, -1), 0.5),
        ("BOTTOMPADDING", (0, 0), (-1, -1), 0.5),
    ]
)
