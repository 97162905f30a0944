"""`fbgen explain`."""

import json
from pathlib import Path

from tests.unit.cli.running import Fbgen

EXAMPLE = Path(__file__).parents[3] / "examples" / "manual_example" / "plant.yaml"


def test_explain_prints_the_page_of_a_code(fbgen: Fbgen) -> None:
    run = fbgen("explain", "fb9003")
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith("# FB9003: there is no message with this code\n")
    assert "\n## Fails\n" in run.out
    assert "\n## Fixed\n" in run.out


def test_an_unknown_code_is_fb9003_with_the_nearest_codes(fbgen: Fbgen) -> None:
    run = fbgen("explain", "FB900")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9003]: there is no message with the code 'FB900'")
    assert "did you mean 'FB90" in run.err


def test_a_generated_line_is_explained(fbgen: Fbgen, tmp_path: Path) -> None:
    assert fbgen("generate", str(EXAMPLE), "-o", str(tmp_path)).status == 0
    block = tmp_path / "TOS_Gateway_gw1.scl"
    lines = block.read_text("ascii").splitlines()
    number = next(n for n, text in enumerate(lines, start=1) if "invNo := 16#0B" in text)
    run = fbgen("explain", f"{block}:{number}")
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith(f"{block}:{number}\n    {lines[number - 1].strip()}\n")
    assert "template   templates/parts/unit.jinja:" in run.out
    assert f"drive drive11\n           {EXAMPLE.as_posix()}:" in run.out
    data = json.loads(fbgen("explain", f"{block}:{number}", "--json").out)
    assert data["text"] == lines[number - 1]
    assert [one["what"] for one in data["origins"]] == ["template", "drive drive11"]


def test_a_line_of_a_file_that_is_not_generated_is_fb9017(fbgen: Fbgen, tmp_path: Path) -> None:
    (tmp_path / "mine.scl").write_text("// mine\n")
    run = fbgen("explain", f"{tmp_path / 'mine.scl'}:1")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9017]: ")


def test_json_is_for_lines_only(fbgen: Fbgen) -> None:
    assert fbgen("explain", "FB9003", "--json").status == 2


def test_a_file_without_a_line_is_told_how_to_name_one(fbgen: Fbgen, tmp_path: Path) -> None:
    path = tmp_path / "TOS_Line.scl"
    path.write_text("", encoding="ascii")
    assert f"add its number: {path}:1" in fbgen("explain", str(path)).err
    assert "FB9003" in fbgen("explain", "x" * 5000).err
