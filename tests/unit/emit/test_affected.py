"""A change of the catalogue or the plant file, and the generated lines that it has changed."""

import shutil
from collections.abc import Mapping
from functools import cache
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.catalog.differences import Difference, catalogue_differences, differences
from fbgen.emit.affected import Comparison, compared
from fbgen.emit.generated import GeneratedSet
from fbgen.emit.generator import generate
from fbgen.plant import load_plant
from fbgen.resources import shipped

PLANT = Path(__file__).parents[3] / "examples" / "five_drives" / "plant.yaml"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A copy of the shipped catalogue to change."""
    return Path(shutil.copytree(shipped("catalog"), tmp_path / "catalog"))


@cache
def shipped_set() -> GeneratedSet:
    """What the shipped catalogue makes of the plant."""
    catalog = load_catalog()
    return generate(load_plant(PLANT, catalog), catalog)


def comparison(folder: Path, changes: Mapping[str, Mapping[str, str]]) -> Comparison:
    """The shipped catalogue against the folder with texts replaced in its files."""
    for name, replaced in changes.items():
        text = (folder / name).read_text("utf-8")
        for old, new in replaced.items():
            assert old in text, old
            text = text.replace(old, new)
        (folder / name).write_text(text, "utf-8")
    old, new = load_catalog(), load_catalog([folder])
    return compared(
        catalogue_differences(old, new), shipped_set(), generate(load_plant(PLANT, new), new)
    )


def told(found: Comparison, path: str) -> tuple[Difference, dict[str, list[str]]]:
    """The difference of a path, and what has changed through it: texts by file."""
    (item,) = [one for one in found.affected if one.difference.path == path]
    lines: dict[str, list[str]] = {}
    for line in item.lines:
        lines.setdefault(line.file, []).append(f"{line.sign} {line.text.strip()}")
    return item.difference, lines


def test_a_moved_bit_shows_the_words_with_it(folder: Path) -> None:
    found = comparison(
        folder,
        {
            "drives/vf-s11.yaml": {
                "bit: 12\n        name: emergency_stop\n": "bit: 0\n        name: emergency_stop\n",
                "bit: 0\n        name: preset_speed_1\n": "bit: 12\n        name: preset_speed_1\n",
            }
        },
    )
    difference, lines = told(found, "vf-s11.words.command.bits.emergency_stop.bit")
    assert (difference.kind, difference.before, difference.after) == ("changed", "12", "0")
    assert lines["TOS_Line.scl"] == [
        "- #statRequest.data := 16#D000;",
        "+ #statRequest.data := 16#C001;",
    ]
    assert lines["TOS_Seq_emergency_stop.scl"] == [
        "- #channel.request.data := 16#D000;",
        "+ #channel.request.data := 16#C001;",
    ]
    assert not {"TOS_Seq_stop.scl", "TOS_HzToWord.scl"} & lines.keys()


def test_a_renumbered_comno_shows_the_blocks_that_name_it(folder: Path) -> None:
    renumbered = {"drives/vf-s11.yaml": {"number: FD01": "number: FD91"}}
    # Series that are like the VF-S11 name the ComNo, too.
    renumbered |= {
        f"drives/{name}.yaml": {"FD01": "FD91"} for name in ("vf-as1", "vf-mb1", "vf-s15")
    }
    found = comparison(folder, renumbered)
    difference, lines = told(found, "vf-s11.comnos.status.number")
    assert (difference.before, difference.after) == ("FD01", "FD91")
    assert difference.place is not None
    assert "FD91" in difference.place.source.line_text(difference.place.line)
    changed = [text for text in lines["TOS_StatusPoll.scl"] if "16#FD" in text]
    assert [text.replace("+", "-").replace("FD91", "FD01") for text in changed] == [changed[0]] * 2
    assert changed[0] != changed[1]
    assert "TOS_Seq_stop.scl" not in lines
    assert found.other == ()


def test_a_new_step_shows_its_lines_and_what_moves_behind_it(folder: Path) -> None:
    step = "  - delay: {ms: 70}\n    title: Let it settle\n"
    found = comparison(folder, {"sequences/stop.yaml": {"steps:\n": f"steps:\n{step}"}})
    difference, lines = told(found, "stop.steps.1")
    assert difference.kind == "added"
    assert set(lines) == {"TOS_Seq_stop.scl"}
    assert any("T#70ms" in text for text in lines["TOS_Seq_stop.scl"])
    assert found.other
    assert {line.file for line in found.other} == {"TOS_Seq_stop.scl"}


def test_a_changed_time_shows_what_was_worked_out_from_it(folder: Path) -> None:
    found = comparison(
        folder, {"drives/vf-s11.yaml": {"reply_max: {ms: 20,": "reply_max: {ms: 78,"}}
    )
    difference, lines = told(found, "vf-s11.times.reply_max.ms")
    assert (difference.before, difference.after) == ("20", "78")
    assert any("timeout := T#" in text for text in lines["TOS_Parameters.db"])
    assert any("gap := T#" in text for text in lines["TOS_Gateway_gw1.scl"])
    assert found.other == ()


def test_a_text_that_no_block_shows_changes_no_line(folder: Path) -> None:
    found = comparison(folder, {"drives/vf-s11.yaml": {"title: Emergency stop\n": "title: Now\n"}})
    difference, lines = told(found, "vf-s11.words.command.bits.emergency_stop.title")
    assert (difference.before, difference.after, lines) == ("Emergency stop", "Now", {})


def test_entries_in_another_order_are_no_change(folder: Path) -> None:
    path = folder / "drives" / "vf-s11.yaml"
    before, _, trips = path.read_text("utf-8").partition("\ntrips:\n")
    first, second, rest = trips.split("  - code:", 3)[1:]
    path.write_text(f"{before}\ntrips:\n  - code:{second}  - code:{first}  - code:{rest}", "utf-8")
    changed = load_catalog([folder])
    assert changed.drive("vf-s11").trips[1].display == "nErr"
    assert not list(catalogue_differences(load_catalog(), changed))


def test_a_drive_of_the_plant_shows_its_lines(tmp_path: Path) -> None:
    catalog = load_catalog()
    other = tmp_path / "plant.yaml"
    text = PLANT.read_text("utf-8")
    assert "inv_no: 3," in text
    other.write_text(text.replace("inv_no: 3,", "inv_no: 33,"), "utf-8")
    plants = [load_plant(path, catalog) for path in (PLANT, other)]
    found = compared(differences(*plants), *(generate(one, catalog) for one in plants))
    (affected,) = found.affected
    assert affected.difference.path.endswith(".inv_no")
    texts = {line.text.strip() for line in affected.lines if line.sign == "+"}
    assert any("16#21" in text for text in texts)
