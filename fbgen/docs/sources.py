"""The documents that a page rests on, numbered in the order in which it names them."""

from fbgen.docs.document import Bullets, Link, Phrase, Section, Tag

ANCHOR = "sources"


class Sources:
    """Collects what a page names, and makes its last section."""

    def __init__(self) -> None:
        self._found: list[str] = []

    def of(self, source: str | None, status: str = "verified") -> Phrase:
        """How a fact names its source: a number that leads to the list, and whether it holds."""
        phrase: Phrase = ()
        if source:
            if source not in self._found:
                self._found.append(source)
            phrase = (Link(f"[{self._found.index(source) + 1}]", "", ANCHOR),)
        if status != "verified":
            phrase += (" ", UNVERIFIED) if phrase else (UNVERIFIED,)
        return phrase

    def sections(self) -> tuple[Section, ...]:
        """The list of the sources, if there are any."""
        if not self._found:
            return ()
        items = tuple((f"[{number}] {text}",) for number, text in enumerate(self._found, start=1))
        return (Section("Sources", (Bullets(items),), ANCHOR),)


UNVERIFIED = Tag("unverified", "unverified")
"""What rests on no document."""
