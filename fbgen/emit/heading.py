"""The head of a generated unit: what it is generated from, its interface, its sources.

Inputs and outputs are read from the unit itself, the sources from the entries of the catalogue that
stand in it. Timing and limits are the template's own: its first comments.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import lru_cache
from textwrap import wrap

from fbgen.blocks.literals import one_line
from fbgen.blocks.texts import Texts
from fbgen.lang import ast
from fbgen.source import Origin, Source

_WIDTH = 94
_INTERFACE = (("VAR_INPUT", "Inputs"), ("VAR_OUTPUT", "Outputs"), ("VAR_IN_OUT", "In-outs"))


def with_head(file: ast.File, texts: Texts) -> ast.File:
    """The file with a complete head above its unit, whose first comment is there already."""
    first, *others = file.units
    if not isinstance(first, ast.Block | ast.DataBlock | ast.TypeDeclaration):
        return file
    begin, *rest = first.leading
    facts = _facts(file.source, texts)
    interface = _interface(first, texts) if isinstance(first, ast.Block) else ()
    head = (begin, *_comments(begin, interface), *rest, *_comments(begin, facts))
    return replace(file, units=(replace(first, leading=head), *others))


def _interface(block: ast.Block, texts: Texts) -> Iterator[str]:
    """The names of the parameters, or that there are none."""
    found = False
    for keyword, label in _INTERFACE:
        names = [
            name.name
            for section in block.sections
            if section.keyword == keyword
            for declaration in section.declarations
            for name in declaration.names
        ]
        if names:
            found = True
            yield f"{texts(label)}: {', '.join(names)}"
    if not found:
        yield texts("Inputs and outputs: none")


def facts_in(source: Source) -> list[str]:
    """Documents and sections, each once, in the order in which the unit needs them."""
    values = {id(origin): origin for _, origin in source.origins if origin is not None}.values()
    found = dict.fromkeys(text for origin in values for text in _sources(origin))
    return list(dict.fromkeys(map(one_line, found)))


def _facts(source: Source, texts: Texts) -> Iterator[str]:
    for text in facts_in(source):
        yield f"{texts('Facts')}: {text}"


def _sources(origin: Origin) -> Iterator[str]:
    if origin.source:
        yield origin.source
    for item in origin.inputs:
        yield from _sources(item)


def _comments(begin: ast.Trivia, texts: Iterable[str]) -> Iterator[ast.Trivia]:
    """Comments that stand where the first one stands."""
    for text in texts:
        for line in _wrapped(text):
            yield replace(begin, text=f"// {line}")


@lru_cache(1000)
def _wrapped(text: str) -> list[str]:
    return wrap(text, _WIDTH, subsequent_indent="   ", break_on_hyphens=False)
