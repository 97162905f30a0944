"""Writing the generated set: nothing of a person's is lost, nothing half written is left."""

import json
from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.emit.folder import FILE_LIST, compare
from fbgen.emit.generated import GeneratedFile, GeneratedSet
from fbgen.emit.writing import CHANGED_BLOCKS, write_set


def files(**texts: str) -> GeneratedSet:
    """A set of files; `_` in a name stands for the dot."""
    made = [GeneratedFile(name.replace("_", "."), text, ()) for name, text in texts.items()]
    return GeneratedSet("tia", tuple(made), "0123456789ab")


def contents(folder: Path) -> dict[str, str]:
    return {path.name: path.read_text("utf-8") for path in folder.iterdir()}


def refused(code: str, generated: GeneratedSet, folder: Path) -> str:
    with pytest.raises(DiagnosticError) as failure:
        write_set(generated, folder)
    assert {item.code for item in failure.value.diagnostics} == {code}
    assert all(item.help for item in failure.value.diagnostics)
    return str(failure.value)


def test_files_and_their_list_are_written(tmp_path: Path) -> None:
    report = write_set(files(a_scl="A\n", b_udt="B\n"), tmp_path / "new" / "out")
    assert report.written == ("a.scl", "b.udt")
    assert set(contents(tmp_path / "new" / "out")) == {"a.scl", "b.udt", FILE_LIST}
    listed = json.loads(contents(tmp_path / "new" / "out")[FILE_LIST])
    assert listed["inputs"] == "0123456789ab"
    assert set(listed["files"]) == {"a.scl", "b.udt"}


def test_what_did_not_change_is_not_touched(tmp_path: Path) -> None:
    write_set(files(a_scl="A\n", b_scl="B\n"), tmp_path)
    before = (tmp_path / "a.scl").stat().st_mtime_ns
    report = write_set(files(a_scl="A\n", b_scl="C\n"), tmp_path)
    assert (report.written, report.unchanged) == (("b.scl",), ("a.scl",))
    assert (tmp_path / "a.scl").stat().st_mtime_ns == before


def test_what_is_not_generated_any_more_is_removed(tmp_path: Path) -> None:
    write_set(files(a_scl="A\n", old_scl="B\n"), tmp_path)
    assert write_set(files(a_scl="A\n"), tmp_path).removed == ("old.scl",)
    assert set(contents(tmp_path)) == {"a.scl", FILE_LIST}


def test_a_file_that_a_person_changed_is_kept_and_nothing_is_written(tmp_path: Path) -> None:
    write_set(files(a_scl="A\n", b_scl="B\n"), tmp_path)
    (tmp_path / "b.scl").write_text("mine\n", "utf-8")
    before = contents(tmp_path)
    new = files(a_scl="new\n", b_scl="new\n")
    assert "b.scl" in refused("FB5020", new, tmp_path)
    assert contents(tmp_path) == before
    write_set(new, tmp_path, force=True)
    assert contents(tmp_path)["a.scl"] == "new\n"


@pytest.mark.parametrize("force", [True, False])
def test_a_file_that_is_not_generated_any_more_is_kept_if_a_person_changed_it(
    force: bool, tmp_path: Path
) -> None:
    write_set(files(a_scl="A\n", b_scl="B\n"), tmp_path)
    (tmp_path / "b.scl").write_text("mine\n", "utf-8")
    report = write_set(files(a_scl="new\n"), tmp_path, force=force)
    assert (report.kept, report.removed) == (("b.scl",), ())
    assert contents(tmp_path)["b.scl"] == "mine\n"
    assert contents(tmp_path)["a.scl"] == "new\n"
    assert "kept     b.scl" in contents(tmp_path)[CHANGED_BLOCKS]


def test_a_name_in_another_case_leaves_one_file(tmp_path: Path) -> None:
    write_set(files(HALL_scl="A\n"), tmp_path)
    assert write_set(files(Hall_scl="A\n"), tmp_path).removed == ("HALL.scl",)
    assert set(contents(tmp_path)) == {"Hall.scl", FILE_LIST}


def test_comparing_says_what_writing_would_do_and_writes_nothing(tmp_path: Path) -> None:
    write_set(files(a_scl="A\n", b_scl="B\n", c_scl="C\n"), tmp_path)
    before = contents(tmp_path)
    found = compare(files(a_scl="A\n", b_scl="new\n", d_scl="D\n"), tmp_path)
    assert (found.written, found.removed) == (("b.scl", "d.scl"), ("c.scl",))
    assert (found.unchanged, found.kept, found.theirs) == (("a.scl",), (), ())
    assert contents(tmp_path) == before


