"""`S=`, `R=` and `REF=`: assignments whose sign begins with letters.

Source: CODESYS help, "Assignment operator S=", "R=" and "REF=".
"""

from fbgen.lang.dialects.dialect import Feature
from fbgen.lang.dialects.words import words
from fbgen.lang.parser.cursor import Cursor

_LETTERS = words("S R REF")


class SetAssignmentParser(Cursor):
    """Tells such a sign from a name in front of a comparison."""

    def set_operator(self) -> str:
        """The sign here, with the cursor on its '='; else "", and the cursor stays."""
        at = self.at
        word = self.texts[at].upper()
        if (
            word not in _LETTERS
            or self.kinds[at] != "name"
            or self.kinds[at + 1] != "="
            or self.ends[at] != self.starts[at + 1]
        ):
            return ""
        self.at = at + 1
        self.need(Feature.REFERENCES if word == "REF" else Feature.SET_ASSIGNMENTS, at)
        return f"{word}="
