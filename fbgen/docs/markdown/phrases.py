"""Phrases as Markdown (CommonMark with tables, as GitHub, GitLab and most wikis read it)."""

import re

from fbgen.docs.document import Code, Inline, Link, Phrase, Strong, Tag

_SPECIAL = re.compile(r"([\\`*_\[\]<>|#~])")
_LEADING = re.compile(r"^(\s*)([-+]|\d+[.)])(?=\s)")


def phrase_markdown(phrase: Phrase) -> str:
    """The phrase in one line; nothing in it becomes markup, and it may stand in a table."""
    return "".join(map(_part, phrase))


def plain_markdown(text: str) -> str:
    """A text as it is."""
    return _LEADING.sub(r"\1\\\2", _SPECIAL.sub(r"\\\1", " ".join(text.split(" "))))


def address(link: Link) -> str:
    """Where a link leads from any page: all lie in one folder."""
    page = f"{link.page}.md" if link.page else ""
    return f"{page}#{link.anchor}" if link.anchor else page


def _part(part: Inline) -> str:
    if isinstance(part, str):
        return _SPECIAL.sub(r"\\\1", part)
    if isinstance(part, Code):
        return _code(part.text)
    text = _SPECIAL.sub(r"\\\1", part.text)
    if isinstance(part, Strong):
        return f"**{text}**"
    if isinstance(part, Tag):
        return f"*{text}*"
    assert isinstance(part, Link)
    return text if part.state else f"[{text}]({address(part)})"


def _code(text: str) -> str:
    """Between as many backticks as it needs; a pipe would end a cell."""
    fence = "``" if "`" in text else "`"
    inner = text.replace("|", "\\|")
    return f"{fence}{inner}{fence}" if text else ""
