"""The page of each diagnostic code, which `fbgen explain` prints: its title and how bad it is.

A page begins `# CODE: title`; its first paragraph begins with "A warning" or "A hint" for what is
no error.
"""

from functools import cache
from pathlib import Path

from fbgen.diagnostics import Severity
from fbgen.resources import shipped

_SEVERITIES = {"A warning": Severity.WARNING, "A hint": Severity.INFO}


@cache
def pages() -> dict[str, Path]:
    """All pages by their code, in the order of the codes."""
    return {page.stem: page for page in sorted(shipped("diagnostics").glob("FB*.md"))}


@cache
def title_of(code: str) -> str:
    """What the code means, in a few words."""
    return _lines(code)[0].partition(": ")[2]


@cache
def severity_of(code: str) -> Severity:
    """How bad a finding with this code is."""
    meaning = next(line for line in _lines(code)[1:] if line)
    for beginning, severity in _SEVERITIES.items():
        if meaning.startswith(beginning):
            return severity
    return Severity.ERROR


def _lines(code: str) -> list[str]:
    return pages()[code].read_text(encoding="utf-8").splitlines()
