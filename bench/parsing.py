"""Text to tokens and to the syntax tree: time and memory for each line, whatever the size."""

import tracemalloc
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial

from bench.measuring import Figure, measure
from bench.plc_text import plc_text
from fbgen.lang.dialects import dialect_named
from fbgen.lang.lexer import tokenize
from fbgen.lang.parser import parse
from fbgen.source import Source

_SIZES = (1_000, 10_000, 100_000)
_WINDOWS = 20
_LIMIT = "at most 11.1 us (90,000 lines/s)"


@dataclass(frozen=True, slots=True)
class Memory:
    """What the tree of a text takes, for each of its lines."""

    name: str
    bytes_per_line: float
    limit: str = "flat"

    def __str__(self) -> str:
        return f"{self.name:<52} {self.bytes_per_line:>10,.0f} B   {self.limit}"


def figures() -> Iterator[Figure | Memory]:
    """Lines of a TIA program; the limit is for lexing and parsing together."""
    for size in _SIZES:
        source = Source("bench.scl", plc_text(size))
        lines = source.text.count("\n")
        lex = partial(tokenize, source, dialect_named("tia"))
        read = partial(parse, source, "tia")
        name = f"one line out of {size:,}"
        yield measure(f"lexing {name}", lex, per=lines, windows=_WINDOWS)
        yield measure(f"lexing and parsing {name}", read, _LIMIT, per=lines, windows=_WINDOWS)
        yield Memory(f"tree of {name}", _memory(source) / lines)


def _memory(source: Source) -> int:
    """The bytes that are in use for the tree of a text, the text itself not counted."""
    tracemalloc.start()
    tree = parse(source, "tia")
    used, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert tree.units
    return used
