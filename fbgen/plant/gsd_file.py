"""The GSD file that a plant file names."""

from pathlib import Path

from fbgen.diagnostics import error
from fbgen.source import Span
from fbgen.wire.gsd import GsdStation, read_gsd


def read_gsd_file(path: Path, name: str, place: Span | None = None) -> GsdStation:
    """The station in a file, called `name` in messages; `place` is where a plant file names it.

    Raises DiagnosticError FB1008 for a file that cannot be read, FB1301 to FB1306 as `read_gsd`.
    """
    try:
        data = path.read_bytes()
    except OSError as problem:
        reason = problem.strerror or type(problem).__name__
        help_text = "name the GSD file of the device, beside the plant file or below it"
        raise error("FB1008", f"{name} cannot be read: {reason}", place, help_text) from None
    return read_gsd(data, name)
