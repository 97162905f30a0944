"""A page is followed from top to bottom, in a folder of its own.

What a code block does, by its language:

* a block with a name (```yaml plant.yaml) is the file of that name from there on;
* `console`: each command runs in this process. Lines that begin with `$` are commands and what
  follows them is what they print, with `...` for what differs from time to time; without any `$`
  each line is a command. A command ends with status 0, or with that of its comment `# status 1`;
* `sh` shows how a command is written, with names of files that nobody has: its options exist (see
  `test_commands`);
* `diff NAME` changes the file of that name: its lines stand there once, and are replaced;
* `python` runs;
* `yaml` for a server that runs the commands in it (`NAME.yml`): those of fbgen run;
* everything else is text of its language (see `fragments`).

A page finds what it speaks of and does not show in `scratch/PAGE/`, and those folders of the
project that it names; `cp` finds any file of the project.
"""

import doctest
import os
import re
import runpy
import shlex
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from fbgen.cli import main
from fbgen.dataclass import dataclass
from tests.unit.documentation.fragments import problems_of
from tests.unit.documentation.markdown import ROOT, CodeBlock, blocks_of, text_of

SCRATCH = Path(__file__).parent / "scratch"
UNREAD = {"sh", "text"}
"""What is neither run nor read here."""
FOLDERS = ("examples",)
"""Folders of the project that pages speak of."""
ELSEWHERE = {
    "make": "the tests in test_commands hold its targets",
    "git": "a clone needs the network",
    "py": "Windows",
    ".venv\\Scripts\\fbgen": "Windows",
    ".venv\\Scripts\\ruff": "Windows",
    ".venv\\Scripts\\mypy": "Windows",
    ".venv\\Scripts\\python": "Windows",
    ".venv\\Scripts\\activate": "Windows",
    "source": "makes an environment the shell's own",
    "pip": "tests/unit/packaging installs the wheel",
    "dask": "takes a cluster",
    "cansend": "takes a CAN interface",
}
"""Commands that are not run from a page, and why."""
LONG = {
    "docs": "draws handshakes of simulated runs; tests/unit/docs makes the pages",
    "sim": "serves until Ctrl-C; tests/unit/serial starts it",
    "record": "listens until Ctrl-C; tests/unit/cli/test_record_and_replay",
    "replay": "takes a recording and a port; tests/unit/cli/test_record_and_replay",
    "talk": "takes an inverter at a port; tests/unit/cli/test_talk asks simulated ones",
    "campaign": "tests/unit/verify runs small ones",
    "mutate": "tests/unit/mutation and tests/unit/cli/test_mutate run small ones",
}
"""Commands of fbgen that take too long or for ever, and who runs them."""


@dataclass(frozen=True, slots=True)
class Command:
    """One command of a page with what it prints there; None if the page does not show it."""

    place: str
    text: str
    shown: str | None

    @property
    def words(self) -> list[str]:
        """The words of the command without its comment; a path of Windows stays as it is."""
        text = self.text.replace("\\", "\\\\")
        return shlex.split(text, comments=True)

    @property
    def status(self) -> int:
        """The exit status with which it is to end."""
        found = re.search(r"# status (\d)", self.text)
        return int(found[1]) if found else 0


def commands_of(block: CodeBlock) -> Iterator[Command]:
    """The commands of a console block."""
    parts = re.split(r"^\$ (.*)\n", block.text, flags=re.MULTILINE)
    if len(parts) == 1:
        for line in block.text.splitlines():
            if line.strip() and not line.startswith("#"):
                yield Command(block.place, line, None)
    for text, shown in zip(parts[1::2], parts[2::2], strict=True):
        yield Command(block.place, text, shown or None)


def follow(page: str, folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Do what a page says, in this folder, which is the current one."""
    _prepare(page, folder)
    names: dict[str, object] = {"__name__": page}
    for block in blocks_of(page):
        if block.language == "diff":
            _change(block, folder)
        elif block.name:
            (folder / block.name).parent.mkdir(parents=True, exist_ok=True)
            Path(folder / block.name).write_text(block.text, encoding="utf-8")
        if block.language == "console":
            for command in commands_of(block):
                _run(command, capsys)
        elif block.language == "python" and not block.name:
            exec(compile(block.text, block.place, "exec"), names)
        elif block.name.endswith(".yml"):
            for line in re.findall(r"^ *- (?:run: )?(fbgen .+)$", block.text, re.MULTILINE):
                _run(Command(block.place, line, None), capsys)
        elif block.language not in {*UNREAD, "diff"}:
            assert problems_of(block.language, block.text) == [], block.place


def _prepare(page: str, folder: Path) -> None:
    own = SCRATCH / Path(page).stem
    if own.is_dir():
        shutil.copytree(own, folder, dirs_exist_ok=True)
    for name in FOLDERS:
        if name in text_of(page):
            shutil.copytree(ROOT / name, folder / name)


def _change(block: CodeBlock, folder: Path) -> None:
    """Replace the lines of a file that begin with a blank or `-` by those with a blank or `+`."""
    lines = block.text.splitlines(keepends=True)
    before, after = ("".join(one[1:] for one in lines if one[0] in kept) for kept in (" -", " +"))
    path = folder / block.name
    text = path.read_text(encoding="utf-8")
    assert text.count(before) == 1, f"{block.place}: {block.name} does not have these lines once"
    path.write_text(text.replace(before, after), encoding="utf-8")


def _run(command: Command, capsys: pytest.CaptureFixture[str]) -> None:
    words = command.words
    if words[0] in ELSEWHERE or words[:3] == ["python", "-m", "venv"]:
        return
    if words[0] == "fbgen" and words[1] in LONG:
        return
    capsys.readouterr()
    target = None
    if ">" in words:
        words, (target,) = words[: words.index(">")], words[words.index(">") + 1 :]
    status = _status(words)
    captured = capsys.readouterr()
    where = f"{command.place}: {command.text}"
    assert status == command.status, f"{where}\n{captured.out}{captured.err}"
    if target:
        Path(target).write_text(captured.out, encoding="utf-8")
    elif command.shown is not None:
        printed = (captured.out + captured.err, captured.err + captured.out)
        if not any(_is_like(command.shown, one) for one in printed):
            pytest.fail(f"{where}\nshown:\n{command.shown}\nprinted:\n{printed[0]}")


def _is_like(shown: str, printed: str) -> bool:
    """Whether that is what is shown; a terminal mixes two streams, so empty lines do not count."""
    wanted, got = (re.sub(r"\n\n+", "\n", text) for text in (shown, printed))
    return doctest.OutputChecker().check_output(wanted, got, doctest.ELLIPSIS)


def _status(words: list[str]) -> int:
    program, *rest = words
    if program == "fbgen":
        return main(rest)
    if program == "cd":
        os.chdir(rest[0])
        return 0
    if program == "mkdir":
        Path(rest[-1]).mkdir(parents="-p" in rest)
        return 0
    if program == "cp":
        source = Path(rest[0])
        shutil.copy(source if source.exists() else ROOT / source, rest[1])
        return 0
    if program == "python":
        runpy.run_path(rest[0], run_name="__main__")
        return 0
    assert program == "pytest", f"no page may use {program}: {ELSEWHERE}"
    done = subprocess.run(
        [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", *rest],
        check=False,
        capture_output=True,
        text=True,
        env={**os.environ, "PYTHONPATH": str(ROOT)},
    )
    print(done.stdout + done.stderr)
    return done.returncode
