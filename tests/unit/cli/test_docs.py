"""`fbgen docs`: what is written, written again and refused."""

from pathlib import Path

from tests.unit.cli.running import Fbgen

PLANT = str(Path(__file__).parents[3] / "examples" / "pbdp110" / "plant.yaml")
OWN = """\
FUNCTION_BLOCK "Watch"
VERSION : 0.1
   VAR_IN_OUT
      frameIn : "typePbdpInput";
   END_VAR
   VAR
      jogs : Bool;
   END_VAR
BEGIN
   #jogs := (#frameIn.status AND 16#0100) <> 16#0000;
END_FUNCTION_BLOCK
"""


def test_a_site_of_a_plant_is_written_and_written_again(fbgen: Fbgen, tmp_path: Path) -> None:
    folder = tmp_path / "site"
    own = tmp_path / "watch.scl"
    own.write_text(OWN)
    run = fbgen("docs", PLANT, "-o", str(folder))
    assert (run.status, run.out) == (0, f"{folder / 'index.html'}\n")
    assert not (folder / "tospbdp001.html").exists()
    again = fbgen("docs", PLANT, "-o", str(folder), "--sources", str(own))
    assert again.status == 0
    assert "0 removed" in again.err
    assert f"Watch ({own})" in (folder / "pbdp110.status.html").read_text("utf-8")


def test_a_page_that_was_changed_by_hand_is_refused(fbgen: Fbgen, tmp_path: Path) -> None:
    assert fbgen("docs", PLANT, "-o", str(tmp_path)).status == 0
    (tmp_path / "index.html").write_text("mine")
    run = fbgen("docs", PLANT, "-o", str(tmp_path))
    assert run.status == 1
    assert "FB5020" in run.err
    assert fbgen("docs", PLANT, "-o", str(tmp_path), "--force").status == 0


def test_sources_need_the_plant_that_they_belong_to(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("docs", "-o", str(tmp_path), "--sources", str(tmp_path))
    assert run.status == 2
    assert "needs a PLANT" in run.err