def test_a_file_that_fbgen_never_wrote_is_kept(tmp_path: Path) -> None:
    (tmp_path / "a.scl").write_text("mine\n", "utf-8")
    refused("FB5020", files(a_scl="A\n"), tmp_path)
    assert contents(tmp_path) == {"a.scl": "mine\n"}


def test_a_file_that_happens_to_be_right_is_taken_over(tmp_path: Path) -> None:
    (tmp_path / "a.scl").write_text("A\n", "utf-8")
    assert write_set(files(a_scl="A\n"), tmp_path).unchanged == ("a.scl",)


def test_a_file_that_was_deleted_by_hand_is_written_again(tmp_path: Path) -> None:
    write_set(files(a_scl="A\n"), tmp_path)
    (tmp_path / "a.scl").unlink()
    assert write_set(files(a_scl="A\n"), tmp_path).written == ("a.scl",)


@pytest.mark.parametrize(
    "text",
    ["", "{", "[]", "null", '{"files": 1}', '{"files": []}', "\x00", '{"files": null}', "[" * 9999],
)
def test_a_damaged_list_is_fb5022_and_nothing_is_written(text: str, tmp_path: Path) -> None:
    write_set(files(a_scl="A\n"), tmp_path)
    (tmp_path / FILE_LIST).write_text(text, "utf-8")
    before = contents(tmp_path)
    refused("FB5022", files(a_scl="new\n"), tmp_path)
    assert contents(tmp_path) == before


def test_a_list_that_is_not_utf8_is_fb5022(tmp_path: Path) -> None:
    (tmp_path / FILE_LIST).write_bytes(b"\xff\xfe\x80")
    refused("FB5022", files(a_scl="A\n"), tmp_path)


@pytest.mark.parametrize("name", ["../victim.scl", "/victim.scl", "..", ".", "sub/victim.scl", ""])
def test_a_list_that_names_files_elsewhere_removes_nothing(name: str, tmp_path: Path) -> None:
    victim = tmp_path / "victim.scl"
    victim.write_text("V\n", "utf-8")
    out = tmp_path / "out"
    (out / "sub").mkdir(parents=True)
    (out / "sub" / "victim.scl").write_text("V\n", "utf-8")
    hashed = {name: "3c6ba6ea6d4e9a4e6ff8b4d1b2d2bb9c"}
    (out / FILE_LIST).write_text(json.dumps({"files": hashed}), "utf-8")
    write_set(files(a_scl="A\n"), out)
    assert victim.is_file()
    assert (out / "sub" / "victim.scl").is_file()


def test_a_file_in_the_place_of_the_folder_is_fb5021(tmp_path: Path) -> None:
    (tmp_path / "out").write_text("mine", "utf-8")
    refused("FB5021", files(a_scl="A\n"), tmp_path / "out")
    assert (tmp_path / "out").read_text("utf-8") == "mine"


def test_a_folder_in_the_place_of_a_file_is_fb5021(tmp_path: Path) -> None:
    (tmp_path / "a.scl").mkdir()
    refused("FB5021", files(a_scl="A\n"), tmp_path)


def test_a_folder_that_must_not_be_written_is_fb5021(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def forbidden(*_: object, **__: object) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "mkdir", forbidden)
    assert "Permission denied" in refused("FB5021", files(a_scl="A\n"), tmp_path / "out")


def test_a_file_that_cannot_be_written_is_named_and_not_its_temporary_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def forbidden(self: Path, _: bytes) -> int:
        raise PermissionError(13, "Permission denied", str(self))

    monkeypatch.setattr(Path, "write_bytes", forbidden)
    told = refused("FB5021", files(a_scl="A\n"), tmp_path)
    assert f"{tmp_path / 'a.scl'} cannot be written: Permission denied" in told


def test_an_interrupted_write_leaves_every_file_whole_and_can_be_repeated(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    write_set(files(a_scl="A\n", b_scl="B\n", c_scl="C\n"), tmp_path)
    before = contents(tmp_path)
    new = files(a_scl="new\n", b_scl="new\n", c_scl="new\n")
    replace = Path.replace

    def full_at_b(self: Path, target: Path) -> Path:
        if target.name == "b.scl":
            raise OSError(28, "No space left on device")
        return replace(self, target)

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full_at_b)
        assert "No space left" in refused("FB5021", new, tmp_path)
    after = contents(tmp_path)
    assert set(after) == set(before)
    assert after["b.scl"] == "B\n"
    assert after["c.scl"] == "C\n"
    assert after["a.scl"] in ("A\n", "new\n")
    write_set(new, tmp_path)
    assert {contents(tmp_path)[name] for name in ("a.scl", "b.scl", "c.scl")} == {"new\n"}
