"""How bad a finding is stands on its page, in the index and in the code that reports it."""

import ast
import re

import pytest

from fbgen.diagnostics import Severity
from fbgen.pages import pages, severity_of, title_of
from tests.architecture.sources import ROOT, modules, tree

INDEX = ROOT / "docs" / "reference" / "diagnostics.md"
CODE = re.compile(r"FB[1-9][0-9]{3}")
BY_METHOD = {"error": Severity.ERROR, "unknown": Severity.ERROR}
BY_METHOD |= {"warning": Severity.WARNING, "hint": Severity.INFO}


def reported_in_language() -> list[tuple[str, Severity, str]]:
    """(code, severity, place) of every report of a code in `fbgen.lang`."""
    found = []
    for name, path in modules().items():
        if not name.startswith("fbgen.lang"):
            continue
        for node in ast.walk(tree(path)):
            if not isinstance(node, ast.Call) or not node.args:
                continue
            code = node.args[0]
            if not (isinstance(code, ast.Constant) and CODE.fullmatch(str(code.value))):
                continue
            called = node.func.attr if isinstance(node.func, ast.Attribute) else ""
            severity = BY_METHOD.get(called)
            if isinstance(node.func, ast.Name) and node.func.id == "Diagnostic":
                given = [one.value for one in node.keywords if one.arg == "severity"]
                text = ast.unparse(given[0]) if given else "Severity.ERROR"
                severity = {f"Severity.{one.name}": one for one in Severity}.get(text)
            if severity is not None:
                found.append((str(code.value), severity, f"{name}:{node.lineno}"))
    return found


def test_the_search_finds_the_reports() -> None:
    assert len(reported_in_language()) > 100


def test_a_page_says_how_bad_its_finding_is() -> None:
    wrong = [
        f"{code} is reported as {severity.value} in {place}"
        for code, severity, place in reported_in_language()
        if severity_of(code) is not severity
    ]
    assert wrong == []


@pytest.mark.parametrize("code", ["FB4001", "FB4101", "FB4242"])
def test_the_three_kinds_are_told_apart(code: str) -> None:
    kinds = {"FB4001": Severity.ERROR, "FB4101": Severity.WARNING, "FB4242": Severity.INFO}
    assert severity_of(code) is kinds[code]


def test_the_index_lists_every_code_with_its_title() -> None:
    listed = re.findall(
        r"^\| \[(FB\d{4})\]\(diagnostics/\1\.md\) \| (\w+) \| (.+) \|$",
        INDEX.read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    expected = [(code, _WORDS[severity_of(code)], title_of(code)) for code in pages()]
    assert listed == expected, "write the index anew: python tools/diagnostics_index.py"


_WORDS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "hint"}
