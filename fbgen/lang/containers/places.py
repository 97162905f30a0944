"""Which pieces of a container's text are code, and what is put there when it is written again."""

from collections.abc import Callable, Iterable
from typing import TypeAlias

from fbgen.dataclass import dataclass
from fbgen.lang.ast import File
from fbgen.lang.containers.xml_tree import Element
from fbgen.source import Source

CodeOf: TypeAlias = Callable[[File], str]
"""The text of one piece of code, taken from a tree."""


@dataclass(frozen=True, slots=True)
class Slot:
    """The content of one element, and where its new text comes from."""

    element: Element
    code: CodeOf


def rewritten(source: Source, slots: Iterable[Slot], file: File) -> str:
    """The text of the container with the code of another tree in its slots."""
    text = source.text
    line_end = "\r\n" if "\r\n" in text else "\n"
    pieces: list[str] = []
    at = 0
    for slot in sorted(slots, key=lambda one: one.element.start):
        element = slot.element
        code = slot.code(file).replace("\n", line_end)
        pieces.append(text[at : element.inner_start])
        if element.inner_start == element.inner_end and text[element.inner_start - 2] == "/":
            if code:
                tag = text[element.start : element.inner_start - 2].rstrip()
                pieces[-1] = text[at : element.start] + tag + ">"
                name = tag[1:].split()[0]
                pieces += (cdata(code), f"</{name}>")
        else:
            is_escaped = element.raw.strip() and "<![CDATA[" not in element.raw
            pieces.append(escape(code) if is_escaped else cdata(code))
        at = element.inner_end
    pieces.append(text[at:])
    return "".join(pieces)


def escape(text: str) -> str:
    """A text as it stands between tags."""
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def cdata(text: str) -> str:
    """A text as CDATA, whatever it has in it."""
    return f"<![CDATA[{text.replace(']]>', ']]]]><![CDATA[>')}]]>"
