"""Pages as one handbook: contents with page numbers, bookmarks, pictures drawn as lines."""

from fbgen.docs.pdf.writer import handbook

__all__ = ["handbook"]
