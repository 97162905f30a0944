"""What is kept on disk: given back as it was, or not at all, and never without bound."""

import os
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from fbgen.cache import entries, keep, kept, key_of
from fbgen.cache.folder import cache_folder

KEY = key_of(["something"])


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The cache folder of this test, which is made when it is needed."""
    place = tmp_path / "cache"
    monkeypatch.setenv("FBGEN_CACHE", str(place))
    return place


def the_file(folder: Path) -> Path:
    """The one file that is there."""
    (path,) = folder.iterdir()
    return path


@pytest.mark.usefixtures("folder")
def test_what_is_kept_comes_back() -> None:
    assert kept(KEY) is None
    keep(KEY, b"\0 content")
    assert kept(KEY) == b"\0 content"
    assert kept(key_of(["something else"])) is None


def test_off_keeps_nothing(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    keep(KEY, b"content")
    monkeypatch.setenv("FBGEN_CACHE", "off")
    assert kept(KEY) is None
    keep(key_of(["more"]), b"content")
    assert len(list(folder.iterdir())) == 1


@pytest.mark.parametrize("damage", ["cut", "changed", "empty"])
def test_a_damaged_entry_is_as_good_as_none_and_goes_away(folder: Path, damage: str) -> None:
    keep(KEY, b"content" * 100)
    path = the_file(folder)
    data = path.read_bytes()
    last = bytes([data[-1] ^ 1])
    path.write_bytes({"cut": data[:-1], "changed": data[:-1] + last, "empty": b""}[damage])
    assert kept(KEY) is None
    assert list(folder.iterdir()) == []


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no modes of this kind")
@pytest.mark.parametrize("mode", [0o770, 0o707, 0o777])
def test_a_folder_that_others_may_write_to_is_not_used(folder: Path, mode: int) -> None:
    keep(KEY, b"content")
    folder.chmod(mode)
    assert kept(KEY) is None
    keep(key_of(["more"]), b"content")
    assert len(list(folder.iterdir())) == 1


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no modes of this kind")
def test_the_folder_is_made_for_the_user_alone(folder: Path) -> None:
    keep(KEY, b"content")
    assert folder.stat().st_mode & 0o777 == 0o700


def test_a_file_where_the_folder_should_be_does_no_harm(folder: Path) -> None:
    folder.write_bytes(b"")
    keep(KEY, b"content")
    assert kept(KEY) is None


def test_the_oldest_go_when_the_folder_is_full(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    keys = [key_of([str(number)]) for number in range(8)]
    for age, key in enumerate(reversed(keys[:7])):
        keep(key, os.urandom(1000))
        os.utime(folder / f"{key}.kept", (1_000_000 - age, 1_000_000 - age))
    assert kept(keys[0]) is not None  # used just now, so no longer the oldest
    monkeypatch.setattr(entries, "MOST_BYTES", 8 * 1000)
    keep(keys[7], os.urandom(1000))
    left = [number for number, key in enumerate(keys) if kept(key) is not None]
    assert left == [0, 4, 5, 6, 7]


def test_what_a_process_left_unfinished_is_removed(folder: Path) -> None:
    keep(KEY, b"content")
    old, new = (folder / f".{KEY}.kept.{number}.tmp" for number in (1, 2))
    foreign = folder / "notes.tmp"
    for path in (old, new, foreign):
        path.write_bytes(b"")
    os.utime(old, (0, 0))
    os.utime(foreign, (0, 0))
    keep(key_of(["more"]), b"content")
    assert [path.exists() for path in (old, new, foreign)] == [False, True, True]


@pytest.mark.usefixtures("folder")
def test_many_may_write_and_read_the_same_entry_at_once() -> None:
    content = bytes(200_000)

    def once(_: int) -> bytes | None:
        keep(KEY, content)
        return kept(KEY)

    with ThreadPoolExecutor(8) as pool:
        assert set(pool.map(once, range(64))) <= {content, None}
    assert kept(KEY) == content


@pytest.mark.parametrize(
    ("platform", "setting", "place"),
    [
        ("linux", "XDG_CACHE_HOME={home}/xdg", "xdg/fbgen"),
        ("linux", "XDG_CACHE_HOME=relative", ".cache/fbgen"),
        ("linux", "XDG_CACHE_HOME=", ".cache/fbgen"),
        ("darwin", "XDG_CACHE_HOME={home}/xdg", "Library/Caches/fbgen"),
        ("win32", "LOCALAPPDATA={home}/local", "local/fbgen/Cache"),
        ("win32", "LOCALAPPDATA=", "AppData/Local/fbgen/Cache"),
    ],
)
def test_it_lies_where_the_system_has_its_caches(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    platform: str,
    setting: str,
    place: str,
) -> None:
    for name in ("FBGEN_CACHE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.delenv(name, raising=False)
    for name in ("HOME", "USERPROFILE"):
        monkeypatch.setenv(name, str(tmp_path))
    name, _, value = setting.partition("=")
    monkeypatch.setenv(name, value.format(home=tmp_path))
    monkeypatch.setattr(sys, "platform", platform)
    assert cache_folder() == tmp_path / place


def test_no_home_means_no_cache(monkeypatch: pytest.MonkeyPatch) -> None:
    def nobody(*_: object) -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("FBGEN_CACHE")
    monkeypatch.delenv("XDG_CACHE_HOME", raising=False)
    monkeypatch.setattr(Path, "home", nobody)
    monkeypatch.setattr(sys, "platform", "linux")
    keep(KEY, b"content")
    assert kept(KEY) is None
