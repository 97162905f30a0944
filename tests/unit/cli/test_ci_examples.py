"""The examples for CI servers: each command in them works, in the folder that they speak of."""

import re
import shlex
import shutil
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from fbgen.cli.table import table
from harness.verify.coverage import HEADINGS, Coverage, rows
from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
EXAMPLES = ROOT / "examples" / "ci"
SCENARIO = """\
version: 1
title: A drive stands
plant: ../plant.yaml
steps:
  - expect: {drive.pump.frequency: 0.0}
"""


def lines_of(data: object) -> Iterator[str]:
    """Everything that a shell runs."""
    if isinstance(data, list):
        for item in data:
            yield from lines_of(item)
    elif isinstance(data, dict):
        for key, value in data.items():
            if key in {"run", "script", "before_script"}:
                yield from [value] if isinstance(value, str) else value
            else:
                yield from lines_of(value)


def read(name: str) -> dict[str, object]:
    data = yaml.safe_load((EXAMPLES / name).read_text("utf-8"))
    assert isinstance(data, dict)
    return data


@pytest.mark.parametrize(
    ("name", "left"),
    [
        (
            "github-actions.yaml",
            ["reports/report.html", "reports/results.xml", "reports/coverage/index.html"],
        ),
        (
            "gitlab-ci.yaml",
            [
                *("gl-code-quality-report.json", "reports/report.html", "reports/results.xml"),
                "reports/coverage/cobertura.xml",
            ],
        ),
    ],
)
def test_every_command_succeeds_and_leaves_what_is_kept(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, left: list[str]
) -> None:
    shutil.copy(ROOT / "tests" / "scenarios" / "one_drive.yaml", tmp_path / "plant.yaml")
    (tmp_path / "scenarios").mkdir()
    (tmp_path / "scenarios" / "stands.scenario.yaml").write_text(SCENARIO, "utf-8")
    monkeypatch.chdir(tmp_path)
    assert fbgen("generate", "plant.yaml", "-o", "blocks").status == 0
    lines = list(lines_of(read(name)))
    commands = [shlex.split(line.partition(">")[0]) for line in lines if line.startswith("fbgen")]
    assert [words[1] for words in commands] == ["generate", "check", "test"]
    assert {line for line in lines if not line.startswith("fbgen")} == {"pip install ./fbgen"}
    for words in commands:
        run = fbgen(*words[1:])
        assert run.status == 0, f"{shlex.join(words)}\n{run.out}{run.err}"
    for path in left:
        assert (tmp_path / path).is_file(), path


def test_gitlab_keeps_what_the_commands_write() -> None:
    text = (EXAMPLES / "gitlab-ci.yaml").read_text("utf-8")
    for job, kept in (
        ("blocks", {"codequality"}),
        ("scenarios", {"codequality", "junit", "coverage_report"}),
    ):
        entry = read("gitlab-ci.yaml")[job]
        assert isinstance(entry, dict)
        reports = entry["artifacts"]["reports"]
        assert set(reports) == kept
        coverage = reports.pop("coverage_report", None)
        assert coverage in (
            None,
            {"coverage_format": "cobertura", "path": "reports/coverage/cobertura.xml"},
        )
        assert all(text.count(str(file)) >= 1 for file in reports.values())


def test_gitlab_finds_the_share_of_statements_in_the_table() -> None:
    entry = read("gitlab-ci.yaml")["scenarios"]
    assert isinstance(entry, dict)
    *_, total = rows(Coverage())
    line = table(HEADINGS, [total]).splitlines()[-1].replace("    -", "  7 % 1/14", 1)
    found = re.search(str(entry["coverage"]).strip("/"), line)
    assert found is not None
    assert found[1] == "7"
