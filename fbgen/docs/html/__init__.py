"""Pages as a static site that opens from disk: no server, no network, one script and one style."""

from fbgen.docs.html.writer import html_site

__all__ = ["html_site"]
