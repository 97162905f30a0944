"""A site written again: its own pages change, those of a person stay, those that fell away go."""

from pathlib import Path

import pytest

from fbgen.diagnostics import DiagnosticError
from fbgen.docs.folder import list_name, write_site

LIST = list_name("html")


def write(folder: Path, force: bool = False, **pages: str) -> tuple[tuple[str, ...], ...]:
    contents = {f"{name}.html": text.encode() for name, text in pages.items()}
    found = write_site(contents, folder, "html", force=force)
    return found.written, found.removed, found.kept


def test_pages_of_its_own_are_written_again_and_go_when_they_fall_away(tmp_path: Path) -> None:
    write(tmp_path, a="1", b="1")
    assert write(tmp_path, a="2") == (("a.html",), ("b.html",), ())
    assert {path.name for path in tmp_path.iterdir()} == {"a.html", LIST}


def test_a_page_that_was_changed_by_hand_stays(tmp_path: Path) -> None:
    write(tmp_path, a="1", b="1")
    for name in ("a.html", "b.html"):
        (tmp_path / name).write_text("mine")
    with pytest.raises(DiagnosticError, match="FB5020"):
        write(tmp_path, a="2")
    assert write(tmp_path, force=True, a="2") == (("a.html",), (), ("b.html",))
    assert (tmp_path / "b.html").read_text() == "mine"


def test_two_formats_lie_side_by_side(tmp_path: Path) -> None:
    write(tmp_path, a="1")
    write_site({"a.md": b"1"}, tmp_path, "markdown")
    assert (tmp_path / "a.html").exists()


@pytest.mark.parametrize("text", ["no json", '{"files": 3}', "[]"])
def test_a_damaged_list_is_told(tmp_path: Path, text: str) -> None:
    (tmp_path / LIST).write_text(text)
    with pytest.raises(DiagnosticError, match="FB5022"):
        write(tmp_path, a="1")


def test_a_list_leads_to_nothing_outside_of_the_folder(tmp_path: Path) -> None:
    outside = tmp_path / "kept.html"
    outside.write_text("mine")
    folder = tmp_path / "site"
    folder.mkdir()
    (folder / LIST).write_text('{"files": {"../kept.html": "0"}}')
    assert write(folder, a="1") == (("a.html",), (), ())
    assert outside.exists()
