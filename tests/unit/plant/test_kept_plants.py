"""A plant that was read is kept for the next process, as long as nothing that it says changes."""

import shutil
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.plant import Plant, load_plant, loading

ROOT = Path(__file__).parents[3]
PLANT = ROOT / "tests" / "scenarios" / "one_drive.yaml"


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A plant of its own, which has been read once."""
    copy = tmp_path / "plant.yaml"
    shutil.copy(PLANT, copy)
    load_plant(copy)
    return copy


def unread(monkeypatch: pytest.MonkeyPatch) -> None:
    def read(*_: object) -> Plant:
        pytest.fail("the plant is kept")

    monkeypatch.setattr(loading, "read_plant", read)


def test_the_next_process_has_the_same_plant_with_its_places(
    path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = load_plant(path)
    unread(monkeypatch)
    again = load_plant(path, load_catalog())
    assert (again, repr(again)) == (first, repr(first))
    assert again is not first
    drives = [plant.gateways[0].drives[0] for plant in (first, again)]
    assert str(drives[0].span_of("inv_no")) == str(drives[1].span_of("inv_no"))


def test_a_plant_that_was_edited_is_read_again(path: Path) -> None:
    path.write_text(path.read_text("utf-8").replace("inv_no: 11", "inv_no: 12"), "utf-8")
    assert load_plant(path).gateways[0].drives[0].inv_no == 12


def test_another_catalogue_reads_it_anew(path: Path, tmp_path: Path) -> None:
    folder = tmp_path / "own" / "sequences"
    folder.mkdir(parents=True)
    text = (ROOT / "catalog" / "sequences" / "stop.yaml").read_text("utf-8")
    (folder / "halt.yaml").write_text(text.replace("id: stop", "id: halt"), "utf-8")
    path.write_text(path.read_text("utf-8").replace(" stop,", " halt,"), "utf-8")
    with pytest.raises(DiagnosticError):
        load_plant(path)
    assert "halt" in load_plant(path, load_catalog((tmp_path / "own",))).sequences


def test_a_plant_with_a_gsd_file_is_read_each_time(tmp_path: Path) -> None:
    example = ROOT / "examples" / "manual_example"
    path, file = tmp_path / "plant.yaml", tmp_path / "esco1803.gsd"
    shutil.copy(example / file.name, file)
    text = (example / path.name).read_text("utf-8")
    path.write_text(text.replace("layout: gsd10", "gsd: esco1803.gsd"), "utf-8")
    load_plant(path)
    file.write_text(file.read_text("latin-1") + "; another one\n", "latin-1")
    gsd = load_plant(path).gateways[0].gsd
    assert gsd is not None
    assert gsd.station is not None
    assert gsd.station.source.text.endswith("; another one\n")
