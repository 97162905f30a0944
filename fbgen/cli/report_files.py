"""Files with reports that commands write beside their result."""

from collections.abc import Sequence
from pathlib import Path

from fbgen.cli.files import write_file
from fbgen.diagnostics import Diagnostic, DiagnosticError


def write_report(path: Path, text: str) -> Sequence[Diagnostic]:
    """Write it over the last one. FB9002 as a finding, so that other reports are still written."""
    try:
        write_file(path, text, overwrite=True)
    except DiagnosticError as wrong:
        return wrong.diagnostics
    return ()
