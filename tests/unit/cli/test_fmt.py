"""`fbgen fmt`."""

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from fbgen.lang import formatting
from fbgen.lang.containers import new_files
from fbgen.lang.parser import parse
from fbgen.source import Source
from tests.unit.cli.running import Fbgen

ROOT = Path(__file__).parents[3]
ROUGH = """\
function "Twice" : Int // doubles
VAR_INPUT
number : Int;   (* any *)
END_VAR
BEGIN


// the work
#Twice:=#number*2; // done
END_FUNCTION
"""
SMOOTH = """\
// doubles
FUNCTION "Twice" : Int
   VAR_INPUT
      number : Int;   (* any *)
   END_VAR

BEGIN

   // the work
   #Twice := #number * 2;   // done
END_FUNCTION
"""
BROKEN = ROUGH.replace("*2", "*")


@pytest.fixture
def rough(tmp_path: Path) -> Path:
    path = tmp_path / "rough.scl"
    path.write_bytes(ROUGH.encode())
    return path


def test_a_file_is_brought_into_its_layout_with_its_comments(fbgen: Fbgen, rough: Path) -> None:
    run = fbgen("fmt", str(rough))
    assert (run.status, run.out, run.err) == (0, f"{rough}\n", "1 changed, 0 unchanged\n")
    assert rough.read_bytes() == SMOOTH.encode()


def test_the_second_time_nothing_changes(fbgen: Fbgen, rough: Path) -> None:
    fbgen("fmt", str(rough))
    before = rough.stat().st_mtime_ns
    run = fbgen("fmt", str(rough))
    assert (run.status, run.out, run.err) == (0, "", "0 changed, 1 unchanged\n")
    assert rough.stat().st_mtime_ns == before


@pytest.mark.parametrize("codec", ["utf-8", "utf-8-sig", "utf-16", "cp1252"])
@pytest.mark.parametrize("line_end", ["\n", "\r\n"])
def test_encoding_bom_and_line_ends_stay(
    fbgen: Fbgen, rough: Path, codec: str, line_end: str
) -> None:
    def encoded(text: str) -> bytes:
        return text.replace("any", "größer").replace("\n", line_end).encode(codec)

    rough.write_bytes(encoded(ROUGH))
    assert fbgen("fmt", str(rough)).status == 0
    assert rough.read_bytes() == encoded(SMOOTH)


def test_check_lists_what_would_change_and_writes_nothing(fbgen: Fbgen, rough: Path) -> None:
    (rough.parent / "smooth.scl").write_text(SMOOTH.replace("Twice", "Thrice"), "utf-8")
    run = fbgen("fmt", str(rough.parent), "--check")
    assert (run.status, run.out) == (1, f"{rough}\n")
    assert run.err == "1 would change, 1 unchanged\n"
    assert rough.read_bytes() == ROUGH.encode()
    assert fbgen("fmt", str(rough.parent / "smooth.scl"), "--check").status == 0


def test_diff_shows_the_change_and_writes_nothing(fbgen: Fbgen, rough: Path) -> None:
    run = fbgen("fmt", str(rough), "--diff")
    assert run.status == 0
    assert run.out.splitlines()[:4] == [
        f"--- {rough}",
        f"+++ {rough}",
        "@@ -1,10 +1,11 @@",
        '-function "Twice" : Int // doubles',
    ]
    assert rough.read_bytes() == ROUGH.encode()
    assert fbgen("fmt", str(rough), "--diff", "--check").status == 1


def test_stdout_gets_the_text_of_one_file(fbgen: Fbgen, rough: Path) -> None:
    run = fbgen("fmt", str(rough), "--stdout")
    assert (run.status, run.out, run.err) == (0, SMOOTH, "")
    assert rough.read_bytes() == ROUGH.encode()


@pytest.mark.parametrize("more", [["--check"], ["--diff"], ["rough.scl"]])
def test_stdout_with_anything_else_is_wrong_usage(
    fbgen: Fbgen, rough: Path, more: list[str]
) -> None:
    run = fbgen("fmt", str(rough), *more, "--stdout")
    assert (run.status, run.out) == (2, "")


def test_a_file_with_errors_is_left_alone_and_the_others_are_done(
    fbgen: Fbgen, rough: Path
) -> None:
    broken = rough.parent / "broken.scl"
    broken.write_text(BROKEN, "utf-8")
    run = fbgen("fmt", str(rough.parent), str(rough.parent / "missing.scl"))
    assert (run.status, run.out) == (1, f"{rough}\n")
    assert f"--> {broken}:9:" in run.err
    assert "error[FB3014]" in run.err
    assert run.err.endswith("1 changed, 0 unchanged, 2 with errors left alone\n")
    assert broken.read_text("utf-8") == BROKEN


def test_each_file_has_the_dialect_of_its_name_or_the_one_that_is_given(
    fbgen: Fbgen, tmp_path: Path
) -> None:
    text = "FUNCTION F : INT\nVAR_INPUT x:INT;END_VAR\nF:=x;\nEND_FUNCTION\n"
    (tmp_path / "f.st").write_text(text, "utf-8")
    (tmp_path / "f.txt").write_text(text, "utf-8")
    assert fbgen("fmt", str(tmp_path)).out == f"{tmp_path / 'f.st'}\n"
    assert fbgen("fmt", str(tmp_path / "f.txt")).status == 2
    assert fbgen("fmt", str(tmp_path / "f.txt"), "--dialect", "iec").status == 0
    assert (tmp_path / "f.txt").read_bytes() == (tmp_path / "f.st").read_bytes()


