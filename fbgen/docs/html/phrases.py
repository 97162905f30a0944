"""Phrases as HTML."""

from markupsafe import Markup, escape

from fbgen.docs.document import Code, Inline, Link, Phrase, Strong, Tag


def phrase_html(phrase: Phrase) -> Markup:
    """The phrase, everything in it escaped."""
    if len(phrase) == 1:
        return _part(phrase[0])
    return Markup("").join(_part(part) for part in phrase)


def address(link: Link) -> str:
    """Where a link leads from any page: all lie in one folder."""
    page = f"{link.page}.html" if link.page else ""
    behind = link.state or link.anchor
    return f"{page}#{behind}" if behind else page


def _part(part: Inline) -> Markup:
    if isinstance(part, str):
        return escape(part)
    text = escape(part.text)
    if isinstance(part, Code):
        return Markup("<code>{}</code>").format(text)
    if isinstance(part, Strong):
        return Markup("<strong>{}</strong>").format(text)
    if isinstance(part, Tag):
        return Markup('<span class="tag {}">{}</span>').format(part.tone, text)
    assert isinstance(part, Link)
    return Markup('<a href="{}">{}</a>').format(address(part), text)
