"""The outputs of `fbgen check` for other programs."""

import json
from hashlib import sha256
from pathlib import Path
from urllib.parse import unquote

import pytest

from fbgen.cli.reports.check_report import CheckReport
from tests.unit.cli.running import Fbgen, Run

_TEXT = """\
FUNCTION_BLOCK "Fan: 100%, new"
VAR_INPUT speed : INT; END_VAR
VAR_OUTPUT y : INT; END_VAR
BEGIN
    #y := #y;
    #y := "Missing"(#speed);
    #y := "Missing"(TRUE);
END_FUNCTION_BLOCK
"""


@pytest.fixture
def run(fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Run:
    """The file in the folder of the process, as SARIF."""
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "my blocks"
    folder.mkdir()
    (folder / "fan.scl").write_text(_TEXT, encoding="utf-8")
    return fbgen("check", "my blocks", "--format", "sarif")


def test_sarif_has_what_the_standard_asks_for(run: Run) -> None:
    assert (run.status, run.err) == (1, "")
    log = json.loads(run.out)
    assert log["version"] == "2.1.0"
    (only,) = log["runs"]
    driver = only["tool"]["driver"]
    assert driver["name"] == "fbgen"
    assert only["columnKind"] == "unicodeCodePoints"
    ids = [rule["id"] for rule in driver["rules"]]
    assert ids == sorted(set(ids))
    for result in only["results"]:
        assert ids[result["ruleIndex"]] == result["ruleId"]
        assert result["level"] in ("error", "warning", "note", "none")
        assert result["message"]["text"]


@pytest.mark.parametrize(
    ("output", "shown"),
    [
        ("sarif", {"FB4004": "error", "FB4101": "warning"}),
        ("json", {"FB4004": "error", "FB4101": "warning"}),
        ("gitlab", {"FB4004": "major", "FB4101": "minor"}),
        ("github", {"FB4004": "error", "FB4101": "warning"}),
    ],
)
def test_errors_and_warnings_are_told_apart(
    fbgen: Fbgen, tmp_path: Path, output: str, shown: dict[str, str]
) -> None:
    text = (
        'FUNCTION_BLOCK "Fan"\nVAR_OUTPUT y : INT; END_VAR\nVAR x : INT; END_VAR\nBEGIN\n'
        '    #y := "Missing"(1);\nEND_FUNCTION_BLOCK\n'
    )
    (tmp_path / "fan.scl").write_text(text, encoding="utf-8")
    out = fbgen("check", str(tmp_path), "--format", output).out
    if output == "sarif":
        found = {one["ruleId"]: one["level"] for one in json.loads(out)["runs"][0]["results"]}
    elif output == "json":
        found = {one["code"]: one["severity"] for one in json.loads(out)["diagnostics"]}
    elif output == "gitlab":
        found = {one["check_name"]: one["severity"] for one in json.loads(out)}
    else:
        found = {line.partition("title=")[2][:6]: line[2:].split()[0] for line in out.splitlines()}
    assert found == shown


def test_sarif_shows_the_page_of_each_rule(run: Run) -> None:
    for rule in json.loads(run.out)["runs"][0]["tool"]["driver"]["rules"]:
        assert rule["shortDescription"]["text"]
        assert rule["help"]["markdown"].startswith(f"# {rule['id']}: ")
        assert rule["help"]["text"]


def test_sarif_says_where(run: Run) -> None:
    results = json.loads(run.out)["runs"][0]["results"]
    places = [one["locations"][0]["physicalLocation"] for one in results]
    assert {unquote(place["artifactLocation"]["uri"]) for place in places} == {"my blocks/fan.scl"}
    assert all(" " not in place["artifactLocation"]["uri"] for place in places)
    assert [
        (one["ruleId"], place["region"]) for one, place in zip(results, places, strict=True)
    ] == [
        ("FB4233", {"startLine": 5, "startColumn": 5, "endLine": 5, "endColumn": 14}),
        ("FB4004", {"startLine": 6, "startColumn": 11, "endLine": 6, "endColumn": 20}),
    ]
    (related,) = results[1]["relatedLocations"]
    assert related["physicalLocation"]["region"]["startLine"] == 7


def test_json_follows_its_schema(fbgen: Fbgen, run: Run) -> None:
    assert run.status == 1
    data = json.loads(fbgen("check", "my blocks", "--format", "json").out)
    report = CheckReport.model_validate(data)
    assert (report.errors, report.warnings) == (1, 1)
    assert [program.dialect for program in report.programs] == ["tia"]
    assert [one.line for one in report.diagnostics] == [5, 6]
    notes = report.diagnostics[1].notes
    assert notes is not None
    assert [note.line for note in notes] == [7]


def test_github_lines_are_escaped(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "a,b.scl"
    path.write_text(_TEXT, encoding="utf-8")
    lines = fbgen("check", str(path), "--format", "github").out.splitlines()
    assert len(lines) == 2
    assert lines[0].startswith("::warning title=FB4233,file=")
    assert "a%2Cb.scl,line=5,endLine=5,col=5,endColumn=14::" in lines[0]
    assert "%0A" in lines[0]


def test_gitlab_findings_have_fingerprints_of_their_own(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "a.scl"
    twice = _TEXT.replace("    #y := #y;\n", "    #y := #y;\n    #y := #y;\n")
    path.write_text(twice, encoding="utf-8")
    report = json.loads(fbgen("check", str(path), "--format", "gitlab").out)
    assert [one["location"]["lines"]["begin"] for one in report] == [5, 6, 7]
    assert [one["severity"] for one in report] == ["minor", "minor", "major"]
    prints = [one["fingerprint"] for one in report]
    assert len(set(prints)) == len(prints) == 3
    assert all(len(one) == len(sha256().hexdigest()) for one in prints)
