"""Phrases in reportlab's own small markup, with links inside of the handbook."""

from xml.sax.saxutils import escape

from fbgen.docs.document import Code, Inline, Link, Phrase, Strong, Tag
from fbgen.docs.drawing import PRINTED

_TONES = {"unverified": "#63499f", "warning": "#8f4400"}


def phrase_markup(phrase: Phrase, page: str) -> str:
    """The phrase as it stands on a page."""
    return "".join(_part(part, page) for part in phrase)


def target(page: str, anchor: str = "") -> str:
    """How the handbook calls a place."""
    return f"{page}--{anchor}" if anchor else page


def text_markup(text: str) -> str:
    """A plain text; what the fonts do not have becomes a question mark."""
    return escape(text.encode("cp1252", "replace").decode("cp1252"))


def _part(part: Inline, page: str) -> str:
    if isinstance(part, str):
        return text_markup(part)
    text = text_markup(part.text)
    if isinstance(part, Code):
        return f'<font face="Courier">{text}</font>'
    if isinstance(part, Strong):
        return f"<b>{text}</b>"
    if isinstance(part, Tag):
        return f'<font color="{_TONES[part.tone]}"><i>{text}</i></font>'
    assert isinstance(part, Link)
    if part.state:
        return text
    place = target(part.page or page, part.anchor)
    return f'<a href="#{place}" color="{PRINTED["accent"]}">{text}</a>'
