"""Texts that a page needs more than once, each kept once and named by its number."""


class Texts:
    """A growing list of different texts."""

    __slots__ = ("_numbers", "found")

    def __init__(self) -> None:
        self.found: list[str] = []
        self._numbers: dict[str, int] = {}

    def number(self, text: str) -> int:
        """The number of a text."""
        number = self._numbers.setdefault(text, len(self.found))
        if number == len(self.found):
            self.found.append(text)
        return number
