"""Coverage in the form that somebody asks for: `html=FILE`, or a file whose ending says it."""

from collections.abc import Mapping
from pathlib import Path
from typing import NamedTuple

from fbgen.diagnostics import error
from fbgen.writing import replace_file
from harness.verify.coverage.cobertura import cobertura
from harness.verify.coverage.collecting import Coverage
from harness.verify.coverage.lcov import lcov
from harness.verify.coverage.naming import report_names
from harness.verify.coverage.page import page
from harness.verify.coverage.storing import as_text

SUFFIXES = {".html": "html", ".xml": "cobertura", ".info": "lcov", ".lcov": "lcov", ".json": "json"}
"""Which form an ending means."""
WHOLE = {"html": "index.html", "cobertura": "cobertura.xml", "lcov": "lcov.info"}
WHOLE |= {"json": "coverage.json"}
"""The files of a folder with everything."""
SOURCES = "sources"
"""The folder in it with the text that was generated."""


class Target(NamedTuple):
    """A report that is asked for. The form of a folder with everything is ""."""

    form: str
    path: Path


def parse_target(text: str) -> Target:
    """`FORM=FILE`, a file with a known ending, or a folder. Raises DiagnosticError FB8053."""
    form, sign, rest = text.partition("=")
    if sign and form in WHOLE:
        return Target(form, Path(rest))
    path = Path(text)
    if path.is_dir() or text.endswith(("/", "\\")):
        return Target("", path)
    if path.suffix.lower() in SUFFIXES:
        return Target(SUFFIXES[path.suffix.lower()], path)
    raise error(
        "FB8053",
        f"'{text}' does not say which report of coverage it shall be",
        help=f"let it end in {', '.join(SUFFIXES)}, write {'=, '.join(WHOLE)}= before it, "
        "or / behind a folder for all of them",
    )


def contents(coverage: Coverage, target: Target) -> Mapping[Path, bytes]:
    """The files of a report."""
    if target.form:
        return {target.path: _text(coverage, target.form).encode()}
    folder = target.path
    files = {folder / name: _text(coverage, form).encode() for form, name in WHOLE.items()}
    names = report_names(coverage)
    for key, counts in coverage.files.items():
        if counts.plants:
            files[folder / SOURCES / names[key]] = key.text.encode()
    return files


def write(coverage: Coverage, target: str | Path | Target) -> None:
    """Write a report over the last one; `target` as `fbgen test --coverage` takes it.

    Raises DiagnosticError FB8053, and OSError for a place that cannot be written.
    """
    if isinstance(target, Target):
        wanted = target
    else:
        wanted = parse_target(target if isinstance(target, str) else target.as_posix())
    for path, data in contents(coverage, wanted).items():
        path.parent.mkdir(parents=True, exist_ok=True)
        replace_file(path, data)


def _text(coverage: Coverage, form: str) -> str:
    if form == "html":
        return page(coverage)
    if form == "cobertura":
        return cobertura(coverage)
    return lcov(coverage) if form == "lcov" else as_text(coverage)