def test_a_missing_line_end_is_a_change(fbgen: Fbgen, rough: Path) -> None:
    rough.write_bytes(SMOOTH.encode().removesuffix(b"\n"))
    run = fbgen("fmt", str(rough), "--diff")
    assert run.out.splitlines()[-3:] == [
        "-END_FUNCTION",
        "\\ No newline at end of file",
        "+END_FUNCTION",
    ]


@pytest.mark.parametrize("container", ["twincat", "plcopen"])
def test_in_xml_only_the_code_changes(fbgen: Fbgen, tmp_path: Path, container: str) -> None:
    dialect = "twincat" if container == "twincat" else "iec"
    text = "FUNCTION Twice : INT\nVAR_INPUT\nx : INT;\nEND_VAR\nTwice := x * 2;\nEND_FUNCTION\n"
    (new,) = new_files([parse(Source("twice", text), dialect)], container, "twice")
    path = tmp_path / new.name
    path.write_bytes(new.data.replace(b"x * 2", b"x*2"))
    run = fbgen("fmt", str(path))
    assert (run.status, run.out) == (0, f"{path}\n")
    assert path.read_bytes() == new.data


def test_jobs_change_nothing_but_the_time(fbgen: Fbgen, tmp_path: Path) -> None:
    for number in range(12):
        text = BROKEN if number % 5 == 3 else ROUGH
        (tmp_path / f"block{number:02}.scl").write_text(text, "utf-8")
    alone = fbgen("fmt", str(tmp_path), "--check")
    shared = fbgen("fmt", str(tmp_path), "--check", "--jobs", "3")
    assert shared == alone
    assert len(alone.out.splitlines()) == 10


@pytest.mark.skipif(os.name == "nt", reason="Windows has no rights of this kind")
def test_rights_and_links_stay(fbgen: Fbgen, rough: Path) -> None:
    rough.chmod(0o640)
    link = rough.parent / "link.scl"
    link.symlink_to(rough)
    assert fbgen("fmt", str(link)).status == 0
    assert link.is_symlink()
    assert rough.read_bytes() == SMOOTH.encode()
    assert stat.S_IMODE(rough.stat().st_mode) == 0o640


def test_a_file_that_cannot_be_written_stays_whole(
    fbgen: Fbgen, rough: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    run = fbgen("fmt", str(rough))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9002]: ")
    assert [path.name for path in rough.parent.iterdir()] == ["rough.scl"]
    assert rough.read_bytes() == ROUGH.encode()


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ((b"* 2", b"* 3"), "says something else"),
        ((b"* 2", b"* "), "cannot be read again"),
        ((b" * 2", b"  *  2"), "is not the last word"),
        ((b"// the work", b""), "loses a comment"),
    ],
)
def test_a_defect_of_the_layout_never_reaches_a_file(
    fbgen: Fbgen,
    rough: Path,
    monkeypatch: pytest.MonkeyPatch,
    change: tuple[bytes, bytes],
    message: str,
) -> None:
    original = formatting.Document.rewritten

    def rewritten(document: formatting.Document, file: formatting.File) -> bytes:
        return original(document, file).replace(*change)

    if message == "is not the last word":
        calls: list[bytes] = []

        def rewritten(document: formatting.Document, file: formatting.File) -> bytes:
            calls.append(original(document, file).replace(*change if not calls else (b"", b"")))
            return calls[-1]

    monkeypatch.setattr(formatting.Document, "rewritten", rewritten)
    run = fbgen("fmt", str(rough))
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith(f"error[FB3041]: {rough} is left alone: its formatted text {message}")
    assert rough.read_bytes() == ROUGH.encode()


INTERRUPTED = """
import os, signal, sys
from pathlib import Path
from fbgen.cli import main

done = []
replace = Path.replace

def interrupted_at_the_sixth(path, target):
    done.append(target)
    if len(done) == 6:
        os.kill(os.getpid(), signal.SIGINT)
    return replace(path, target)

Path.replace = interrupted_at_the_sixth
if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
"""


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for other processes")
@pytest.mark.usefixtures("usual_ctrl_c")
@pytest.mark.parametrize("jobs", ["1", "2"])
def test_an_interrupted_run_leaves_whole_files(tmp_path: Path, jobs: str) -> None:
    blocks = tmp_path / "blocks"
    blocks.mkdir()
    for number in range(30):
        (blocks / f"block{number:03}.scl").write_bytes(ROUGH.encode())
    script = tmp_path / "interrupted.py"
    script.write_text(INTERRUPTED, "utf-8")
    process = subprocess.run(
        [sys.executable, str(script), "fmt", str(blocks), "--jobs", jobs],
        capture_output=True,
        check=False,
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    assert (process.returncode, process.stderr) == (130, b"")
    contents = [path.read_bytes() for path in sorted(blocks.iterdir())]
    assert contents == [SMOOTH.encode()] * 5 + [ROUGH.encode()] * 25
