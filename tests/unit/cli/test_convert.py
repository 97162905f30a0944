"""`fbgen convert`."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import pytest

from fbgen.lang import ast
from fbgen.lang import conversion as conversions
from fbgen.lang.parser import parse
from fbgen.source import Source
from tests.unit.cli.running import Fbgen

BAD = Path(__file__).parents[1] / "bad"
TWICE = """\
FUNCTION "Twice" : Int
   VAR_INPUT
      number : Int;   // any
   END_VAR

BEGIN
   // the work
   #Twice := #number * 2;
END_FUNCTION
"""
TWICE_IEC = """\
FUNCTION Twice : INT
    VAR_INPUT
        number : INT;   (* any *)
    END_VAR
    (* the work *)
    Twice := number * 2;
END_FUNCTION
"""
COUNTER = """\
FUNCTION_BLOCK "Counter"
   VAR_OUTPUT
      count : Int;
   END_VAR

BEGIN
   #count += "Twice"(1);
END_FUNCTION_BLOCK
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A program of two files."""
    (tmp_path / "plant").mkdir()
    (tmp_path / "plant" / "twice.scl").write_text(TWICE, "utf-8")
    (tmp_path / "plant" / "counter.scl").write_text(COUNTER, "utf-8")
    return tmp_path / "plant"


def test_one_file_goes_to_standard_output(fbgen: Fbgen, folder: Path) -> None:
    run = fbgen("convert", str(folder / "twice.scl"), "--to", "iec")
    assert (run.status, run.out, run.err) == (0, TWICE_IEC, "")


@pytest.mark.parametrize(
    ("wanted", "names"),
    [
        ("tia", ["counter.scl", "twice.scl"]),
        ("step7", ["counter.scl", "twice.scl"]),
        ("iec", ["new.st"]),
        ("twincat", ["Counter.TcPOU", "Twice.TcPOU"]),
        ("twincat --text", ["new.st"]),
        ("plcopen", ["new.xml"]),
    ],
)
def test_a_folder_gets_what_comes_out_and_it_is_right(
    fbgen: Fbgen, folder: Path, tmp_path: Path, wanted: str, names: list[str]
) -> None:
    new = tmp_path / "new"
    run = fbgen("convert", str(folder), "-o", str(new), "--to", *wanted.split())
    to = wanted.split(maxsplit=1)[0]
    assert run.status == 0
    assert sorted(path.name for path in new.iterdir()) == names
    assert sorted(run.out.splitlines()) == [str(new / name) for name in names]
    assert run.err == f"2 files of dialect tia are now {len(names)} of {to}\n"
    dialect = {"plcopen": "iec"}.get(to, to)
    files = [str(new / name) for name in names]
    assert fbgen("check", *files, "--dialect", dialect).status == 0


def test_every_way_there_and_back_gives_the_same_program(
    fbgen: Fbgen, folder: Path, tmp_path: Path
) -> None:
    for to in ("step7", "iec", "twincat", "plcopen"):
        out = tmp_path / to
        fbgen("convert", str(folder / "twice.scl"), "--to", to, "-o", str(out))
        dialect = {"plcopen": "iec"}.get(to, to)
        (file,) = out.iterdir()
        run = fbgen("convert", str(file), "--dialect", dialect, "--to", "iec")
        assert (to, sorted(run.out.split())) == (to, sorted(TWICE_IEC.split()))


def test_folders_in_a_folder_stay_apart(fbgen: Fbgen, folder: Path, tmp_path: Path) -> None:
    (folder / "inner").mkdir()
    (folder / "twice.scl").rename(folder / "inner" / "counter.scl")
    fbgen("convert", str(folder), "--to", "step7", "-o", str(tmp_path / "new"))
    found = sorted(p.relative_to(tmp_path / "new") for p in tmp_path.glob("new/**/*.scl"))
    assert found == [Path("counter.scl"), Path("inner/counter.scl")]


def test_names_that_differ_in_their_suffix_stay_apart(
    fbgen: Fbgen, folder: Path, tmp_path: Path
) -> None:
    (folder / "twice.scl").rename(folder / "counter.udt")
    fbgen("convert", str(folder), "--to", "step7", "-o", str(tmp_path / "new"))
    found = sorted(path.name for path in (tmp_path / "new").iterdir())
    assert found == ["counter_scl.scl", "counter_udt.scl"]


def test_one_object_can_be_a_file_with_a_name(fbgen: Fbgen, folder: Path, tmp_path: Path) -> None:
    one = str(folder / "twice.scl")
    for name in ("T.TcPOU", "T.st"):
        run = fbgen("convert", one, "--to", "twincat", "-o", str(tmp_path / name))
        assert (run.status, run.out) == (0, f"{tmp_path / name}\n")
    assert (tmp_path / "T.TcPOU").read_bytes().startswith(b"<?xml")
    assert (tmp_path / "T.st").read_text("utf-8").startswith("FUNCTION Twice : INT\n")


@pytest.mark.parametrize(
    ("to", "name"), [("twincat", "all.TcPOU"), ("tia", "all.xml"), ("iec", "all.TcGVL")]
)
def test_a_name_that_cannot_hold_what_comes_out_is_wrong_usage(
    fbgen: Fbgen, folder: Path, tmp_path: Path, to: str, name: str
) -> None:
    run = fbgen("convert", str(folder), "--to", to, "-o", str(tmp_path / name))
    assert (run.status, run.out) == (2, "")
    assert not (tmp_path / name).exists()


def test_nothing_is_overwritten_without_force(fbgen: Fbgen, folder: Path, tmp_path: Path) -> None:
    new = tmp_path / "new"
    arguments = ("convert", str(folder), "--to", "step7", "-o", str(new))
    assert fbgen(*arguments).status == 0
    assert fbgen(*arguments).status == 0
    (new / "twice.scl").write_text("mine", "utf-8")
    (new / "counter.scl").unlink()
    run = fbgen(*arguments)
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[FB9001]: {new / 'twice.scl'} is already there\n")
    assert [path.name for path in new.iterdir()] == ["twice.scl"]
    assert fbgen(*arguments, "--force").status == 0
    assert (new / "twice.scl").read_text("utf-8") != "mine"


def test_all_that_is_refused_is_named_and_nothing_written(
    fbgen: Fbgen, folder: Path, tmp_path: Path
) -> None:
    text = TWICE.replace("#number * 2", "WORD_TO_INT(%IW4:P)").replace("Twice", "Raw")
    (folder / "raw.scl").write_text(text + text.replace("Raw", "Other").replace("%IW4", "%IW6"))
    run = fbgen("convert", str(folder), "--to", "iec", "-o", str(tmp_path / "new"))
    assert (run.status, run.out) == (1, "")
    assert run.err.count("error[FB3051]") == 2
    assert not (tmp_path / "new").exists()


def test_a_mistake_in_the_source_is_shown_before_anything_else(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "twice.scl"
    path.write_text(TWICE.replace("#number *", "#numbr *"), "utf-8")
    run = fbgen("convert", str(path), "--to", "iec")
    assert (run.status, run.out) == (1, "")
    assert "error[FB4001]" in run.err
    assert f"--> {path}:8:14\n" in run.err
    unchecked = fbgen("convert", str(path), "--to", "step7", "--no-check")
    assert (unchecked.status, "numbr * 2" in unchecked.out) == (0, True)


def test_all_files_are_read_before_the_command_gives_up(fbgen: Fbgen, folder: Path) -> None:
    (folder / "bad.scl").write_text(TWICE.replace("* 2", "*"), "utf-8")
    run = fbgen("convert", str(folder), str(folder / "missing.scl"), "--to", "iec")
    assert run.status == 1
    assert f"--> {folder / 'bad.scl'}:8:" in run.err
    assert "missing.scl" in run.err


@pytest.fixture
def broken_conversion(monkeypatch: pytest.MonkeyPatch) -> None:
    """A conversion that takes every INT for a BOOL."""

    def wrong(files: Sequence[ast.File], target: str) -> list[ast.File]:
        text = TWICE_IEC.replace("number : INT", "number : BOOL")
        other = parse(Source("other", text), target)
        (block,) = other.units
        (source,) = files
        assert isinstance(block, ast.Block)
        (statement,) = block.body
        assert isinstance(statement, ast.Assignment)
        (original,) = source.units
        assert isinstance(original, ast.Block)
        moved = replace(statement, span=original.body[0].span)
        return [replace(other, units=(replace(block, body=(moved,)),))]

    monkeypatch.setattr(conversions, "convert", wrong)


@pytest.mark.usefixtures("broken_conversion")
def test_what_comes_out_wrong_is_shown_where_it_came_from(fbgen: Fbgen, folder: Path) -> None:
    path = folder / "twice.scl"
    run = fbgen("convert", str(path), "--to", "iec")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB3055]: what this becomes is not right in dialect iec: ")
    assert f"--> {path}:8:4\n" in run.err
    assert "= note: converted: Twice := number * 2;" in run.err
    unchecked = fbgen("convert", str(path), "--to", "iec", "--no-check")
    assert (unchecked.status, "number : BOOL" in unchecked.out) == (0, True)


def test_step7_gets_ansi_and_tia_a_bom(fbgen: Fbgen, folder: Path, tmp_path: Path) -> None:
    path = folder / "twice.scl"
    path.write_text(TWICE.replace("any", "größer"), "utf-8")
    for to, codec in (("step7", "cp1252"), ("tia", "utf-8-sig"), ("iec", "utf-8")):
        out = tmp_path / f"{to}.scl"
        assert fbgen("convert", str(path), "--to", to, "-o", str(out)).status == 0
        assert "größer" in out.read_bytes().decode(codec)


def test_characters_that_are_not_ansi_are_refused_for_step7(fbgen: Fbgen) -> None:
    path = BAD / "FB3056_no_ansi.scl"
    run = fbgen("convert", str(path), "--to", "step7")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB3056]: this line has the character 'н' (U+043D)")
    assert f"--> {path}:1:1\n" in run.err
