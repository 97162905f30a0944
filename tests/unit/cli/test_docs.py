"""`fbgen docs`: what is written, written again and refused."""

from pathlib import Path

import pytest

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
    (tmp_path / "index.html").write_text("mine")
    run = fbgen("docs", PLANT, "-o", str(tmp_path))
    assert run.status == 1
    assert "FB5020" in run.err
    assert fbgen("docs", PLANT, "-o", str(tmp_path), "--force").status == 0


def test_sources_need_the_plant_that_they_belong_to(fbgen: Fbgen, tmp_path: Path) -> None:
    run = fbgen("docs", "-o", str(tmp_path), "--sources", str(tmp_path))
    assert run.status == 2
    assert "needs a PLANT" in run.err


def test_a_wiki_in_german_and_a_handbook_lie_in_one_folder(fbgen: Fbgen, tmp_path: Path) -> None:
    wiki = fbgen("docs", PLANT, "-o", str(tmp_path), "--format", "markdown", "--language", "de")
    assert wiki.out == f"{tmp_path / 'index.md'}\n"
    pdf = fbgen("docs", PLANT, "-o", str(tmp_path), "--format", "pdf")
    assert pdf.out == f"{tmp_path / 'handbook.pdf'}\n"
    assert (tmp_path / "handbook.pdf").read_bytes().startswith(b"%PDF-")
    assert "Ueberstrom beim Beschleunigen" in (tmp_path / "vf-s11-trips.md").read_text("utf-8")
    block = (tmp_path / "block-PBDP_Parameter.md").read_text("utf-8")
    assert "steigende Flanke" in block
    assert "| Timing | ein Aufruf je Zyklus." in block


def test_a_handbook_without_its_library_is_told(
    fbgen: Fbgen, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    run = fbgen("docs", PLANT, "-o", str(tmp_path), "--format", "pdf")
    assert run.status == 1
    assert "FB9060" in run.err


def test_a_gateway_of_the_plant_has_its_addresses_slot_by_slot(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    plant = Path(PLANT).parents[1] / "manual_example" / "plant.yaml"
    run = fbgen("docs", str(plant), "-o", str(tmp_path), "--format", "markdown")
    assert run.status == 0
    text = (tmp_path / "tospbdp001.md").read_text("utf-8")
    rows = [line for line in text.splitlines() if "QB" in line]
    assert rows[0].startswith("| 1 | `30` | `QB256` |")
    assert "| 6 | `70` | `QB261 to QB262` | `IB260 to IB261` |" in text
