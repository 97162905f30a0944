"""A key stands for everything that something was made from, fbgen itself too."""

import os
from collections.abc import Callable
from pathlib import Path

import pytest

from fbgen.cache import key_of, keys

_FILES = ("fbgen/__init__.py", "fbgen/lang/lexer.py", "harness/engine/names.py")


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with packages that stand for fbgen, looked at anew for each key."""
    for name in _FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("x = 1\n", encoding="utf-8")
    monkeypatch.setattr(keys.fbgen, "__file__", str(tmp_path / _FILES[0]))
    monkeypatch.setattr(keys, "_made_by", keys._made_by.__wrapped__)
    return tmp_path


def test_parts_do_not_run_into_each_other() -> None:
    assert key_of(["ab", "c"]) != key_of(["a", "bc"]) != key_of(["abc"])
    assert key_of(["a", b"b"]) == key_of([b"a", "b"])


def edited(file: Path) -> None:
    """More in it, but the time of the change as before."""
    before = file.stat()
    file.write_text("x = 10\n", encoding="utf-8")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns))


def saved_later(file: Path) -> None:
    """As long as before."""
    before = file.stat()
    file.write_text("x = 2\n", encoding="utf-8")
    os.utime(file, ns=(before.st_atime_ns, before.st_mtime_ns + 1_000_000))


@pytest.mark.parametrize("name", _FILES)
@pytest.mark.parametrize("change", [edited, saved_later, Path.unlink])
def test_another_state_of_fbgen_is_another_key(
    package: Path, name: str, change: Callable[[Path], None]
) -> None:
    before = key_of(["part"])
    assert key_of(["part"]) == before
    change(package / name)
    assert key_of(["part"]) != before


@pytest.mark.usefixtures("package")
def test_another_version_is_another_key(monkeypatch: pytest.MonkeyPatch) -> None:
    before = key_of(["part"])
    monkeypatch.setattr(keys.fbgen, "__version__", "99.0")
    assert key_of(["part"]) != before


@pytest.mark.parametrize("package", ["fbgen", "harness"])
def test_every_python_file_of_fbgen_counts(package: str) -> None:
    counted = {
        Path(line.rsplit(" ", 3)[0]) for line in keys._made_by().split("\n") if ".py " in line
    }
    folder = Path(keys.fbgen.__file__).parents[1] / package
    assert counted >= set(folder.rglob("*.py"))
