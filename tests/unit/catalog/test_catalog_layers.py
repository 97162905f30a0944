"""Catalogues of the user's own, layered over the shipped one."""

import shutil
from pathlib import Path

import pytest

from fbgen.catalog import load_catalog
from fbgen.diagnostics import DiagnosticError
from fbgen.resources import shipped


def copy(folder: Path, kind: str, name: str, *changes: tuple[str, str], to: str = "") -> Path:
    """A shipped entry, changed, in a catalogue of the user's own."""
    text = (shipped("catalog") / kind / f"{name}.yaml").read_text("utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    path = folder / kind / f"{to or name}.yaml"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    return path


def codes(failure: pytest.ExceptionInfo[DiagnosticError]) -> list[str]:
    return [item.code for item in failure.value.diagnostics]


def test_an_entry_of_the_same_id_replaces_the_shipped_one_and_is_told(tmp_path: Path) -> None:
    copy(tmp_path, "sequences", "stop", ("title: Stop along", "title: Halt along"))
    catalog = load_catalog([tmp_path])
    assert catalog.sequence("stop").title.startswith("Halt")
    (replaced,) = catalog.replaced
    assert (replaced.kind, replaced.id) == ("sequences", "stop")
    assert replaced.file == f"{tmp_path}/sequences/stop.yaml"
    assert replaced.replaced_file == "catalog/sequences/stop.yaml"
    assert not load_catalog().replaced


def test_a_new_entry_stands_beside_the_shipped_ones(tmp_path: Path) -> None:
    copy(tmp_path, "drives", "vf-s11", ("id: vf-s11", "id: my-drive"), to="my-drive")
    catalog = load_catalog([tmp_path])
    assert set(catalog.drives) - set(load_catalog().drives) == {"my-drive"}
    assert catalog.word("my-drive.FA00").name == "command"
    assert not catalog.replaced


def test_a_later_folder_wins_over_an_earlier_one(tmp_path: Path) -> None:
    for name in ("first", "second"):
        copy(tmp_path / name, "sequences", "stop", ("title: Stop along", f"title: {name}"))
    catalog = load_catalog([tmp_path / "first", tmp_path / "second"])
    assert catalog.sequence("stop").title.startswith("second")
    assert len(catalog.replaced) == 2


def test_errors_of_all_files_are_reported_together(tmp_path: Path) -> None:
    copy(tmp_path, "sequences", "stop", ("title: Stop along", "titel: Stop along"))
    copy(tmp_path, "sequences", "read_status", ("read: trip_code", "read: trip_cod"))
    copy(tmp_path, "drives", "vf-s11", ("id: vf-s11", "id: d"), ("protocol: toshiba",
         "protocol: toshba"), to="d")  # fmt: skip
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert codes(failure) == ["FB1005", "FB1105", "FB1105"]


def test_names_of_an_entry_that_cannot_be_read_are_not_reported_a_second_time(
    tmp_path: Path,
) -> None:
    copy(tmp_path, "drives", "vf-s11", ("id: vf-s11", "id: d\nnew: 1"), to="d")
    copy(tmp_path, "sequences", "stop", ("series: [vf-s11]", "series: [d]"))
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert codes(failure) == ["FB1005"]


def test_a_missing_folder_is_reported(tmp_path: Path) -> None:
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path / "nowhere"])
    assert codes(failure) == ["FB1110"]


def test_a_file_outside_the_four_folders_is_reported(tmp_path: Path) -> None:
    shutil.copy(shipped("catalog") / "sequences" / "stop.yaml", tmp_path / "stop.yaml")
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert codes(failure) == ["FB1110"]


def test_one_id_in_two_files_of_a_folder_is_reported(tmp_path: Path) -> None:
    path = copy(tmp_path, "sequences", "stop")
    shutil.copy(path, path.with_suffix(".yml"))
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert codes(failure) == ["FB1102"]


def test_the_texts_of_all_files_are_kept_for_the_hash_of_the_inputs(tmp_path: Path) -> None:
    path = copy(tmp_path, "sequences", "stop")
    sources = {source.name: source.text for source in load_catalog([tmp_path]).sources}
    assert sources[f"{tmp_path}/sequences/stop.yaml"] == path.read_text("utf-8")
    assert "catalog/drives/vf-s11.yaml" in sources


@pytest.mark.parametrize(
    ("kind", "name", "change", "code"),
    [
        ("drives", "vf-s11", ("  command: command_word\n", "  command: command_wort\n"), "FB1105"),
        ("drives", "vf-s11", ("  command: command_word\n", "  command: trip_code\n"), "FB1105"),
        ("drives", "vf-s11", ("number: FA01", "number: fa00"), "FB1102"),
        ("drives", "vf-s11", ("limited_by: maximum_frequency", "limited_by: max"), "FB1105"),
        ("drives", "vf-s11", ("unverified: [default]", "unverified: [defaults]"), "FB1105"),
        ("drives", "vf-s11", ("    default: 3\n", "    default: 9\n"), "FB1108"),
        ("gateways", "tospbdp001", ("default_layout: gsd10", "default_layout: gsd9"), "FB1105"),
        ("gateways", "tospbdp001", ("  - name: control\n", "  - name: kontrol\n"), "FB1105"),
        ("gateways", "tospbdp001", ("command_new: command_new", "command_new: new"), "FB1105"),
        ("gateways", "tospbdp001", ("  field: trigger", "  field: triger"), "FB1105"),
        ("gateways", "tospbdp001", ("series: [vf-s11]", "series: [vf-s8]"), "FB1105"),
        ("gateways", "tospbdp001", ("identifiers: C0 89 87", "identifiers: C0 89"), "FB1106"),
        ("gateways", "tospbdp001", ("name: comno, offset: 5", "name: comno, offset: 6"), "FB1106"),
        ("protocols", "toshiba", ("code: 0002", "code: 0001"), "FB1102"),
        ("sequences", "stop", ("{reverse: reverse}", "{reverse: revers}"), "FB1107"),
        ("sequences", "stop", ("type: BOOL", "type: INT"), "FB1107"),
        ("sequences", "stop", ('default: "false"', 'default: "FALSE; x := 1"'), "FB1107"),
        ("sequences", "read_current", ("into: current", "into: curent"), "FB1107"),
        ("sequences", "read_status", ("  - read: trip_code\n    into: trip_code",
         "  - write: trip_code\n    bits: []"), "FB1107"),
        ("sequences", "manual_example", ("step: 5", "step: 6"), "FB1107"),
        ("sequences", "manual_example", ("C4 00\n    input", "C4 0\n    input"), "FB1107"),
        ("sequences", "fault_reset", ("drive_time:", "ms: 5, drive_time:"), "FB1107"),
        ("sequences", "fault_reset", ("{drive_time: reset_silence}", "{}"), "FB1107"),
        ("sequences", "start_forward", ("    parameter: frequency\n", ""), "FB1107"),
        ("sequences", "start_forward", ("type: REAL", "type: WORD"), "FB1107"),
    ],
)  # fmt: skip
def test_contradictions_of_an_entry_are_found(
    kind: str, name: str, change: tuple[str, str], code: str, tmp_path: Path
) -> None:
    copy(tmp_path, kind, name, change)
    with pytest.raises(DiagnosticError) as failure:
        load_catalog([tmp_path])
    assert set(codes(failure)) == {code}
    assert all(item.span is not None for item in failure.value.diagnostics)
