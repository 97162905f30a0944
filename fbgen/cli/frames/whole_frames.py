"""Frames as people write them, taken apart, and frames made of fields: for decode and encode."""

from collections.abc import Sequence

from fbgen.cli.frames.cell_texts import CellTexts
from fbgen.cli.frames.frame_fields import Fields
from fbgen.cli.frames.frame_reading import Reading
from fbgen.cli.frames.modbus_reading import modbus_reading
from fbgen.cli.frames.modbus_writing import modbus_frame
from fbgen.cli.frames.toshiba_reading import toshiba_reading
from fbgen.cli.frames.toshiba_writing import toshiba_frame
from fbgen.diagnostics import error


def frame_reading(
    protocol: str, direction: str | None, text: str, cells: CellTexts, request: str | None
) -> Reading:
    """The reading of a frame as somebody writes it. A MODBUS reply may come with its request.

    Raises DiagnosticError FB9040 if these are no bytes, FB9041 if they are no frame, FB9045 if the
    frame is no reply to the request.
    """
    if protocol == "modbus":
        asked = None if request is None else bytes_of(request)
        return modbus_reading(bytes_of(text), direction, cells, asked)
    if request is not None:
        raise error(
            "FB9045", "a reply of the Toshiba protocol names its ComNo", help="leave out --request"
        )
    frame = _ascii(text) if text.lstrip().startswith("(") else bytes_of(text)
    return toshiba_reading(frame, direction, cells)


def written_frame(
    protocol: str, direction: str | None, fields: Sequence[str], cells: CellTexts
) -> Reading:
    """The reading of a frame made of its fields; without a direction it is a request.

    Raises DiagnosticError FB9042 and FB9043 with everything that is wrong with the fields.
    """
    way = direction or "request"
    given = Fields(fields, cells)
    if protocol == "modbus":
        return modbus_reading(modbus_frame(way, given), way, cells, None)
    return toshiba_reading(toshiba_frame(way, given), way, cells)


def bytes_of(text: str) -> bytes:
    """Bytes as people write them: `2F 0B 50`. Raises DiagnosticError FB9040."""
    plain = text.replace("_", " ").replace("0x", "").replace("16#", "")
    try:
        data = bytes.fromhex(plain)
    except ValueError:
        data = b""
    if not data:
        raise error(
            "FB9040",
            f"'{text}' are no bytes",
            help='write two hexadecimal digits for each byte: "2F 0B 50 FA 00 C4 00 48"',
        )
    return data


def _ascii(text: str) -> bytes:
    """The frame, which need not be written with its carriage return."""
    plain = text.strip().removesuffix("\\r").removesuffix("CR").rstrip()
    try:
        return plain.encode("ascii") + b"\r"
    except UnicodeEncodeError:
        raise error(
            "FB9040",
            f"'{text}' has characters that are not ASCII",
            help="write an ASCII frame as the manuals do: (PFA008400)",
        ) from None
