"""Pages of docs/reference that are made from the program are those of this program."""

from functools import cache

from tools.pages.__main__ import REFERENCE, made_pages

MEANING = {"command-line.md": 1, "python.md": 1, "status-codes.md": 1}
"""Column of the meaning, where it is not the last of five."""


@cache
def pages() -> dict[str, str]:
    """The pages as they are made now."""
    return made_pages()


def test_made_pages_are_up_to_date() -> None:
    old = [name for name, text in pages().items() if _there(name) != text]
    assert old == [], "make pages writes them anew"


def _there(name: str) -> str:
    path = REFERENCE / name
    return path.read_text("utf-8") if path.is_file() else ""


def test_no_page_is_left_of_a_file_that_is_gone() -> None:
    there = {f"files/{path.name}" for path in (REFERENCE / "files").iterdir()}
    assert there == {name for name in pages() if name.startswith("files/")}


def test_every_key_and_option_says_what_it_means() -> None:
    silent = []
    for name, text in pages().items():
        column = MEANING.get(name, 4)
        for row in text.splitlines():
            cells = row.replace("\\|", "").strip("|").split(" | ")
            if row.startswith("| `") and not cells[column].strip():
                silent.append(f"{name}: {row}")
    assert silent == [], "give the field a description, or the key one in tools/pages/meanings.py"
