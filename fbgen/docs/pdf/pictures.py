"""Drawings on a page, as lines and texts: sharp in print at any size."""

from reportlab.lib.colors import HexColor
from reportlab.pdfbase.pdfmetrics import stringWidth
from reportlab.platypus import Flowable

from fbgen.docs.drawing import PRINTED, Box, Drawing, Label, Line


class Picture(Flowable):
    """A drawing that shrinks to the room there is."""

    def __init__(self, drawing: Drawing) -> None:
        super().__init__()
        self._drawing = drawing
        self._scale = 1.0

    def wrap(self, width: float, height: float) -> tuple[float, float]:
        """How much room it takes."""
        drawing = self._drawing
        self._scale = min(0.85, width / drawing.width, height / drawing.height)
        return drawing.width * self._scale, drawing.height * self._scale

    def draw(self) -> None:
        """Put it on the page, whose origin is below."""
        canvas = self.canv
        canvas.saveState()
        canvas.translate(0, self._drawing.height * self._scale)
        canvas.scale(self._scale, self._scale)
        for shape in self._drawing.shapes:
            if isinstance(shape, Box):
                canvas.setFillColor(HexColor(PRINTED[shape.fill]))
                canvas.setStrokeColor(HexColor(PRINTED[shape.edge]))
                canvas.setLineWidth(1)
                place = (shape.x, -shape.y - shape.height, shape.width, shape.height)
                canvas.roundRect(*place, shape.round, stroke=1, fill=1)
            elif isinstance(shape, Line):
                self._line(shape)
            else:
                self._label(shape)
        canvas.restoreState()

    def _line(self, line: Line) -> None:
        canvas = self.canv
        canvas.setStrokeColor(HexColor(PRINTED[line.colour]))
        canvas.setLineWidth(line.width)
        canvas.setDash([4, 3] if line.dashed else [])
        path = canvas.beginPath()
        path.moveTo(line.points[0][0], -line.points[0][1])
        for x, y in line.points[1:]:
            path.lineTo(x, -y)
        canvas.drawPath(path)
        canvas.setDash([])
        if line.arrow:
            (x0, y0), (x, y) = line.points[-2], line.points[-1]
            length = ((x - x0) ** 2 + (y - y0) ** 2) ** 0.5 or 1.0
            ux, uy = (x - x0) / length, (y - y0) / length
            head = canvas.beginPath()
            head.moveTo(x, -y)
            head.lineTo(x - 7 * ux - 3 * uy, -(y - 7 * uy + 3 * ux))
            head.lineTo(x - 7 * ux + 3 * uy, -(y - 7 * uy - 3 * ux))
            head.close()
            canvas.setFillColor(HexColor(PRINTED[line.colour]))
            canvas.drawPath(head, stroke=0, fill=1)

    def _label(self, label: Label) -> None:
        canvas = self.canv
        font = "Courier" if label.fixed else "Helvetica"
        font += "-Bold" if label.strong else ""
        text = label.text.encode("cp1252", "replace").decode("cp1252")
        width = stringWidth(text, font, label.size)
        shift = {"start": 0.0, "middle": width / 2, "end": width}[label.anchor]
        canvas.setFillColor(HexColor(PRINTED[label.colour]))
        canvas.setFont(font, label.size)
        canvas.drawString(label.x - shift, -label.y, text)
