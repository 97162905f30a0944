"""Writes the made pages of docs/reference anew."""

from pathlib import Path

from tools.pages.command_line import command_line_page
from tools.pages.file_pages import file_pages
from tools.pages.python_interface import python_page
from tools.pages.status_codes import status_codes_page

REFERENCE = Path(__file__).resolve().parents[2] / "docs" / "reference"


def made_pages() -> dict[str, str]:
    """The pages by their path in docs/reference."""
    files = {f"files/{name}.md": text for name, text in file_pages().items()}
    return {
        "command-line.md": command_line_page(),
        "python.md": python_page(),
        "status-codes.md": status_codes_page(),
        **files,
    }


def main() -> None:
    """Write them."""
    for name, text in made_pages().items():
        path = REFERENCE / name
        path.parent.mkdir(exist_ok=True)
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
