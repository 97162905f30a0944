"""How deep texts may nest, and room on the stack for walking trees of that depth.

Python stops at 1,000 calls inside each other by default, and a level of a text takes several. Since
Python 3.11 calls between Python functions take no space on the C stack, so the limit may be raised
as long as the depth of the text itself is limited.
"""

import sys
from collections.abc import Iterator
from contextlib import contextmanager

DEEPEST = 256
"""Levels of nesting that the parser reads: parentheses, brackets, calls, statements, types."""

_CALLS_PER_LEVEL = 20


@contextmanager
def room_for_depth() -> Iterator[None]:
    """While this is open, `DEEPEST` levels of a tree fit on the stack, whoever calls."""
    before = sys.getrecursionlimit()
    sys.setrecursionlimit(max(before, 1000 + DEEPEST * _CALLS_PER_LEVEL))
    try:
        yield
    finally:
        sys.setrecursionlimit(before)
