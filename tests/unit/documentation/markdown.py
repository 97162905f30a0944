"""Pages in Markdown: their code blocks, headings and links."""

import re
import textwrap
from functools import cache
from pathlib import Path

from fbgen.dataclass import dataclass

ROOT = Path(__file__).parents[3]
_FENCE = re.compile(r"^( *)```(\S*)(?: (\S+))?\n(.*?)^\1```$", re.MULTILINE | re.DOTALL)
_LINK = re.compile(r"\]\(([^)\s]+)\)")
_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)


@dataclass(frozen=True, slots=True)
class CodeBlock:
    """What stands between two fences: ```LANGUAGE NAME, where the name is the file it goes to."""

    page: str
    line: int
    language: str
    name: str
    text: str

    @property
    def place(self) -> str:
        """Where it stands."""
        return f"{self.page}:{self.line}"


@cache
def pages() -> dict[str, Path]:
    """Every page of the project by its path from the root."""
    found = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "bench").glob("*.md")]
    return {path.relative_to(ROOT).as_posix(): path for path in sorted(found)}


@cache
def text_of(page: str) -> str:
    """The text of a page."""
    return pages()[page].read_text(encoding="utf-8")


@cache
def blocks_of(page: str) -> tuple[CodeBlock, ...]:
    """The code blocks of a page in their order."""
    text = text_of(page)
    found = []
    for match in _FENCE.finditer(text):
        line = text.count("\n", 0, match.start()) + 1
        code = textwrap.dedent(match[4])
        found.append(CodeBlock(page, line, match[2], match[3] or "", code))
    return tuple(found)


def prose(page: str) -> str:
    """A page without its code blocks and comments."""
    return _COMMENT.sub("", _FENCE.sub("", text_of(page)))


def links_of(page: str) -> list[str]:
    """The targets of the links of a page."""
    return _LINK.findall(re.sub(r"`[^`\n]*`", "", prose(page)))


@cache
def anchors_of(page: str) -> frozenset[str]:
    """What the headings of a page are called in a link."""
    names: set[str] = set()
    for heading in re.findall(r"^#+ +(.+?) *$", prose(page), re.MULTILINE):
        plain = re.sub(r"\[([^\]]+)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        same = sum(known == name or known.startswith(f"{name}-") for known in names)
        names.add(f"{name}-{same}" if name in names else name)
    return frozenset(names)
