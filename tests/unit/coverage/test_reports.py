"""Reports: each form is read by somebody else's reader, and says the same."""

import json
from pathlib import Path

import pytest
from lcov_cobertura import LcovCobertura
from lxml import etree
from pycobertura import Cobertura

from fbgen.diagnostics import DiagnosticError
from fbgen.source import Source
from harness import load_program
from harness.verify.coverage import (
    Coverage,
    load,
    parse_limits,
    parse_target,
    too_little,
    write,
)
from harness.verify.coverage.cobertura import cobertura
from harness.verify.coverage.lcov import lcov
from harness.verify.coverage.naming import report_names
from harness.verify.coverage.page import page
from harness.verify.coverage.storing import as_text
from tests.unit.coverage.programs import BELT, belt

HERE = Path(__file__).parent
STARTED = {"start": True, "ready": True, "speed": 3}


def test_cobertura_is_as_its_dtd_says() -> None:
    document = etree.fromstring(cobertura(belt(STARTED)).encode())
    dtd = etree.DTD(str(HERE / "coverage-04.dtd"))
    assert dtd.validate(document), dtd.error_log


def test_cobertura_is_read_by_pycobertura(tmp_path: Path) -> None:
    path = tmp_path / "coverage.xml"
    path.write_text(cobertura(belt(STARTED)), encoding="utf-8")
    read = Cobertura(str(path))
    assert read.files() == ["belt.scl"]
    missed = [line for line, what in read.missed_lines("belt.scl") if what == "miss"]
    assert missed == [9, 12, 15]
    assert read.total_statements("belt.scl") == 12
    assert read.total_misses("belt.scl") == 7  # partial ones count there


def test_lcov_is_read_by_lcov_cobertura() -> None:
    document = etree.fromstring(LcovCobertura(lcov(belt(STARTED))).convert().encode())
    lines = {
        int(line.get("number")): int(line.get("hits"))
        for line in document.iterfind(".//class/lines/line")
    }
    assert {number for number, hits in lines.items() if not hits} == {9, 12, 15}
    assert lines[7] == 1
    assert document.get("branch-rate") == str(6 / 12)


def test_lcov_tells_branches_never_reached_from_branches_never_taken() -> None:
    text = 'FUNCTION_BLOCK "B" VAR_INPUT a, b : BOOL; END_VAR VAR q : INT; END_VAR BEGIN\n'
    text += "IF #a THEN\nIF #b THEN #q := 1; END_IF;\nEND_IF;\nEND_FUNCTION_BLOCK\n"
    coverage = Coverage()
    load_program([Source("b.scl", text)], probes=[coverage]).instance("B")()
    records = [line for line in lcov(coverage).split("\n") if line.startswith("BRDA")]
    assert records == ["BRDA:2,0,0,0", "BRDA:2,0,1,1", "BRDA:3,0,0,-", "BRDA:3,0,1,-"]


def test_json_gives_back_what_was_counted(tmp_path: Path) -> None:
    coverage = belt(STARTED, {"stop": True})
    write(coverage, tmp_path / "coverage.json")
    assert as_text(load(tmp_path / "coverage.json")) == as_text(coverage)


def test_merging_adds_the_counts(tmp_path: Path) -> None:
    both = Coverage()
    for number, inputs in enumerate((STARTED, {"stop": True})):
        path = tmp_path / f"{number}.json"
        write(belt(inputs), path)
        both.merge([load(path)])
    assert as_text(both) == as_text(belt(STARTED, {"stop": True}))


def test_merging_leaves_the_other_one_as_it_is() -> None:
    other = belt(STARTED)
    before = as_text(other)
    Coverage().merge([other, other])
    assert as_text(other) == before


def test_the_same_runs_give_the_same_files() -> None:
    assert [form(belt(STARTED)) for form in (as_text, lcov, cobertura, page)] == [
        form(belt(STARTED)) for form in (as_text, lcov, cobertura, page)
    ]


def test_the_page_holds_everything_and_asks_for_nothing() -> None:
    text = page(belt(STARTED))
    assert "://" not in text
    assert "src=" not in text
    data = text.partition('type="application/json">')[2].partition("</script>")[0]
    (block,) = json.loads(data)["texts"]
    assert block["text"] == BELT.rstrip("\n").split("\n")
    assert block["missing"][0] == [6, "branch", "never: ELSE"]


def test_text_of_a_program_cannot_end_the_script_of_the_page() -> None:
    text = 'FUNCTION_BLOCK "B" VAR q : INT; END_VAR BEGIN\n#q := 1; // </script><b>\n'
    text += "END_FUNCTION_BLOCK\n"
    coverage = Coverage()
    load_program([Source("b.scl", text)], probes=[coverage]).instance("B")()
    assert page(coverage).count("</script>") == 2


def test_a_folder_gets_everything(tmp_path: Path) -> None:
    write(belt(STARTED), f"{tmp_path.as_posix()}/report/")
    assert sorted(path.name for path in (tmp_path / "report").iterdir()) == [
        "cobertura.xml",
        "coverage.json",
        "index.html",
        "lcov.info",
    ]


def test_files_of_one_name_are_told_apart() -> None:
    coverage = belt(STARTED)
    other = BELT.replace("> 100", "> 50")
    load_program([Source("belt.scl", other)], probes=[coverage])
    assert sorted(report_names(coverage).values()) == ["belt-2.scl", "belt.scl"]


def test_a_report_without_a_known_form_is_refused() -> None:
    with pytest.raises(DiagnosticError, match="FB8053") as refused:
        parse_target("report.txt")
    assert "html=" in refused.value.diagnostics[0].help
    assert parse_target("html=report.txt") == ("html", Path("report.txt"))


@pytest.mark.parametrize("text", ["", "{}", "[]", '{"format": "fbgen-coverage", "version": 1}'])
def test_a_file_without_coverage_is_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "coverage.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(DiagnosticError, match="FB8050"):
        load(path)


def test_a_file_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError, match=r"FB8050.*No such file"):
        load(tmp_path / "coverage.json")


@pytest.mark.parametrize("text", ["branches=80", "branch=many", "branch=101", "branch", ""])
def test_a_wrong_demand_is_refused(text: str) -> None:
    with pytest.raises(DiagnosticError, match="FB8051"):
        parse_limits(text)


def test_too_little_is_said_for_each_kind() -> None:
    limits = parse_limits("90, branch=50, mcdc=10")
    found = list(too_little(belt(STARTED), limits))
    assert [one.code for one in found] == ["FB8052", "FB8052"]
    assert "the statement coverage is 69.2 % (9 of 13)" in found[0].message
    assert "the mcdc coverage is 0.0 % (0 of 3)" in found[1].message
