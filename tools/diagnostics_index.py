"""Writes docs/reference/diagnostics.md, the list of all codes, from their pages."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT))

from fbgen.diagnostics import Severity  # noqa: E402  (the checkout has to be on the path first)
from fbgen.pages import pages, severity_of, title_of  # noqa: E402  (as above)

_HEAD = """\
# All messages

`fbgen explain CODE` prints the page of a code: what it means, a text that fails, a text that is
right. Errors stop the work. Warnings are likely mistakes; `// fbgen: allow CODE` silences one
place, and `fbgen check --strict` makes them count. Hints are shown with `--severity info`.

Ranges: FB1 catalogue, YAML and GSD, FB2 plant file, FB3 reading PLC text, FB4 checking PLC text,
FB5 generating, FB6 running PLC text, FB7 plant simulation, FB8 scenarios, FB9 command line and
files.

This list is made from the pages by `python tools/diagnostics_index.py`.

| code | kind | what |
|---|---|---|
"""
_WORDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "hint"}


def main() -> None:
    """Write the list anew."""
    rows = [
        f"| [{code}](diagnostics/{code}.md) | {_WORDS[severity_of(code)]} | {title_of(code)} |\n"
        for code in pages()
    ]
    target = ROOT / "docs" / "reference" / "diagnostics.md"
    target.write_text(_HEAD + "".join(rows), encoding="utf-8")


main()
