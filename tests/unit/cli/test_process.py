"""How a process of fbgen starts and ends: speed, exit status, what goes to which stream."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from fbgen.cli import main, program
from tests.unit.cli.running import Fbgen

COMMAND = [sys.executable, "-m", "fbgen.cli"]
ROOT = Path(__file__).parents[3]
COMMANDS = [
    *[("demo",), ("init",), ("generate",), ("check",), ("fmt",), ("convert",), ("run",), ("test",)],
    *[
        ("decode",),
        ("encode",),
        ("coverage",),
        ("mutate",),
        ("campaign",),
        ("diff",),
        ("gsd",),
        ("docs",),
        ("explain",),
        ("schemas",),
        ("catalog",),
        ("catalog", "list"),
        ("catalog", "show"),
        ("sim",),
        ("sim", "gateway"),
        ("sim", "drive"),
        ("talk",),
        ("record",),
        ("replay",),
    ],
]


@pytest.mark.skipif(os.name == "nt", reason="Windows does not tell the processor time of children")
def test_help_takes_less_than_0_3_s() -> None:
    """Measured as processor time, which other work on the machine does not lengthen much."""

    def seconds() -> float:
        before = os.times()
        subprocess.run([*COMMAND, "--help"], check=True, stdout=subprocess.DEVNULL, cwd=ROOT)
        after = os.times()
        user = after.children_user - before.children_user
        return user + after.children_system - before.children_system

    assert min(seconds() for _ in range(5)) < 0.3


def test_help_imports_nothing_heavy() -> None:
    script = (
        "import sys; from fbgen.cli import main; main(['--help']); "
        "print(sorted({name.split('.')[0] for name in sys.modules} & "
        "{'harness', 'pydantic', 'yaml', 'jinja2', 'rich'}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], check=True, capture_output=True, text=True, cwd=ROOT
    )
    assert done.stdout.splitlines()[-1] == "[]"


@pytest.mark.parametrize("command", COMMANDS, ids=" ".join)
def test_every_command_has_help_with_examples(fbgen: Fbgen, command: tuple[str, ...]) -> None:
    run = fbgen(*command, "--help")
    assert (run.status, run.err) == (0, "")
    examples = run.out.partition("\n  Examples:\n")[2].splitlines()
    assert examples
    assert examples[0].startswith(f"    fbgen {' '.join(command)}")


def test_all_commands_are_listed_by_help(fbgen: Fbgen) -> None:
    out = fbgen("--help").out
    section = out.partition("\nCommands:\n")[2].partition("\n\n")[0]
    listed = {line.split()[0] for line in section.splitlines()}
    assert listed == {command[0] for command in COMMANDS}


def test_version_is_one_line(fbgen: Fbgen) -> None:
    run = fbgen("--version")
    assert (run.status, run.err) == (0, "")
    assert run.out.startswith("fbgen ")
    assert run.out.count("\n") == 1


@pytest.mark.parametrize(
    "arguments",
    [
        ("nonsense",),
        ("decode", "vf-s11.command"),
        ("generate", "plant.yaml"),
        ("generate", "plant.yaml", "-o", "out", "--dialect", "cobol"),
        ("check", "pump.txt"),
        ("check", "pump.scl", "--format", "xml"),
        ("test", "--seed", "x"),
    ],
)
def test_wrong_usage_is_status_2_with_nothing_on_standard_output(
    fbgen: Fbgen, arguments: tuple[str, ...]
) -> None:
    run = fbgen(*arguments)
    assert (run.status, run.out) == (2, "")
    assert "Usage: fbgen" in run.err


def test_a_defect_is_called_one_without_a_traceback(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    _break_decode(monkeypatch, ZeroDivisionError("a\nb"))
    run = fbgen("decode", "vf-s11.command", "0")
    assert (run.status, run.out) == (70, "")
    assert run.err.startswith("defect: ZeroDivisionError: a\nThis is a defect in fbgen")
    assert "FBGEN_TRACEBACK=1" in run.err
    assert "Traceback" not in run.err


def test_fbgen_traceback_shows_where_a_defect_happened(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    _break_decode(monkeypatch, ZeroDivisionError("a"))
    monkeypatch.setenv("FBGEN_TRACEBACK", "1")
    err = fbgen("decode", "vf-s11.command", "0").err
    assert err.startswith("Traceback (most recent call last):\n")
    assert "decode.py" in err


def test_ctrl_c_is_status_130_without_a_word(fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch) -> None:
    _break_decode(monkeypatch, KeyboardInterrupt())
    run = fbgen("decode", "vf-s11.command", "0")
    assert (run.status, run.out, run.err) == (130, "", "")


def test_a_file_that_the_system_refuses_is_fb9002(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    _break_decode(monkeypatch, PermissionError(13, "Permission denied", "plant.yaml"))
    run = fbgen("decode", "vf-s11.command", "0")
    assert (run.status, run.out) == (1, "")
    assert run.err.startswith("error[FB9002]: plant.yaml cannot be used: Permission denied\n")


@pytest.mark.skipif(os.name == "nt", reason="Windows has no SIGINT for other processes")
@pytest.mark.usefixtures("usual_ctrl_c")
def test_ctrl_c_in_a_process_is_status_130_without_a_word() -> None:
    script = (
        "import sys, fbgen.cli.program, fbgen.catalog, time\n"
        "def wait(*_):\n"
        "    print('ready', flush=True); time.sleep(60)\n"
        "fbgen.catalog.load_catalog = wait\n"
        "sys.exit(fbgen.cli.main(['decode', 'vf-s11.command', '0']))"
    )
    with subprocess.Popen(
        [sys.executable, "-c", script],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        cwd=ROOT,
    ) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "ready\n"
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=30)
    assert (process.returncode, out, err) == (130, "", "")


@pytest.mark.skipif(os.name == "nt", reason="pipes of Windows do not say that they are broken")
@pytest.mark.parametrize(
    "arguments", [("catalog", "list"), ("catalog", "show", "vf-s11", "--json")]
)
def test_a_reader_that_goes_away_is_quiet(arguments: tuple[str, ...]) -> None:
    reader, writer = os.pipe()
    os.close(reader)
    try:
        done = subprocess.run(
            [*COMMAND, *arguments], check=False, stdout=writer, stderr=subprocess.PIPE, cwd=ROOT
        )
    finally:
        os.close(writer)
    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.parametrize(
    ("text", "status"),
    [
        ("title: Twice\nblock: Twice\nsources: [twice.scl]\nsteps: [expect: {block.a: 0}]\n", 141),
        ("title: Twice\n", 1),
    ],
)
def test_reports_are_written_although_the_reader_goes_away(
    tmp_path: Path, text: str, status: int
) -> None:
    scenario = tmp_path / "twice.scenario.yaml"
    scenario.write_text(f"version: 1\n{text}", encoding="utf-8")
    (tmp_path / "twice.scl").write_text(
        "FUNCTION_BLOCK Twice\nVAR_INPUT\n    a : INT;\nEND_VAR\nBEGIN\nEND_FUNCTION_BLOCK\n",
        encoding="utf-8",
    )
    arguments = ["test", str(scenario), "--coverage", "table", "--junit", str(tmp_path / "out.xml")]
    reader, writer = os.pipe()
    os.close(reader)
    try:
        done = subprocess.run(
            [*COMMAND, *arguments], check=False, stdout=writer, stderr=subprocess.PIPE, cwd=ROOT
        )
    finally:
        os.close(writer)
    assert done.returncode == status, done.stderr
    assert b"twice.scenario" in (tmp_path / "out.xml").read_bytes()
    assert b"Traceback" not in done.stderr


def test_findings_are_coloured_on_a_terminal_only(
    fbgen: Fbgen, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert "\x1b" not in fbgen("explain", "FB0").err
    monkeypatch.setattr("sys.stderr.isatty", lambda: True, raising=False)
    assert "\x1b[31m\x1b[1merror[FB9003]\x1b[0m" in fbgen("explain", "FB0").err
    monkeypatch.setenv("NO_COLOR", "1")
    assert "\x1b" not in fbgen("explain", "FB0").err


def test_main_without_arguments_takes_those_of_the_process(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(sys, "argv", ["fbgen", "--version"])
    assert main() == 0
    assert capsys.readouterr().out.startswith("fbgen ")


def _break_decode(monkeypatch: pytest.MonkeyPatch, problem: BaseException) -> None:
    def fail(*_: object) -> None:
        raise problem

    monkeypatch.setattr("fbgen.catalog.load_catalog", fail)


def test_a_command_imports_no_other_command() -> None:
    script = (
        "import sys\n"
        "from fbgen.cli import main\n"
        "main(['decode', 'tospbdp001.status', '9F00'])\n"
        "from fbgen.cli.program import COMMANDS\n"
        "print([name for name in COMMANDS if f'fbgen.cli.{name}' in sys.modules])\n"
        "print('harness' in sys.modules)\n"
    )
    shown = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT, check=True
    )
    assert shown.stdout.splitlines()[-2:] == ["['decode']", "False"]


def test_the_help_names_every_command_that_there_is(fbgen: Fbgen) -> None:
    shown = fbgen("--help").out.partition("Commands:")[2].partition("Examples:")[0]
    named = [line.split()[0] for line in shown.splitlines() if line.strip()]
    modules = (ROOT / "fbgen" / "cli").glob("*.py")
    registered = {path.stem for path in modules if "def register(" in path.read_text("utf-8")}
    assert named == list(program.COMMANDS)
    assert set(program.COMMANDS) == registered


def test_a_process_ends_without_looking_for_garbage() -> None:
    script = (
        "import atexit, gc, sys\n"
        "atexit.register(lambda: print('frozen', gc.get_freeze_count() > 1000))\n"
        "from fbgen.cli import run\n"
        "sys.argv = ['fbgen', '--version']\n"
        "sys.exit(run())\n"
    )
    shown = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, cwd=ROOT, check=True
    )
    assert shown.stdout.splitlines()[-1] == "frozen True"
