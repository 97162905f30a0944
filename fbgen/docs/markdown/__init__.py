"""Pages as Markdown for a wiki: relative links, tables, pictures as files beside them."""

from fbgen.docs.markdown.writer import markdown_site

__all__ = ["markdown_site"]
