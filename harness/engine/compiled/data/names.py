"""Python names for PLC names.

PLC names do not depend on case and may be Python keywords or hold any character; Python names here
are as close to the declared ones as possible, because the generated source is meant to be read.
Names with a leading underscore belong to the generator, so a PLC name never gets one.
"""

import keyword
import re

_USED_HERE = frozenset(
    "abs chr frame int len max min ord range self str value zip".split()  # noqa: SIM905  # shorter
)
"""What generated functions name themselves."""


class Names:
    """Gives each PLC name of one scope its own Python name.

    `outer` holds names that must stay visible inside the scope; attributes have none.
    """

    __slots__ = ("_given", "_used")

    def __init__(self, outer: "Names | None" = None) -> None:
        self._used: set[str] = set(keyword.kwlist) | (outer._used if outer else set())
        self._given: dict[str, str] = {}

    @classmethod
    def of_a_module(cls) -> "Names":
        """For names of a module, and, as `outer`, for the functions in it."""
        names = cls()
        names._used |= _USED_HERE
        return names

    def give(self, name: str) -> str:
        """A new Python name that looks like `name` and that nothing in this scope has."""
        plain = re.sub(r"[^A-Za-z0-9_]", "_", name).lstrip("_") or "x"
        if plain[0].isdigit():
            plain = f"x{plain}"
        candidate, number = plain, 1
        while candidate in self._used:
            number += 1
            candidate = f"{plain}_{number}"
        self._used.add(candidate)
        return candidate

    def of(self, name: str) -> str:
        """The Python name of a PLC name: one and the same for every spelling of its case."""
        key = name.casefold()
        if key not in self._given:
            self._given[key] = self.give(name)
        return self._given[key]
